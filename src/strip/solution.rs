//! What the contact iteration on the edge is asked for, and what it hands back.

use crate::cone::{Cone, ContactSet, Judgement, Margins, Status};
use crate::error::{Error, Result};

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Residual of the last linear problem, relative, in the energy norm.
    pub tolerance: f64,
    /// Reduction of the residual asked of the linear problems while the contact set moves.
    pub reduction: f64,
    /// Allowed steps (linear problems).
    pub steps: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { tolerance: 1e-13, reduction: 1e-2, steps: 200 }
    }
}

impl Settings {
    pub(super) fn check(&self) -> Result<()> {
        let open_unit =
            |name, value: f64| Error::require(name, value, "(0, 1)", value > 0.0 && value < 1.0).map(|_| ());
        open_unit("tolerance", self.tolerance)?;
        open_unit("reduction", self.reduction)
    }
}

/// A discrete contact solution on the edge, with its judgement.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeSolution {
    /// u_N at the edge nodes.
    pub values: Vec<f64>,
    /// λ ≥ 0, one per node (nodal cone) or per segment (midpoint cone).
    pub multiplier: Vec<f64>,
    /// Active constraints.
    pub contact: ContactSet,
    /// The cone.
    pub cone: Cone,
    /// min J = ½ g'A g − b'g + c.
    pub energy: f64,
    /// How the iteration ended.
    pub status: Status,
    /// The four KKT figures.
    pub judgement: Judgement,
    /// Distance from weak contact.
    pub margins: Margins,
    /// Inner iterations of each step.
    pub inner_iterations: Vec<usize>,
}

impl EdgeSolution {
    /// Number of linear problems solved.
    pub fn steps(&self) -> usize {
        self.inner_iterations.len()
    }
}
