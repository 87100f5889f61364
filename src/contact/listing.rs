//! The row that a contact solution contributes to a table, the same in every example.

use super::problem::ContactProblem;
use super::solution::ContactSolution;
use crate::report::{Cell, Column, Format};

impl ContactSolution {
    /// The columns of [`ContactSolution::row`].
    pub fn columns() -> Vec<Column> {
        let words = Format::Significant(3);
        vec![
            Column::new("n", "n", words, ""),
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

    /// The row of this solution; `n` is whatever counts the mesh in the example, `cold_steps` what a start without contact took.
    pub fn row(&self, n: usize, problem: &ContactProblem, cold_steps: Option<u64>) -> Vec<Cell> {
        let ends = self.contact_set.runs().into_iter().flat_map(|run| [run.start, run.end - 1]);
        let runs: Vec<f64> = ends.map(|i| self.positions[i]).collect();
        vec![
            n.into(),
            problem.free_unknowns().into(),
            self.cone.to_string().into(),
            self.solver.to_string().into(),
            self.energy.into(),
            self.energy_rounding.into(),
            self.contact_set.count().into(),
            self.contact_set.constraints().into(),
            runs.into(),
            self.pressure.iter().fold(0.0, |m: f64, &p| m.max(p)).into(),
            self.contact_force.into(),
            self.balance.into(),
            self.judgement.worst().into(),
            self.judgement.balance.into(),
            self.judgement.sign.into(),
            self.judgement.gap.into(),
            self.judgement.complementarity.into(),
            self.margins.pressure.into(),
            self.margins.gap.into(),
            (self.work.iterations as usize).into(),
            cold_steps.map(|steps| steps as usize).into(),
            self.status.to_string().into(),
            self.seconds.total().into(),
            self.seconds.assembly.into(),
            self.seconds.factorization.into(),
            self.seconds.contact.into(),
            self.seconds.recovery.into(),
        ]
    }
}
