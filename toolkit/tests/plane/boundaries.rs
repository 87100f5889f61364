//! Norms on polygonal curves: closed forms over corners, intervals, circles as limits of regular polygons.

use fractional_sobolev::{Curve, DualOf, Error, Estimate, Function, Mesh, Order, Tolerance};
use std::f64::consts::{PI, TAU};

/// The linear interpolant of f at the nodes.
fn interpolate(
    curve: Curve,
    f: impl Fn([f64; 2]) -> f64,
) -> fractional_sobolev::Result<Function<'static>> {
    let values: Vec<f64> = curve.nodes().into_iter().map(f).collect();
    Function::on_curve(&curve, 1, &values)
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

fn uniform(count: usize) -> Mesh {
    Mesh::uniform(count, 1.0).unwrap()
}

/// A regular polygon in the unit circle, one element on every side.
fn regular(count: usize) -> Curve {
    let vertex = |k: usize| {
        let (sine, cosine) = (TAU * k as f64 / count as f64).sin_cos();
        [cosine, sine]
    };
    let vertices: Vec<[f64; 2]> = (0..count).map(vertex).collect();
    Curve::closed(&vertices, &vec![uniform(1); count]).unwrap()
}

/// ∫∫ τ² d^{-1-2ν} over the unit square, d the distance of points at σ, τ from a corner of the angle ω, in
/// polar coordinates: d = ρ √(1 − sin 2θ cos ω), ρ up to 1/max(cos θ, sin θ).
fn over_corner(angle: f64, nu: f64) -> f64 {
    let steps = 40_000;
    let value = |theta: f64| {
        let reach = 1.0 / theta.cos().max(theta.sin());
        let d = (1.0 - (2.0 * theta).sin() * angle.cos()).sqrt();
        theta.sin().powi(2) * d.powf(-1.0 - 2.0 * nu) * reach.powf(3.0 - 2.0 * nu)
            / (3.0 - 2.0 * nu)
    };
    // Simpson's rule on either side of the kink at π/4.
    let half = |from: f64| {
        let h = 0.25 * PI / steps as f64;
        let weight = |k: usize| if k == 0 || k == steps { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
        (0..=steps).map(|k| weight(k) * value(from + k as f64 * h)).sum::<f64>() * h / 3.0
    };
    half(0.0) + half(0.25 * PI)
}

#[test]
fn corners_of_every_angle() {
    for angle in [0.02, 0.3, 1.0, 0.5 * PI, 2.0, 3.0, 3.3, 5.0, 6.2] {
        for nu in [0.1, 0.5, 0.9] {
            let end = [f64::cos(angle), f64::sin(angle)];
            for count in [1, 5] {
                let meshes = [uniform(count), Mesh::algebraic(count, 2.0, 1.0).unwrap()];
                let curve = Curve::open(&[[1.0, 0.0], [0.0, 0.0], end], &meshes).unwrap();
                let values: Vec<f64> = (0..=2 * count)
                    .map(|k| k.saturating_sub(count) as f64 / count as f64)
                    .map(|t| t * t)
                    .collect();
                let u = Function::on_curve(&curve, 1, &values).unwrap();
                let found = u.seminorm(order(nu), Tolerance::new(1e-10).unwrap()).unwrap();
                // u = τ on the second leg alone.
                let own = 2.0 / ((2.0 - 2.0 * nu) * (3.0 - 2.0 * nu));
                let exact = (own + 2.0 * over_corner(angle, nu)).sqrt();
                assert!(
                    (found.value / exact - 1.0).abs() < 1e-8,
                    "{angle} {nu} {count}: {found} {exact}"
                );
            }
        }
    }
}

#[test]
fn straight_curves_are_intervals() {
    let (first, second) = (Mesh::algebraic(20, 3.0, 1.0).unwrap(), uniform(13));
    let lengths: Vec<f64> = first
        .lengths()
        .iter()
        .map(|h| 3.0 * h)
        .chain(second.lengths().iter().map(|h| 2.0 * h))
        .collect();
    let direction = [0.6, 0.8];
    let at = |t: f64| [1.0 + t * direction[0], -2.0 + t * direction[1]];
    let curve = Curve::open(&[at(0.0), at(3.0), at(5.0)], &[first, second]).unwrap();
    let values: Vec<f64> = (0..34).map(|k| f64::sin(f64::from(k * k))).collect();
    let steps: Vec<f64> = (0..33).map(|k| f64::sin(f64::from(k * k))).collect();
    let mesh = Mesh::from_lengths(&lengths).unwrap();
    let on_curve = Function::on_curve(&curve, 1, &values).unwrap();
    let flat = Function::linears(&mesh, &values).unwrap();
    for nu in [0.1, 0.5, 0.95] {
        for tolerance in [1e-3, 1e-8, 1e-12] {
            let tolerance = Tolerance::new(tolerance).unwrap();
            let found = on_curve.norm(order(nu), tolerance).unwrap();
            let exact = flat.norm(order(nu), Tolerance::reference()).unwrap();
            assert!(
                (found.value - exact.value).abs() <= found.error + exact.error,
                "{nu}: {found} {exact}"
            );
        }
    }
    let on_curve = Function::on_curve(&curve, 0, &steps).unwrap();
    let flat = Function::piecewise(&mesh, 0, &steps).unwrap();
    for nu in [0.1, 0.49] {
        let found = on_curve.seminorm(order(nu), Tolerance::balanced()).unwrap();
        let exact = flat.seminorm(order(nu), Tolerance::reference()).unwrap();
        assert!(
            (found.value - exact.value).abs() <= found.error + exact.error,
            "{nu}: {found} {exact}"
        );
    }
}

#[test]
fn regular_polygons_become_the_circle() {
    // |cos kθ|²_{1/2} = 2π² k on the unit circle, its square in L² π: of the eigenfunction the dual norm is
    // π/||u||.
    for k in [1, 3] {
        let wave = |x: [f64; 2]| (f64::from(k) * x[1].atan2(x[0])).cos();
        let exact = (2.0 * PI * PI * f64::from(k)).sqrt();
        let off = |count: usize| {
            let u = interpolate(regular(count), wave).unwrap();
            u.seminorm(Order::HALF, Tolerance::balanced()).unwrap().value / exact - 1.0
        };
        let (coarse, fine) = (off(150), off(300));
        assert!(fine.abs() < 2e-3 && (coarse / fine - 4.0).abs() < 0.2, "{k}: {coarse:e} {fine:e}");
        assert!((fine - coarse / 4.0).abs() < 2e-5);
        let dual = PI / (PI + exact * exact).sqrt();
        let off = |count: usize| {
            let u = interpolate(regular(count), wave).unwrap();
            let found = u.norm(-Order::HALF, Tolerance::new(1e-6).unwrap()).unwrap();
            found.value / dual - 1.0
        };
        let (coarse, fine) = (off(48), off(96));
        assert!((fine - coarse / 4.0).abs() < 1e-3 * f64::from(k * k), "{k}: {coarse:e} {fine:e}");
        assert!(fine.abs() < 4e-3 * f64::from(k * k), "{k}: {fine:e}");
    }
}

#[test]
fn powers_have_their_closed_forms() {
    let u = interpolate(Curve::algebraic(&SQUARE, 6, 2.5).unwrap(), |x| x[0] - 0.5);
    let u = u.unwrap();
    for q in [1.0, 2.0, 2.5, 40.0] {
        // |x - 1/2| on two sides, 1/2 on the others
        let exact: f64 = 2.0 * 0.5f64.powf(q) * (1.0 + 1.0 / (q + 1.0));
        let found = u.lp(q, 1e-12).unwrap();
        let off = (found.value - exact.powf(1.0 / q)).abs();
        assert!(off <= found.error && found.relative_error() < 1e-12, "{q}: {found}, off {off:e}");
    }
    assert_eq!(u.lp(f64::INFINITY, 1e-12).unwrap().value, 0.5);
    assert!(matches!(u.lp(0.5, 1e-12), Err(Error::OutOfRange { .. })));
}

#[test]
fn duals_of_interpolation_spaces_have_their_fourier_series() {
    let triangle = [[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]];
    let (lengths, total) = ([3.0, 5.0, 4.0], 12.0);
    let mesh = |k: usize| {
        let half = Mesh::algebraic(3 + k, 1.0 + k as f64, 0.5).unwrap();
        let both = half.lengths().iter().chain(half.lengths().iter().rev());
        Mesh::from_lengths(&both.copied().collect::<Vec<_>>()).unwrap()
    };
    let meshes = [mesh(0), mesh(1), mesh(2)];
    for (side, nu) in [(0, 0.3), (1, 0.3), (2, 0.3), (0, 0.5), (1, 0.75), (2, 0.95)] {
        // 1 on a side: c_k = sin(pi k l/L)/(pi k), the square L sum |c_k|^2 (1 + (2 pi k/L)^2)^-nu
        let term = |k: usize| {
            let k = k as f64;
            let c = (PI * k * lengths[side] / total).sin() / (PI * k);
            2.0 * c * c * (1.0 + (TAU * k / total).powi(2)).powf(-nu)
        };
        let mean: f64 = lengths[side] / total;
        let count = 2_000_000;
        // sin^2 is 1/2 on average beyond
        let last = count as f64 + 0.5;
        let rest = (TAU / total).powf(-2.0 * nu) / (PI * PI) * last.powf(-1.0 - 2.0 * nu)
            / (1.0 + 2.0 * nu);
        let sum: f64 = (1..=count).rev().map(term).sum::<f64>() + rest + mean * mean;
        let exact = (total * sum).sqrt();
        let curve = Curve::closed(&triangle, &meshes).unwrap();
        let values: Vec<f64> = (meshes.iter().enumerate())
            .flat_map(|(k, mesh)| vec![f64::from(u8::from(k == side)); mesh.len()])
            .collect();
        let u = Function::on_curve(&curve, 0, &values).unwrap();
        for of in [DualOf::Interpolation, DualOf::InterpolationZero] {
            let found = u.dual_norm(of, nu, 1e-9).unwrap();
            let off = (found.value - exact).abs();
            assert!(off <= found.error + 1e-11 * exact, "{side} {nu} {of:?}: {found}, off {off:e}");
        }
    }
}

#[test]
fn duals_on_open_curves_know_the_arc_length_alone() {
    let nodes = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
    let bent = Curve::open(&nodes, &[uniform(3), uniform(3)]).unwrap();
    let values = [0.3, -1.0, 2.0, 0.0, 0.5, 1.0, -0.7];
    let u = Function::on_curve(&bent, 1, &values).unwrap();
    let straight = Function::linears(&Mesh::uniform(6, 2.0).unwrap(), &values).unwrap();
    for of in [DualOf::Interpolation, DualOf::InterpolationZero] {
        let [a, b] =
            [u.dual_norm(of, 0.4, 1e-9), straight.dual_norm(of, 0.4, 1e-9)].map(Result::unwrap);
        assert!((a.value / b.value - 1.0).abs() < 1e-12, "{a} {b}");
    }
    assert_eq!(u.dual_norm(DualOf::Slobodeckij, 0.4, 1e-3), u.norm(-0.4, 1e-3));
}

#[test]
fn many_elements_of_a_closed_curve_are_a_matter_of_seconds() {
    // The same function on 100 000 elements and on 8.
    let of = |per_side: usize| {
        let curve = Curve::algebraic(&SQUARE, per_side, 1.0).unwrap();
        interpolate(curve, |x| x[0] + x[0] * 3.0 * x[1]).unwrap()
    };
    let [few, many] =
        [of(2), of(25_000)].map(|u| u.dual_norm(DualOf::Interpolation, 0.5, 1e-8).unwrap());
    assert!((few.value - many.value).abs() <= few.error + many.error, "{few} {many}");
}

#[test]
fn faults_are_refused() {
    let mesh = || uniform(2);
    let crossed = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
    let meshes = [mesh(), mesh(), mesh(), mesh()];
    assert!(matches!(Curve::closed(&crossed, &meshes), Err(Error::Edge { .. })));
    let spike = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.0], [0.5, 1.0]];
    assert!(matches!(Curve::open(&spike, &meshes[..3]), Err(Error::EntryOutOfRange { .. })));
    let point = [[0.0, 0.0], [0.0, 0.0], [0.5, 1.0]];
    assert!(matches!(Curve::open(&point, &meshes[..2]), Err(Error::EntryOutOfRange { .. })));
    assert!(matches!(Curve::closed(&SQUARE, &meshes[..3]), Err(Error::LengthMismatch { .. })));
    let bad = [[0.0, 0.0], [f64::NAN, 0.0], [0.5, 1.0]];
    assert!(matches!(Curve::closed(&bad, &meshes[..3]), Err(Error::NotFinite { .. })));
    assert!(Curve::closed(&SQUARE[..2], &meshes[..2]).is_err());
    assert!(Curve::closed(&SQUARE.map(|vertex| vertex.map(|x| 1e-200 * x)), &meshes).is_ok());
    assert!(Curve::algebraic(&SQUARE, 3, 1.0).is_err());
    let curve = Curve::closed(&SQUARE, &meshes).unwrap();
    assert!(Function::on_curve(&curve, 1, &[0.0; 9]).is_err());
    assert!(Function::on_curve(&curve, 0, &[f64::INFINITY; 8]).is_err());
    let zero = Function::on_curve(&curve, 0, &[0.0; 8]).unwrap();
    assert_eq!(zero.seminorm(order(0.7), Tolerance::fast()).unwrap().value, 0.0);
    assert_eq!(zero.norm(-order(0.7), Tolerance::fast()).unwrap().value, 0.0);
}

