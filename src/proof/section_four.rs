//! (4.9)-(4.14) on one segment.

use super::alternatives::Alternative;
use super::check::Check;
use super::constants::ProofConstants;
use super::inequality::Inequality;
use super::laws::TwoLaws;
use super::section::Section;
use super::setting::SegmentSetting;
use super::step::Step;
use crate::edge::SegmentNorms;

/// Every inequality of the cases that hold on a segment (both, where both do).
pub(super) fn checks(
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
) -> Vec<Check> {
    let size = norms.force * norms.projection_error[1];
    let mut checks =
        vec![Check::equal(Inequality::MeanZero, norms.projection_term, norms.midpoint_term, size)];
    if constants.tau() <= 2.0 && Alternative::of_norms(Section::Four, norms, setting.theta).first() {
        first_case(norms, constants, setting.theta, &mut checks);
    }
    let has_contact = norms.zero_distance.is_some();
    if has_contact
        && (constants.tau() > 2.0 || Alternative::of_norms(Section::Four, norms, setting.theta).second())
    {
        second_case(norms, constants, setting, &mut checks);
    }
    checks
}

/// diam C_T ≤ h θ: (4.10) bounds the term by ‖σ_N‖_{L¹} ‖u_N − π^h u_N‖_{L^∞}, with ‖·‖_{L^∞} ≤ (h/3)^{1/2} ‖u_N'‖₀ and
/// ‖σ_N‖_{L¹} ≤ (hθ)^{1−1/q} C(q) h^{1/q−1/2} ‖σ_N‖_ν; the product is C(q) h θ^{1−1/q}/√3 ‖σ_N‖_ν ‖u_N'‖₀.
fn first_case(norms: &SegmentNorms, constants: &ProofConstants, theta: f64, checks: &mut Vec<Check>) {
    let (h, q, power) = (norms.length, constants.q(), constants.hoelder());
    let highest = norms.projection_error[1];
    checks.push(Check::at_most(
        Inequality::ForceTimesHeight,
        norms.midpoint_term,
        norms.force * highest,
        0.0,
    ));
    let pointwise = constants.pointwise * h.sqrt() * norms.slope.l2;
    checks.push(Check::at_most(Inequality::Pointwise, highest, pointwise, 0.0).plus(norms.rounding()));
    let hoelder = (h * theta).powf(power) * norms.stress.lq;
    checks.push(Check::at_most(Inequality::SupportHoelder, norms.force, hoelder, 0.0));
    let (full, error) = (norms.stress.norm_squared().sqrt(), norms.stress.seminorm_error());
    let embedding = constants.embedding * h.powf(1.0 / q - 0.5) * full;
    checks.push(Check::at_most(Inequality::StressEmbedding, norms.stress.lq, embedding, error));
    let last = if constants.tau() == 2.0 { Inequality::SetFirstCaseTwo } else { Inequality::SetFirstCase };
    let product = first_factor(h, theta, constants) * full * norms.slope.l2;
    checks.push(Check::at_most(last, norms.midpoint_term, product, error));
}

/// diam C_T ≥ h θ: (4.11) bounds the term by ‖σ_N − π^h σ_N‖₀ ‖u_N − π^h u_N‖₀, with the factors γ₁ h^ν |σ_N|_ν and
/// (h/π) ‖u_N'‖₀ ≤ (γ_θ/π) h^{1+ν} |u_N'|_ν, since u_N' = 0 almost everywhere on C_T.
fn second_case(
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
    checks: &mut Vec<Check>,
) {
    let (h, nu) = (norms.length, constants.order().value());
    let (deviation, error) = (norms.stress.deviation, norms.projection_error[0]);
    checks.push(Check::at_most(
        Inequality::ProjectionCauchySchwarz,
        norms.midpoint_term,
        deviation * error,
        0.0,
    ));
    let (sigma, slope) = (norms.stress.seminorm(), norms.slope.seminorm());
    let (uncertain_sigma, uncertain_slope) = (norms.stress.seminorm_error(), norms.slope.seminorm_error());
    let projection = constants.projection * h.powf(nu) * sigma;
    checks.push(Check::at_most(Inequality::StressProjection, deviation, projection, uncertain_sigma));
    let wirtinger = constants.wirtinger * h * norms.slope.l2;
    let rounding = norms.rounding() * h.sqrt();
    checks.push(Check::at_most(Inequality::DisplacementProjection, error, wirtinger, 0.0).plus(rounding));
    let poincare = setting.gamma * h.powf(nu) * slope;
    checks.push(Check::at_most(Inequality::SlopePoincare, norms.slope.l2, poincare, uncertain_slope));
    let last = match constants.tau() {
        tau if tau < 2.0 => Inequality::SetSecondCase,
        2.0 => Inequality::SetSecondCaseTwo,
        _ => Inequality::AnyContact,
    };
    let bound = second_factor(h, constants, setting.gamma) * sigma * slope;
    checks.push(Check::at_most(last, norms.midpoint_term, bound, uncertain_sigma + uncertain_slope));
}

/// C(q) h θ^{1−1/q}/√3.
pub(super) fn first_factor(h: f64, theta: f64, constants: &ProofConstants) -> f64 {
    constants.pointwise * constants.embedding * h * theta.powf(constants.hoelder())
}

/// γ γ₁ h^{1+2ν}/π.
pub(super) fn second_factor(h: f64, constants: &ProofConstants, gamma: f64) -> f64 {
    gamma * constants.projection * constants.wirtinger * h.powf(1.0 + 2.0 * constants.order().value())
}

/// Successive bounds of ∫ (σ_N − π^h σ_N)(π^h u_N − u_N) on one segment, without the last; second column
/// with the corrected law.
pub(super) fn chain(
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
) -> [TwoLaws; Step::ALL.len() - 1] {
    let (h, theta, nu) = (norms.length, setting.theta, constants.order().value());
    let mut bounds = [0.0; Step::ALL.len() - 1];
    bounds[0] = norms.midpoint_term;
    let Some(diameter) = norms.contact_diameter() else {
        // No contact: the term is zero and nothing is estimated.
        return bounds.map(TwoLaws::same);
    };
    if constants.tau() <= 2.0 && Alternative::of_norms(Section::Four, norms, theta).first() {
        let (q, power, slope) = (constants.q(), constants.hoelder(), norms.slope.l2);
        let full = norms.stress.norm_squared().sqrt();
        let own = constants.pointwise * h.sqrt() * slope * diameter.powf(power);
        bounds[1] = norms.force * norms.projection_error[1];
        bounds[2] = own * norms.stress.lq;
        bounds[3] = own * constants.embedding * h.powf(1.0 / q - 0.5) * full;
        bounds[4] = first_factor(h, theta, constants) * full * slope;
        bounds[5] = bounds[4];
        return bounds.map(TwoLaws::same);
    }
    let (sigma, slope) = (norms.stress.seminorm(), norms.slope.seminorm());
    bounds[1] = norms.stress.deviation * norms.projection_error[0];
    bounds[2] = constants.projection * h.powf(nu) * sigma * constants.wirtinger * h * norms.slope.l2;
    bounds[3] = second_factor(h, constants, setting.own_gamma) * sigma * slope;
    bounds[4] = second_factor(h, constants, setting.gamma) * sigma * slope;
    let mut pairs = bounds.map(TwoLaws::same);
    pairs[5] = setting.law.map(|law| second_factor(h, constants, law) * sigma * slope);
    pairs
}
