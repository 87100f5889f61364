//! What the contact iteration on the edge hands back.

use crate::cone::{Cone, ContactSet, KktResiduals, Margins, Status};

/// A discrete contact solution on the edge, with its KKT residuals.
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
    /// min ½ g'A g − b'g.
    pub energy: f64,
    /// How the iteration ended.
    pub status: Status,
    /// The four scaled KKT residuals.
    pub kkt: KktResiduals,
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