/// r^{2/3} sin(2θ/3) on the boundary of an L: its seminorm of order 1/2 to ten digits, that of its interpolants tends to it
/// from above, and lengths of 1e±200 leave the digits.
#[test]
fn a_corner_function_on_an_l_has_ten_digits() {
    let l = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [0.0, -1.0]];
    let corner = |[x, y]: [f64; 2]| {
        let angle = y.atan2(x).rem_euclid(TAU);
        x.hypot(y).powf(2.0 / 3.0) * (2.0 * angle / 3.0).sin()
    };
    let found = Function::on_polygon(&l, corner).unwrap().seminorm(0.5, 1e-10).unwrap();
    assert!(
        (found.value - 3.577_137_929_2).abs() < 1e-10 && found.relative_error() < 1e-10,
        "{found}"
    );
    let at = |n: usize| interpolate(Curve::algebraic(&l, n, 4.0).unwrap(), corner).unwrap();
    let off = [32, 64, 128].map(|n| at(n).seminorm(0.5, 1e-9).unwrap().value / found.value - 1.0);
    assert!(off[2].abs() < 1e-4 && off[0] / off[1] > 2.5 && off[1] / off[2] > 2.5, "{off:?}");
    for unit in [1e-200, 1e200] {
        let far = l.map(|vertex| vertex.map(|x| unit * x));
        let u = Function::on_polygon(&far, |[x, y]| corner([x / unit, y / unit])).unwrap();
        assert!((u.seminorm(0.5, 1e-10).unwrap().value / found.value - 1.0).abs() < 1e-10);
        assert!(
            (u.norm(0.0, 1e-10).unwrap().value / unit.sqrt() / 1.901_276_617_695_32 - 1.0).abs()
                < 1e-9
        );
    }
}

