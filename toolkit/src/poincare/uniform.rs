//! An asymptotic formula, θ → 0, for the constant γ_θ(ν) of the zone (0,θ), uniform in ν ∈ [0.4, 0.6].

use super::mean::dual_moments;
use super::mellin;
use super::slopes::kernel::exp_quotient;
use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use std::f64::consts::PI;

/// A = 3/(2π²), the slope of γ² with respect to ln(1/θ) at ν = 1/2 for a zone at an end.
const END_SLOPE: f64 = 3.0 / (2.0 * PI * PI);

/// Lengths at which the constants are determined: relative remainders are below 1e-12, and N² is still of order
/// one.
const SHORT: f64 = 1e-22;
const SHORTER: f64 = 1e-44;

/// Largest number of Newton steps; the convergence is quadratic.
const NEWTON: usize = 20;

/// Value of 1 − 2ν from which the limit B(ν) is more accurate than the quotient of two values of N².
const NEAR_HALF: f64 = 1e-6;
/// Lengths at which the law is positive for every order; the least length at which it is not is 0.837.
const POSITIVE: &str =
    "(0, 0.8], or longer where the expansion in ln(1/theta) is positive; gamma has no such limit";

/// The law γ² = λ with λ = s + d/λ + e/λ², s = A (θ^{2ν−1} − 1)/(1 − 2ν) + c.
///
/// # Method
///
/// With the dual norm N of u ↦ mean_E u − mean u and its representer r, γ² = λ solves λ = N² + ‖r‖₀²/λ + ⟨T²r,
/// r⟩/λ² + ... (expand the resolvent of the rank-one perturbation; T is the operator of ‖·‖₀² on functions of
/// mean zero). As θ → 0, with p = 1 − 2ν,
///
/// N² = A (θ^{−p} − 1)/p + c + o(1),  ‖r‖₀² → d,  ⟨T²r, r⟩ → e,  hence
/// λ = s + d/λ + e/λ²,  s = A (θ^{−p} − 1)/p + c.
///
/// A = p B(ν)² for ν < 1/2, A = 3/(2π²) and (θ^{−p} − 1)/p = ln(1/θ) at ν = 1/2; for ν > 1/2, A is the analytic
/// continuation, computed there (and slightly below 1/2) from two values of N. The remainders of N² and ‖r‖₀²
/// are of order θ^{1−|p|} up to logarithms and θ^{4ν−1}: the law is available for |ν − 1/2| ≤ 0.1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct UniformLaw {
    order: Order,
    /// The slope A of γ² with respect to ln(1/θ) at ν = 1/2.
    pub(super) slope: Estimate,
    /// The constant c.
    pub(super) constant: Estimate,
    /// The constant d.
    pub(super) correction: Estimate,
    /// The constant e.
    pub(super) second_correction: Estimate,
}

impl UniformLaw {
    /// The law for 0.4 ≤ ν ≤ 0.6.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for other orders; [`Error::ToleranceNotMet`] if the dual norms do not reach
    /// the tolerance.
    pub(super) fn new(order: Order, tolerance: Tolerance) -> Result<Self> {
        Error::require("nu", order.value(), "[0.4, 0.6]", order.offset().abs() <= 0.1)?;
        let p = order.one_minus_twice();
        let growth = |theta: f64| exp_quotient(p, -theta.ln());
        let [square, representer, image] = dual_moments(order, SHORT, tolerance)?;
        let slope = if order.offset() == 0.0 {
            Estimate::new(END_SLOPE, 0.0, Work::default())?
        } else if p > NEAR_HALF {
            let limit = mellin::reached(order, Tolerance::reference())?;
            limit.product(limit)?.times(p)?
        } else {
            let [far, ..] = dual_moments(order, SHORTER, tolerance)?;
            let span = growth(SHORTER) - growth(SHORT);
            let error = (square.error + far.error) / span;
            Estimate::new((far.value - square.value) / span, error, far.work)?
        };
        let constant = Estimate::new(
            square.value - slope.value * growth(SHORT),
            square.error + slope.error * growth(SHORT),
            square.work,
        )?;
        Ok(Self { order, slope, constant, correction: representer, second_correction: image })
    }

    /// The value √λ, with the error of the four constants, without the remainder of the law.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < θ < 1 and λ > 0.
    pub(super) fn gamma(&self, theta: f64) -> Result<Estimate> {
        Error::require("theta", theta, "(0, 1)", theta > 0.0 && theta < 1.0)?;
        let lambda = self.square(theta)?;
        let growth = exp_quotient(self.order.one_minus_twice(), -theta.ln());
        let known = self.slope.error * growth
            + self.constant.error
            + self.correction.error / lambda
            + self.second_correction.error / (lambda * lambda);
        Estimate::new(lambda, known, self.slope.work + self.constant.work)?.sqrt()
    }

    /// The root λ, by Newton's method starting from λ = s + d/s: the corrections are a few hundredths.
    fn square(&self, theta: f64) -> Result<f64> {
        let s = self.slope.value * exp_quotient(self.order.one_minus_twice(), -theta.ln())
            + self.constant.value;
        let (d, e) = (self.correction.value, self.second_correction.value);
        let mut lambda = s + d / s;
        for _ in 0..NEWTON {
            let residual = lambda - s - d / lambda - e / (lambda * lambda);
            lambda -= residual / (1.0 + d / (lambda * lambda) + 2.0 * e / lambda.powi(3));
        }
        Error::require("theta", theta, POSITIVE, lambda > 0.0 && s > 0.0)?;
        Ok(lambda)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Constraint, gamma};

    #[test]
    fn uniform_law_passes_smoothly_through_one_half() {
        // λ = N² + d/λ + e/λ² + f/λ³ + ...; the moments fall at least by ‖T‖ = γ₁², so that what the law
        // neglects is at most e γ₁²/λ³ / (1 − γ₁²/λ), and γ is off relatively by half of that over λ. Five
        // numbers are known to 1e-8.
        const KNOWN: f64 = 5e-8;
        for nu in ["0.48", "1/2-1e-9", "1/2-1e-12", "1/2", "1/2+1e-9", "0.52"] {
            let nu: Order = nu.parse().unwrap();
            let law = UniformLaw::new(nu, Tolerance::balanced()).unwrap();
            let found =
                |constraint| gamma(nu, constraint, Tolerance::balanced()).unwrap().constant.value;
            let short = found(Constraint::mean_zero_on(0.0..1e-40).unwrap());
            let predicted = law.gamma(1e-40).unwrap().value;
            let (lambda, whole) = (short * short, found(Constraint::mean_zero()).powi(2));
            let neglected =
                0.5 * law.second_correction.value * whole / lambda.powi(4) / (1.0 - whole / lambda);
            let apart = (short / predicted - 1.0).abs();
            assert!(
                apart < neglected + KNOWN,
                "nu {nu}: {short}, {predicted}, neglected {neglected:e}"
            );
        }
    }
}
