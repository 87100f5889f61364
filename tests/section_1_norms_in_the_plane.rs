//! Section 1 in the plane: closed form, both limits, and planted faults.

#[allow(dead_code)]
#[path = "../examples/section_1_norms_in_the_plane.rs"]
mod example;

use example_frame::Outcome;
use fractional_sobolev::Estimate;

#[test]
fn the_norm_has_its_closed_form_and_its_limits() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
}

#[test]
fn a_wrong_norm_and_a_finite_norm_of_a_step_are_seen() {
    let options = example::Options { squares: 2, ..example::Options::default() };
    let sound = example::compute(&options).unwrap();
    let outcome = |rows: &[example::Row], key: &str| {
        let found = example::findings(&options, rows);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    for key in ["closed.form", "infinite", "one", "half"] {
        assert_eq!(outcome(&sound, key), Outcome::Holds, "{key}");
    }
    let wrong = |e: Estimate| Estimate { value: (1.0 + 1e-5) * e.value, ..e };
    let mut rows = example::compute(&options).unwrap();
    rows.iter_mut().for_each(|row| row.coordinate = wrong(row.coordinate));
    for key in ["closed.form", "one"] {
        assert_eq!(outcome(&rows, key), Outcome::Refuted, "{key}");
    }
    let mut rows = example::compute(&options).unwrap();
    rows.iter_mut().for_each(|row| row.step = row.step.map(wrong));
    assert_eq!(outcome(&rows, "half"), Outcome::Refuted);
    rows[4].step = Some(rows[4].coordinate);
    assert_eq!(outcome(&rows, "infinite"), Outcome::Refuted);
}
