//! Multigrid beside elimination, on every scene and on what is hard for cycles.

#[allow(dead_code)]
#[path = "../examples/section_2_multigrid.rs"]
mod example;

use example_frame::contact::RoadsRow;
use example_frame::{Outcome, Verdict};
use experiments::hard_cases::HardCase;
use signorini::contact::Fallback;

fn outcome(rows: &[RoadsRow], key: &str) -> Outcome {
    let found = example::findings(&example::Options::default(), rows);
    found.into_iter().find(|finding| finding.key() == key).unwrap().outcome()
}

#[test]
fn both_roads_end_at_the_same_solution_and_planted_faults_are_seen() {
    let options = example::Options { n: 16, ..example::Options::default() };
    let mut rows = example::compute(&options).unwrap();
    let found = example::findings(&options, &rows);
    assert!(Verdict::of(&found).is_confirmed(), "{:?}", found.iter().map(|f| f.words()).collect::<Vec<_>>());
    let by_cycles = rows.iter().position(|row| row.found.fallback.is_none()).unwrap();
    let before = rows[by_cycles].found;
    for (key, spoil) in [
        ("energies", (|row: &mut RoadsRow| row.found.energies_apart = 2e-11) as fn(&mut RoadsRow)),
        ("sets", |row| row.found.sets_apart = Some(1)),
        ("ended", |row| row.found.is_converged = false),
        ("promise", |row| row.found.algebraic = 1e-3),
    ] {
        assert_eq!(outcome(&rows, key), Outcome::Holds, "{key}");
        spoil(&mut rows[by_cycles]);
        assert_eq!(outcome(&rows, key), Outcome::Refuted, "{key}");
        rows[by_cycles].found = before;
    }
    let beyond = |row: &RoadsRow| matches!(row.case, HardCase::Compressibility(ratio) if ratio == 1000.0);
    let row = rows.iter_mut().find(|row| beyond(row)).unwrap();
    assert_eq!(row.found.fallback, Some(Fallback::NearlyIncompressible));
    row.found.fallback = None;
    assert_eq!(outcome(&rows, "beyond"), Outcome::Refuted);
}

#[test]
fn bad_options_are_refused() {
    for tolerance in [0.0, -1.0, 2.0, f64::NAN] {
        assert!(example::compute(&example::Options { tolerance, ..example::Options::default() }).is_err());
    }
    assert!(example::compute(&example::Options { n: 0, levels: 1, ..example::Options::default() }).is_err());
}
