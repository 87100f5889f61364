//! Every verb of a function on an interval for every way to make one, and which norms every kind of function has.

use crate::common::SplitMix;
use fractional_sobolev::{
    Constraint, Curve, DualOf, Error, Estimate, Function, Mesh, PlanePosition, Result, Triangles,
    gamma,
};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A function on (0, 1), with a formula for its values.
struct Made {
    by: &'static str,
    u: Function<'static>,
    values: Box<dyn Fn(f64) -> f64>,
}

fn kink(x: f64) -> f64 {
    (x - 0.3).abs()
}

fn hat(x: f64) -> f64 {
    if x < 0.25 { 4.0 * x } else { (1.0 - x) / 0.75 }
}

fn hats() -> Result<Function<'static>> {
    Function::linears(&Mesh::from_nodes(&[0.0, 0.25, 1.0])?, &[0.0, 1.0, 0.0])
}

fn formula(f: fn(f64) -> f64, breaks: &[f64]) -> Result<Function<'static>> {
    Function::from_fn(breaks, f)
}

/// One function for every constructor and for every verb that makes a function.
fn made() -> Result<Vec<Made>> {
    let ends = [0.0, 1.0];
    let sine = || formula(f64::sin, &ends);
    let bent = || formula(kink, &[0.0, 0.3, 1.0]);
    let cubic = |x: f64| x * x * (1.0 - x);
    let nodes: Vec<f64> = (0..=9).map(|k| f64::from(k) / 9.0).collect();
    let thirds: Vec<f64> = (0..3).flat_map(|k| nodes[3 * k..3 * k + 4].to_vec()).collect();
    let at_thirds: Vec<f64> = thirds.iter().map(|&x| cubic(x)).collect();
    let extremal = gamma(0.5, Constraint::mean_zero_on(0.0..0.25), 1e-4)?.extremal()?;
    let interpolant = extremal.interpolate(4, 1, &[0.25])?;
    let of_extremal = interpolant.scaled(1.0)?;
    let values_of_extremal = move |x: f64| interpolant.value(x).unwrap().value;
    let mut all: Vec<Made> = Vec::new();
    let mut add = |by, u: Result<Function<'static>>, values: Box<dyn Fn(f64) -> f64>| {
        all.push(Made { by, u: u?, values });
        Ok::<_, Error>(())
    };
    add("from_fn", sine(), Box::new(f64::sin))?;
    add("from_fn with a breakpoint", bent(), Box::new(kink))?;
    add("from_fn with a kink", formula(kink, &ends), Box::new(kink))?;
    add(
        "from_positions",
        Function::from_positions(&[0.0, 0.3, 1.0], |at| 2.0 + at.distance_to(1).powf(1.7)),
        Box::new(|x| 2.0 + kink(x).powf(1.7)),
    )?;
    add("power", Function::power(2.5), Box::new(|x| x.powf(2.5)))?;
    add("linears", hats(), Box::new(hat))?;
    add("piecewise", Function::piecewise(&Mesh::uniform(3, 1.0)?, 3, &at_thirds), Box::new(cubic))?;
    add("interpolate", Function::interpolate(&Mesh::uniform(2, 1.0)?, 3, cubic), Box::new(cubic))?;
    add("an extremal function", Ok(of_extremal), Box::new(values_of_extremal))?;
    add("formula minus values", sine()?.minus(&hats()?), Box::new(|x| x.sin() - hat(x)))?;
    add("values minus formula", hats()?.minus(&bent()?), Box::new(|x| hat(x) - kink(x)))?;
    add("formula plus formula", sine()?.plus(&bent()?), Box::new(|x| x.sin() + kink(x)))?;
    let square = Function::interpolate(&Mesh::uniform(3, 1.0)?, 2, |x| x * x)?;
    add("values plus values", hats()?.plus(&square), Box::new(|x| hat(x) + x * x))?;
    add("formula times formula", bent()?.times(&sine()?), Box::new(|x| x.sin() * kink(x)))?;
    add("formula times values", bent()?.times(&hats()?), Box::new(|x| kink(x) * hat(x)))?;
    add(
        "a multiple",
        sine()?.minus(&hats()?)?.scaled(-2.0),
        Box::new(|x| 2.0 * (hat(x) - x.sin())),
    )?;
    let slope = formula(|x| 0.5 * x * x, &ends)?.derivative();
    add("a derivative", slope, Box::new(|x| x))?;
    let wide = formula(|x| (x - 0.5).exp(), &[-1.0, 2.0])?;
    add("a restriction", wide.restrict(0.0..1.0), Box::new(|x| (x - 0.5).exp()))?;
    Ok(all)
}

