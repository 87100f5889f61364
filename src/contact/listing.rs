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
            Column::new("energy", "J", Format::Significant(13), "energy a(u,u)/2 - l(u)"),
            Column::new("active", "active", words, "constraints that hold with equality"),
            Column::hidden("constraints"),
            Column::new("runs", "contact on", Format::Significant(4), "first and last position of every run"),
            Column::new("pressure", "p", Format::Significant(4), "largest contact pressure"),
            Column::new("contact_force", "force", Format::Significant(7), "sum of the multipliers"),
            Column::new(
                "balance",
                "balance",
                Format::Scientific(1),
                "loads + reactions - contact force, relative",
            ),
            Column::new(
                "kkt",
                "KKT",
                Format::Scientific(1),
                "worst of balance, sign, gap, complementarity, each scaled",
            ),
            Column::hidden("kkt_balance"),
            Column::hidden("kkt_sign"),
            Column::hidden("kkt_gap"),
            Column::hidden("kkt_complementarity"),
            Column::new(
                "pressure_margin",
                "p margin",
                Format::Scientific(1),
                "least active multiplier over the largest; 0 is weak contact",
            ),
            Column::new(
                "gap_margin",
                "gap margin",
                Format::Scientific(1),
                "least inactive gap over the largest displacement; 0 is weak contact",
            ),
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
            Column::new("status", "status", words, ""),
            Column::new("seconds", "s", Format::Significant(2), "seconds, assembly included"),
            Column::hidden("seconds_assembly"),
            Column::new(
                "seconds_factorization",
                "eliminate",
                Format::Significant(2),
                "seconds of elimination",
            ),
            Column::new(
                "seconds_contact",
                "iterate",
                Format::Significant(2),
                "seconds of the contact iteration",
            ),
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
