//! Gauss-Legendre and Gauss-Jacobi rules on (0, 1).

use super::jacobi::jacobi_rule;
use crate::error::{Error, Result};
use gauss_quad::GaussLegendre;
use std::sync::OnceLock;

/// A quadrature rule with increasing points in (0, 1) and positive weights.
///
/// Returned by [`gauss_legendre`] and [`gauss_jacobi`].
///
/// # Method
///
/// ∫₀¹ (1−t)^α t^β f(t) dt ≈ Σ wᵢ f(tᵢ), exact for polynomials of degree 2n − 1; α, β > −1. Legendre rules (α = β = 0)
/// are computed by `gauss-quad` and Newton steps on the recurrence in t, and are cached up to 64 points.
/// Jacobi rules are computed from the eigenvalues of the Jacobi matrix (Golub & Welsch, Math. Comp. 23 (1969)
/// 221-230), followed by Newton steps on the three-term recurrence in t, the last one and the weights with twice
/// the digits: points and weights have a relative error of a few units of rounding for n ≤ 4096, points next to 1
/// an absolute one. Cost: O(n²), a second for n = 4096.
#[doc(alias("Gauss-Legendre", "Gauss-Jacobi", "quadrature"))]
#[derive(Debug, Clone, PartialEq)]
pub struct Rule {
    pub(super) points: Vec<f64>,
    pub(super) weights: Vec<f64>,
}

/// The n-point Gauss-Legendre rule for ∫₀¹ f(t) dt.
///
/// ```
/// use fractional_sobolev::{Rule, gauss_legendre};
/// let rule: Rule = gauss_legendre(3)?;
/// let fifth: f64 = rule.points().iter().zip(rule.weights()).map(|(x, w)| w * x.powi(5)).sum();
/// assert!((fifth - 1.0 / 6.0).abs() < 1e-15);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::CountOutOfRange`] for n = 0 and for n > 65536.
pub fn gauss_legendre(n: usize) -> Result<Rule> {
    Rule::gauss_legendre(n)
}

/// The n-point Gauss-Jacobi rule for ∫₀¹ (1−t)^α t^β f(t) dt; points (also near 0) and weights have a relative error of
/// at most 1e-14 for n ≤ 4096 and α + β < 1e5. For larger exponents all weights have a common factor whose error is that
/// of the logarithm of a Gamma function, 1e-10 and more.
///
/// ```
/// use fractional_sobolev::gauss_jacobi;
/// // ∫₀¹ (1−t)^{1/2} t^{−1/2} dt = π/2
/// let rule = gauss_jacobi(5, 0.5, -0.5)?;
/// assert!((rule.integrate(|_| 1.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
/// assert!(rule.iter().all(|(t, w)| 0.0 < t && t < 1.0 && w > 0.0));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::CountOutOfRange`] for n = 0 and for n > 65536, [`Error::OutOfRange`] unless α and β are finite and
/// exceed −1, and if the recurrence overflows for large α or β.
pub fn gauss_jacobi(n: usize, alpha: f64, beta: f64) -> Result<Rule> {
    Rule::gauss_jacobi(n, alpha, beta)
}

impl Rule {
    /// As [`gauss_legendre`].
    pub(crate) fn gauss_legendre(n: usize) -> Result<Self> {
        require_points(n)?;
        match KNOWN.get(n) {
            Some(known) => Ok(known.get_or_init(|| legendre_rule(n)).clone()),
            None => Ok(legendre_rule(n)),
        }
    }

    /// As [`gauss_jacobi`].
    pub(crate) fn gauss_jacobi(n: usize, alpha: f64, beta: f64) -> Result<Self> {
        require_points(n)?;
        for (name, exponent) in [("alpha", alpha), ("beta", beta)] {
            Error::require(name, exponent, "(-1, inf)", exponent > -1.0 && exponent.is_finite())?;
        }
        jacobi_rule(n, alpha, beta)
    }

    /// The points in (0, 1), in increasing order.
    pub fn points(&self) -> &[f64] {
        &self.points
    }

    /// The positive weights.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Pairs (point, weight).
    pub fn iter(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.points.iter().copied().zip(self.weights.iter().copied())
    }

    /// Σ wᵢ f(tᵢ).
    pub fn integrate(&self, mut f: impl FnMut(f64) -> f64) -> f64 {
        self.iter().map(|(t, w)| w * f(t)).sum()
    }
}

/// Largest number of points, which are the eigenvalues of a tridiagonal matrix: n² operations.
const MOST_POINTS: usize = 1 << 16;

fn require_points(n: usize) -> Result<()> {
    if (1..=MOST_POINTS).contains(&n) {
        return Ok(());
    }
    Err(Error::CountOutOfRange { name: "quadrature points", value: n, range: "[1, 65536]" })
}

/// Cache of Gauss-Legendre rules by their number of points.
static KNOWN: [OnceLock<Rule>; 65] = [const { OnceLock::new() }; 65];

/// The points of `gauss-quad` mapped to (0, 1), in increasing order.
fn on_unit_interval(n: usize) -> Vec<f64> {
    let Some(count) = std::num::NonZeroUsize::new(n) else { return Vec::new() };
    let mut points: Vec<f64> = GaussLegendre::new(count).nodes().map(|x| 0.5 + 0.5 * x).collect();
    points.sort_by(f64::total_cmp);
    points
}

