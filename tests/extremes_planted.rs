//! The planted extremes of the example, case by case, and the examples of speed against accuracy at small
//! size.

#[path = "../examples/extremes.rs"]
#[allow(dead_code, reason = "only `run` and the lists are used here")]
mod extremes;

#[path = "../examples/section_2_speed_for_accuracy.rs"]
#[allow(dead_code, reason = "only `run` is used here")]
mod contact_speed;

#[path = "../examples/speed_for_accuracy.rs"]
#[allow(dead_code, reason = "only `run` is used here")]
mod speed;

use example_frame::Verdict;

#[test]
fn every_bad_input_is_refused_with_its_reason() {
    for (planted, asked, compute, names) in extremes::cases::INADMISSIBLE {
        let outcome = compute();
        let error = outcome.expect_err(planted);
        assert!(!error.to_string().is_empty() && names(&error), "{planted}, {asked}: {error}");
    }
}

#[test]
fn every_hard_input_gets_digits() {
    let headline = extremes::run(&extremes::Options::default()).unwrap();
    assert_eq!(headline.verdict(), Verdict::Holds, "{headline}");
    for (row, (planted, ..)) in extremes::cases::ADMISSIBLE.iter().enumerate() {
        let error = headline.table.number(row, "error").unwrap();
        assert!(error <= extremes::DIGITS, "{planted}: {error:e}");
    }
}

#[test]
fn tolerances_of_the_toolkit_are_met() {
    let options = speed::Options { repeat: 1, ..Default::default() };
    let headline = speed::run(&options).unwrap();
    assert_eq!(headline.verdict(), Verdict::Holds, "{headline}");
}

#[test]
fn errors_of_contact_solutions_fall_whatever_the_road() {
    let options = contact_speed::Options { levels: 4, ..Default::default() };
    let headline = contact_speed::run(&options).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    let rows = headline.table.rows().len();
    let errors: Vec<f64> = (0..rows).map(|row| headline.table.number(row, "error").unwrap()).collect();
    assert!(errors.iter().all(|&error| error > 0.0));
    assert!(errors[0] > errors[rows - 1]);
}
