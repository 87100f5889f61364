//! Choice of the solver and of the initial guess.

use super::problem::ContactProblem;
use super::settings::{Settings, Start};
use super::solution::{ContactSolution, gap_of};
use super::solver::Solver;
use super::{condensed, interior_point};
use crate::cone::{Cone, ContactSet};
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::scale::largest;

impl ContactProblem {
    /// The discrete solution in the given cone, with its KKT residuals; an error if the solver does not converge.
    ///
    /// On a closed edge with an even number of segments, all of them in contact, the constraints of the midpoint cone
    /// are linearly dependent: the multipliers are determined up to a sawtooth, and those with the greatest minimum
    /// are returned.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let solution = TestProblem::Membrane.problem(8)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// assert!(solution.contact_set.count() > 0 && solution.kkt.worst() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// The solution by multigrid to the requested accuracy; [`ContactSolution::multigrid`] contains its error
    /// estimate:
    ///
    /// ```
    /// use signorini::cone::Cone;
    /// use signorini::contact::{Accuracy, Settings, Solver};
    /// use signorini::problems::TestProblem;
    /// let accuracy = Accuracy::OfDiscretisation(0.01);
    /// let settings = Settings { solver: Solver::Multigrid, accuracy, ..Settings::default() };
    /// let solution = TestProblem::Block.problem(32)?.solve(Cone::Nodal, settings)?;
    /// assert!(solution.multigrid.is_some_and(|report| report.fallback.is_none()));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotConverged`], with the best solution, unless the status is
    /// [`Status::Converged`](crate::cone::Status::Converged); [`Error::BeyondFloor`] if it is not because no
    /// displacement is admissible; and those of [`ContactProblem::attempt`].
    pub fn solve<'a>(&self, cone: Cone, how: impl Into<Settings<'a>>) -> Result<ContactSolution> {
        let found = self.attempt(cone, how)?;
        match found.status.is_converged() {
            true => Ok(found),
            false => Err(self
                .clamp_beyond_floor(cone)
                .unwrap_or_else(|| Error::not_converged(found.status, found.energy, found))),
        }
    }

    /// The error of a constraint whose nodes are all clamped, if the prescribed displacement violates it beyond
    /// rounding: then no displacement of the body is admissible.
    ///
    /// The constraint i with the largest (B u − g)_i > 8 ε max (|u|, |g|), over all nodes of the contact edge.
    fn clamp_beyond_floor(&self, cone: Cone) -> Option<Error> {
        let (cone, normals) = (self.edge_cone(cone), self.normal_unknowns());
        let values: Vec<f64> = normals.iter().map(|&unknown| self.values[unknown]).collect();
        let size = largest(&values).max(largest(&self.gap));
        let off = gap_of(self, cone, &values);
        let is_clamped = |i: usize| cone.support(i).all(|node| self.prescribed[normals[node]]);
        let clamped = (0..off.len()).filter(|&i| is_clamped(i));
        let worst = clamped.max_by(|&i, &j| off[i].total_cmp(&off[j]))?;
        (off[worst] > 8.0 * f64::EPSILON * size).then(|| Error::BeyondFloor {
            place: self.edge.points()[worst],
            displacement: values[worst],
            gap: self.gap[worst],
        })
    }

    /// What the solver found, converged or not: the termination of the iteration is in
    /// [`ContactSolution::status`], which the caller must read.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let found = TestProblem::Incompressible.problem(8)?.attempt(Cone::Nodal, Solver::InteriorPoint)?;
    /// let line = if found.status.is_converged() { found.energy.to_string() } else { found.status.to_string() };
    /// assert!(!line.is_empty());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::NotPositiveDefinite`] if some part of the body has no Dirichlet boundary;
    /// [`ToolkitError::Incompatible`] for the midpoint cone on a contact edge in several pieces and for a start from
    /// the other cone; [`Error::Solver`] for an error of Clarabel; [`ToolkitError::CountOutOfRange`] for a start from
    /// a coarser mesh if the edge has several pieces; [`ToolkitError::LengthMismatch`] for a contact set of the wrong
    /// length, or a hierarchy whose finest mesh is not that of the problem; [`ToolkitError::NotFinite`] for an energy
    /// that overflows; [`ToolkitError::OutOfRange`] unless the share of the discretisation error is in (0, 1]; the
    /// error of the progress callback.
    pub fn attempt<'a>(&self, cone: Cone, how: impl Into<Settings<'a>>) -> Result<ContactSolution> {
        let Settings { solver, start, accuracy, hierarchy, progress } = how.into();
        self.require_cone(cone)?;
        let found = match solver.for_unknowns(self.unknowns()) {
            Solver::ActiveSet => condensed::solve(self, cone, self.first_set(cone, start)?),
            // A body that only its floors keep in place has no coarse problem without contact.
            _ if self.floats && solver != Solver::InteriorPoint => {
                condensed::solve(self, cone, self.first_set(cone, start)?)
            }
            Solver::Multigrid | Solver::Auto => {
                self.by_multigrid(cone, hierarchy, accuracy, progress)
            }
            Solver::InteriorPoint => interior_point::solve(self, cone),
        };
        self.completed(cone, found)
    }

    fn first_set(&self, cone: Cone, start: Start<'_>) -> Result<ContactSet> {
        match start {
            Start::Open => {
                let constraints = self.edge_cone(cone).constraints();
                Ok(ContactSet::new(&vec![self.floats; constraints]))
            }
            Start::Set(set) => Ok(set),
            Start::Coarse(coarse) if coarse.cone != cone => {
                let (given, with) = (coarse.cone.to_string(), "a solution in the other cone");
                let (what, expected) =
                    ("initial guess for cone", "an initial guess for the same cone");
                Err(Error::Toolkit(ToolkitError::Incompatible { what, given, with, expected }))
            }
            Start::Coarse(coarse) => {
                self.edge.require_one_piece()?;
                self.edge_cone(cone).refined_set(&coarse.contact_set)
            }
        }
    }
}
