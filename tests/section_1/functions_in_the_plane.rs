//! Section 1 in the plane: closures against polar coordinates, against norms of piecewise linears and
//! constants, down to 1e-100.

use crate::common::SplitMix;
use crate::plane_polar::Star;
use fractional_sobolev::{Error, Estimate, Function, Order, PlanePosition, Tolerance, Triangles};
use std::f64::consts::PI;

/// Two computations.
const TWO_ROADS: f64 = 1e-8;

type Points = Vec<[f64; 2]>;

fn polar(angle: f64, r: f64) -> [f64; 2] {
    [r * angle.cos(), r * angle.sin()]
}

fn l_shape() -> Points {
    vec![[1.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [0.0, -1.0]]
}

/// Three wedges and the L-shape with their angles.
fn polygons() -> Vec<(Points, f64)> {
    let wide =
        [0.0, 70.0, 150.0].map(|degrees: f64| polar(degrees.to_radians(), 1.0 + 0.002 * degrees));
    vec![
        (vec![[1.0, 0.0], [0.7, 0.9]], 0.9f64.atan2(0.7)),
        (vec![[1.0, 0.0], [0.0, 1.0]], 0.5 * PI),
        (wide.to_vec(), 5.0 / 6.0 * PI),
        (l_shape(), 1.5 * PI),
    ]
}

/// r^a sin(bφ) at corner 0.
fn power(a: f64, b: f64) -> impl Fn(&PlanePosition<'_>) -> f64 + Sync {
    move |at| at.radius(0).powf(a) * (b * at.angle(0)).sin()
}

fn seminorm(w: &Function<'_>, s: f64, tolerance: f64) -> fractional_sobolev::Result<Estimate> {
    w.seminorm(Order::new(s)?, Tolerance::new(tolerance)?)
}

fn off(found: Estimate, exact: f64) -> f64 {
    (found.value / exact - 1.0).abs()
}

#[test]
fn two_computations_agree_up_to_the_limit_of_finiteness() {
    let mut worst = 0.0f64;
    let cases = [(1.2, 0.3), (1e-2, 0.7), (1e-3, 0.6), (1e-6, 0.4)];
    for (number, (points, angle)) in polygons().into_iter().enumerate() {
        // Two of the four for each polygon, and all four where there is time.
        for (gap, s) in cases.into_iter().skip(number % 2).step_by(if crate::MANY { 1 } else { 2 })
        {
            let (a, b) = (gap + s - 1.0, PI / angle);
            let star = Triangles::star(&points).unwrap();
            let other = Star::new(&points).squared(a, b, s).sqrt();
            let cut = (gap < 0.1 && gap > 1e-4).then(|| star.cut_at(0, 0.45).unwrap());
            for mesh in std::iter::once(star).chain(cut) {
                let w = Function::from_plane_positions(&mesh, &[(0, a)], power(a, b)).unwrap();
                let found = seminorm(&w, s, 1e-8).unwrap();
                let difference = off(found, other);
                assert!(
                    difference < TWO_ROADS,
                    "{angle} {gap} {s}: {found} {other} {difference:e}"
                );
                worst = worst.max(difference);
            }
        }
    }
    // A frequency that is off by 1e-6 is seen.
    let (points, star) = (&polygons()[0].0, Star::new(&polygons()[0].0));
    let w = Function::from_plane_positions(
        &Triangles::star(points).unwrap(),
        &[(0, 0.4)],
        power(0.4, 2.0),
    )
    .unwrap();
    let wrong = off(seminorm(&w, 0.6, 1e-8).unwrap(), star.squared(0.4, 2.0 + 2e-6, 0.6).sqrt());
    println!("two computations: {worst:.1e}, a wrong frequency: {wrong:.1e}");
    assert!(wrong > 10.0 * TWO_ROADS);
}

/// The second computation of the norms of piecewise functions: by quadrature of a formula, which knows no elements.
#[test]
fn piecewise_linears_and_steps_have_their_norms() {
    (5..if crate::MANY { 25 } else { 8 }).for_each(piecewise_functions_on_a_random_mesh);
}

fn piecewise_functions_on_a_random_mesh(seed: u64) {
    let mut random = SplitMix::new(seed);
    let squares = [1 + random.below(3), 1 + random.below(2)];
    let moved = |p: [f64; 2]| p.map(|x| x + random.between(-0.08, 0.08));
    let mesh = Triangles::grid(squares, 0.5).unwrap().mapped(moved).unwrap();
    let nodes = mesh.nodes().to_vec();
    let values: Vec<f64> = nodes.iter().map(|p| (3.0 * p[0]).sin() + p[1] * p[0]).collect();
    let linear = Function::on_triangles(&mesh, 1, &values).unwrap();
    let steps: Vec<f64> = (0..mesh.triangles().len()).map(|k| (k as f64).sin()).collect();
    let step = Function::on_triangles(&mesh, 0, &steps).unwrap();
    let cross = |u: [f64; 2], v: [f64; 2], w: [f64; 2]| {
        (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0])
    };
    let at_corners = |at: &PlanePosition<'_>| {
        let [a, b, c] = mesh.triangles()[at.triangle()];
        let (p, q, r, x) = (nodes[a], nodes[b], nodes[c], at.x());
        let parts =
            cross(x, q, r) * values[a] + cross(p, x, r) * values[b] + cross(p, q, x) * values[c];
        parts / cross(p, q, r)
    };
    let smooth = Function::from_plane_positions(&mesh, &[], at_corners).unwrap();
    let jumping = || Function::from_plane_positions(&mesh, &[], |at| steps[at.triangle()]).unwrap();
    let jumps = jumping();
    let of = |known: &Function<'_>, w: &Function<'_>, s: f64| {
        let order = Order::new(s).unwrap();
        let exact = known.seminorm(order, Tolerance::new(1e-12).unwrap()).unwrap();
        let found = seminorm(w, s, 1e-9).unwrap();
        let difference = off(found, exact.value);
        assert!(
            difference <= found.relative_error() + exact.relative_error(),
            "{s}: {found} {exact}"
        );
    };
    [0.05, 0.5, 0.75, 1.0 - 1e-8].into_iter().for_each(|s| of(&linear, &smooth, s));
    [0.05, 0.3, 0.5 - 1e-9].into_iter().for_each(|s| of(&step, &jumps, s));
    for (known, w) in [(&linear, &smooth), (&step, &jumps)] {
        let found = w.norm(0.0, Tolerance::new(1e-11).unwrap()).unwrap();
        assert!(off(found, known.norm(0.0, 1e-12).unwrap().value) < 1e-12);
    }
    let error = seminorm(&jumps, 0.5, 1e-4).unwrap_err();
    assert!(
        matches!(error, Error::InfiniteNorm { .. }) && error.to_string().contains("s >= 1/2"),
        "{error}"
    );
    assert!(jumps.with_gradient(vec![jumping(), jumping()]).norm(1.3, Tolerance::fast()).is_err());
}

