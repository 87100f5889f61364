//! The proofs of Theorems 3.1 and 4.1 line by line: both sides of every inequality on computed pairs (u_N, σ_N).
//!
//! Let T ∩ Γ_C = [a₁, a₂] have length h = h_e ≤ 1, ν = τ − 3/2, and let (u_N, σ_N) be a [`super::ContactPair`]: functions with
//! u_N ≤ 0, σ_N ≤ 0, σ_N u_N = 0 at every point, whose norms of order ν (of σ_N and of u_N') are finite. For τ < 2 both are
//! constant on fine cells, q = 1/(2 − τ) = 2/(1 − 2ν); for τ ≥ 2 continuous and piecewise linear, q ≥ 2 free at τ = 2. The
//! vanishing zones are unions of fine cells. Norms are (1.1) on the segment, ‖v‖²_ν = ‖v‖₀² + |v|²_ν,
//! ‖u_N‖²_{τ−1/2} = ‖u_N‖₀² + ‖u_N'‖²_ν. Every line is then a statement about one segment with an explicit constant:
//!
//! | line | left | right |
//! | --- | --- | --- |
//! | (3.3) | ∫σ_N(I^h u)_N; ‖σ_N‖₀‖(I^h u)_N‖₀ | ‖σ_N‖₀‖(I^h u)_N‖₀; ‖σ_N‖₀ h^{1/2} max\|u_N(a_i)\| |
//! | (3.4) | \|u_N(a_i)\| | \|∫ u_N'\| from a_i to the nearest zero ξ_i (an equality) |
//! | (3.5) | \|∫ u_N'\| | (hθ)^{1−1/q} ‖u_N'‖_{L^q} |
//! | (3.6)-(3.8) | ‖u_N'‖_{L^q} | C(q) h^{1/q−1/2} ‖u_N'‖_ν, through (‖u_N'‖₀² + h^{2ν}\|u_N'\|²_ν)^{1/2} |
//! | (3.9), (3.10) | ∫σ_N(I^h u)_N | C(q) h θ^{1−1/q} ‖σ_N‖₀‖u_N'‖_ν; then Young |
//! | (3.11) | ∫σ_N(I^h u)_N = ∫σ_N((I^h u)_N − u_N) | ‖σ_N‖₀ ‖(I^h u)_N − u_N‖₀ |
//! | (3.12) | ‖σ_N‖₀ | γ_θ(ν) h^ν \|σ_N\|_ν |
//! | (3.13) | ‖(I^h u)_N − u_N‖₀ | C_L2(ν) h^{1+ν} \|u_N'\|_ν |
//! | (3.14), (3.15) | ∫σ_N(I^h u)_N | γ_θ C_L2 h^{2τ−2} \|σ_N\|_ν\|u_N'\|_ν; then Young |
//! | (4.9) | −∫(σ_N − π^hσ_N)u_N | ∫(σ_N − π^hσ_N)(π^hu_N − u_N) (an equality) |
//! | (4.10), (4.12) | the same term; ‖u_N − π^hu_N‖_{L^∞}; ‖σ_N‖_{L¹(S)}; ‖σ_N‖_{L^q} | ‖σ_N‖_{L¹}‖u_N − π^hu_N‖_{L^∞}; h^{1/2}‖u_N'‖₀/√3; (hθ)^{1−1/q}‖σ_N‖_{L^q}; C(q)h^{1/q−1/2}‖σ_N‖_ν |
//! | (4.11), (4.13), (4.14) | the same term; ‖σ_N − π^hσ_N‖₀; ‖u_N − π^hu_N‖₀; ‖u_N'‖₀ | the product; γ₁h^ν\|σ_N\|_ν; (h/π)‖u_N'‖₀; γ_θ h^ν\|u_N'\|_ν |
//!
//! C(q), C_L2, γ₁, γ_θ and the 1/√3 of (6.2) are best constants or upper bounds of them ([`ProofConstants`]). In (4.14),
//! τ > 2, γ is the constant of functions that vanish at a point: u_N' does at an interior contact point.
//!
//! The *ladder* of one mesh is the sum over its segments of successive bounds of the consistency term ([`Rung`]), each segment in its
//! own case (the first where both hold). Its steps: Hölder's inequality; interpolation and the distance to a zero; embedding and
//! Poincaré for the zone the segment *has*; the same as if every zone were as short as h_e θ; the printed law of γ_θ; Young and
//! norms of the whole edge. Exponents are slopes of least squares over the meshes; each loss is the slope of a quotient of
//! two rungs, so the losses add up to what lies between the first and the last.

mod constants;
mod inequality;
mod ladder;
mod report;
mod resolution;
mod section_four;
mod section_three;
mod study;

pub use constants::ProofConstants;
pub use inequality::{Check, InequalityProfile};
pub use ladder::{Exponent, Rung};
pub use resolution::Resolution;
pub use section_four::section_four_checks;
pub use section_three::section_three_checks;
pub use study::{LevelProfile, ProofCase, ProofProfile};

use super::segment::SegmentNorms;

/// What is known of a segment beside its norms: θ and the constants that depend on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SegmentSetting {
    /// θ.
    pub theta: f64,
    /// γ_θ(ν), zone at an end: the worst place.
    pub gamma: f64,
    /// γ for the zone the segment has, rounded down to a power of 1/2.
    pub own_gamma: f64,
    /// The printed law C θ^{τ−2}, at τ = 2 C ln(1/θ); τ > 2: C.
    pub law: f64,
    /// At τ = 2 C √ln(1/θ); else the same.
    pub corrected_law: f64,
}

/// Which cases hold.
fn first_case_three(norms: &SegmentNorms, theta: f64) -> bool {
    norms.zero_distance.is_some_and(|d| d.iter().all(|&d| d < norms.length * theta))
}

fn second_case_three(norms: &SegmentNorms, theta: f64) -> bool {
    norms.free_length >= norms.length * theta
}

fn first_case_four(norms: &SegmentNorms, theta: f64) -> bool {
    norms.contact_diameter().is_none_or(|d| d <= norms.length * theta)
}

fn second_case_four(norms: &SegmentNorms, theta: f64) -> bool {
    norms.contact_diameter().is_some_and(|d| d >= norms.length * theta)
}
