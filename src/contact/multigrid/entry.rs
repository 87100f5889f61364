//! The multigrid solver from outside.

use super::super::condensed;
use super::super::problem::ContactProblem;
use super::accuracy::{Accuracy, Fallback, MOST_INCOMPRESSIBLE, MultigridProgress, MultigridSolution};
use super::chain::Chain;
use super::nested::{self, Observer};
use crate::cone::Cone;
use crate::error::{Error, Result};
use crate::fem::Form;
use crate::mesh::Hierarchy;

/// Unknowns of a coarsest mesh up to which it is worth eliminating.
const COARSEST: usize = 100_000;

impl ContactProblem {
    /// The discrete solution by multigrid, as exact as asked for. Coarser meshes are those of the hierarchy,
    /// whose finest mesh must be that of the problem, or else every other line of a grid. Where there are
    /// none, near Poisson's ratio 1/2, or where cycles do not reach the accuracy, the direct solver takes
    /// over and the answer says so.
    ///
    /// `observe` hears of every step; its error ends the iteration. Loads whose squares leave the range of
    /// binary64 are solved for in units of a power of two.
    ///
    /// ```
    /// use signorini::cone::Cone;
    /// use signorini::contact::Accuracy;
    /// use signorini::scenes::MeshScene;
    /// let problem = MeshScene::Block.problem(32)?;
    /// let found = problem.solve_by_multigrid(Cone::Nodal, None, Accuracy::default(), |_| Ok(()))?;
    /// assert!(found.solution.status.is_converged() && found.fallback.is_none());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`ContactProblem::solve`]; [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a hierarchy of another mesh;
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless the share of the error of discretisation is in (0, 1]; what `observe`
    /// returns.
    pub fn solve_by_multigrid(
        &self,
        cone: Cone,
        hierarchy: Option<&Hierarchy>,
        accuracy: Accuracy,
        mut observe: impl FnMut(&MultigridProgress) -> Result<()> + Send,
    ) -> Result<MultigridSolution> {
        if let Accuracy::OfDiscretisation(share) = accuracy {
            Error::require(
                "share of the error of discretisation",
                share,
                "(0, 1]",
                share > 0.0 && share <= 1.0,
            )?;
        }
        if let Some((scaled, unit)) = self.in_unit() {
            let mut heard = |progress: &MultigridProgress| {
                observe(&MultigridProgress { error: progress.error * unit, ..*progress })
            };
            return scaled.by_cycles(cone, hierarchy, accuracy, &mut heard)?.scaled_by(unit);
        }
        self.by_cycles(cone, hierarchy, accuracy, &mut |progress| observe(progress))
    }

    /// The same in the units of the problem.
    fn by_cycles(
        &self,
        cone: Cone,
        hierarchy: Option<&Hierarchy>,
        accuracy: Accuracy,
        observe: &mut Observer<'_>,
    ) -> Result<MultigridSolution> {
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
        // Inside the pool, so that short tasks need no other thread.
        let (found, ()) = rayon::join(|| nested::solve(self, &chain, cone, accuracy, observe), || ());
        let found = found?;
        if found.solution.status.is_converged() || self.unknowns() > LARGEST_DIRECT {
            return Ok(found);
        }
        Ok(MultigridSolution { levels: found.levels, ..self.directly(cone, Fallback::NotReached)? })
    }

    fn directly(&self, cone: Cone, why: Fallback) -> Result<MultigridSolution> {
        let solution = condensed::solve_by_cascade(self, cone)?;
        Ok(MultigridSolution {
            coarsest_steps: solution.history.len(),
            solution,
            error: None,
            discretisation: None,
            levels: Vec::new(),
            fallback: Some(why),
        })
    }

    /// The largest λ/μ of the materials; 0 for a scalar form.
    fn compressibility(&self) -> f64 {
        match &self.form {
            Form::Scalar { .. } => 0.0,
            Form::Elastic { materials } => materials.iter().map(|m| m.lambda() / m.mu()).fold(0.0, f64::max),
        }
    }
}

/// Unknowns up to which the direct solver is tried when cycles fail: n = 1024, some 4 GB.
const LARGEST_DIRECT: usize = 2_200_000;
