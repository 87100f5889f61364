//! Interpolatory rules for ∫₀¹ t^β f(t) dt that remain accurate as β → −1.

use super::Rule;
use crate::error::{Error, Result};
use crate::numeric::legendre;

impl Rule {
    /// The n-point rule for the weight function t^β, given β + 1 > 0, with weights of both signs.
    ///
    /// # Method
    ///
    /// At the n Gauss-Legendre points t_i with weights g_i the weights are w_i = g_i Σ_{k<n} (2k+1) μ_k
    /// P_k(2t_i−1), where μ_k = ∫₀¹ t^β P_k(2t−1) dt = Π_{j=0}^{k−1} (β−j) / Π_{j=0}^{k} (β+1+j). They are
    /// exact for polynomials of degree n − 1. A Gauss-Jacobi rule is exact for degree 2n − 1, but as β → −1
    /// one of its points tends to 0, where a difference quotient has no correct digits; here f is
    /// extrapolated to 0 from points of size 1/n² with weights whose absolute sum is bounded. The argument is
    /// β + 1, so that none of its digits is lost. Cost O(n²).
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for n = 0, [`Error::OutOfRange`] unless 0 < β + 1 < ∞.
    pub(crate) fn power_weight(n: usize, beta_plus_one: f64) -> Result<Self> {
        let admissible = beta_plus_one > 0.0 && beta_plus_one.is_finite();
        Error::require("beta + 1", beta_plus_one, "(0, inf)", admissible)?;
        let mut rule = Self::gauss_legendre(n)?;
        let moments = moments(n, beta_plus_one);
        for (t, weight) in rule.points.iter().zip(&mut rule.weights) {
            let coefficients = moments.iter().enumerate().map(|(k, m)| (2.0 * k as f64 + 1.0) * m);
            *weight *= legendre::series(coefficients, 2.0 * t - 1.0);
        }
        Ok(rule)
    }
}

/// ∫₀¹ t^β P_k(2t−1) dt for k < n.
fn moments(n: usize, beta_plus_one: f64) -> Vec<f64> {
    let mut moment = 1.0 / beta_plus_one;
    (0..n)
        .map(|k| {
            let current = moment;
            let k = k as f64;
            moment *= (beta_plus_one - 1.0 - k) / (beta_plus_one + k + 1.0);
            current
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding error of sums of at most 20 terms whose absolute sum is below 20 times the value.
    const MOMENT_TOLERANCE: f64 = 1e-13;

    #[test]
    fn monomials_are_exact_down_to_beta_minus_one() {
        for n in [1, 2, 5, 12, 20] {
            for beta_plus_one in [1e-12, 2e-6, 0.3, 1.0, 1.7, 2.999] {
                let rule = Rule::power_weight(n, beta_plus_one).unwrap();
                for k in 0..n {
                    let value = rule.integrate(|t| t.powi(k as i32));
                    let exact = 1.0 / (beta_plus_one + k as f64);
                    // Extrapolated to 0, t^k leaves the rounding of 1/(β+1).
                    let scale = if k == 0 { exact } else { exact.max(1.0 / beta_plus_one) };
                    assert!(
                        (value - exact).abs() < MOMENT_TOLERANCE * scale,
                        "n {n} beta+1 {beta_plus_one} k {k}: {value} {exact}"
                    );
                }
            }
        }
    }

    #[test]
    fn inadmissible_weights_are_errors() {
        assert!(Rule::power_weight(0, 1.0).is_err());
        assert!(Rule::power_weight(3, 0.0).is_err());
        assert!(Rule::power_weight(3, f64::NAN).is_err());
    }
}
