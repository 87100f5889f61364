//! The solvers, by name.

use crate::error::{Error, Result};
use std::fmt;
use std::str::FromStr;

/// Unrelated roads to the same discrete solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Solver {
    /// Eliminate all but the contact unknowns once, then a primal-dual active set on the edge.
    #[default]
    ActiveSet,
    /// A general interior point method for quadratic programs (Clarabel) on the full sparse problem.
    InteriorPoint,
    /// Nested iteration with conjugate gradients and a V-cycle.
    Multigrid,
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Solver::ActiveSet => "active-set",
            Solver::InteriorPoint => "interior-point",
            Solver::Multigrid => "multigrid",
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
            _ => Err(Error::UnknownName {
                what: "solver",
                given: text.to_owned(),
                expected: "active-set, interior-point or multigrid",
            }),
        }
    }
}