/// ∫ f over (0, 1) by the midpoint rule between the places where functions here are not smooth, extrapolated.
fn integral(f: impl Fn(f64) -> f64) -> f64 {
    let mut nodes: Vec<f64> = (0..=36).map(|k| f64::from(k) / 36.0).collect();
    nodes.extend([0.3, 0.01, 1e-3]);
    nodes.sort_by(f64::total_cmp);
    let rule = fractional_sobolev::gauss_legendre(20).unwrap();
    nodes
        .windows(2)
        .map(|pair| (pair[1] - pair[0]) * rule.integrate(|t| f(pair[0] + (pair[1] - pair[0]) * t)))
        .sum()
}

#[track_caller]
fn agrees(by: &str, verb: &str, found: Result<Estimate>, exact: f64, slack: f64) {
    let found = found.unwrap_or_else(|error| panic!("{verb} of {by}: {error}"));
    let off = (found.value - exact).abs();
    assert!(off <= found.error + slack, "{verb} of {by}: {found}, {exact}");
}

#[test]
fn every_verb_is_there_for_every_constructor() -> Result<()> {
    let asked = 1e-7;
    let one = Function::from_fn(&[0.0, 1.0], |_| 1.0)?;
    for Made { by, u, values } in made()? {
        for x in [0.013, 0.299, 0.31, 0.77] {
            agrees(by, "value", u.value(x), values(x), 1e-12);
        }
        agrees(by, "value_near", u.value_near(0, 1e-3), values(1e-3), 1e-12);
        let slope = u.derivative()?;
        let [a, b] = [0.41, 0.43];
        // ∫ u′ = u(b) − u(a)
        let step = slope.restrict(a..b)?.mean(asked)?.times(b - a);
        agrees(by, "derivative and restrict", step, values(b) - values(a), 1e-9);
        let sum = u.plus(&one)?;
        agrees(by, "plus", sum.value(0.6), values(0.6) + 1.0, 1e-12);
        agrees(by, "minus", one.minus(&u)?.value(0.6), 1.0 - values(0.6), 1e-12);
        agrees(by, "times", u.times(&u)?.value(0.6), values(0.6).powi(2), 1e-12);
        agrees(by, "scaled", u.scaled(-3.0)?.value(0.6), -3.0 * values(0.6), 1e-12);
        let square = integral(|x| values(x).powi(2));
        // Extremal functions have graded cells that this rule does not know.
        let slack = if by.contains("extremal") { 1e-5 } else { 1e-11 };
        agrees(by, "norm of order 0", u.norm(0.0, asked), square.sqrt(), slack);
        agrees(by, "lp", u.lp(4.0, asked), integral(|x| values(x).powi(4)).powf(0.25), slack);
        agrees(by, "mean", u.mean(asked), integral(&values), slack);
        agrees(by, "inner", u.inner(&one, 0.0, asked), integral(&values), slack);
        let largest = (0..=4000).map(|k| values(f64::from(k) / 4000.0).abs()).fold(0.0, f64::max);
        agrees(by, "max", u.lp(f64::INFINITY, asked), largest, 1e-3);
        // The seminorm of u + 1 is that of u, by other polynomials or another formula.
        let own = u.seminorm(0.4, asked)?;
        let other = sum.seminorm(0.4, asked)?;
        agrees(by, "seminorm", Ok(own), other.value, other.error);
        let whole = own.value.hypot(square.sqrt());
        agrees(by, "norm", u.norm(0.4, asked), whole, own.error + slack);
        let dual = u.dual_norm(DualOf::Interpolation, 0.4, asked)?;
        assert!(dual.value <= square.sqrt() + slack, "dual norm of {by}: {dual}, {square}");
        let first = slope.lp(2.0, asked)?;
        agrees(by, "seminorm of order 1", u.seminorm(1.0, asked), first.value, first.error);
        agrees(
            by,
            "norm of order 1.2",
            u.norm(1.2, 1e-6),
            {
                let top = slope.norm(0.2, 1e-6)?;
                top.value.hypot(square.sqrt())
            },
            1e-4 * (1.0 + first.value),
        );
    }
    Ok(())
}

