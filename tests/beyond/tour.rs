//! The tour: every line of it is confirmed, and fits a terminal.

#[path = "../../examples/tour.rs"]
#[allow(dead_code, reason = "only `outcome` is used here")]
mod tour;

use example_report::Verdict;

#[test]
fn the_tour_confirms_every_line() {
    let found = tour::outcome(&tour::Options { tau: vec![1.75] }).unwrap();
    assert_eq!(found.status(), Verdict::True, "{}", found.text(false));
    assert!(found.text(false).lines().count() <= 30, "{}", found.text(false));
}
