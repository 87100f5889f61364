//! The result of the contact iteration on the edge.

use crate::cone::{Cone, ContactSet, KktResiduals, Margins, Status};

/// A discrete contact solution on the edge, with its KKT residuals.
///
/// With the values w, the load b and the constraints B w ≤ 0 of the cone, A w − b + B'λ = 0, B w ≤ 0, λ ≥ 0 and
/// λ'B w = 0 up to the residuals `kkt`. Hence w'A w = b'w, and the energy is −½ b'w.
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
#[non_exhaustive]
pub struct EdgeSolution {
    /// Number n of cells of the edge; h = 1/n.
    pub cells: usize,
    /// The normal displacement u_N at the edge nodes.
    ///
    /// One value per edge node, ordered by x = i/n. The values are ≤ 0 in the nodal cone, their means over
    /// segments are ≤ 0 in the midpoint cone.
    pub values: Vec<f64>,
    /// The multipliers λ ≥ 0, one per node (nodal cone) or per segment (midpoint cone).
    ///
    /// These are forces, λ_i = −∫ σ_N φ_i or −∫ σ_N over segment i, not scaled by h.
    pub multiplier: Vec<f64>,
    /// The active constraints.
    pub contact: ContactSet,
    /// The discrete cone.
    pub cone: Cone,
    /// The value of ½ g'A g − b'g at the solution.
    ///
    /// It is nonpositive, since g = 0 is admissible; the terms are added by pairwise summation.
    pub energy: f64,
    /// A bound on the algebraic error |w − w_h|_A, |v|²_A = v'A v, w_h the exact solution of the discrete problem.
    ///
    /// R/2 + (R²/4 + C)^{1/2} with R² = r'A⁻¹r, r = b − A w − B'λ⁺, λ⁺ = max(λ, 0), and C = Σ_i λ⁺_i |B w|_i; R
    /// includes the rounding error of r.
    pub error: f64,
    /// The termination status of the iteration.
    pub status: Status,
    /// The four scaled KKT residuals.
    pub kkt: KktResiduals,
    /// The margins of strict complementarity; small values mean weak contact.
    pub margins: Margins,
    /// Number of inner iterations of each step.
    ///
    /// Each requires one product A g by FFT; up to a small factor their number depends neither on n nor on the number
    /// of non-contact intervals.
    pub inner_iterations: Vec<usize>,
}

impl EdgeSolution {
    /// Number of linear problems solved.
    ///
    /// ```
    /// use signorini::{cone::Cone, strip::Strip};
    /// let strip = Strip::scalar(8, 8)?;
    /// // the load b < 0 opens the contact everywhere: the solution is that without the contact condition
    /// let found = strip.operator().solve_contact(&[-1.0; 9], Cone::Nodal, None, 1e-12)?;
    /// let free = strip.operator().solve(&[-1.0; 9])?;
    /// assert!(found.contact.count() == 0 && found.steps() <= 3);
    /// assert!(found.values.iter().zip(&free).all(|(a, b)| (a - b).abs() < 1e-11));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn steps(&self) -> usize {
        self.inner_iterations.len()
    }
}
