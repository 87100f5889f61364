//! The accuracy table: true errors against what was promised.

#[allow(dead_code)]
#[path = "../examples/accuracy_table.rs"]
mod example;

use example_frame::{Outcome, Verdict};
use fractional_sobolev::{Estimate, Tolerance};

fn outcome(rows: &[example::cases::Row], key: &str) -> Outcome {
    let found = example::findings(rows);
    found.iter().find(|finding| finding.key() == key).unwrap().outcome()
}

#[test]
fn no_promise_is_broken_and_planted_errors_are_seen() {
    for (tolerance, seed) in [(1e-3, 2), (1e-5, 3)] {
        let options = example::Options {
            tolerance: Tolerance::new(tolerance).unwrap(),
            each: 6,
            seed,
            ..Default::default()
        };
        let mut rows = example::compute(&options).unwrap();
        assert!(Verdict::of(&example::findings(&rows)).is_confirmed(), "{rows:#?}");
        assert!(rows.iter().map(|row| row.cases[0]).sum::<usize>() > 150);
        rows[3].share = 1.01;
        rows[4].met = 1.01;
        rows[5].cases[1] = 1;
        for key in ["promise", "met", "refused"] {
            assert_eq!(outcome(&rows, key), Outcome::Refuted, "{key}");
        }
    }
    assert_eq!(outcome(&[], "promise"), Outcome::Undecided);
}

#[test]
fn a_function_that_is_wrong_by_twice_its_promise_is_seen() {
    let options = example::Options { each: 2, ..Default::default() };
    let families = example::cases::families(2, options.seed).unwrap();
    let tolerance = Tolerance::new(1e-4).unwrap();
    for family in families.into_iter().filter(|family| family.least == 0.0) {
        let spoiled = family.cases.into_iter().map(|(exact, ask)| {
            let wrong = move |t: Tolerance| {
                let found = ask(t)?;
                let value = exact.value + 2.0 * (found.error + exact.error);
                Estimate::new(value, found.error, found.work)
            };
            (exact, Box::new(wrong) as example::cases::Ask)
        });
        let row = example::cases::Family { cases: spoiled.collect(), ..family }.row(tolerance).unwrap();
        assert!(row.share > 1.0, "{row:?}");
    }
}
