//! What the lines of the proof need of a segment beside its norms, and the cases by norms.

use super::step::TwoLaws;
use crate::edge::SegmentNorms;

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

/// First case of Section 3: zeros of u_N within h_e θ of both vertices.
pub(super) fn first_case_three(norms: &SegmentNorms, theta: f64) -> bool {
    norms.zero_distance.is_some_and(|d| d.iter().all(|&d| d < norms.length * theta))
}

/// Second case of Section 3: σ_N = 0 on a piece of length h_e θ at a vertex.
pub(super) fn second_case_three(norms: &SegmentNorms, theta: f64) -> bool {
    norms.free_length >= norms.length * theta
}

/// First case of Section 4: diam C_T ≤ h_e θ.
pub(super) fn first_case_four(norms: &SegmentNorms, theta: f64) -> bool {
    norms.contact_diameter().is_none_or(|d| d <= norms.length * theta)
}

/// Second case of Section 4: diam C_T ≥ h_e θ.
pub(super) fn second_case_four(norms: &SegmentNorms, theta: f64) -> bool {
    norms.contact_diameter().is_some_and(|d| d >= norms.length * theta)
}
