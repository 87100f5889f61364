//! (3.3)-(3.15) on one segment.

use super::constants::ProofConstants;
use super::inequality::Check;
use super::line::Line;
use super::setting::{SegmentSetting, first_case_three, second_case_three};
use super::step::{RUNGS, TwoLaws};
use crate::edge::SegmentNorms;

/// Every inequality of the cases that hold on a segment (both, where both do).
pub fn section_three_checks(
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
) -> Vec<Check> {
    let mut checks = Vec::new();
    if first_case_three(norms, setting.theta) {
        first_case(norms, constants, setting.theta, &mut checks);
    }
    if second_case_three(norms, setting.theta) {
        second_case(norms, constants, setting, &mut checks);
    }
    checks
}

fn first_case(norms: &SegmentNorms, constants: &ProofConstants, theta: f64, checks: &mut Vec<Check>) {
    let (h, q, power) = (norms.length, constants.q(), constants.hoelder());
    let (stress, slope) = (norms.stress.l2, norms.slope.lq);
    let highest = norms.vertices[0].abs().max(norms.vertices[1].abs());
    let cauchy = stress * norms.interpolant;
    checks.push(Check::at_most(Line::InterpolantCauchySchwarz, norms.nodal_term, cauchy, 0.0));
    checks.push(Check::at_most(Line::VertexValue, cauchy, stress * h.sqrt() * highest, 0.0));
    for (value, increment) in norms.vertices.iter().zip(norms.increments) {
        checks.push(Check::equal(Line::VertexToZero, value.abs(), increment, highest));
        let right = (h * theta).powf(power) * slope;
        checks.push(Check::at_most(Line::VertexHoelder, increment, right, 0.0).plus(norms.rounding()));
    }
    let error = norms.slope.seminorm_error();
    let nu = constants.order().value();
    let scaled = scaled_norm(norms, nu);
    let middle = constants.embedding * h.powf(1.0 / q - 0.5) * scaled;
    let full = constants.embedding * h.powf(1.0 / q - 0.5) * norms.slope.norm_squared().sqrt();
    checks.push(Check::at_most(Line::SlopeEmbedding, slope, middle, error));
    checks.push(Check::at_most(Line::NormScaling, middle, full, error));
    checks.push(Check::at_most(Line::ScaledEmbedding, slope, full, error));
    let product = first_factor(h, theta, constants) * stress * norms.slope.norm_squared().sqrt();
    let (line, young) = if constants.tau() == 2.0 {
        (Line::FirstCaseTwo, Line::FirstYoungTwo)
    } else {
        (Line::FirstCase, Line::FirstYoung)
    };
    checks.push(Check::at_most(line, norms.nodal_term, product, error));
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
    let identity = Check::equal(Line::Complementarity, norms.nodal_term, norms.interpolation_term, size);
    checks.push(identity);
    let rounding = norms.rounding() * norms.force;
    checks
        .push(Check::at_most(Line::ErrorCauchySchwarz, norms.nodal_term, stress * error, 0.0).plus(rounding));
    let (sigma, slope) = (norms.stress.seminorm(), norms.slope.seminorm());
    let (uncertain_sigma, uncertain_slope) = (norms.stress.seminorm_error(), norms.slope.seminorm_error());
    let poincare = setting.gamma * h.powf(nu) * sigma;
    checks.push(Check::at_most(Line::StressPoincare, stress, poincare, uncertain_sigma));
    let interpolation = constants.interpolation * h.powf(1.0 + nu) * slope;
    let rounding = norms.rounding() * h.sqrt();
    checks.push(Check::at_most(Line::Interpolation, error, interpolation, uncertain_slope).plus(rounding));
    let uncertain = uncertain_sigma + uncertain_slope;
    let factor = second_factor(h, constants, setting.gamma);
    let (line, young) = if constants.tau() == 2.0 {
        (Line::SecondCaseTwo, Line::SecondYoungTwo)
    } else {
        (Line::SecondCase, Line::SecondYoung)
    };
    checks.push(Check::at_most(line, norms.nodal_term, factor * sigma * slope, uncertain));
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

/// Successive bounds of ∫ σ_N (I^h u)_N on one segment, the last rung apart; second column with the corrected
/// law.
pub(super) fn chain(
    norms: &SegmentNorms,
    constants: &ProofConstants,
    setting: &SegmentSetting,
) -> [TwoLaws; RUNGS - 1] {
    let (h, theta, nu) = (norms.length, setting.theta, constants.order().value());
    let stress = norms.stress.l2;
    let mut rungs = [0.0; RUNGS - 1];
    rungs[0] = norms.nodal_term;
    if let Some(distance) = norms.zero_distance.filter(|_| first_case_three(norms, theta)) {
        let (q, power) = (constants.q(), constants.hoelder());
        let own = distance[0].max(distance[1]).powf(power);
        let full = constants.embedding * h.powf(1.0 / q - 0.5) * norms.slope.norm_squared().sqrt();
        rungs[1] = stress * norms.interpolant;
        rungs[2] = stress * h.sqrt() * own * norms.slope.lq;
        rungs[3] = stress * h.sqrt() * own * full;
        rungs[4] = first_factor(h, theta, constants) * stress * norms.slope.norm_squared().sqrt();
        rungs[5] = rungs[4];
        return rungs.map(TwoLaws::same);
    }
    let (sigma, slope) = (norms.stress.seminorm(), norms.slope.seminorm());
    rungs[1] = stress * norms.interpolation_error;
    rungs[2] = stress * constants.interpolation * h.powf(1.0 + nu) * slope;
    rungs[3] = second_factor(h, constants, setting.own_gamma) * sigma * slope;
    rungs[4] = second_factor(h, constants, setting.gamma) * sigma * slope;
    let mut pairs = rungs.map(TwoLaws::same);
    pairs[5] = setting.law.map(|law| second_factor(h, constants, law) * sigma * slope);
    pairs
}