#[test]
fn a_second_norm_of_polynomials_takes_no_values_of_the_function() -> Result<()> {
    let count = AtomicUsize::new(0);
    // a kink that is not declared
    let u = Function::from_fn(&[0.0, 1.0], |x| {
        count.fetch_add(1, Ordering::Relaxed);
        (x - 0.3217).abs()
    })?;
    let slope = u.derivative()?;
    let first = count.load(Ordering::Relaxed);
    assert!(first > 0 && (slope.value(0.7)?.value - 1.0).abs() < 1e-10);
    for order in [0.3, 0.45] {
        slope.norm(order, 1e-6)?;
    }
    u.norm(0.45, 1e-6)?;
    assert_eq!(count.load(Ordering::Relaxed), first, "values taken again");
    u.seminorm(1.0, 1e-6)?;
    u.norm(1.2, 1e-6).ok();
    u.restrict(0.1..0.9)?;
    let plain = Function::linears(&Mesh::uniform(5, 1.0)?, &[1.0; 6])?;
    u.times(&plain)?.norm(0.4, 1e-6)?;
    println!("{first} values of the function for the polynomials");
    Ok(())
}

#[test]
fn a_singular_end_is_sampled_once_for_all_norms() -> Result<()> {
    let power = |at: fractional_sobolev::Position| at.distance_to(0).powf(0.4);
    let deep = |at: fractional_sobolev::Position| match at.anchor() {
        0 => (0.4 * at.log_distance()).exp(),
        _ => at.x().powf(0.4),
    };
    let inside = |at: fractional_sobolev::Position| at.distance_to(1).powf(0.4);
    let count = AtomicUsize::new(0);
    let counted = |value: f64| {
        count.fetch_add(1, Ordering::Relaxed);
        value
    };
    let all = [
        ("x^0.4", Function::from_positions(&[0.0, 1.0], |at| counted(power(at)))?),
        ("by its logarithm", Function::from_log_distances(&[0.0, 1.0], |at| counted(deep(at)))?),
        ("|x - 0.3|^0.4", Function::from_positions(&[0.0, 0.3, 1.0], |at| counted(inside(at)))?),
        (
            "|x - 0.3|^0.4 of x",
            Function::from_fn(&[0.0, 0.3, 1.0], |x| counted((x - 0.3).abs().powf(0.4)))?,
        ),
    ];
    for (name, u) in &all {
        count.store(0, Ordering::Relaxed);
        // The largest order needs the smallest distances.
        let asked = if name.ends_with("of x") { 1e-5 } else { 1e-8 };
        u.norm(0.7, asked)?;
        u.lp(f64::INFINITY, asked)?;
        let dual = u.dual_norm(DualOf::Interpolation, 0.4, 1e-6);
        if name.starts_with("x^0.4") {
            // ‖u‖² = Σ (2 − δ_{k0}) (∫ u cos kπx)² (1 + k²π²)^{−ν}, summed with 20 digits
            agrees(name, "dual norm", dual, 0.725_757_579_3, 1e-9);
        }
        let first = count.load(Ordering::Relaxed);
        for order in [0.1, 0.3, 0.5, 0.65] {
            u.norm(order, asked)?;
        }
        for q in [1.0, 2.0, 3.0, f64::INFINITY] {
            u.lp(q, asked)?;
        }
        u.mean(asked)?;
        u.dual_norm(DualOf::Interpolation, 0.3, 1e-6).ok();
        let later = count.load(Ordering::Relaxed) - first;
        println!("{name}: {first} values at first, {later} in ten more verbs");
        // Where x is rounded, u is no smooth function of the distance, and is evaluated.
        let most = if name.ends_with("of x") { first / 100 } else { 0 };
        assert!(first < 70_000 && later <= most, "{name}: {first}, {later}");
    }
    Ok(())
}