/// x on any polygon with the symmetry of the diagonal: |x|² = L²/2 at order 1/2; constants have no seminorm; a jump at a vertex
/// is an error at order 1/2, and a kink inside a side one with its best value.
#[test]
fn formulas_on_polygons_agree_with_closed_forms_or_are_refused() {
    let x = Function::on_polygon(&SQUARE, |[x, _]| x).unwrap();
    assert!((x.seminorm(0.5, 1e-12).unwrap().value.powi(2) / 8.0 - 1.0).abs() < 1e-12);
    let hat = Function::on_polygon(&SQUARE, |[x, y]| (1.0 - x - y).max(0.0)).unwrap();
    let linears = Curve::closed(&SQUARE, &vec![uniform(1); 4]).unwrap();
    let same = Function::on_curve(&linears, 1, &[1.0, 0.0, 0.0, 0.0]).unwrap();
    for nu in [0.1, 0.5, 0.9] {
        let [a, b] = [&hat, &same].map(|u| u.norm(nu, 1e-10).unwrap());
        assert!((a.value - b.value).abs() <= a.error + b.error, "{nu}: {a} {b}");
    }
    let one = Function::on_polygon(&SQUARE, |_| 3.0).unwrap();
    assert!(
        one.seminorm(0.5, 1e-8).unwrap().value == 0.0
            && (one.norm(0.5, 1e-8).unwrap().value - 6.0).abs() < 1e-12
    );
    let kink = |[x, y]: [f64; 2]| (x - 0.3).abs() + y;
    let jump = |[x, y]: [f64; 2]| f64::from(y == 0.0 && x > 0.0 && x < 1.0);
    let few = Tolerance::new(1e-8).unwrap().with_work(1 << 22);
    let refused = Function::on_polygon(&SQUARE, jump).unwrap().seminorm(0.5, few);
    let is_named = |e: &Error| {
        matches!(e, Error::InfiniteNorm { .. } | Error::ToleranceNotMet { best: Some(_), .. })
    };
    assert!(refused.as_ref().is_err_and(is_named), "{refused:?}");
    let refused = Function::on_polygon(&SQUARE, kink).unwrap().seminorm(0.5, few);
    assert!(matches!(refused, Err(Error::ToleranceNotMet { best: Some(_), .. })), "{refused:?}");
    // With the kink as a vertex every digit is there.
    let kinked = [[0.0, 0.0], [0.3, 0.0], [1.0, 0.0], [1.0, 1.0], [0.3, 1.0], [0.0, 1.0]];
    let right = Function::on_polygon(&kinked, kink).unwrap().seminorm(0.5, 1e-9).unwrap();
    let best = Estimate::or_best(refused).unwrap();
    assert!((best.value - right.value).abs() <= best.error + right.error, "{best} {right}");
    // r^{3/10} is in H^s for s < 4/5. At another vertex than the origin its coordinates hide 1e-9 of it.
    let power = |[x, y]: [f64; 2]| x.hypot(y).powf(0.3);
    let limit = Function::on_polygon(&SQUARE, power).unwrap();
    let endless = limit.seminorm(0.85, few.with_work(1 << 25));
    assert!(matches!(endless, Err(Error::InfiniteNorm { .. })), "{endless:?}");
    let exact = limit.seminorm(0.5, 1e-10).unwrap();
    let moved = SQUARE.map(|[x, y]| [x + 3.0 / 7.0, y + 5.0 / 7.0]);
    let moved =
        Function::on_polygon(&moved, |[x, y]| power([x - 3.0 / 7.0, y - 5.0 / 7.0])).unwrap();
    for tolerance in [1e-4, 1e-8, 1e-10] {
        let found = Estimate::or_best(moved.seminorm(0.5, tolerance)).unwrap();
        assert!(
            (found.value - exact.value).abs() <= found.error + exact.error,
            "{tolerance}: {found} {exact}"
        );
    }
    assert!(moved.seminorm(0.5, 1e-10).is_err());
    assert!(
        Function::on_polygon(&SQUARE, |[x, _]| 1.0 / (x - x)).unwrap().norm(0.5, 1e-6).is_err()
    );
}

