//! Norms in one dimension on inputs near every limit, beside formulas of the test (`hard/references.rs`), closed
//! forms, and other computations.

use crate::common::SplitMix;
use crate::hard::{Case, Family, cases, decades, judge, median, references, seeded};
use fractional_sobolev::{
    DualOf, Error, Estimate, Function, Mesh, Order, Position, Rule, Tolerance, Work, closed_forms,
    gauss_legendre,
};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Rounding of the references: sums of some thousand positive terms.
const ROUNDING: f64 = 1e-14;
/// Of trapezoidal sums in two variables.
const REFERENCE: f64 = 1e-10;
/// Largest median of the ratio of stated to true errors.
const CAREFUL: f64 = 50.0;
/// Of cos kπx where kπx is rounded.
const ARGUMENT: f64 = 1e-11;

static GAUSS_12: LazyLock<Rule> = LazyLock::new(|| gauss_legendre(12).unwrap());
static GAUSS_16: LazyLock<Rule> = LazyLock::new(|| gauss_legendre(16).unwrap());

/// Orders everywhere in (0, 1), and at the ends and the middle as close as they can be given.
pub fn order(random: &mut SplitMix) -> Order {
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

fn tolerance(random: &mut SplitMix, low: f64, high: f64) -> Tolerance {
    Tolerance::new(decades(random, low, high)).unwrap()
}

fn closed_power(random: &mut SplitMix) -> Case {
    let order = order(random);
    let a = exponent(random, order);
    let asked = Tolerance::reference();
    let exact = (references::power(a, order), ROUNDING);
    let found = |_| closed_forms::power_seminorm_squared(a, order);
    Case { asked: None, ..Case::new(format!("|x^{a:e}|², {order:?}"), asked, exact, found) }
}

/// An exponent of the logarithm near 1/2, or near 0.
fn log_exponent(random: &mut SplitMix, least: f64) -> f64 {
    match random.below(2) {
        0 => 0.5 - decades(random, -7.0, -0.31),
        _ => decades(random, least, -0.31),
    }
}

fn closed_log_power(random: &mut SplitMix) -> Case {
    let alpha = log_exponent(random, -10.0);
    let exact = (references::log_power(alpha), ROUNDING);
    let found = |_| closed_forms::log_power_seminorm_squared(alpha);
    Case {
        asked: None,
        ..Case::new(format!("||ln x|^{alpha:e}|²"), Tolerance::reference(), exact, found)
    }
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

/// From 5e-14: on 300 decades the rounding of exponents leaves 2e-14.
fn linears(random: &mut SplitMix) -> Case {
    let (order, lengths, asked) = (order(random), lengths(random), tolerance(random, -13.3, -3.0));
    let values = values(random, lengths.len() + 1);
    let ends: Vec<[f64; 2]> = values.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let u = Function::linears(&Mesh::from_lengths(&lengths).unwrap(), &values).unwrap();
    let exact = (root_of_reference(&lengths, &ends, order, &GAUSS_12), ROUNDING);
    let what = format!("linears {values:?} on {lengths:?}, {order:?}");
    Case::new(what, asked, exact, |asked| u.seminorm(order, asked))
}

fn constants(random: &mut SplitMix) -> Case {
    let order = order_below_half(random);
    let (lengths, asked) = (lengths(random), tolerance(random, -13.3, -3.0));
    let values = values(random, lengths.len());
    let ends: Vec<[f64; 2]> = values.iter().map(|&value| [value; 2]).collect();
    let u = Function::piecewise(&Mesh::from_lengths(&lengths).unwrap(), 0, &values).unwrap();
    let exact = (root_of_reference(&lengths, &ends, order, &GAUSS_12), ROUNDING);
    let what = format!("constants {values:?} on {lengths:?}, {order:?}");
    Case::new(what, asked, exact, |asked| u.seminorm(order, asked))
}

fn power(random: &mut SplitMix) -> Case {
    let order = order(random);
    let (a, asked) = (exponent(random, order), tolerance(random, -11.0, -2.0));
    let u = power_of_position(a);
    let exact = (references::power(a, order).sqrt(), ROUNDING);
    Case::new(format!("x^{a:e}, {order:?}"), asked, exact, |asked| u.seminorm(order, asked))
}

/// Orders next to 0, 1/2 and 1, and exponents next to those of infinite norms.
fn extreme_order(random: &mut SplitMix) -> Order {
    let near = decades(random, -12.0, -1.0);
    match random.below(4) {
        0 => Order::new(near),
        1 => Order::half_plus(if random.below(2) == 0 { near } else { -near }),
        _ => Order::new(1.0 - near),
    }
    .unwrap()
}

/// Singular at either end or in the middle, even or odd there, with a logarithm or without, on intervals of any length.
fn power_at_a_limit(random: &mut SplitMix) -> Case {
    let (order, length) = (extreme_order(random), decades(random, -200.0, 200.0));
    let length = if random.below(2) == 0 { 1.0 } else { length };
    let a = loop {
        let a = order.offset() + decades(random, -4.0, 0.0) * (2.0 - order.offset());
        if a > order.offset() {
            break a;
        }
    };
    let asked = tolerance(random, -13.0, -4.0);
    let place = random.below(4);
    let (breaks, at): (&[f64], usize) = match place {
        0 => (&[0.0, 1.0], 0),
        1 => (&[-1.0, 0.0], 1),
        _ => (&[-1.0, 0.0, 1.0], 1),
    };
    let breaks: Vec<f64> = breaks.iter().map(|c| c * length).collect();
    let has_log = place < 2 && random.below(3) == 0;
    let f = move |position: Position| {
        let share = position.offset().abs() / length;
        let (log, value) = if position.anchor() == at {
            (share.ln(), share.powf(a))
        } else {
            ((-share).ln_1p(), (a * (-share).ln_1p()).exp())
        };
        let is_negative = place == 3 && position.x().is_sign_negative();
        let value = if is_negative { -value } else { value };
        if has_log { value * log } else { value }
    };
    let square = match (has_log, place) {
        (true, _) => references::power_with_logarithm(a, order),
        (false, 2) => 2.0 * references::power(a, order) + references::two_powers(a, order, -1.0),
        (false, 3) => 2.0 * references::power(a, order) + references::two_powers(a, order, 1.0),
        _ => references::power(a, order),
    };
    let exact = square.sqrt() * references::scale(length, order).sqrt();
    let u = Function::from_positions(&breaks, f).unwrap();
    let what = format!(
        "x^{a:e}{} at place {place} of length {length:e}, {order:?}",
        if has_log { " ln x" } else { "" }
    );
    let rounding = ROUNDING + length.ln().abs() * f64::EPSILON;
    Case::new(what, asked, (exact, rounding), |asked| u.seminorm(order, asked))
}

/// x^a with small a at ν = 1/2, of size one down to e^(−1/a), by the logarithm of x, and less 1.
#[test]
fn slow_powers_are_followed_below_the_range_of_numbers() {
    for (a, less) in
        [(0.8e-3, 0.0), (1.239e-3, 0.0), (1.239e-3, 1.0), (3e-3, 1.0), (0.01, 1.0), (0.05, 0.0)]
    {
        let exact = closed_forms::power_seminorm_squared(a, Order::HALF).unwrap().value.sqrt();
        let u = Function::from_log_distances(&[0.0, 1.0], move |at| {
            let log = if at.anchor() == 0 { at.log_distance() } else { at.offset().ln_1p() };
            if less == 0.0 { (a * log).exp() } else { (a * log).exp_m1() }
        });
        let found = u.unwrap().seminorm(Order::HALF, 3e-11).unwrap();
        let is_within = (found.value - exact).abs() <= found.error + ROUNDING * exact;
        assert!(is_within && found.relative_error() <= 3e-11, "{a} {less}: {found} {exact}");
    }
}

/// |ln x|^155 at an order just below 1/2 is zero at all distances that binary64 has, in units of its maximum near e^(−4e5):
/// it was 0 ± 0.
#[test]
fn a_function_of_the_logarithm_may_live_below_all_distances() {
    let (alpha, order) = (155.57712450797106, Order::half_plus(-1.8240123181672289e-4).unwrap());
    let exact = (references::log_power_below_half(alpha, order).sqrt(), REFERENCE);
    let u = power_of_logarithm(alpha, references::log_unit(alpha, order));
    let asked = Tolerance::new(1.6e-3).unwrap();
    let case = Case::new("below".to_owned(), asked, exact, |asked| u.seminorm(order, asked));
    println!("{:?} {}", case.found, case.exact);
    assert!(case.fault().is_none(), "{:?}", case.fault());
    assert!(!matches!(case.found, Ok(found) if found.value == 0.0));
}

fn log_power(random: &mut SplitMix) -> Case {
    let (alpha, asked) = (log_exponent(random, -5.0), tolerance(random, -3.0, -1.5));
    let u = power_of_logarithm(alpha, 0.0);
    let exact = (references::log_power(alpha).sqrt(), ROUNDING);
    Case::new(format!("|ln x|^{alpha:e}"), asked, exact, |asked| u.seminorm(Order::HALF, asked))
}

/// |ln x|^α over e^{unit}, right below 1e-300.
fn power_of_logarithm(alpha: f64, unit: f64) -> Function<'static> {
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

/// α up to 200.
fn log_power_below_half(random: &mut SplitMix) -> Case {
    loop {
        let alpha = decades(random, -7.0, 2.301);
        let order = match random.below(3) {
            0 => Order::half_plus(-decades(random, -6.0, -0.4)),
            1 => Order::new(decades(random, -3.0, -0.5)),
            _ => Order::new(random.between(0.05, 0.49)),
        }
        .unwrap();
        let asked = tolerance(random, -5.0, -1.5);
        if 2.0 * alpha + (-2.0 * order.offset()) >= references::LEAST {
            let exact = (references::log_power_below_half(alpha, order).sqrt(), REFERENCE);
            let u = power_of_logarithm(alpha, references::log_unit(alpha, order));
            let what = format!("|ln x|^{alpha:e}, {order:?}");
            return Case::new(what, asked, exact, |asked| u.seminorm(order, asked));
        }
    }
}

/// Up to ten thousand half waves.
fn cosine(random: &mut SplitMix) -> Case {
    let k = decades(random, 0.0, 4.0) as u32;
    let (order, asked, parts) = (order(random), tolerance(random, -4.0, -1.5), 1 + random.below(4));
    let breaks: Vec<f64> = (0..=parts).map(|i| i as f64 / parts as f64).collect();
    let omega = PI * f64::from(k);
    let u = Function::from_fn(&breaks, |x: f64| (omega * x).cos()).unwrap();
    let exact = (references::cosine(k, order, &GAUSS_16).sqrt(), ARGUMENT);
    Case::new(format!("cos {k}πx on {parts} parts, {order:?}"), asked, exact, |asked| {
        u.seminorm(order, asked)
    })
}

fn plain_order(random: &mut SplitMix, high: f64) -> Order {
    if high > 0.5 && random.below(4) == 0 {
        return Order::HALF;
    }
    Order::new(random.between(0.02, high)).unwrap()
}

/// ∥x^a |ln x|^α∥_q = (Γ(αq + 1)/(aq + 1)^{αq+1})^{1/q} for αq whole; q = 1, 2, 4.
fn lebesgue(random: &mut SplitMix) -> Case {
    let q = [1.0, 2.0, 4.0][random.below(3)];
    let whole = random.below(7);
    let (alpha, asked) = (whole as f64 / q, tolerance(random, -12.0, -2.0));
    let a = (10f64.powf(random.between(-1.9, 0.5)) - 1.0) / q;
    let factorial: f64 = (1..=whole).map(|k| k as f64).product();
    let exact = (factorial / (a * q + 1.0).powi(whole as i32 + 1)).powf(1.0 / q);
    let by_log = random.below(2) == 0;
    let f = move |at: Position| match at.anchor() {
        0 => (a * at.log_distance()).exp() * (-at.log_distance()).powf(alpha),
        _ => (1.0 + at.offset()).powf(a) * (-at.offset().ln_1p()).powf(alpha),
    };
    let u = if by_log {
        Function::from_log_distances(&[0.0, 1.0], f).unwrap()
    } else {
        Function::from_positions(&[0.0, 1.0], f).unwrap()
    };
    let what = format!("x^{a} |ln x|^{alpha} in L^{q}, {by_log}");
    let is_deep = a * q < -0.9;
    Case { is_deep, ..Case::new(what, asked, (exact, 1e-12), |asked| u.lp(q, asked)) }
}

/// Waves as a load: cos kπx has the norm (1 + k²π²)^{-ν/2}/√2 in the dual of interpolation.
fn wave_load(random: &mut SplitMix) -> Case {
    let (order, asked) = (plain_order(random, 0.97), tolerance(random, -12.0, -2.0));
    let frequency = (1 + random.below(12)) as f64 * PI;
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| (frequency * x).cos()).unwrap();
    let exact = ((1.0 + frequency * frequency).powf(-0.5 * order.value()) / 2f64.sqrt(), 1e-13);
    let found = |asked| u.dual_norm(DualOf::Interpolation, order, asked);
    Case {
        is_deep: false,
        ..Case::new(format!("cos {frequency} x as a load, {order}"), asked, exact, found)
    }
}

/// ∫₀¹ x^a |ln x|^p.
fn moment(a: f64, p: usize) -> f64 {
    (1..=p).map(|k| k as f64).product::<f64>() / (a + 1.0).powi(p as i32 + 1)
}

/// In L¹ and L²: towards the break a slow power with a small coefficient hides behind a fast one.
fn slow_behind_fast(random: &mut SplitMix) -> Case {
    let (fast, slow) = (random.between(0.0, 3.0), random.between(-0.4, 0.0));
    let (p, r, q) = (random.below(3), random.below(2), 1 + random.below(2));
    let (small, asked) = (decades(random, -6.0, 0.0), tolerance(random, -11.0, -2.0));
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| {
        let log = -x.ln();
        x.powf(fast) * log.powi(p as i32) + small * x.powf(slow) * log.powi(r as i32)
    });
    let square = moment(2.0 * fast, 2 * p)
        + 2.0 * small * moment(fast + slow, p + r)
        + small * small * moment(2.0 * slow, 2 * r);
    let exact = if q == 1 { moment(fast, p) + small * moment(slow, r) } else { square.sqrt() };
    let what = format!("x^{fast} log^{p} + {small} x^{slow} log^{r} in L^{q}");
    Case {
        is_deep: false,
        ..Case::new(what, asked, (exact, 1e-13), |asked| u?.lp(q as f64, asked))
    }
}