#[test]
fn narrow_bells_near_a_singular_end_are_seen() -> Result<()> {
    let mut random = SplitMix::new(54);
    for _ in 0..100 {
        let at = 10f64.powf(random.between(-6.0, -1.0));
        let width = at * random.between(0.004, 0.03);
        let height = at.powf(0.4) * 10f64.powf(random.between(-2.0, 0.0));
        let bell = move |x: f64| height * (-0.5 * ((x - at) / width).powi(2)).exp();
        let u = Function::from_fn(&[0.0, 1.0], move |x| x.powf(0.4) + bell(x))?;
        // The midpoint rule is exact to rounding for Gauss' bell.
        let (step, mut square, mut mean) = (width / 16.0, 1.0 / 1.8, 1.0 / 1.4);
        for k in -160..160 {
            let x = at + step * (f64::from(k) + 0.5);
            square += step * bell(x) * (2.0 * x.powf(0.4) + bell(x));
            mean += step * bell(x);
        }
        for (found, exact) in [(u.lp(2.0, 1e-8)?, square.sqrt()), (u.mean(1e-8)?, mean)] {
            assert!(
                (found.value - exact).abs() <= found.error + 1e-14,
                "{at} {width}: {found} {exact}"
            );
        }
    }
    Ok(())
}

#[test]
fn differences_are_resolved_on_common_cells() -> Result<()> {
    let mut random = SplitMix::new(53);
    for _ in 0..20 {
        // two kinks and their difference, a hat between them: |u − v|_1 and the mean in closed form
        let [a, b] = [random.between(0.1, 0.4), random.between(0.5, 0.9)];
        let u = Function::linears(&Mesh::from_nodes(&[0.0, a, 1.0])?, &[a, 0.0, 1.0 - a])?;
        let v = Function::from_fn(&[0.0, b, 1.0], move |x| (x - b).abs())?;
        for difference in [u.minus(&v)?, v.minus(&u)?.scaled(-1.0)?] {
            // slopes 0, 2, 0 on (0, a), (a, b), (b, 1)
            let slope = difference.seminorm(1.0, 1e-9)?;
            assert!((slope.value - 2.0 * (b - a).sqrt()).abs() <= slope.error, "{slope}");
            let mean = difference.mean(1e-9)?;
            let exact = 0.5 * (a * a + (1.0 - a).powi(2) - b * b - (1.0 - b).powi(2));
            assert!((mean.value - exact).abs() <= mean.error, "{mean} {exact}");
        }
    }
    Ok(())
}

/// The orders of the table, and a name.
const ORDERS: [f64; 5] = [-0.3, 0.0, 0.3, 1.0, 1.3];

