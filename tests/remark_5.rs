//! Remark 5: the example confirms its statement, and a spoiled number turns it.

use example_frame::{Outcome, Verdict};

#[path = "../examples/remark_5_log_counterexample.rs"]
#[allow(dead_code)]
mod example;

use std::sync::LazyLock;

/// At default size, once for all tests; `tests/findings.rs` runs the example itself.
static COMPUTED: LazyLock<example::Computed> =
    LazyLock::new(|| example::compute(&example::Options::default()).unwrap());

fn outcome(key: &str) -> Outcome {
    let found = example::findings(&COMPUTED);
    found.iter().find(|finding| finding.key() == key).unwrap().outcome()
}

#[test]
fn statement_is_confirmed() {
    assert!(Verdict::of(&example::findings(&COMPUTED)).is_confirmed());
    for key in ["below", "repaired", "constant", "grows.alpha0.25", "grows.alpha0.45", "slope.alpha1"] {
        assert_eq!(outcome(key), Outcome::Holds, "{key}");
    }
    // The quotients still grow faster than L^α over the zones computed.
    assert_eq!(outcome("power.alpha0.25"), Outcome::Refuted);
}

#[test]
fn the_printed_chain_fails_and_the_repaired_one_holds() {
    for family in COMPUTED.families.iter().filter(|family| family.alpha < 0.5) {
        for (norms, (log, _)) in family.chain.iter().zip(&family.quotients) {
            let label = format!("alpha = {}, L = {log}: {norms:?}", family.alpha);
            // ‖w‖ tends to one: the printed bound 1/n fails once n is above it.
            assert!(*log < 64.0 || norms.printed > 1.4, "{label}");
            assert!(norms.repaired <= norms.truncation && norms.truncation < 1.0 + 1e-3, "{label}");
        }
    }
    assert_eq!(outcome("chain"), Outcome::Refuted);
    assert!(matches!(Verdict::of(&example::findings(&COMPUTED)), Verdict::PrintedFormFails(_)));
}

#[test]
fn the_ramp_has_the_sharp_factor_and_other_powers_less() {
    let slope = |alpha: f64| COMPUTED.families.iter().find(|f| f.alpha == alpha).unwrap().slope.unwrap();
    let sharp = 3.0 / (2.0 * std::f64::consts::PI.powi(2));
    assert!((slope(1.0).value / sharp - 1.0).abs() < 1e-3, "{:?}", slope(1.0));
    assert!(slope(0.75).value < 0.95 * sharp, "{:?}", slope(0.75));
    for alpha in [0.6, 0.75, 0.9, 1.0] {
        assert!(experiments::trial::truncated_slope(alpha) <= sharp * (1.0 + 1e-15));
    }
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
