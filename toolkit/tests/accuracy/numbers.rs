//! Norms and constants in one dimension on inputs near every limit. Every answer lies within its own error of a
//! formula of the test (`hard/references.rs`), or there is a reason why there is none.

use crate::common::SplitMix;
use crate::hard::references;
use crate::hard::{Count, cases, seeded};
use fractional_sobolev::{
    Constraint, Error, Function, Mesh, Order, Rule, Tolerance, closed_forms, gamma, gauss_legendre,
};
use std::f64::consts::PI;

/// Rounding of the references: sums of some thousand positive terms.
const ROUNDING: f64 = 1e-14;

/// Of trapezoidal sums in two variables.
const REFERENCE: f64 = 1e-10;

/// Of cos kπx where kπx is rounded.
const ARGUMENT: f64 = 1e-11;

/// Evenly in the exponent.
fn decades(random: &mut SplitMix, low: f64, high: f64) -> f64 {
    10f64.powf(random.between(low, high))
}

/// Orders everywhere in (0, 1), and at the ends and the middle as close as they can be given.
fn order(random: &mut SplitMix) -> Order {
    match random.below(10) {
        0 => Order::new(1e-300),
        1 => Order::new(1e-16),
        2 => Order::half_plus(if random.below(2) == 0 { 1e-16 } else { -1e-16 }),
        3 => Order::new(1.0 - f64::EPSILON / 2.0),
        4 => Ok(Order::HALF),
        5 => Order::half_plus(decades(random, -20.0, -1.0)),
        6 => Order::new(decades(random, -12.0, -0.5)),
        7 => Order::new(1.0 - decades(random, -15.0, -0.5)),
        _ => Order::new(random.between(0.01, 0.99)),
    }
    .unwrap()
}

fn order_below_half(random: &mut SplitMix) -> Order {
    loop {
        let order = order(random);
        if order.offset() < 0.0 {
            return order;
        }
    }
}

/// An exponent a with a − (ν − 1/2) from 1e-6 on.
fn exponent(random: &mut SplitMix, order: Order) -> f64 {
    loop {
        let a = order.offset() + decades(random, -6.0, 0.4);
        if a != 0.0 && a > order.offset() {
            return a;
        }
    }
}

#[test]
fn closed_forms_of_powers_and_logarithms() {
    let (mut random, mut count) = (seeded(1), Count::default());
    for _ in 0..cases(5000) {
        let order = order(&mut random);
        let a = exponent(&mut random, order);
        let exact = references::power(a, order);
        count.judge(
            || format!("|x^{a:e}|², {order:?}"),
            &closed_forms::power_seminorm_squared(a, order),
            exact,
            ROUNDING,
        );
    }
    count.close("closed forms of powers", cases(5000), 0.0);
    let mut count = Count::default();
    for i in 0..cases(4500) {
        let distance = decades(&mut random, -7.0, -0.31);
        let alpha = if i % 2 == 0 { 0.5 - distance } else { decades(&mut random, -10.0, -0.31) };
        let exact = references::log_power(alpha);
        count.judge(
            || format!("||ln x|^{alpha:e}|²"),
            &closed_forms::log_power_seminorm_squared(alpha),
            exact,
            ROUNDING,
        );
    }
    count.close("closed forms of powers of the logarithm", cases(4500), 0.0);
}

/// Up to five elements: of lengths 1e-300 ... 1, tiny ones beside long ones, or all of one size.
fn lengths(random: &mut SplitMix) -> Vec<f64> {
    let kind = random.below(4);
    let size = decades(random, -300.0, 0.0);
    (0..1 + random.below(5))
        .map(|_| match (kind, random.below(2)) {
            (0, _) => decades(random, -300.0, 0.0),
            (1, 0) => decades(random, -300.0, -295.0),
            (1, _) => random.between(0.1, 1.0),
            (2, _) => size * random.between(0.1, 1.0),
            _ => decades(random, -6.0, 0.0),
        })
        .collect()
}

