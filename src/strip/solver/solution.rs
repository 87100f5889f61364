//! What the contact iteration on the edge hands back.

use crate::cone::{Cone, ContactSet, KktResiduals, Margins, Status};

/// A discrete contact solution on the edge, with its KKT residuals.
///
/// A w − b + B'λ = 0, B w ≤ 0, λ ≥ 0 and λ'B w = 0 up to `kkt`. Hence w'A w = b'w, and the energy is −½ b'w.
///
/// ```
/// use signorini::{cone::Cone, strip::Strip};
/// let strip = Strip::scalar(8, 8)?;
/// let b: Vec<f64> = (0..9).map(|i| 0.2 - (i as f64 / 4.0).sin()).collect();
/// let found = strip.operator().solve_contact(&b, Cone::Midpoint, None, 1e-13)?;
/// let work: f64 = b.iter().zip(&found.values).map(|(b, w)| b * w).sum();
/// assert!(found.kkt.worst() < 1e-12 && (found.energy + 0.5 * work).abs() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
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
