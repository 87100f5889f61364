//! The explicit constants of the proofs of Theorems 3.1 and 4.1, the bounds that contain them, and the best constants
//! of a segment. Both sides of every inequality are evaluated in the example `theorem_3_1_proof_profile`.

mod constants;
mod segment_constants;

pub use constants::{ProofConstants, TwoLaws};
pub use segment_constants::{
    SegmentConstant, consistency_constant, midpoint_bound, one_gap_ratio, product_bound, product_constant,
};

/// The exponent of h in the bound of the consistency term that results from θ = h^{2τ−3} (h² at τ = 2): 2τ² −
/// 5τ + 4 for τ < 2, 2τ − 2 for τ ≥ 2; at τ = 2 with the factor ln(1/h). (3.1), (3.2), (4.2) to (4.4).
///
/// It is twice the exponent of [`Bound::Paper`](crate::rates::Bound::Paper) for 3/2 < τ ≤ 2.
///
/// ```
/// use signorini::{proof::printed_exponent, rates::Bound};
/// assert_eq!(printed_exponent(1.75), 2.0 * Bound::Paper.exponent(1.75)?);
/// assert_eq!(printed_exponent(2.0), 2.0);
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn printed_exponent(tau: f64) -> f64 {
    if tau < 2.0 { 2.0 * tau * tau - 5.0 * tau + 4.0 } else { 2.0 * tau - 2.0 }
}
