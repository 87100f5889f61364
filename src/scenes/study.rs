//! A scene on one mesh or on nested ones, by one solver or by both: what the examples of Section 2 print.

use super::{MeshScene, Setting};
use crate::contact::{Cone, ContactProblem, ContactSolution, NOISE, Solver};
use crate::error::{Error, Result};
use crate::report::{Headline, Table, Verdict};

/// Both solvers must agree in J to this, relative.
pub const AGREEMENT: f64 = 1e-8;

/// Every scaled KKT figure must be below this.
pub const JUDGED: f64 = 1e-10;

/// What to solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneStudy {
    /// The scene.
    pub scene: MeshScene,
    /// Its parameters.
    pub setting: Setting,
    /// The cone.
    pub cone: Cone,
    /// One solver; both when `None`.
    pub solver: Option<Solver>,
    /// Cells along each side of the coarsest mesh.
    pub n: usize,
    /// Number of meshes n, 2n, 4n, ...; the active set starts from the contact set of the mesh before.
    pub levels: usize,
}

/// One solution of a study.
#[derive(Debug, Clone)]
pub struct SceneRun {
    /// Cells along each side.
    pub n: usize,
    /// The assembled problem.
    pub problem: ContactProblem,
    /// Its solution.
    pub solution: ContactSolution,
    /// Steps of the active set from an empty contact set, when `solution` started from a coarser one.
    pub cold_steps: Option<u64>,
}

impl SceneStudy {
    /// Solves on every level, coarsest first, the active set before the interior point.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without levels; whatever meshes, problems and solvers return.
    pub fn run(&self) -> Result<Vec<SceneRun>> {
        if !(1..=12).contains(&self.levels) {
            return Err(Error::CountOutOfRange { name: "levels", value: self.levels, range: "[1, 12]" });
        }
        let solvers =
            self.solver.map_or(vec![Solver::ActiveSet, Solver::InteriorPoint], |solver| vec![solver]);
        let mut runs: Vec<SceneRun> = Vec::new();
        for level in 0..self.levels {
            let n = self.n.saturating_mul(1 << level);
            let problem = self.scene.problem_with(n, &self.setting)?;
            let coarser = runs.iter().rev().find(|run| run.solution.solver == Solver::ActiveSet);
            let coarser = coarser.map(|run| run.solution.clone());
            for &solver in &solvers {
                let (solution, cold_steps) = match (&coarser, solver) {
                    (Some(coarse), Solver::ActiveSet) if !problem.edge().is_closed() => {
                        problem.solve_after_beside_cold(coarse)?
                    }
                    _ => (problem.solve(self.cone, solver)?, None),
                };
                runs.push(SceneRun { n, problem: problem.clone(), solution, cold_steps });
            }
        }
        Ok(runs)
    }

    /// Table, verdict and quoted numbers of the runs. The numbers are those of the finest level.
    pub fn headline(&self, runs: &[SceneRun]) -> Result<Headline> {
        let mut table = Table::new(ContactSolution::columns());
        for run in runs {
            table.push(run.solution.row(run.n, &run.problem, run.cold_steps));
        }
        let finest = runs.iter().map(|run| run.n).max().unwrap_or(0);
        let Some(last) = runs.iter().find(|run| run.n == finest) else {
            return Err(Error::CountOutOfRange { name: "runs", value: 0, range: "[1, inf)" });
        };
        let worst = runs.iter().fold(0.0, |w: f64, run| w.max(run.solution.judgement.worst()));
        let apart = disagreement(runs);
        let solution = &last.solution;
        let measured = format!(
            "J = {:.12e} ± {:.0e}, {} of {} constraints active, contact force {:.8e}, KKT {worst:.0e}",
            solution.energy,
            solution.energy_rounding,
            solution.contact_set.count(),
            solution.contact_set.constraints(),
            solution.contact_force,
        );
        let converged = runs.iter().all(|run| run.solution.status.is_converged());
        let balance = runs.iter().fold(0.0, |w: f64, run| w.max(run.solution.balance));
        let verdict = if !converged || worst > JUDGED || apart > AGREEMENT || apart.is_nan() {
            Verdict::NotConfirmed(format!("KKT {worst:.1e}, energies apart by {apart:.1e}"))
        } else if balance > AGREEMENT {
            Verdict::NotConfirmed(format!("too few digits: forces balance to {balance:.0e} only"))
        } else {
            Verdict::Holds
        };
        let kind = if self.scene.is_elastic() { "elastic" } else { "scalar" };
        let claim = if self.solver.is_some() {
            format!(
                "a solution of the {kind} problem in the {} cone meets every discrete condition",
                self.cone
            )
        } else {
            format!(
                "the {kind} problem in the {} cone has one solution; two unrelated solvers find it",
                self.cone
            )
        };
        let label = match self.cone {
            Cone::Nodal => format!("Section 2, (2.9), {kind}"),
            Cone::Midpoint => format!("Section 4, (4.1), {kind}"),
        };
        let mut headline = Headline::new(label, claim, table, measured, verdict);
        for (key, value) in [
            ("energy", solution.energy),
            ("force", solution.contact_force),
            ("active", solution.contact_set.count() as f64),
            ("kkt", worst),
        ] {
            headline.quote(format!("section.2.{}.{}.{key}", self.scene, self.cone), value);
        }
        Ok(headline)
    }
}

/// The largest difference in J between solutions on the same mesh, relative. Not a number if J is not.
fn disagreement(runs: &[SceneRun]) -> f64 {
    runs.windows(2)
        .filter(|pair| pair[0].n == pair[1].n)
        .map(|pair| {
            let difference = (pair[0].solution.energy - pair[1].solution.energy).abs();
            if difference == 0.0 { 0.0 } else { difference / energy_scale(&pair[0].solution) }
        })
        .fold(0.0, |worst: f64, apart| if apart.is_nan() { apart } else { worst.max(apart) })
}

/// |J|; where contact prevents every displacement J is rounding, and force times displacement is its scale.
fn energy_scale(solution: &ContactSolution) -> f64 {
    let largest = solution.displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    if largest <= NOISE * solution.displacement_scale {
        solution.force_scale * solution.displacement_scale
    } else {
        solution.energy.abs()
    }
}