#[test]
fn norms_of_every_kind_of_function() -> Result<()> {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let curve = Curve::algebraic(&square, 2, 1.0)?;
    let ring = [0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0];
    let plane = Triangles::grid([1, 1], 1.0)?;
    let at_corners = [0.0, 1.0, 0.0, 1.0];
    let sine = || Function::from_fn(&[0.0, 1.0], f64::sin);
    let smooth = |at: &PlanePosition<'_>| at.x()[0];
    let kinds: [(&str, Function<'_>, [bool; 5]); 8] = [
        ("a formula", sine()?, [true; 5]),
        ("values", hats()?, [true; 5]),
        ("formula minus values", sine()?.minus(&hats()?)?, [true; 5]),
        ("a product", sine()?.times(&hats()?)?, [true; 5]),
        (
            "values on a curve",
            Function::on_curve(&curve, 1, &ring)?,
            [true, true, true, true, true],
        ),
        ("a formula on a boundary", Function::on_polygon(&square, |[x, _]| x)?, [true; 5]),
        (
            "values on triangles",
            Function::on_triangles(&plane, 1, &at_corners)?,
            [false, true, true, true, true],
        ),
        (
            "a formula on triangles",
            Function::from_plane_positions(&plane, &[], smooth)?,
            [false, true, true, false, false],
        ),
    ];
    let mut answered = 0;
    for (kind, u, expected) in &kinds {
        for (order, expected) in ORDERS.iter().zip(expected) {
            match u.norm(*order, 1e-3) {
                Ok(_) => answered += 1,
                Err(Error::Incompatible { expected: possible, .. }) => {
                    assert!(!expected, "order {order} of {kind}");
                    assert!(possible.contains("order"), "order {order} of {kind}: {possible}");
                }
                Err(other) => panic!("order {order} of {kind}: {other}"),
            }
            assert_eq!(u.norm(*order, 1e-3).is_ok(), *expected, "order {order} of {kind}");
        }
    }
    println!("{answered} of {} pairs of a kind and an order", kinds.len() * ORDERS.len());
    assert_eq!(answered, 36);
    Ok(())
}

/// f(x + c) of a steep hat is rounded more than x and its values are: it was divided into 131072 cells and then by rules
/// up to the work limit. The noise is part of the error: the second was off by 1.8e-9 with 4e-12 stated at first.
#[test]
fn noise_of_values_is_part_of_the_error() {
    for (left, length, centre, width, height, beside, order) in [
        (
            -1.434_776_298_490_308_7,
            0.001_435_437_159_409_435,
            -1.434_616_042_372_308_9,
            8.626_715_222_964_75e-6,
            2.684_636_926_662_588,
            0.0,
            0.644,
        ),
        (
            -1.841_141_820_142_809,
            0.010_944_310_806_893_2,
            -1.835_763_576_001_005_4,
            1.333_401_536_693_085e-4,
            1.0,
            1.0,
            0.767_505_613_748_688_9,
        ),
    ] {
        let hat = move |x: f64| beside + height * (1.0 - (x - centre).abs() / width).max(0.0);
        let corners = [left, centre - width, centre, centre + width, left + length];
        let declared = Function::from_fn(&corners, hat).unwrap();
        let moved = Function::from_fn(&[0.0, length], |x| hat(left + x)).unwrap();
        let zero = Function::piecewise(&Mesh::uniform(3, length).unwrap(), 0, &[0.0; 3]).unwrap();
        let exact = declared.seminorm(order, 1e-7).unwrap();
        for asked in [1e-3, 1e-5, 1e-7] {
            let difference = moved.minus(&zero).unwrap();
            for found in [moved.seminorm(order, asked), difference.seminorm(order, asked)] {
                let Ok(found) = Estimate::or_best(found) else { continue };
                let off = (found.value - exact.value).abs();
                // In the moved hat its width is rounded.
                let rounding = 4.0 * f64::EPSILON * left.abs() / width * exact.value;
                assert!(off <= found.error + exact.error + rounding, "{found} {exact}");
            }
        }
    }
}

/// u − v with v = u + h bell keeps the digits that rounding of u leaves, and refuses more: it was a staircase of ulps of u
/// with as many jumps, off by 6e-6 with 1e-10 stated, or infinite.
#[test]
fn differences_of_formulas_know_the_rounding_of_their_terms() -> Result<()> {
    let bell = |x: f64| (-0.5 * ((x - 0.37) / 0.02).powi(2)).exp();
    let sine = |x: f64| (3.0 * x + 1.0).sin();
    for height in [1e-4, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16] {
        let alone = formula(|x| x, &[0.0, 1.0])?;
        let alone =
            Function::from_fn(&[0.0, 1.0], move |x| height * bell(x))?.plus(&alone.scaled(0.0)?)?;
        let with = Function::from_fn(&[0.0, 1.0], move |x| sine(x) + height * bell(x))?;
        let (sine, line) = (formula(sine, &[0.0, 1.0])?, formula(|x| 0.5 * x, &[0.0, 1.0])?);
        let three = with.plus(&line)?.minus(&sine)?.minus(&line)?;
        let double = with.minus(&sine)?.times(&formula(|_| 2.0, &[0.0, 1.0])?)?.scaled(0.5)?;
        for u in [with.minus(&sine)?, three, double, with.minus(&sine)?.restrict(0.0..1.0)?] {
            let value = u.value(0.37)?;
            assert!((value.value - height).abs() <= value.error, "{height}: {value}");
            for asked in [1e-3, 1e-8] {
                let of = |u: &Function| {
                    [
                        u.lp(1.0, asked),
                        u.lp(2.0, asked),
                        u.lp(f64::INFINITY, asked),
                        u.mean(asked),
                        u.seminorm(0.3, asked),
                        u.seminorm(0.8, asked),
                        u.norm(0.5, asked),
                        u.dual_norm(DualOf::Interpolation, 0.5, asked),
                    ]
                };
                for (found, exact) in of(&u).into_iter().zip(of(&alone)) {
                    let exact = Estimate::or_best(exact)?;
                    let found = match found {
                        Err(Error::ToleranceNotMet { best: None, .. }) => continue,
                        found => Estimate::or_best(found)?,
                    };
                    let off = (found.value - exact.value).abs();
                    assert!(off <= found.error + exact.error, "{height}: {found} {exact}");
                }
            }
        }
    }
    Ok(())
}

/// Next to c the rounding of x hides a power of the distance from the polynomials, of which a product is made.
#[test]
fn values_next_to_a_singular_point_of_x() -> Result<()> {
    for (a, b, p, c, left) in [
        (1.565_012_379_675_169_6, 1.687_699_295_744_545_4, 0.076, -0.0729, -0.3733),
        (1.0, 0.3, 0.25, 0.7, 0.2),
        (1.0, -0.5, 0.4, 1.3, 0.0),
    ] {
        let u =
            Function::from_fn(&[left, c], move |x| a - b * ((x - c).abs() / (c - left)).powf(p))?;
        let one = Function::linears(&Mesh::from_nodes(&[left, c])?, &[1.0; 2])?;
        let found = u.times(&one)?.value(c)?;
        assert!((found.value - a).abs() <= found.error, "{p}: {found}, {a}");
    }
    Ok(())
}

/// Whether a difference is resolved first does not depend on the verb that was asked before.
#[test]
fn verbs_of_a_difference_do_not_depend_on_their_order() -> Result<()> {
    let mesh = Mesh::uniform(7, 1.0)?;
    let field = Function::linears(&mesh, &[0.3; 8])?;
    for (name, f) in [
        ("bell", (|x: f64| (-0.5 * ((x - 0.4) / 0.003).powi(2)).exp()) as fn(f64) -> f64),
        ("kink", |x: f64| (x - 0.3217).abs()),
        ("root", |x: f64| x.sqrt()),
        ("smooth", |x: f64| (3.0 * x).sin()),
    ] {
        let difference = || Function::from_fn(&[0.0, 1.0], f)?.minus(&field);
        let alone = difference()?.seminorm(0.4, 1e-7)?;
        let u = difference()?;
        u.mean(1e-6)?;
        assert_eq!(u.seminorm(0.4, 1e-7)?, alone, "{name}");
    }
    Ok(())
}