/// Largest number of Newton steps; one or two are typical.
const NEWTON: usize = 4;

/// The Gauss-Legendre rule on (0, 1): the points of `gauss-quad`, improved by Newton's method in t, then
/// reflected.
///
/// On (−1, 1) a point near −1 is known to ε, hence t = (1 + x)/2 only to ε n² relative to its size, which
/// matters for integrands with a singularity at 0. After the Newton step the error is ε t.
///
/// Q_k(t) = P_k(1 − 2t) is computed by the differences d_k = Q_{k+1} − Q_k, (k+1) d_k = k d_{k−1} − 2(2k+1) t
/// Q_k, without cancellation near t = 0; 2t(1−t) Q_n' = n (d_{n−1} − 2t Q_n), and the weight is 1/(t(1−t)
/// Q_n'²).
fn legendre_rule(n: usize) -> Rule {
    let count = n as f64;
    let newton = |t: f64| {
        let (mut value, mut difference) = (1.0, 0.0);
        for k in 0..n {
            let k = k as f64;
            difference = (k * difference - 2.0 * (2.0 * k + 1.0) * t * value) / (k + 1.0);
            value += difference;
        }
        (value, count * (difference - 2.0 * t * value) / (2.0 * t * (1.0 - t)))
    };
    let mut points = vec![0.5; n];
    let mut weights = vec![0.0; n];
    for (k, t) in on_unit_interval(n).into_iter().take(n.div_ceil(2)).enumerate() {
        let is_middle = 2 * k + 1 == n;
        let mut t = if is_middle { 0.5 } else { t };
        for _ in 0..if is_middle { 0 } else { NEWTON } {
            let (value, slope) = newton(t);
            let step = value / slope;
            t -= step;
            if step.abs() <= 0.5 * f64::EPSILON * t {
                break;
            }
        }
        let weight = 1.0 / (t * (1.0 - t) * newton(t).1.powi(2));
        (points[k], weights[k]) = (t, weight);
        (points[n - 1 - k], weights[n - 1 - k]) = (1.0 - t, weight);
    }
    Rule { points, weights }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding error of n-term sums and of the Gamma function, n <= 40.
    const MOMENT_TOLERANCE: f64 = 2e-13;

    #[test]
    fn jacobi_moments_are_beta_functions() {
        for n in [1, 2, 3, 5, 8, 13, 40] {
            for (alpha, beta) in [
                (0.0, 0.0),
                (-0.5, -0.5),
                (0.3, -0.7),
                (-0.9, 0.4),
                (1.6, -0.999),
                (0.0, 2.3),
                (-0.3, -0.7),
            ] {
                let rule = Rule::gauss_jacobi(n, alpha, beta).unwrap();
                for k in 0..2 * n {
                    let moment = rule.integrate(|t| t.powi(k as i32));
                    let exact = libm::tgamma(alpha + 1.0)
                        / libm::tgamma(alpha + beta + 2.0 + k as f64)
                        * libm::tgamma(beta + 1.0 + k as f64);
                    assert!(
                        (moment / exact - 1.0).abs() < MOMENT_TOLERANCE,
                        "n {n} alpha {alpha} beta {beta} k {k}: {moment} against {exact}"
                    );
                }
            }
        }
    }

    #[test]
    fn legendre_is_jacobi_without_weight() {
        for n in [1, 2, 7, 30, 64, 65, 200] {
            let (legendre, jacobi) =
                (Rule::gauss_legendre(n).unwrap(), Rule::gauss_jacobi(n, 0.0, 0.0).unwrap());
            for ((s, v), (t, w)) in legendre.iter().zip(jacobi.iter()) {
                assert!((s - t).abs() < 1e-15 && (v - w).abs() < 1e-14, "{n}: {s} {t} {v} {w}");
            }
        }
    }

    /// The first point by the first zero j₀ of the Bessel function J₀; without the Newton step its error is
    /// several ε n².
    #[test]
    fn points_near_zero_keep_their_digits() {
        let bessel = 2.404825557695773f64;
        let n = 20_000;
        let polished = Rule::gauss_legendre(n).unwrap().points()[0];
        let count = n as f64 + 0.5;
        // t₁ = sin²(φ/2), φ = (j₀/N)(1 − 1/(24 N²) + O(N⁻⁴)), N = n + 1/2: Olver's expansion.
        let angle = 2.0 * polished.sqrt().asin();
        let expected = bessel / count * (1.0 - 1.0 / (24.0 * count * count));
        assert!((angle / expected - 1.0).abs() < 1e-14, "{angle} {expected}");
        let raw = on_unit_interval(n)[0];
        assert!(
            (raw / polished - 1.0).abs() > 1e-12,
            "gauss-quad's point needs no polish any more"
        );
        for n in [5, 64, 200] {
            let rule = Rule::gauss_legendre(n).unwrap();
            for (s, t) in rule.points().iter().zip(on_unit_interval(n)) {
                assert!((s - t).abs() < 5e-16, "{n}: {s} {t}");
            }
        }
    }

    #[test]
    fn inadmissible_rules_are_errors() {
        assert!(Rule::gauss_legendre(0).is_err());
        assert!(Rule::gauss_jacobi(3, -1.0, 0.0).is_err());
        assert!(Rule::gauss_jacobi(3, f64::NAN, 0.0).is_err());
    }
}
