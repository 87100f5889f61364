//! (3.3)-(3.15) on one segment.

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
    let mut checks = Vec::new();
    if Alternative::of_norms(Section::Three, norms, setting.theta).first() {
        first_case(norms, constants, setting.theta, &mut checks);
    }
    if Alternative::of_norms(Section::Three, norms, setting.theta).second() {
        second_case(norms, constants, setting, &mut checks);
    }
    checks
}

fn first_case(norms: &SegmentNorms, constants: &ProofConstants, theta: f64, checks: &mut Vec<Check>) {
    let (h, q, power) = (norms.length, constants.q(), constants.hoelder());
    let (stress, slope) = (norms.stress.l2, norms.slope.lq);
    let highest = norms.vertices[0].abs().max(norms.vertices[1].abs());
    let cauchy = stress * norms.interpolant;
    checks.push(Check::at_most(Inequality::InterpolantCauchySchwarz, norms.nodal_term, cauchy, 0.0));
    checks.push(Check::at_most(Inequality::VertexValue, cauchy, stress * h.sqrt() * highest, 0.0));
    for (value, increment) in norms.vertices.iter().zip(norms.increments) {
        checks.push(Check::equal(Inequality::VertexToZero, value.abs(), increment, highest));
        let right = (h * theta).powf(power) * slope;
        checks.push(Check::at_most(Inequality::VertexHoelder, increment, right, 0.0).plus(norms.rounding()));
    }
    let error = norms.slope.seminorm_error();
    let nu = constants.order().value();
    let scaled = scaled_norm(norms, nu);
    let middle = constants.embedding * h.powf(1.0 / q - 0.5) * scaled;
    let full = constants.embedding * h.powf(1.0 / q - 0.5) * norms.slope.norm_squared().sqrt();
    checks.push(Check::at_most(Inequality::SlopeEmbedding, slope, middle, error));
    checks.push(Check::at_most(Inequality::NormScaling, middle, full, error));
    checks.push(Check::at_most(Inequality::ScaledEmbedding, slope, full, error));
    let product = first_factor(h, theta, constants) * stress * norms.slope.norm_squared().sqrt();
    let (last, young) = if constants.tau() == 2.0 {
        (Inequality::FirstCaseTwo, Inequality::FirstYoungTwo)
    } else {
        (Inequality::FirstCase, Inequality::FirstYoung)
    };
    checks.push(Check::at_most(last, norms.nodal_term, product, error));
    checks.push(Check::at_most(young, product, first_factor(h, theta, constants) * squares(norms), error));
}

fn second_case(
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
    checks: &mut Vec<Check>,
) {
    let (h, nu) = (norms.length, constants.order().value());
    let (stress, error) = (norms.stress.l2, norms.interpolation_error);
    let size = norms.force * (norms.vertices[0].abs() + norms.vertices[1].abs());
    let identity =
        Check::equal(Inequality::Complementarity, norms.nodal_term, norms.interpolation_term, size);
    checks.push(identity);
    let rounding = norms.rounding() * norms.force;
    checks.push(
        Check::at_most(Inequality::ErrorCauchySchwarz, norms.nodal_term, stress * error, 0.0).plus(rounding),
    );
    let (sigma, slope) = (norms.stress.seminorm(), norms.slope.seminorm());
    let (uncertain_sigma, uncertain_slope) = (norms.stress.seminorm_error(), norms.slope.seminorm_error());
    let poincare = setting.gamma * h.powf(nu) * sigma;
    checks.push(Check::at_most(Inequality::StressPoincare, stress, poincare, uncertain_sigma));
    let interpolation = constants.interpolation * h.powf(1.0 + nu) * slope;
    let rounding = norms.rounding() * h.sqrt();
    checks.push(
        Check::at_most(Inequality::Interpolation, error, interpolation, uncertain_slope).plus(rounding),
    );
    let uncertain = uncertain_sigma + uncertain_slope;
    let factor = second_factor(h, constants, setting.gamma);
    let (last, young) = if constants.tau() == 2.0 {
        (Inequality::SecondCaseTwo, Inequality::SecondYoungTwo)
    } else {
        (Inequality::SecondCase, Inequality::SecondYoung)
    };
    checks.push(Check::at_most(last, norms.nodal_term, factor * sigma * slope, uncertain));
    checks.push(Check::at_most(young, factor * sigma * slope, factor * squares(norms), uncertain));
}

/// (‖v‖₀² + h^{2ν}|v|²_ν)^{1/2} of v = u_N': h^{1/2} times the norm on the reference interval.
pub(super) fn scaled_norm(norms: &SegmentNorms, nu: f64) -> f64 {
    let slope = &norms.slope;
    (slope.l2 * slope.l2 + norms.length.powf(2.0 * nu) * slope.seminorm_squared.value).sqrt()
}

/// C(q) h θ^{1−1/q}.
pub(super) fn first_factor(h: f64, theta: f64, constants: &ProofConstants) -> f64 {
    constants.embedding * h * theta.powf(constants.hoelder())
}

/// γ C_L2 h^{1+2ν}.
pub(super) fn second_factor(h: f64, constants: &ProofConstants, gamma: f64) -> f64 {
    gamma * constants.interpolation * h.powf(1.0 + 2.0 * constants.order().value())
}

/// (‖σ_N‖²_ν + ‖u_N‖²_{τ−1/2})/2.
fn squares(norms: &SegmentNorms) -> f64 {
    0.5 * (norms.stress.norm_squared() + norms.displacement_norm_squared())
}

/// Successive bounds of ∫ σ_N (I^h u)_N on one segment, without the last; second column with the corrected
/// law.
pub(super) fn chain(
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
) -> [TwoLaws; Step::ALL.len() - 1] {
    let (h, theta, nu) = (norms.length, setting.theta, constants.order().value());
    let stress = norms.stress.l2;
    let mut bounds = [0.0; Step::ALL.len() - 1];
    bounds[0] = norms.nodal_term;
    if let Some(distance) =
        norms.zero_distance.filter(|_| Alternative::of_norms(Section::Three, norms, theta).first())
    {
        let (q, power) = (constants.q(), constants.hoelder());
        let own = distance[0].max(distance[1]).powf(power);
        let full = constants.embedding * h.powf(1.0 / q - 0.5) * norms.slope.norm_squared().sqrt();
        bounds[1] = stress * norms.interpolant;
        bounds[2] = stress * h.sqrt() * own * norms.slope.lq;
        bounds[3] = stress * h.sqrt() * own * full;
        bounds[4] = first_factor(h, theta, constants) * stress * norms.slope.norm_squared().sqrt();
        bounds[5] = bounds[4];
        return bounds.map(TwoLaws::same);
    }
    let (sigma, slope) = (norms.stress.seminorm(), norms.slope.seminorm());
    bounds[1] = stress * norms.interpolation_error;
    bounds[2] = stress * constants.interpolation * h.powf(1.0 + nu) * slope;
    bounds[3] = second_factor(h, constants, setting.own_gamma) * sigma * slope;
    bounds[4] = second_factor(h, constants, setting.gamma) * sigma * slope;
    let mut pairs = bounds.map(TwoLaws::same);
    pairs[5] = setting.law.map(|law| second_factor(h, constants, law) * sigma * slope);
    pairs
}
