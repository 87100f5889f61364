//! Lemma 5.1: the example confirms its statement, and a spoiled number turns it.

use example_frame::{Outcome, Verdict};

#[path = "../examples/lemma_5_1_peetre_tartar.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    for key in ["positive", "attained", "least", "falls.nu0.25"] {
        assert_eq!(headline.finding(key).unwrap().outcome(), Outcome::Holds, "{key}: {headline}");
    }
    // ν > 1/2: the constant settles as the zone shrinks to a point.
    assert_eq!(headline.finding("falls.nu0.75").unwrap().outcome(), Outcome::Refuted, "{headline}");
}

#[test]
fn an_alpha_off_by_two_per_cent_is_not_confirmed() {
    let options = example::Options { theta: vec![1e-1, 1e-2], ..example::Options::default() };
    let mut rows = example::compute(&options).unwrap();
    rows[1].attained.value *= 1.02;
    let findings = example::findings(&rows);
    assert!(matches!(Verdict::of(&findings), Verdict::NotConfirmed(_)), "{findings:?}");
}