/// Of any size, of both signs, or a few ulps apart.
fn values(random: &mut SplitMix, count: usize) -> Vec<f64> {
    let kind = random.below(5);
    let base = random.between(0.5, 2.0) * decades(random, -100.0, 100.0);
    let value = |random: &mut SplitMix| match kind {
        0 => random.between(-1.0, 1.0),
        1 => base * (1.0 + f64::EPSILON * random.below(6) as f64),
        2 => f64::from(u8::from(random.below(4) == 0)),
        3 => base * random.between(-1.0, 1.0),
        _ => 1.0 + decades(random, -16.0, -8.0),
    };
    (0..count).map(|_| value(random)).collect()
}

/// From 5e-14: on 300 decades the rounding of exponents leaves 2e-14.
fn tolerance(random: &mut SplitMix) -> Tolerance {
    Tolerance::new(decades(random, -13.3, -3.0)).unwrap()
}

/// |u|_ν by the reference: of u over a power of two near its differences.
fn root_of_reference(lengths: &[f64], ends: &[[f64; 2]], order: Order, rule: &Rule) -> f64 {
    let all = || ends.iter().flatten();
    let spread = all().fold(f64::MIN, |m, &v| m.max(v)) - all().fold(f64::MAX, |m, &v| m.min(v));
    let unit = if spread == 0.0 { 1.0 } else { 2f64.powi(spread.log2().floor() as i32) };
    let scaled: Vec<[f64; 2]> = ends.iter().map(|end| end.map(|value| value / unit)).collect();
    // |u|² ~ L^{1−2ν}: above one half on an interval as much longer, where nothing overflows.
    let longer = if order.offset() < 0.0 { 1.0 } else { 2f64.powi(100) };
    let lengths: Vec<f64> = lengths.iter().map(|length| longer * length).collect();
    unit * longer.powf(order.offset()) * references::linears(&lengths, &scaled, order, rule).sqrt()
}

#[test]
fn piecewise_linears_on_lengths_of_300_decades() {
    let (mut random, rule) = (seeded(2), gauss_legendre(12).unwrap());
    let mut linears = Count::default();
    for _ in 0..cases(4000) {
        let (order, lengths, tolerance) = (order(&mut random), lengths(&mut random), tolerance(&mut random));
        let values = values(&mut random, lengths.len() + 1);
        let ends: Vec<[f64; 2]> = values.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let partition = Mesh::from_lengths(lengths.clone()).unwrap();
        let u = Function::linears(&partition, &values).unwrap();
        let exact = root_of_reference(&lengths, &ends, order, &rule);
        let case = || format!("linears {values:?} on {lengths:?}, {order:?}, {tolerance}");
        linears.judge(case, &u.seminorm(order, tolerance), exact, ROUNDING);
    }
    linears.close("piecewise linears", cases(4000), 0.01);
}

#[test]
fn piecewise_constants_on_lengths_of_300_decades() {
    let (mut random, rule) = (seeded(6), gauss_legendre(12).unwrap());
    let mut constants = Count::default();
    for _ in 0..cases(2000) {
        let order = order_below_half(&mut random);
        let (lengths, tolerance) = (lengths(&mut random), tolerance(&mut random));
        let values = values(&mut random, lengths.len());
        let ends: Vec<[f64; 2]> = values.iter().map(|&value| [value; 2]).collect();
        let partition = Mesh::from_lengths(lengths.clone()).unwrap();
        let u = Function::piecewise(&partition, 0, &values).unwrap();
        let exact = root_of_reference(&lengths, &ends, order, &rule);
        let case = || format!("constants {values:?} on {lengths:?}, {order:?}, {tolerance}");
        constants.judge(case, &u.seminorm(order, tolerance), exact, ROUNDING);
    }
    constants.close("piecewise constants", cases(2000), 0.01);
}