/// ∫ f over (0, 1) by Gauss's rule.
fn over_side(f: impl Fn(f64) -> f64) -> f64 {
    fractional_sobolev::gauss_legendre(40).unwrap().integrate(f)
}

#[test]
fn formulas_on_polygons_have_derivatives_along_the_boundary() {
    let within = |found: Estimate, exact: f64, asked: f64| {
        let off = (found.value - exact).abs();
        assert!(off <= found.error && found.error <= asked * exact, "{found} {exact}");
    };
    // x is linear on the sides: the same function by its values, of which the derivative is constant on every side
    let x = Function::on_polygon(&SQUARE, |[x, _]| x).unwrap();
    let by_values = interpolate(Curve::algebraic(&SQUARE, 2, 1.0).unwrap(), |[x, _]| x).unwrap();
    within(x.norm(1.0, 1e-10).unwrap(), (5.0f64 / 3.0 + 2.0).sqrt(), 1e-10);
    for (order, asked) in [(1.1, 1e-7), (1.3, 1e-5)] {
        let [found, exact] = [&x, &by_values].map(|u| u.norm(order, asked).unwrap());
        assert!((found.value - exact.value).abs() <= found.error + exact.error, "{found} {exact}");
    }
    // u′ jumps at the vertices.
    let few = Tolerance::new(1e-6).unwrap().with_work(1 << 22);
    assert!(x.norm(1.5, few).is_err());
    // a smooth function, by the derivative in closed form
    let waves = Function::on_polygon(&SQUARE, |[x, y]| (3.0 * x + 2.0 * y).sin()).unwrap();
    let square = over_side(|t| {
        let legs = [3.0 * (3.0 * t).cos(), 2.0 * (3.0 + 2.0 * t).cos()];
        let back = [3.0 * (3.0 * t + 2.0).cos(), 2.0 * (2.0 * t).cos()];
        [legs, back].as_flattened().iter().map(|v| v * v).sum()
    });
    within(waves.seminorm(1.0, 1e-9).unwrap(), square.sqrt(), 1e-9);
    // r^0.8 at a vertex, and its derivative as another formula; with another value at the vertex digits are lost
    let slope = |[x, y]: [f64; 2]| {
        let far = |t: f64| 0.8 * t * (1.0 + t * t).powf(-0.6);
        match (x, y) {
            (_, 0.0) => 0.8 * x.powf(-0.2),
            (0.0, _) => -0.8 * y.powf(-0.2),
            (1.0, _) => far(y),
            _ => -far(x),
        }
    };
    let slope = Function::on_polygon(&SQUARE, slope).unwrap();
    for (shift, asked) in [(0.0, 1e-6), (1.0, 1e-2)] {
        let power = Function::on_polygon(&SQUARE, |[x, y]| shift + x.hypot(y).powf(0.8)).unwrap();
        let exact = slope.norm(0.0, 1e-9).unwrap();
        within(power.seminorm(1.0, asked).unwrap(), exact.value, asked);
    }
    let power = Function::on_polygon(&SQUARE, |[x, y]| x.hypot(y).powf(0.8)).unwrap();
    let exact = slope.seminorm(0.2, 1e-2).unwrap();
    let found = power.seminorm(1.2, 1e-2).unwrap();
    assert!((found.value - exact.value).abs() <= found.error + exact.error, "{found} {exact}");
    assert!(power.seminorm(1.35, few).is_err());
    // functions that jump, at a vertex or in the middle of a side, have no derivative in L², nor have roots
    let steps: [fn([f64; 2]) -> f64; 2] =
        [|[_, y]| if y == 0.0 { 1.0 } else { 0.0 }, |[x, _]| if x < 0.5 { 1.0 } else { 0.0 }];
    for step in steps {
        for order in [1.0, 1.2] {
            let refused = Function::on_polygon(&SQUARE, step).unwrap().norm(order, 1e-3);
            assert!(
                matches!(refused, Err(Error::InfiniteNorm { order: found, .. }) if found == order)
            );
        }
    }
    let corner = |a: f64| move |[x, y]: [f64; 2]| x.hypot(y).powf(a);
    assert!(Function::on_polygon(&SQUARE, corner(0.4)).unwrap().norm(1.0, 1e-6).is_err());
}

