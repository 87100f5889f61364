//! Choice of solver and first guess.

use super::cone::Cone;
use super::contact_set::ContactSet;
use super::problem::ContactProblem;
use super::solution::ContactSolution;
use super::{condensed, interior_point};
use crate::error::{Error, Result};
use std::fmt;
use std::str::FromStr;

/// Two unrelated roads to the same discrete solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Solver {
    /// Eliminate all but the contact unknowns once, then a primal-dual active set on the edge.
    #[default]
    ActiveSet,
    /// A general interior point method for quadratic programs (Clarabel) on the full sparse problem.
    InteriorPoint,
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Solver::ActiveSet => "active-set",
            Solver::InteriorPoint => "interior-point",
        })
    }
}

impl FromStr for Solver {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "active-set" => Ok(Solver::ActiveSet),
            "interior-point" => Ok(Solver::InteriorPoint),
            _ => Err(Error::UnknownName {
                what: "solver",
                given: text.to_owned(),
                expected: "active-set or interior-point",
            }),
        }
    }
}

impl ContactProblem {
    /// The discrete solution in the given cone by the given solver, judged. The active set starts without contact.
    ///
    /// ```
    /// use signorini::{contact::{Cone, Solver}, scenes::MeshScene};
    /// let solution = MeshScene::Membrane.problem(8)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// assert!(solution.status.is_converged() && solution.judgement.worst() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] when some part of the body is not held, [`Error::CountOutOfRange`] for the midpoint
    /// cone on a closed edge. How the iteration ended is in the status.
    pub fn solve(&self, cone: Cone, solver: Solver) -> Result<ContactSolution> {
        match solver {
            Solver::ActiveSet => self.solve_from(cone, self.no_contact(cone)),
            Solver::InteriorPoint => {
                self.check_ends(cone)?;
                interior_point::solve(self, cone)
            }
        }
    }

    /// The same from the contact set of the next coarser mesh, every contact segment of which was halved.
    ///
    /// # Errors
    /// As for [`ContactProblem::solve_from`].
    pub fn solve_after(&self, coarse: &ContactSolution) -> Result<ContactSolution> {
        self.solve_from(coarse.cone, coarse.cone.refined_set(&coarse.contact_set))
    }

    /// [`ContactProblem::solve_after`], and the number of steps that a start without contact would have taken; the
    /// elimination is shared.
    ///
    /// # Errors
    /// As for [`ContactProblem::solve_from`].
    pub fn solve_after_beside_cold(
        &self,
        coarse: &ContactSolution,
    ) -> Result<(ContactSolution, Option<u64>)> {
        self.check_ends(coarse.cone)?;
        let (guess, cold) = (coarse.cone.refined_set(&coarse.contact_set), self.no_contact(coarse.cone));
        condensed::solve(self, coarse.cone, guess, Some(cold))
    }

    /// The discrete solution by the active set, starting from a guess of the contact set (of a coarser level, say).
    ///
    /// # Errors
    /// As for [`ContactProblem::solve`]; [`Error::LengthMismatch`] when the guess has the wrong length.
    pub fn solve_from(&self, cone: Cone, guess: ContactSet) -> Result<ContactSolution> {
        self.check_ends(cone)?;
        condensed::solve(self, cone, guess, None).map(|(solution, _)| solution)
    }

    fn no_contact(&self, cone: Cone) -> ContactSet {
        ContactSet::empty(cone.constraints(self.edge().nodes().len()))
    }

    /// On a closed edge with as many segments as nodes the means may be dependent, and multipliers are not unique.
    fn check_ends(&self, cone: Cone) -> Result<()> {
        if cone == Cone::Midpoint && self.edge().is_closed() {
            let range = "2 for the midpoint cone: a closed contact edge has as many segments as nodes";
            return Err(Error::CountOutOfRange { name: "ends of the contact edge", value: 0, range });
        }
        Ok(())
    }
}
