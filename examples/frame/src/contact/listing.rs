//! The rows that contact solutions contribute to a table, the same in every example.

use crate::{Cell, Column, Format, Table};
use experiments::contact_levels::SceneRun;

/// Every solution of a study, coarsest mesh first.
pub fn table(runs: &[SceneRun]) -> Table {
    Table::new(columns("")).with_rows(runs.iter().map(row))
}

/// The same of a body whose meshes have no cells along a side.
pub(super) fn own_table(runs: &[SceneRun]) -> Table {
    Table::new(columns("segments of the contact edge")).with_rows(runs.iter().map(row))
}

/// The largest of numbers ≥ 0; not a number if one of them is not.
pub fn worst(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |worst, value| if value > worst || value.is_nan() { value } else { worst })
}

fn columns(n: &str) -> Vec<Column> {
    let words = Format::Significant(3);
    vec![
        Column::new("n", "n", words, n),
        Column::hidden("unknowns"),
        Column::hidden("cone"),
        Column::new("solver", "solver", words, ""),
        Column::new("energy", "J", Format::Significant(10), "energy a(u,u)/2 - l(u)"),
        Column::hidden("energy_rounding"),
        Column::new("active", "active", words, "constraints that hold with equality"),
        Column::hidden("constraints"),
        Column::new("runs", "contact on", Format::Significant(4), "first and last position of every run"),
        Column::hidden("pressure"),
        Column::new("contact_force", "force", Format::Significant(6), "sum of the multipliers"),
        Column::new(
            "balance",
            "balance",
            Format::Scientific(0),
            "loads, reactions and contact force, relative",
        ),
        Column::new(
            "kkt",
            "KKT",
            Format::Scientific(0),
            "worst of nodal balance, sign, gap, complementarity, each scaled",
        ),
        Column::hidden("kkt_balance"),
        Column::hidden("kkt_sign"),
        Column::hidden("kkt_gap"),
        Column::hidden("kkt_complementarity"),
        Column::hidden("pressure_margin"),
        Column::hidden("gap_margin"),
        Column::new(
            "iterations",
            "steps",
            words,
            "iterations, from the contact set of the mesh before if there is one",
        ),
        Column::new(
            "iterations_cold",
            "cold",
            words,
            "iterations from no contact, where the solution started from a coarser one",
        ),
        Column::hidden("status"),
        Column::hidden("algebraic_error"),
        Column::new(
            "seconds",
            "s",
            Format::Significant(2),
            "seconds, assembly included; by phase with --json",
        ),
        Column::hidden("seconds_assembly"),
        Column::hidden("seconds_factorization"),
        Column::hidden("seconds_contact"),
        Column::hidden("seconds_recovery"),
    ]
}

fn row(run: &SceneRun) -> Vec<Cell> {
    let SceneRun { n, problem, solution, cold_steps } = run;
    let (error, report) = (run.error(), solution.multigrid.as_ref());
    let fallback = report.and_then(|report| report.fallback);
    let status = fallback.map_or(solution.status.to_string(), |why| format!("{}, {why}", solution.status));
    let ends = solution.contact_set.runs().into_iter().flat_map(|run| [run.start, run.end - 1]);
    let runs: Vec<f64> = ends.map(|i| solution.positions[i]).collect();
    vec![
        (*n).into(),
        problem.free_unknowns().into(),
        solution.cone.to_string().into(),
        solution.solver.to_string().into(),
        solution.energy.into(),
        solution.energy_rounding.into(),
        solution.contact_set.count().into(),
        solution.contact_set.constraints().into(),
        runs.into(),
        solution.pressure.iter().fold(0.0, |m: f64, &p| m.max(p)).into(),
        solution.contact_force.into(),
        solution.balance.into(),
        solution.kkt.worst().into(),
        solution.kkt.balance.into(),
        solution.kkt.sign.into(),
        solution.kkt.gap.into(),
        solution.kkt.complementarity.into(),
        solution.margins.pressure.into(),
        solution.margins.gap.into(),
        (solution.work.iterations as usize).into(),
        cold_steps.map(|steps| steps as usize).into(),
        status.into(),
        error.map(|norm| norm.relative_error()).into(),
        solution.seconds.total().into(),
        solution.seconds.assembly.into(),
        solution.seconds.factorization.into(),
        solution.seconds.contact.into(),
        solution.seconds.recovery.into(),
    ]
}