/// Cases, and the share of refusals that is allowed.
const FAMILIES: [Family; 12] = [
    ("closed forms of powers", 5000, 0.0, closed_power),
    ("closed forms of powers of the logarithm", 4500, 0.0, closed_log_power),
    ("piecewise linears on lengths of 300 decades", 4000, 0.01, linears),
    ("piecewise constants on lengths of 300 decades", 2000, 0.01, constants),
    ("powers", 600, 0.05, power),
    ("powers of the logarithm", 100, 0.1, log_power),
    ("powers of the logarithm below one half", 80, 0.25, log_power_below_half),
    ("cosines", 60, 0.2, cosine),
    ("L^q of powers and logarithms", 40, 0.33, lebesgue),
    ("waves as loads", 20, 0.6, wave_load),
    ("slow powers behind fast ones", 4000, 0.01, slow_behind_fast),
    ("exponents and orders at their limits", 150, 0.25, power_at_a_limit),
];

#[test]
fn every_answer_is_within_its_error_or_refused_with_a_value_that_is() {
    let Some(median) = median(&judge(1, &FAMILIES)) else { return };
    println!("half of the errors are within {median:.0} of the true ones");
    // Of all families together: closed forms are known to the last digits, cosines to few.
    if std::env::var("SIGNORINI_FAMILY").is_err() {
        assert!(median <= CAREFUL, "half of the errors are {median:.0} times the true ones");
    }
}

