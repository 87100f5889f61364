//! The law of the Poincaré constant at one half: two proved bounds enclose it, and what is left is predicted.

use example_frame::{Outcome, Verdict};
use experiments::growth::END_SLOPE;
use fractional_sobolev::{Constraint, Error, Law, Order, Tolerance, gamma, law};

#[path = "../examples/lemma_5_2_exact_law.rs"]
#[allow(dead_code)]
mod example;

fn at_one_half() -> Law {
    law(Order::HALF, 0.0, Tolerance::fast()).unwrap()
}

#[test]
fn two_proved_bounds_enclose_the_constant() {
    let law = at_one_half();
    for theta in [0.3, 0.1, 3e-2, 1e-3, 1e-6, 1e-12, 1e-50, 1e-150, 1e-250, 1e-300] {
        let zone = Constraint::mean_zero_on(0.0..theta);
        let found = gamma(Order::HALF, zone, Tolerance::balanced()).unwrap().constant;
        let (low, high) = (found.value - found.error, found.value + found.error);
        let [lower, upper] = law.bracket(-f64::ln(theta)).unwrap();
        assert!(lower <= high * high, "theta {theta}: {found} against {lower}");
        assert!(upper >= low * low, "theta {theta}: {found} against {upper}");
    }
}

/// A^(1/2) ∫ C(r) r²/(2 sinh²(r/2)) dr is 3.46.
const CHAINS: f64 = 3.5;

#[test]
fn the_bounds_close_on_the_law() {
    let mut before = f64::INFINITY;
    let at_one_half = at_one_half();
    for exponent in 1..=15 {
        let log = 10f64.powi(exponent);
        let [lower, upper] = at_one_half.bracket(log).unwrap();
        let law = END_SLOPE * log;
        // The ramp is right up to 1/L. The chains lose b = A^(1/2) ∫ C w / L^(1/2), and N ≤ (A L)^(1/2) (b +
        // (1 + b²)^(1/2)).
        assert!((lower / law - 1.0).abs() < 1.0 / log, "L {log}: {lower} against {law}");
        let above = upper / law - 1.0;
        assert!(above > 0.0 && above < before, "L {log}: {above} after {before}");
        let b = CHAINS / log.sqrt();
        assert!(above < (b + b.hypot(1.0)).powi(2) - 1.0, "L {log}: {above}");
        before = above;
    }
}

#[test]
fn bad_lengths_are_refused() {
    let law = at_one_half();
    for log in [f64::NAN, 0.0, 0.5, -3.0, f64::INFINITY, 1e16] {
        assert!(matches!(law.bracket(log), Err(Error::OutOfRange { .. })), "{log}");
    }
}

#[test]
fn the_example_confirms_the_law() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(matches!(headline.verdict(), Verdict::Holds), "{headline}");
    for key in ["lower", "upper", "closing", "rest", "explained", "inside"] {
        assert_eq!(headline.finding(key).unwrap().outcome(), Outcome::Holds, "{key}: {headline}");
    }
}

#[test]
fn another_law_is_not_confirmed() {
    let options =
        example::Options { theta: vec![1e-5, 1e-20, 1e-80], log: vec![1e12], ..example::Options::default() };
    assert!(Verdict::of(&example::findings(&example::compute(&options).unwrap())).is_confirmed());
    // A constant one per cent above the bound along chains; and the law with a slope one part in 1e4 too
    // large.
    let mut above = example::compute(&options).unwrap();
    above.points[1].1.square.value = 1.01 * above.points[1].0.upper;
    assert!(!Verdict::of(&example::findings(&above)).is_confirmed());
    let mut other = example::compute(&options).unwrap();
    other.points[2].1.explained.value *= 1.01;
    assert!(!Verdict::of(&example::findings(&other)).is_confirmed());
    let mut open = example::compute(&options).unwrap();
    open.beyond[0].upper *= 1.001;
    assert!(!Verdict::of(&example::findings(&open)).is_confirmed());
}
