//! Choice of solver and first guess.

use super::multigrid::Accuracy;
use super::problem::ContactProblem;
use super::solution::ContactSolution;
use super::solver::Solver;
use super::{condensed, interior_point};
use crate::cone::{Cone, ContactSet};
use crate::error::{Error, Result, ToolkitError};
use fractional_sobolev::Tolerance;

impl ContactProblem {
    /// The discrete solution in the given cone by the given solver, judged. The active set starts without
    /// contact; multigrid is asked for twelve digits in the energy norm.
    ///
    /// On a closed edge with an even number of segments, all of them in contact, the means of the midpoint
    /// cone are dependent: of the multipliers, which differ by a sawtooth, the one with the greatest minimum
    /// is returned.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, scenes::MeshScene};
    /// let solution = MeshScene::Membrane.problem(8)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// assert!(solution.status.is_converged() && solution.kkt.worst() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::NotPositiveDefinite`](crate::ToolkitError::NotPositiveDefinite) when some part of the body is not held; [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for the
    /// midpoint cone on a contact edge in several pieces. How the iteration ended is in the status.
    pub fn solve(&self, cone: Cone, solver: Solver) -> Result<ContactSolution> {
        self.require_cone(cone)?;
        match solver.for_unknowns(self.unknowns()) {
            Solver::ActiveSet => self.solve_from(cone, self.no_contact(cone)),
            Solver::Multigrid | Solver::Auto => {
                let accuracy = Accuracy::Relative(Tolerance::reference());
                Ok(self.solve_by_multigrid(cone, None, accuracy, |_| Ok(()))?.solution)
            }
            Solver::InteriorPoint => interior_point::solve(self, cone),
            Solver::EdgeInteriorPoint => condensed::solve_by_program(self, cone),
        }
    }

    /// The same from the contact set of the next coarser mesh, every contact segment of which was halved.
    ///
    /// # Errors
    /// As for [`ContactProblem::solve_from`]; [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) on an edge in several pieces.
    pub fn solve_after(&self, coarse: &ContactSolution) -> Result<ContactSolution> {
        self.edge.require_one_piece()?;
        self.solve_from(coarse.cone, self.edge_cone(coarse.cone).refined_set(&coarse.contact_set)?)
    }

    /// [`ContactProblem::solve_after`], and the number of steps that a start without contact would have
    /// taken; the elimination is shared.
    ///
    /// # Errors
    /// As for [`ContactProblem::solve_after`].
    pub fn solve_after_beside_cold(
        &self,
        coarse: &ContactSolution,
    ) -> Result<(ContactSolution, Option<u64>)> {
        self.edge.require_one_piece()?;
        let guess = self.edge_cone(coarse.cone).refined_set(&coarse.contact_set)?;
        condensed::solve(self, coarse.cone, guess, Some(self.no_contact(coarse.cone)))
    }

    /// The discrete solution by the active set, starting from a guess of the contact set (of a coarser level,
    /// say).
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, scenes::MeshScene};
    /// let problem = MeshScene::Block.problem(8)?;
    /// let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// let again = problem.solve_from(Cone::Nodal, solution.contact_set.clone())?;
    /// assert_eq!(again.work.iterations, 1);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`ContactProblem::solve`]; [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) when the guess has the wrong length.
    pub fn solve_from(&self, cone: Cone, guess: ContactSet) -> Result<ContactSolution> {
        self.require_cone(cone)?;
        condensed::solve(self, cone, guess, None).map(|(solution, _)| solution)
    }

    /// The discrete solution in the nodal cone by an interior point method on the condensed edge, with one barrier
    /// weight per node: S_ii d_i² for the relative `sizes` d_i > 0 expected of the displacement there.
    ///
    /// Near a singular point it is used on every decade of the mesh. [`Solver::InteriorPoint`], with one weight for
    /// all nodes, is run on half as many decades in `section_1_clamped_end`, because it does not resolve more.
    ///
    /// # Errors
    /// As for [`ContactProblem::solve`]; [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) and
    /// [`ToolkitError::EntryOutOfRange`](crate::ToolkitError::EntryOutOfRange) for `sizes` of another length or not
    /// positive; [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) on a closed edge and on one
    /// in several pieces.
    pub fn solve_by_sizes(&self, sizes: &[f64]) -> Result<ContactSolution> {
        self.edge.require_one_piece()?;
        if self.edge().is_closed() {
            let range = "2 for the barrier on the edge";
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "ends of the contact edge",
                value: 0,
                range,
            }));
        }
        condensed::solve_by_sizes(self, sizes)
    }

    fn no_contact(&self, cone: Cone) -> ContactSet {
        ContactSet::empty(self.edge_cone(cone).constraints())
    }
}
