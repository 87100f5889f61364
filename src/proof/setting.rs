//! What the inequalities of the proofs need of a segment beside its norms.

use super::laws::TwoLaws;

/// What is known of a segment beside its norms: θ and the constants that depend on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SegmentSetting {
    /// The share of the segment that counts as near.
    pub theta: f64,
    /// γ_θ(ν), zone at an end: the worst place.
    pub gamma: f64,
    /// γ for the zone the segment has, rounded down to a power of 1/2.
    pub own_gamma: f64,
    /// The laws of γ_θ with their constants.
    pub law: TwoLaws,
}
