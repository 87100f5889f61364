//! Remark 6: the example confirms its statement, and a spoiled number turns it.

use example_frame::{Outcome, Verdict};

#[path = "../examples/remark_6_point_condition.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let options = example::Options::default();
    let mut rows = example::compute(&options).unwrap();
    let found = example::findings(&options, &rows);
    assert!(Verdict::of(&found).is_confirmed(), "{found:?}");
    for key in ["short", "inside", "finite.nu0.55", "limit.nu0.75", "blow.up"] {
        let finding = found.iter().find(|finding| finding.key() == key).unwrap();
        assert_eq!(finding.outcome(), Outcome::Holds, "{finding:?}");
    }
    // A point inside that were worse.
    rows[2].ratios[0].value = 1.000_001;
    assert!(!Verdict::of(&example::findings(&options, &rows)).is_confirmed());
}