#[test]
fn dual_norms_of_formulas_on_polygons() {
    // ∫ v / ‖v‖ is largest for v = 1
    let one = Function::on_polygon(&SQUARE, |_| 1.0).unwrap();
    for order in [-0.2, -0.5, -0.8] {
        let found = one.norm(order, 1e-9).unwrap();
        assert!((found.value - 2.0).abs() <= found.error && found.error < 1e-8, "{found}");
    }
    // the same linear function by its values on another mesh
    let x = Function::on_polygon(&SQUARE, |[x, _]| x).unwrap();
    let graded = Curve::algebraic(&SQUARE, 10, 2.0).unwrap();
    let by_values = interpolate(graded, |[x, _]| x).unwrap();
    for order in [-0.3, -0.5] {
        let [found, exact] = [&x, &by_values].map(|u| u.norm(order, 1e-5).unwrap());
        let off = (found.value - exact.value).abs();
        assert!(off <= found.error + exact.error, "{order}: {found} {exact}");
    }
    // r^{−0.4} and its means on the elements of a graded mesh: the norms differ by at most ‖f − f_h‖, ‖f_h‖² = ‖f‖² −
    // ‖f − f_h‖²
    let power = Function::on_polygon(&SQUARE, |[x, y]| x.hypot(y).powf(-0.4)).unwrap();
    let mesh = Mesh::geometric(85, 0.6, 1.0).unwrap();
    let mirrored = Mesh::from_lengths(&mesh.lengths().iter().rev().copied().collect::<Vec<_>>());
    let plain = uniform(30);
    let meshes = [mesh.clone(), plain.clone(), plain, mirrored.unwrap()];
    let curve = Curve::closed(&SQUARE, &meshes).unwrap();
    let nodes = mesh.nodes();
    let of_power =
        |pair: &[f64]| (pair[1].powf(0.6) - pair[0].powf(0.6)) / 0.6 / (pair[1] - pair[0]);
    let near: Vec<f64> = nodes.windows(2).map(of_power).collect();
    let mean = |k: usize| over_side(|t| (1.0 + ((k as f64 + t) / 30.0).powi(2)).powf(-0.2));
    let far: Vec<f64> = (0..30).map(mean).collect();
    let back = |all: &[f64]| all.iter().rev().copied().collect::<Vec<f64>>();
    let means = [near.clone(), far.clone(), back(&far), back(&near)].concat();
    let projected = Function::on_curve(&curve, 0, &means).unwrap();
    let size = 2.0 / 0.2 + 2.0 * over_side(|t| (1.0 + t * t).powf(-0.4));
    let apart = (size - projected.norm(0.0, 1e-12).unwrap().value.powi(2)).sqrt();
    for order in [-0.3, -0.6] {
        let [found, exact] = [&power, &projected].map(|u| u.norm(order, 1e-4).unwrap());
        let off = (found.value - exact.value).abs();
        // f − f_h is orthogonal to constants on the elements, which makes its dual norm smaller than its L² norm.
        assert!(off <= found.error + exact.error + apart * 0.1f64.powf(-order), "{found} {exact}");
        assert!(apart < 0.2 * exact.value, "{apart}");
    }
    // not in L², but a functional on H^{1/2}
    let strong = Function::on_polygon(&SQUARE, |[x, y]| x.hypot(y).powf(-0.6)).unwrap();
    assert!(strong.norm(0.0, 1e-3).is_err());
    let found = strong.norm(-0.5, 1e-3).unwrap();
    assert!(found.value > power.norm(-0.5, 1e-3).unwrap().value);
    let refused = strong.dual_norm(DualOf::Interpolation, 0.5, 1e-3).unwrap_err().to_string();
    assert!(refused.contains("Slobodeckij"), "{refused}");
}
