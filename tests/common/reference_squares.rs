//! The rows of tests/reference/signorini_square.json and what must agree with them.

use serde_json::Value;
use signorini::cone::Cone;
use signorini::contact::{ContactSolution, Solver};
use signorini::problems::TestProblem;

/// Relative difference in J: the rows agree among themselves to 12 digits or more.
const ENERGY: f64 = 1e-11;
/// Force balance relative to the load: 10^4 additions of size ε.
const BALANCE: f64 = 1e-12;
/// Multipliers, gaps: relative to the largest of their kind; rows carry them to about 1e-12.
const MARGIN: f64 = 1e-9;
/// Scaled KKT figures of a direct solution with refinement.
const KKT: f64 = 1e-11;

pub fn check_against_reference(problem: &str, scene: TestProblem, cone: Cone) {
    let text = include_str!("../reference/signorini_square.json");
    let all: Value = serde_json::from_str(text).unwrap();
    let rows: Vec<&Value> =
        all["cases"].as_array().unwrap().iter().filter(|row| row["problem"] == problem).collect();
    assert_eq!(rows.len(), 4, "{problem}");
    for row in rows {
        let n = row["n"].as_u64().unwrap() as usize;
        let solution = scene.problem(n).unwrap().solve(cone, Solver::ActiveSet).unwrap();
        check_row(row, &solution, &format!("{problem} n = {n}"));
    }
}

fn check_row(row: &Value, solution: &ContactSolution, case: &str) {
    let number = |key: &str| row[key].as_f64().unwrap();
    let close = |value: f64, key: &str, tolerance: f64| {
        let reference = number(key);
        let relative = (value / reference - 1.0).abs();
        assert!(
            relative <= tolerance,
            "{case}: {key} {value:e}, reference {reference:e}, off by {relative:e}"
        );
    };
    assert!(solution.status.is_converged(), "{case}: {}", solution.status);
    close(solution.energy, "J", ENERGY);
    close(solution.contact_force, "sum_multipliers", MARGIN);
    close(solution.multiplier.iter().fold(0.0, |m: f64, &l| m.max(l)), "max_multiplier", MARGIN);
    assert_eq!(
        solution.contact_set.count() as u64,
        row["active_count"].as_u64().unwrap(),
        "{case}"
    );
    let runs: Vec<(f64, f64, u64)> = solution
        .contact_set
        .runs()
        .iter()
        .map(|run| {
            (solution.positions[run.start], solution.positions[run.end - 1], run.len() as u64)
        })
        .collect();
    let expected: Vec<(f64, f64, u64)> = row["active_runs_xfirst_xlast_count"]
        .as_array()
        .unwrap()
        .iter()
        .map(|run| (run[0].as_f64().unwrap(), run[1].as_f64().unwrap(), run[2].as_u64().unwrap()))
        .collect();
    assert_eq!(runs, expected, "{case}");
    assert!(solution.balance <= BALANCE, "{case}: balance {:e}", solution.balance);
    assert!(solution.kkt.worst() <= KKT, "{case}: {:?}", solution.kkt);
}
