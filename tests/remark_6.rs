//! Remark 6: the example confirms its statement, and a spoiled number turns it.

use example_frame::{Outcome, Verdict};

#[path = "../examples/remark_6_point_condition.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    for key in ["short", "inside", "finite.nu0.55", "limit.nu0.75", "blow.up"] {
        assert_eq!(headline.finding(key).unwrap().outcome(), Outcome::Holds, "{key}: {headline}");
    }
}

#[test]
fn a_point_inside_that_were_worse_is_not_confirmed() {
    let options = example::Options::default();
    let mut rows = example::compute(&options).unwrap();
    rows[2].ratios[0].value = 1.000_001;
    assert!(!Verdict::of(&example::findings(&options, &rows)).is_confirmed());
}
