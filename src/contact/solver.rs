//! The solvers, by name.

use crate::error::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;

/// Independent solvers for the same discrete problem.
///
/// | solver | method | cost for N unknowns, n contact nodes |
/// | --- | --- | --- |
/// | `ActiveSet` | primal-dual active sets on the Schur complement S | one sparse factorization, O(n³) per step |
/// | `InteriorPoint` | primal-dual interior point method on (K, B) | 11 to 16 sparse factorizations of size N |
/// | `Multigrid` | nested iteration, V-cycle preconditioner | O(N) for a fixed accuracy |
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// let problem = TestProblem::Block.problem(8)?;
/// let direct = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
/// let independent = problem.solve(Cone::Nodal, Solver::InteriorPoint)?;
/// // the minimum of J and the contact set do not depend on the solver
/// assert!((direct.energy - independent.energy).abs() < 1e-9 * direct.energy.abs());
/// assert_eq!(direct.contact_set, independent.contact_set);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Solver {
    /// Elimination of all but the contact unknowns, followed by a primal-dual active set method on the edge.
    #[default]
    ActiveSet,
    /// A general interior point method for quadratic programs (Clarabel) on the full sparse problem: the independent
    /// computation up to some ten thousand unknowns, for an algebraic error of about 1e-9.
    InteriorPoint,
    /// Nested iteration with conjugate gradients and a V-cycle.
    Multigrid,
    /// The active set method up to [`Solver::CROSSING`] unknowns, multigrid above: the faster of the two.
    Auto,
}

impl Solver {
    /// Number of unknowns above which multigrid is faster than elimination: both take some ten milliseconds there;
    /// with a hundred times as many unknowns multigrid takes a tenth of the time and of the memory.
    pub const CROSSING: usize = 10_000;

    /// The solver that `Auto` selects for this many unknowns.
    ///
    /// ```
    /// use signorini::contact::Solver;
    /// assert_eq!(Solver::Auto.for_unknowns(Solver::CROSSING), Solver::ActiveSet);
    /// assert_eq!(Solver::Auto.for_unknowns(Solver::CROSSING + 1), Solver::Multigrid);
    /// assert_eq!(Solver::InteriorPoint.for_unknowns(1), Solver::InteriorPoint);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn for_unknowns(self, unknowns: usize) -> Self {
        match self {
            Solver::Auto if unknowns <= Self::CROSSING => Solver::ActiveSet,
            Solver::Auto => Solver::Multigrid,
            solver => solver,
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Solver::ActiveSet => "active-set",
            Solver::InteriorPoint => "interior-point",
            Solver::Multigrid => "multigrid",
            Solver::Auto => "auto",
        })
    }
}

impl FromStr for Solver {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "active-set" => Ok(Solver::ActiveSet),
            "interior-point" => Ok(Solver::InteriorPoint),
            "multigrid" => Ok(Solver::Multigrid),
            "auto" => Ok(Solver::Auto),
            _ => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "solver",
                given: text.to_owned(),
                expected: "active-set, interior-point, multigrid or auto",
            })),
        }
    }
}