#[test]
fn closures_of_powers() {
    let mut random = seeded(3);
    let mut count = Count::default();
    for _ in 0..cases(600) {
        let order = order(&mut random);
        let a = exponent(&mut random, order);
        let tolerance = Tolerance::new(decades(&mut random, -6.0, -2.0)).unwrap();
        let u = Function::from_positions(&[0.0, 1.0], |at| match at.anchor() {
            0 => at.offset().powf(a),
            _ => (a * at.offset().ln_1p()).exp(),
        })
        .unwrap();
        let exact = references::power(a, order).sqrt();
        count.judge(
            || format!("x^{a:e}, {order:?}, {tolerance}"),
            &u.seminorm(order, tolerance),
            exact,
            ROUNDING,
        );
    }
    count.close("closures of powers", cases(600), 0.7);
}

#[test]
fn closures_of_powers_of_the_logarithm() {
    let (mut random, mut count) = (seeded(7), Count::default());
    for i in 0..cases(100) {
        let distance = decades(&mut random, -7.0, -0.31);
        let alpha = if i % 2 == 0 { 0.5 - distance } else { decades(&mut random, -5.0, -0.31) };
        let tolerance = Tolerance::new(decades(&mut random, -3.0, -1.5)).unwrap();
        let u = Function::from_log_distances(&[0.0, 1.0], |at| match at.anchor() {
            0 => (-at.log_distance()).powf(alpha),
            // Below 1e-20 the distance to 1 is −ln x, whose power may still be far from 0 below 1e-300.
            _ if at.log_distance() < -46.0 => (alpha * at.log_distance()).exp(),
            _ => (-at.offset().ln_1p()).powf(alpha),
        })
        .unwrap();
        let exact = references::log_power(alpha).sqrt();
        let found = u.seminorm(Order::HALF, tolerance);
        count.judge(|| format!("|ln x|^{alpha:e}, {tolerance}"), &found, exact, ROUNDING);
    }
    count.close("closures of powers of the logarithm", cases(100), 0.9);
}

/// |ln x|^α over e^{unit}, right below 1e-300.
fn log_power(alpha: f64, unit: f64) -> Function<'static> {
    Function::from_log_distances(&[0.0, 1.0], move |at| {
        let log = match at.anchor() {
            0 => (-at.log_distance()).ln(),
            _ if at.log_distance() < -46.0 => at.log_distance(),
            _ => (-at.offset().ln_1p()).ln(),
        };
        (alpha * log - unit).exp()
    })
    .unwrap()
}

#[test]
fn powers_of_the_logarithm_up_to_200_at_orders_below_one_half() {
    let (mut random, mut count) = (seeded(9), Count::default());
    for _ in 0..cases(80) {
        let alpha = decades(&mut random, -7.0, 2.301);
        let order = match random.below(3) {
            0 => Order::half_plus(-decades(&mut random, -6.0, -0.4)),
            1 => Order::new(decades(&mut random, -3.0, -0.5)),
            _ => Order::new(random.between(0.05, 0.49)),
        }
        .unwrap();
        let tolerance = Tolerance::new(decades(&mut random, -5.0, -1.5)).unwrap();
        if 2.0 * alpha + (-2.0 * order.offset()) < references::LEAST {
            continue;
        }
        let exact = references::log_power_below_half(alpha, order).sqrt();
        let found = log_power(alpha, references::log_unit(alpha, order)).seminorm(order, tolerance);
        count.judge(|| format!("|ln x|^{alpha:e}, {order:?}, {tolerance}"), &found, exact, REFERENCE);
    }
    count.close("powers of the logarithm below one half", cases(8), 0.25);
}

#[test]
fn infinite_powers_of_the_logarithm_are_not_taken_for_finite() {
    let (mut random, mut infinite, mut refused) = (seeded(10), 0, 0);
    for i in 0..cases(240) {
        let (alpha, order) = if i % 2 == 0 {
            (0.5 + decades(&mut random, -7.0, 2.3), Order::HALF)
        } else {
            let above = decades(&mut random, -16.0, -0.31);
            (decades(&mut random, -7.0, 2.301), Order::half_plus(above).unwrap())
        };
        match log_power(alpha, 0.0).seminorm(order, Tolerance::fast()) {
            Err(Error::InfiniteNorm { .. }) => infinite += 1,
            Err(_) => refused += 1,
            Ok(found) => panic!("|ln x|^{alpha:e}, {order:?} is not in H^nu, and has the norm {found}"),
        }
    }
    println!("infinite powers of the logarithm: {infinite} infinite, {refused} refused");
    assert!(refused * 10 <= infinite, "{infinite} infinite, {refused} refused");
}

