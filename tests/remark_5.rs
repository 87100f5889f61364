//! Remark 5: the example confirms its statement, and a spoiled number turns it.

use example_frame::{Outcome, Verdict};

#[path = "../examples/remark_5_log_counterexample.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    for key in ["below", "truncation", "constant", "grows.alpha0.25", "grows.alpha0.45"] {
        assert_eq!(headline.finding(key).unwrap().outcome(), Outcome::Holds, "{key}: {headline}");
    }
    // The column quotient / L^α still rises over the zones computed: it refutes the power L^α there.
    assert_eq!(headline.finding("power.alpha0.25").unwrap().outcome(), Outcome::Refuted, "{headline}");
}

#[test]
fn quotients_that_do_not_grow_are_not_confirmed() {
    let options = example::Options { log: vec![4.0, 16.0, 64.0], ..example::Options::default() };
    let computed = example::compute(&options).unwrap();
    assert!(Verdict::of(&example::findings(&computed)).is_confirmed());
    let mut flat = example::compute(&options).unwrap();
    flat.families[0].growth.as_mut().unwrap().value = -0.5;
    assert!(!Verdict::of(&example::findings(&flat)).is_confirmed());
    let mut above = computed;
    above.families[1].shares[2].value = 1.001;
    assert!(!Verdict::of(&example::findings(&above)).is_confirmed());
}
