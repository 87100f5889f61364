//! Remark 7: the example confirms its statement, the printed step fails with any constant, and spoiled
//! numbers turn both.

use example_frame::{Outcome, Verdict};
use experiments::trial::{trial_quotient, truncated_logarithm};
use fractional_sobolev::{Constraint, Order, Tolerance, gamma};

#[path = "../examples/remark_7_zone_location.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed_and_the_printed_step_is_not() {
    let options = example::Options::default();
    let mut places = example::compute(&options).unwrap();
    let found = example::findings(&options, &places);
    assert!(matches!(Verdict::of(&found), Verdict::PrintedFormFails(_)), "{found:?}");
    let outcome = |key: &str| found.iter().find(|finding| finding.key() == key).unwrap().outcome();
    for key in ["end", "repair", "step"] {
        assert_eq!(outcome(key), Outcome::Holds, "{key}");
    }
    for key in ["sign.nu0.25", "ramp.nu0.5"] {
        assert_eq!(outcome(key), Outcome::Refuted, "{key}");
    }
    // A zone inside that were worse.
    places[0].zones[2].ratio.value = 1.000_001;
    assert!(!Verdict::of(&example::findings(&options, &places)).is_confirmed());
}

#[test]
fn above_one_half_a_finite_factor_refutes_nothing() {
    let nu = vec![Order::new(0.75).unwrap()];
    let headline = example::run(&example::Options { nu, ..example::Options::default() }).unwrap();
    assert_eq!(headline.verdict(), Verdict::Holds, "{headline}");
}

#[test]
fn odd_ramps_come_within_a_twentieth_of_the_constant_of_their_zone() {
    let order = Order::HALF;
    for radius in [1e-4f64, 1e-8, 1e-16] {
        let log = -(2.0 * radius).ln();
        let ramp = truncated_logarithm(1.0, log).unwrap();
        let found = trial_quotient(&ramp, order, Tolerance::balanced()).unwrap().value;
        let zone = 0.0..2.0 * radius;
        let best =
            gamma(order, Constraint::vanishing_on(zone), Tolerance::balanced()).unwrap().constant.value;
        assert!(found < best && found > 0.95 * best, "radius {radius:e}: {found} against {best}");
    }
}