#[test]
fn cosines_up_to_ten_thousand_half_waves() {
    let (mut random, rule) = (seeded(4), gauss_legendre(16).unwrap());
    let mut closures = Count::default();
    for _ in 0..cases(60) {
        let k = decades(&mut random, 0.0, 4.0) as u32;
        let order = order(&mut random);
        let tolerance = Tolerance::new(decades(&mut random, -4.0, -1.5)).unwrap();
        let omega = PI * f64::from(k);
        let parts = 1 + random.below(4);
        let breaks: Vec<f64> = (0..=parts).map(|i| i as f64 / parts as f64).collect();
        let u = Function::from_fn(&breaks, |x: f64| (omega * x).cos()).unwrap();
        let exact = references::cosine(k, order, &rule).sqrt();
        let case = || format!("cos {k}πx on {parts} parts, {order:?}, {tolerance}");
        closures.judge(case, &u.seminorm(order, tolerance), exact, ARGUMENT);
    }
    closures.close("closures of cosines", cases(60), 0.8);
}

#[test]
fn cosines_in_pieces() {
    let (mut random, rule) = (seeded(8), gauss_legendre(16).unwrap());
    let mut pieces = Count::default();
    for _ in 0..cases(600) {
        let (k, order, tolerance) = (1 + random.below(6) as u32, order(&mut random), tolerance(&mut random));
        let omega = PI * f64::from(k);
        let partition = Mesh::uniform(4 * k as usize, 1.0).unwrap();
        // The rest of Lagrange's form at degree 10 and kh = 1/4: below (π/4)^11 / 11! / 4^11.
        let u = Function::interpolate(&partition, 10, |x| (omega * x).cos()).unwrap();
        let exact = references::cosine(k, order, &rule).sqrt();
        let case = || format!("cos {k}πx of degree 10, {order:?}, {tolerance}");
        pieces.judge(case, &u.seminorm(order, tolerance), exact, ARGUMENT);
    }
    pieces.close("cosines in pieces", cases(600), 0.3);
}

#[test]
fn poincare_constants_between_bounds_known_by_hand() {
    let (mut random, mut answered, mut refused) = (seeded(5), 0, 0);
    for _ in 0..cases(100) {
        let order = order(&mut random);
        let theta = decades(&mut random, -4.0, 0.0);
        match gamma(order, Constraint::mean_zero_on(0.0..theta), Tolerance::fast())
            .map(|found| found.constant)
        {
            Ok(found) => {
                answered += 1;
                let [low, high] = [found.value - found.error, found.value + found.error];
                // u = x − θ/2 from below; |x−y| ≤ 1 and u = w − (mean of w over the zone) from above
                let c = 0.5 * theta;
                let complement = 1.0 - order.value();
                let seminorm = 1.0 / (complement * (1.0 + 2.0 * complement));
                let line = ((1.0 / 3.0 - c + c * c) / seminorm).sqrt();
                let crude = (0.5 * (1.0 + 1.0 / theta)).sqrt();
                let case = format!("zone {theta:e}, {order:?}: {found}, {line:e} to {crude:e}");
                assert!(high >= line * (1.0 - ROUNDING) && low <= crude, "{case}");
            }
            Err(Error::ToleranceNotMet { .. } | Error::OutOfRange { .. }) => refused += 1,
            Err(other) => panic!("zone {theta:e}, {order:?}: {other}"),
        }
    }
    println!("Poincaré constants: {} tried, {answered} answered, {refused} refused", answered + refused);
    assert!(10 * answered >= 9 * cases(100), "{answered} answered, {refused} refused");
}