#[test]
fn norms_of_order_one_and_more_take_the_gradient() {
    // r^p sin(pφ), p = 5/3, on the L-shape: its gradient is p r^{p−1} (sin, cos) of (p−1)φ.
    let p = 5.0 / 3.0;
    let mesh = Triangles::star(&l_shape()).unwrap();
    let part = |shift: f64| {
        let of = move |at: &PlanePosition<'_>| {
            p * at.radius(0).powf(p - 1.0) * ((p - 1.0) * at.angle(0) + shift).sin()
        };
        Function::from_plane_positions(&mesh, &[(0, p - 1.0)], of).unwrap()
    };
    let w = Function::from_plane_positions(&mesh, &[(0, p)], power(p, p)).unwrap();
    let w = w.with_gradient(vec![part(0.0), part(0.5 * PI)]);
    let (order, asked) = (Order::new(0.4).unwrap(), Tolerance::new(1e-7).unwrap());
    let gradient = [part(0.0), part(0.5 * PI)];
    let norm = w.norm(order.plus_one(), asked).unwrap().value;
    let l2 = |w: &Function<'_>| w.norm(0.0, asked).unwrap().value.powi(2);
    let half = |w: &Function<'_>| w.norm(order, asked).unwrap().value.powi(2);
    let sum = l2(&w) + gradient.iter().map(half).sum::<f64>();
    assert!((norm * norm / sum - 1.0).abs() < 1e-6);
}

#[test]
fn estimates_are_honest() {
    let mut random = SplitMix::new(77);
    let (mut worst, mut loose, cases) = (0.0f64, 0, if crate::MANY { 16 } else { 6 });
    for case in 0..cases {
        let parts = 1 + random.below(3);
        let step = random.between(0.5, 1.2);
        let points: Points =
            (0..=parts).map(|k| polar(step * k as f64, random.between(0.7, 1.4))).collect();
        let s = random.between(0.1, 0.9);
        let a = s - 1.0 + 10f64.powf(random.between(-3.0, 0.2));
        let (b, c, d) =
            (random.between(0.5, 3.0), random.between(0.0, 2.0), random.between(0.0, 3.0));
        let of = |at: &PlanePosition<'_>| {
            let (r, phi) = (at.radius(0), at.angle(0));
            r.powf(a) * ((b * phi).sin() + c * (d * r).cos())
        };
        let star = Triangles::star(&points).unwrap();
        let mesh =
            if case % 3 == 0 { star.cut_at(0, random.between(0.3, 0.7)).unwrap() } else { star };
        let w = Function::from_plane_positions(&mesh, &[(0, a)], of).unwrap();
        let found = seminorm(&w, s, 10f64.powf(random.between(-5.0, -1.5))).unwrap();
        let exact = seminorm(&w, s, 1e-8).unwrap();
        let quotient = (found.value - exact.value).abs() / (found.error + exact.error);
        assert!(quotient <= 1.0, "{case}: {found} {exact}");
        worst = worst.max(quotient);
        loose += usize::from(quotient > 1e-3);
    }
    println!("largest error over estimate {worst:.2}, above 1e-3 in {loose} of {cases}");
}

