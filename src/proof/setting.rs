//! The data of a segment, besides its norms, in the inequalities of the proofs.

use super::laws::TwoLaws;

/// The data of a segment besides its norms: θ and the constants that depend on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SegmentSetting {
    /// θ, the share of the segment that counts as near a vertex.
    pub theta: f64,
    /// γ_θ(ν), zone at an end: the worst place.
    pub gamma: f64,
    /// γ for the zone of the segment, its length rounded down to a power of 1/2.
    pub own_gamma: f64,
    /// The laws of γ_θ with their constants.
    pub law: TwoLaws,
}