fn power_of_position(a: f64) -> Function<'static> {
    Function::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
        0 => at.offset().powf(a),
        _ => (a * at.offset().ln_1p()).exp(),
    })
    .unwrap()
}

/// Errors of 6e-11 on one side of the interval and -6e-11 on the other: their sum, 1e-12, was the difference from the next
/// level, which is off by 1.6e-12. Found among 183 600 random cases.
#[test]
fn errors_of_opposite_signs_are_no_small_error() {
    let (a, offset) = (0.5729046192378049, 0.4989790821329767);
    let order = Order::half_plus(offset).unwrap();
    // By 40 digits.
    let exact = 46.665_010_302_441_69;
    let found = power_of_position(a).seminorm(order, 4.1247276462776796e-11).unwrap();
    assert!((found.value - exact).abs() <= found.error, "{found} {exact}");
}

/// t² e^{−wt} grows until t = 2/w, beyond the smallest distance of binary64 at t = 690: whether the norm is finite is not
/// seen there, and it was called infinite.
#[test]
fn growth_up_to_the_smallest_distance_is_not_infinite() {
    for (a, offset) in
        [(0.4970010332776227, 0.49643593882756354), (0.5004537924791496, 0.4999950471762048)]
    {
        let u = Function::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
            0 => at.offset().powf(a) * at.log_distance(),
            _ => (a * at.offset().ln_1p()).exp() * at.offset().ln_1p(),
        });
        let found = u.unwrap().seminorm(Order::half_plus(offset).unwrap(), 1e-4);
        assert!(matches!(found, Err(Error::ToleranceNotMet { .. })), "{a} {offset}: {found:?}");
    }
    // Nor is growth beyond a zero of ℓ, at t = 1/a; the value is that of mpmath.
    let a = 0.006419430157903723;
    let u = Function::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
        0 => at.offset().powf(a) * at.log_distance(),
        _ => (a * at.offset().ln_1p()).exp() * at.offset().ln_1p(),
    });
    let order = Order::half_plus(-9.939332530522245e-11).unwrap();
    let found = u.unwrap().seminorm(order, 2.5e-6).unwrap();
    assert!((found.value - 15.786515275).abs() <= found.error, "{found}");
    // Polynomials on cells see the same growth in L².
    let u = Function::from_fn(&[0.0, 1.0], |x| x.powf(-0.49275007807927923) * (-x.ln()).powf(2.5));
    let found = u.unwrap().lp(2.0, 6.4e-9);
    assert!(matches!(found, Err(Error::ToleranceNotMet { .. })), "{found:?}");
    // Growth like a power of the distance is.
    let infinite = power_of_position(-0.3).seminorm(0.4, 1e-4);
    assert!(matches!(infinite, Err(Error::InfiniteNorm { .. })), "{infinite:?}");
}

