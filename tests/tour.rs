//! The tour: every row of its quick form is confirmed.

#[path = "../examples/tour.rs"]
#[allow(dead_code, reason = "only `run` is used here")]
mod tour;

#[test]
fn the_quick_tour_confirms_every_row() {
    let headline = tour::run(&tour::Options { quick: true, ..Default::default() }).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    assert_eq!(headline.table.rows().len(), 12, "{headline}");
}
