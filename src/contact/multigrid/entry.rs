//! The entry point of the multigrid solver.

use super::super::condensed;
use super::super::problem::ContactProblem;
use super::super::solution::ContactSolution;
use super::accuracy::{Accuracy, Fallback, MOST_INCOMPRESSIBLE, MultigridReport, Progress};
use super::chain::Chain;
use super::nested::{self, Observer};
use crate::cone::Cone;
use crate::error::{Error, Result};
use crate::fem::Form;
use crate::mesh::Hierarchy;

/// Largest number of unknowns of a coarsest mesh that is treated by elimination.
const COARSEST: usize = 100_000;

impl ContactProblem {
    /// The discrete solution by multigrid, to the requested accuracy. The coarser meshes are those of the hierarchy,
    /// whose finest mesh must be that of the problem, or otherwise every other line of a grid. If there are none, if
    /// Poisson's ratio is close to 1/2, or if multigrid does not reach the accuracy, the direct solver is used and
    /// the report gives the reason. Problems whose squared loads leave the range of binary64 are scaled by a power of
    /// two.
    pub(in crate::contact) fn by_multigrid(
        &self,
        cone: Cone,
        hierarchy: Option<&Hierarchy>,
        accuracy: Accuracy,
        mut observe: Option<&mut Observer<'_>>,
    ) -> Result<ContactSolution> {
        if let Accuracy::OfDiscretisation(share) = accuracy {
            Error::require(
                "share of the discretisation error",
                share,
                "(0, 1]",
                share > 0.0 && share <= 1.0,
            )?;
        }
        if let Some((scaled, unit)) = self.in_unit() {
            let mut heard = |progress: &Progress| match &mut observe {
                Some(observe) => observe(&Progress { error: progress.error * unit, ..*progress }),
                None => Ok(()),
            };
            return scaled.by_cycles(cone, hierarchy, accuracy, &mut heard)?.scaled_by(unit);
        }
        match observe {
            Some(observe) => self.by_cycles(cone, hierarchy, accuracy, observe),
            None => self.by_cycles(cone, hierarchy, accuracy, &mut |_| Ok(())),
        }
    }

    /// The solution of a problem that needs no scaling.
    fn by_cycles(
        &self,
        cone: Cone,
        hierarchy: Option<&Hierarchy>,
        accuracy: Accuracy,
        observe: &mut Observer<'_>,
    ) -> Result<ContactSolution> {
        self.require_cone(cone)?;
        if self.edge().pieces().len() > 1 {
            return self.directly(cone, Fallback::SeveralEdges);
        }
        if cone == Cone::Midpoint && self.edge().is_closed() {
            return self.directly(cone, Fallback::ClosedEdge);
        }
        if self.compressibility() > MOST_INCOMPRESSIBLE {
            return self.directly(cone, Fallback::NearlyIncompressible);
        }
        let chain = Chain::of(self, hierarchy)?;
        let coarsest = chain.problems.first().filter(|coarsest| coarsest.unknowns() <= COARSEST);
        if coarsest.is_none() {
            return self.directly(cone, Fallback::NoLevels);
        }
        // Inside the thread pool, so that short tasks are not passed to another thread.
        let (found, ()) =
            rayon::join(|| nested::solve(self, &chain, cone, accuracy, observe), || ());
        let mut found = found?;
        if let Some(error) = found.multigrid.as_ref().and_then(|report| report.error.as_ref()) {
            found.energy_rounding += 0.5 * error.error * error.error;
        }
        if found.status.is_converged() || self.unknowns() > LARGEST_DIRECT {
            return Ok(found);
        }
        let mut solution = self.directly(cone, Fallback::NotReached)?;
        if let (Some(report), Some(tried)) = (&mut solution.multigrid, found.multigrid) {
            report.levels = tried.levels;
        }
        Ok(solution)
    }

    fn directly(&self, cone: Cone, why: Fallback) -> Result<ContactSolution> {
        let solution = condensed::solve_by_cascade(self, cone)?;
        let report = MultigridReport {
            coarsest_steps: solution.steps.len(),
            error: None,
            discretisation: None,
            levels: Vec::new(),
            fallback: Some(why),
        };
        Ok(ContactSolution { multigrid: Some(report), ..solution })
    }

    /// The largest λ/μ of the materials; 0 for a scalar form.
    fn compressibility(&self) -> f64 {
        match &self.form {
            Form::Scalar { .. } => 0.0,
            Form::Elastic { materials } => {
                materials.iter().map(|m| m.lambda() / m.mu()).fold(0.0, f64::max)
            }
        }
    }
}

/// Largest number of unknowns for which the direct solver replaces multigrid if it fails: n = 1024, about 4 GB.
const LARGEST_DIRECT: usize = 2_200_000;