/// The power of the length is rounded; with its error the tolerance is met or the answer refused.
#[test]
fn the_rounding_of_a_long_or_short_interval_counts_for_the_tolerance() {
    let (a, length, asked) = (0.8288566552413861, 2.2723117595887165e-180, 4.265142569398116e-13);
    let u = Function::from_positions(&[-length, 0.0], move |at| match at.anchor() {
        0 => (a * (-at.offset() / length).ln_1p()).exp(),
        _ => (-at.offset() / length).powf(a),
    });
    match u.unwrap().seminorm(0.9999987573018334, asked) {
        Ok(found) => assert!(found.relative_error() <= asked, "{found}"),
        Err(refused) => assert!(refused.best().is_some(), "{refused}"),
    }
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
        match power_of_logarithm(alpha, 0.0).seminorm(order, Tolerance::fast()) {
            Err(Error::InfiniteNorm { .. }) => infinite += 1,
            Err(_) => refused += 1,
            Ok(found) => {
                panic!("|ln x|^{alpha:e}, {order:?} is not in H^nu, and has the norm {found}")
            }
        }
    }
    println!("infinite powers of the logarithm: {infinite} infinite, {refused} refused");
    assert!(refused * 10 <= infinite, "{infinite} infinite, {refused} refused");
}

#[test]
fn wrong_answers_are_found() {
    let made = |value: f64, error: f64, points: u64, found: bool| {
        let estimate = Estimate { value, error, work: Work { points, ..Work::default() } };
        let (asked, reached, best) = (1e-6, estimate.relative_error(), Some(estimate));
        let refusal =
            Err(Error::ToleranceNotMet { what: "norm", asked, reached, best, why: "made" });
        let tolerance = Tolerance::new(1e-6).unwrap();
        let found = if found { Ok(estimate) } else { refusal };
        let exact = Estimate { value: 1.0, error: 1e-13, work: Work::default() };
        Case::beside("made".to_owned(), tolerance, exact, |_| found).fault()
    };
    assert!(made(1.0 + 1e-8, 1e-7, 1, true).is_none() && made(1.0, 1e-3, 1, false).is_none());
    for (value, error, points, found, what) in [
        (1.0 + 1e-6, 1e-7, 1, true, "an error above its estimate"),
        (1.0, 1e-3, 1, true, "an answer beside its tolerance"),
        (1.0, 1e-7, 4 * Tolerance::WORK + 1, true, "an answer beside its limit of work"),
        (1.1, 1e-3, 1, false, "a refusal that does not enclose"),
    ] {
        assert!(made(value, error, points, found).is_some(), "{what}");
    }
}
