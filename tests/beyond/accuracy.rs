//! The planted extremes, and speed against accuracy.

#[path = "../../examples/extremes.rs"]
#[allow(dead_code, reason = "only `outcome` is used here")]
mod extremes;

#[path = "../../examples/section_2_speed_for_accuracy.rs"]
#[allow(dead_code, reason = "only `outcome` is used here")]
mod contact_speed;

#[path = "../../examples/speed_for_accuracy.rs"]
#[allow(dead_code, reason = "only `outcome` is used here")]
mod speed;

use example_report::Verdict;

#[test]
fn every_hard_input_gets_digits() {
    let found = extremes::outcome(&extremes::Options::default()).unwrap();
    assert_eq!(found.status(), Verdict::True, "{}", found.text(false));
    let errors = found.numbers("error");
    assert!(
        errors[..14].iter().all(|error| *error <= 1e-9) && errors[14..].iter().all(|error| error.is_nan())
    );
}

#[test]
fn tolerances_of_the_toolkit_are_met() {
    let found = speed::outcome(&speed::Options { repeat: 1, ..Default::default() }).unwrap();
    assert_eq!(found.status(), Verdict::True, "{}", found.text(false));
}

#[test]
fn errors_of_contact_solutions_fall_whatever_the_road() {
    let options = contact_speed::Options { n: vec![8, 16, 32, 64], ..Default::default() };
    let found = contact_speed::outcome(&options).unwrap();
    assert_eq!(found.status(), Verdict::True, "{}", found.text(false));
    let errors = found.numbers("error");
    assert!(errors.iter().all(|&error| error > 0.0) && errors[0] > errors[errors.len() - 1]);
}