#[test]
fn distances_from_a_corner_are_exact_down_to_1e_100() {
    let points = [[1.0, 0.0], [0.7, 0.9]];
    let a = -0.365;
    let star = |l: f64| Triangles::star(&points).unwrap().mapped(|p| p.map(|x| l * x)).unwrap();
    // |w(·/l)|_s = l^{1−s}|w|_s.
    let scaled = |l: f64| {
        let of = |at: &PlanePosition<'_>| (at.radius(0) / l).powf(a) * (2.0 * at.angle(0)).sin();
        seminorm(&Function::from_plane_positions(&star(l), &[(0, a)], of).unwrap(), 0.3, 1e-8)
            .unwrap()
            .value
    };
    for l in [1e-100f64, 1e100] {
        assert!((scaled(l) / scaled(1.0) / l.powf(0.7) - 1.0).abs() < 1e-13);
    }
    // The corner elsewhere, turned: the same norm, which distances that are rounded would not give.
    let turned =
        star(1.0).mapped(|[x, y]| [3.0 + 0.6 * x - 0.8 * y, -2.0 + 0.8 * x + 0.6 * y]).unwrap();
    let w = Function::from_plane_positions(&turned, &[(0, a)], power(a, 2.0)).unwrap();
    assert!((seminorm(&w, 0.3, 1e-8).unwrap().value / scaled(1.0) - 1.0).abs() < 1e-12);
}

#[test]
fn what_cannot_be_is_an_error() {
    let star = || Triangles::star(&[[1.0, 0.0], [0.0, 1.0]]).unwrap();
    let declared = |corners: &[(usize, f64)]| {
        Function::from_plane_positions(&star(), corners, |_| 1.0).map(|_| ())
    };
    assert!(matches!(declared(&[(0, -1.0)]), Err(Error::OutOfRange { .. })));
    assert!(matches!(declared(&[(0, f64::NAN)]), Err(Error::OutOfRange { .. })));
    assert!(matches!(declared(&[(7, 0.5)]), Err(Error::Node { .. })));
    assert!(matches!(declared(&[(0, 0.5), (0, 0.5)]), Err(Error::Node { .. })));
    assert!(matches!(declared(&[(0, 0.5), (1, 0.5)]), Err(Error::Triangle { .. })));
    assert!(matches!(star().cut_at(0, 1.0), Err(Error::OutOfRange { .. })));
    let nan = Function::from_plane_positions(&star(), &[], |at| (at.x()[0] - 0.5).sqrt());
    assert!(matches!(nan.map(|_| ()), Err(Error::NotFinite { .. })));
    let w = |a: f64| Function::from_plane_positions(&star(), &[(0, a)], power(a, 2.0)).unwrap();
    for (a, s) in [(-0.3, 0.7), (-0.5, 0.5), (-0.9, 0.2)] {
        let error = seminorm(&w(a), s, 1e-4).unwrap_err();
        assert!(
            matches!(error, Error::InfiniteNorm { .. }) && error.to_string().contains("a > s - 1"),
            "{error}"
        );
    }
    // What is rougher than declared is not believed, nor a corner that was not declared.
    let rough = Function::from_plane_positions(&star(), &[(0, 0.5)], power(-0.8, 2.0)).unwrap();
    let hidden =
        Function::from_plane_positions(&star(), &[], |at| at.x()[0].hypot(at.x()[1]).powf(-0.25))
            .unwrap();
    for w in [&rough, &hidden] {
        assert!(matches!(
            seminorm(w, 0.7, 1e-6),
            Err(Error::ToleranceNotMet { .. } | Error::NotFinite { .. })
        ));
    }
    let constant = Function::from_plane_positions(&star(), &[], |_| 3.0).unwrap();
    assert_eq!(seminorm(&constant, 0.7, 1e-6).unwrap().value, 0.0);
}
