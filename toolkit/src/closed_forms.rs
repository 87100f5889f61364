//! Closed forms of |u|²_ν = ∫∫ (u(x)−u(y))² / |x−y|^{d+2ν} on intervals (d = 1), the circle (d = 1) and the square
//! (d = 2), arranged so that no digits cancel.
//!
//! | function | interval, curve or square | parameters |
//! | --- | --- | --- |
//! | [`power_seminorm_squared`]: x^a | (0, 1) | a > ν − 1/2 |
//! | [`jump_seminorm_squared`]: 0 on a cell, 1 on the next | (0, p + q) | ν < 1/2 |
//! | [`hat_seminorm_squared`]: piecewise linear hat function | an interval around it | 0 < ν < 1 |
//! | [`log_power_seminorm_squared`]: \|ln x\|^α | (0, 1) | ν = 1/2, 0 < α < 1/2 |
//! | [`cosine_on_circle_seminorm_squared`]: cos kφ | the unit circle | 0 < ν < 1 |
//! | [`coordinate_on_square_seminorm_squared`]: x₁ | the unit square | 0 < ν < 1 |
//! | [`fractional_laplacian_constant`]: C(1, ν) | the line | 0 < ν < 1 |
//!
//! Every value is the *squared* seminorm, as its name says, except for [`power_seminorm`] and
//! [`fractional_laplacian_constant`]; all are sums of positive terms or differences of well separated ones.
//! They are exact to rounding and take no tolerance.

use super::gram::dense::{diagonal_linear, require_constants_finite};
use super::kernel::cells::CellPairs;
use super::kernel::power::symbol_constant;
use super::mesh::Mesh;
use super::order::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Work};
use crate::quadrature::Rule;

/// Rounding error of the sums below, relative to the value: at most a few hundred operations, all of one sign.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Number of points for an integrand analytic in an ellipse with ρ = 2 + √5 about (0, 1), singular at ±i:
/// ρ^{-2n} < 1e-24.
const SQUARE_POINTS: usize = 20;

/// |x^a|²_s on (0, 1) = 2/(2a−2s+1) [B(1,−2s) − 2B(a+1,−2s) + B(2a+1,−2s)], B the analytically continued Beta function.
///
/// The bracket equals ∫₀¹ (1−t^a)² (1−t)^{-1-2s} dt. It is split at ε = max(1/2, 1 − 1/(1+a)); with E = ε^a
/// − 1,
/// - below: Σ_k (1+2s)_k/k! ε^{k+1} [2a²/((k+1)(k+1+a)(k+1+2a)) − 2aE/((k+1+a)(k+1+2a)) + E²/(k+1+2a)], all
///   terms positive;
/// - above: the power series of ((1−(1−τ)^a)/τ)² in τ = 1 − t, integrated with the weight τ^{1-2s}.
///
/// Neither part suffers from cancellation at s = 1/2, a = 0 or s = 1. Cost about 100 terms, 40 (1 + a) for large a.
///
/// ```
/// use fractional_sobolev::{Order, closed_forms};
/// // |x - y|^2 / |x - y|^2 over the unit square
/// let squared = closed_forms::power_seminorm_squared(1.0, Order::HALF)?;
/// assert!((squared.value - 1.0).abs() < 1e-14);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::InfiniteNorm`] for a ≤ s − 1/2 (a ≠ 0); [`Error::OutOfRange`] unless 0 < s < 1 and a is finite
/// and at most 1e4.
pub fn power_seminorm_squared(a: f64, s: impl Given<Order>) -> Result<Estimate> {
    let order = s.given()?;
    Error::require("exponent a", a, "(-inf, 1e4]", a.is_finite() && a <= 1e4)?;
    if a == 0.0 {
        return Estimate::new(0.0, 0.0, Work::default());
    }
    let gap = a - order.offset();
    if gap <= 0.0 {
        return Err(Error::InfiniteNorm {
            order: order.value(),
            why: "x^a is in H^nu(0,1) only for a > nu - 1/2",
        });
    }
    let split = 0.5f64.max(a / (1.0 + a));
    let (below, below_terms) = power_below(a, order, split);
    let (above, above_terms) = power_above(a, order, 1.0 - split);
    let value = (below + above) / gap;
    // The rounding of a itself matters where the denominators 2a−2ν+1 and 2a+1 are small.
    let conditioning = a.abs() / gap + a.abs() / (0.5 + a).abs();
    let work = Work { points: below_terms + above_terms, ..Work::default() };
    // What is subnormal is rounded, to 0 perhaps.
    Estimate::new(value, value * (ROUNDING + f64::EPSILON * conditioning) + f64::MIN_POSITIVE, work)
}

/// |x^a|_s on (0, 1), accurate also where its square underflows: for small |a|,
/// |x^a|_s √(a − s + 1/2) / |a| is constant up to relative terms of order a.
///
/// ```
/// use fractional_sobolev::closed_forms;
/// let tiny = closed_forms::power_seminorm(1e-200, 0.25)?; // its square is 0 in binary64
/// assert!(tiny.value > 1e-201 && tiny.relative_error() < 1e-12);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`power_seminorm_squared`].
pub fn power_seminorm(a: f64, s: impl Given<Order>) -> Result<Estimate> {
    let order = s.given()?;
    const TINY: f64 = 1e-30;
    if a == 0.0 || a.abs() >= TINY || a <= order.offset() {
        return power_seminorm_squared(a, order)?.sqrt();
    }
    let gaps = (TINY - order.offset()) / (a - order.offset());
    let found =
        power_seminorm_squared(TINY, order)?.sqrt()?.times(gaps.sqrt() * (a.abs() / TINY))?;
    Estimate::new(found.value, found.error + f64::MIN_POSITIVE * f64::EPSILON, found.work)
}

/// ∫₀^ε (1−t^a)² (1−t)^{-1-2s} dt and the number of terms of its series.
fn power_below(a: f64, order: Order, end: f64) -> (f64, u64) {
    let e = (a * end.ln()).exp_m1();
    let (mut sum, mut coefficient, mut terms) = (0.0, end, 0);
    for k in 0.. {
        let n = f64::from(k) + 1.0;
        let (one, two) = (n + a, n + 2.0 * a);
        let bracket = 2.0 * a * a / (n * one * two) - 2.0 * a * e / (one * two) + e * e / two;
        let term = coefficient * bracket;
        sum += term;
        terms += 1;
        coefficient *= end * (n + 2.0 * order.value()) / n;
        // The tail is below term / (1 − ε) up to the slow growth of the coefficients.
        if term <= 1e-18 * sum * (1.0 - end) || k == i32::MAX {
            break;
        }
    }
    (sum, terms)
}

/// ∫₀^η (1−(1−τ)^a)² τ^{-1-2s} dτ and the number of terms of its series.
fn power_above(a: f64, order: Order, end: f64) -> (f64, u64) {
    // (1 − (1−τ)^a)/τ = Σ c_j τ^j, c_0 = a, c_j = c_{j-1} (j − a)/(j + 1); here c_j η^j
    let mut series = vec![a];
    while series.len() < 80 {
        let j = series.len() as f64;
        series.push(series[series.len() - 1] * end * (j - a) / (j + 1.0));
    }
    let exponent = 2.0 * order.complement();
    let mut sum = 0.0;
    for m in (0..series.len()).rev() {
        let square: f64 = (0..=m).map(|j| series[j] * series[m - j]).sum();
        sum += square / (m as f64 + exponent);
    }
    (sum * end.powf(exponent), series.len() as u64)
}

/// |u|²_s on (0, p+q) for u = 0 on (0, p), 1 on (p, p+q):
/// 2 [p^{1-2s} + q^{1-2s} − (p+q)^{1-2s}] / (2s(1−2s)).
///
/// ```
/// use fractional_sobolev::{Order, closed_forms};
/// let order = Order::new(0.25)?;
/// // 2 (1 + 1 − √2) / (1/2 · 1/2)
/// let squared = closed_forms::jump_seminorm_squared(1.0, 1.0, order)?;
/// assert!((squared.value - 8.0 * (2.0 - 2f64.sqrt())).abs() < 1e-13);
/// assert!(closed_forms::jump_seminorm_squared(1.0, 1.0, Order::HALF).is_err()); // a jump is not in H^{1/2}
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::InfiniteNorm`] for s ≥ 1/2; [`Error::OutOfRange`] unless 0 < s < 1; as [`Mesh::from_lengths`] for
/// inadmissible lengths.
pub fn jump_seminorm_squared(p: f64, q: f64, s: impl Given<Order>) -> Result<Estimate> {
    let order = s.given()?;
    require_constants_finite(order)?;
    Mesh::from_lengths(&[p, q])?;
    let value = 2.0 * CellPairs::new(order).touching_constants(p, q);
    Estimate::new(value, ROUNDING * value, Work::default())
}

/// |φ|²_s for the hat function φ that increases from 0 to 1 over the length `rise`, decreases to 0 over the
/// length `fall`, and vanishes on intervals of lengths `before` and `after` on either side.
///
/// `before` and `after` may be zero: the support of the hat function then reaches the end of the interval.
///
/// ```
/// use fractional_sobolev::{Function, Mesh, Order, closed_forms};
/// let squared = closed_forms::hat_seminorm_squared(1.0, 2.0, 1.0, 0.0, Order::HALF)?;
/// let mesh = Mesh::from_nodes(&[0.0, 1.0, 3.0, 4.0])?;
/// let hat = Function::linears(&mesh, &[0.0, 0.0, 1.0, 0.0])?;
/// let norm = hat.seminorm(Order::HALF, 1e-12)?;
/// assert!((norm.value.powi(2) / squared.value - 1.0).abs() < 1e-12);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < s < 1; as [`Mesh::from_lengths`] for inadmissible lengths.
pub fn hat_seminorm_squared(
    before: f64,
    rise: f64,
    fall: f64,
    after: f64,
    s: impl Given<Order>,
) -> Result<Estimate> {
    let order = s.given()?;
    let mut lengths = vec![rise, fall];
    let mut peak = 1;
    if before != 0.0 {
        lengths.insert(0, before);
        peak = 2;
    }
    if after != 0.0 {
        lengths.push(after);
    }
    let partition = Mesh::from_lengths(&lengths)?;
    let value = diagonal_linear(&partition, &CellPairs::new(order), peak);
    Estimate::new(value, ROUNDING * value, Work::default())
}

/// |cos kφ|²_s on the unit circle, with distances in the plane: 2π ∫₀^{2π} (1 − cos kθ) (2 sin(θ/2))^{-1-2s}
/// dθ, which for k ≥ 1 is by Cauchy's Beta integral 2π^{3/2} 4^{-s} Γ(1−s)/(s Γ(3/2−s)) [(1/2+s) Π_{j=2}^k
/// (j−1/2+s)/(j−1/2−s) − 1/2 + s]; 2π²k for s = 1/2. Cost: k products.
///
/// ```
/// use fractional_sobolev::closed_forms;
/// let squared = closed_forms::cosine_on_circle_seminorm_squared(3, 0.5)?;
/// assert!((squared.value / (6.0 * std::f64::consts::PI.powi(2)) - 1.0).abs() < 1e-14);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for an order outside (0, 1).
pub fn cosine_on_circle_seminorm_squared(k: u32, s: impl Given<Order>) -> Result<Estimate> {
    let order = s.given()?;
    if k == 0 {
        return Estimate::new(0.0, 0.0, Work::default());
    }
    let (nu, half, pi) = (order.value(), order.offset(), std::f64::consts::PI);
    let gammas = libm::tgamma(order.complement()) / (nu * libm::tgamma(1.0 - half));
    let product: f64 =
        (2..=k).map(|j| (f64::from(j) + half) / (f64::from(j) - 1.0 - half)).product();
    let value = 2.0 * pi * pi.sqrt() * 4f64.powf(-nu) * gammas * ((0.5 + nu) * product + half);
    // Each of the k quotients is rounded, and the bracket cancels for k = 1, ν → 0, to 2ν.
    let rounding = (ROUNDING + f64::from(k) * f64::EPSILON) * (1.0 + 0.5 / nu);
    Estimate::new(value, rounding * value, Work::default())
}

/// |x₁|²_s on the unit square: 4 ∫₀¹ (1+k²)^{-s} (p − qk) dk, p = 1/((2−2s)(3−2s)), q = 1/((3−2s)(4−2s)).
///
/// The covariogram of the square is (1−|z₁|)(1−|z₂|), so that |x₁|²_s = 4 ∫∫ (1−u)(1−v) u² (u²+v²)^{-1-s}
/// over (0,1)². With v = uk for v < u and u = vk for v > u the integral in the larger variable is p − qk,
/// times (1+k²)^{-1-s} and k² (1+k²)^{-1-s}. As s → 1, (1−s)|x₁|²_s → π/2.
///
/// ```
/// use fractional_sobolev::{Order, closed_forms};
/// let s = 1.0 - 1e-9;
/// let squared = closed_forms::coordinate_on_square_seminorm_squared(Order::new(s)?)?;
/// assert!(((1.0 - s) * squared.value - std::f64::consts::FRAC_PI_2).abs() < 1e-8);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < s < 1.
pub fn coordinate_on_square_seminorm_squared(s: impl Given<Order>) -> Result<Estimate> {
    let order = s.given()?;
    let two = 2.0 * order.complement();
    let (p, q) = (1.0 / (two * (1.0 + two)), 1.0 / ((1.0 + two) * (2.0 + two)));
    let part = |k: f64| (p - q * k) * (-order.value() * (k * k).ln_1p()).exp();
    let value = 4.0 * Rule::gauss_legendre(SQUARE_POINTS)?.integrate(part);
    Estimate::new(value, ROUNDING * value, Work { points: SQUARE_POINTS as u64, ..Work::default() })
}

/// ||ln x|^α|²_{1/2} on (0, 1) = 2 ζ(1+2α) [Γ(1+α)²/cos(πα) − Γ(1+2α)].
///
/// In t = −ln x the form is ∫∫ (s^α−t^α)² / (4 sinh²((s−t)/2)); with r = s − t it is twice the product of
/// ∫₀^∞ r^{2α+1}/(4 sinh²(r/2)) dr = Γ(2α+2) ζ(2α+1) and κ(α) = ∫₀^∞ ((1+t)^α − t^α)² dt, the constant of
/// Mandelbrot & Van Ness (SIAM Rev. 10 (1968) 422-437).
///
/// # Errors
/// [`Error::InfiniteNorm`] for 1/2 ≤ α < ∞, [`Error::OutOfRange`] for α ≤ 0, α = ∞ or NaN.
pub fn log_power_seminorm_squared(alpha: f64) -> Result<Estimate> {
    Error::require("alpha", alpha, "(0, 1/2)", alpha > 0.0 && alpha.is_finite())?;
    if alpha >= 0.5 {
        return Err(Error::InfiniteNorm {
            order: 0.5,
            why: "|ln x|^alpha is in H^{1/2}(0,1) only for alpha < 1/2",
        });
    }
    // cos(πα) as a sine of the complement, exact near α = 1/2.
    let log_cos = if alpha < 0.25 {
        // ln cos = ln(1 − 2 sin²)
        let sine = (0.5 * std::f64::consts::PI * alpha).sin();
        (-2.0 * sine * sine).ln_1p()
    } else {
        (std::f64::consts::PI * (0.5 - alpha)).sin().ln()
    };
    let log_quotient = log_gamma_defect(alpha) - log_cos;
    let value = 2.0
        * zeta(1.0 + 2.0 * alpha, 2.0 * alpha)
        * libm::tgamma(1.0 + 2.0 * alpha)
        * log_quotient.exp_m1();
    let conditioning = 0.5 / (0.5 - alpha);
    Estimate::new(value, value * (ROUNDING + f64::EPSILON * conditioning), Work::default())
}

/// 2 ln Γ(1+α) − ln Γ(1+2α), small like −ζ(2) α².
fn log_gamma_defect(alpha: f64) -> f64 {
    if alpha > 0.2 {
        return 2.0 * libm::lgamma(1.0 + alpha) - libm::lgamma(1.0 + 2.0 * alpha);
    }
    // ln Γ(1+z) = −γz + Σ_{k≥2} ζ(k) (−z)^k / k
    let mut sum = 0.0;
    for k in (2..=50).rev() {
        let n = f64::from(k);
        sum += zeta(n, n - 1.0) * (-alpha).powi(k) * (2.0 - 2f64.powi(k)) / n;
    }
    sum
}

/// Riemann's ζ(s) for s > 1, with s − 1 given separately: Euler-Maclaurin summation from n = 12.
fn zeta(s: f64, s_minus_one: f64) -> f64 {
    /// B_{2k} / (2k)!
    const BERNOULLI: [f64; 8] = [
        1.0 / 12.0,
        -1.0 / 720.0,
        1.0 / 30_240.0,
        -1.0 / 1_209_600.0,
        1.0 / 47_900_160.0,
        -691.0 / 1_307_674_368_000.0,
        1.0 / 74_724_249_600.0,
        -3_617.0 / 10_670_622_842_880_000.0,
    ];
    let n = 12.0f64;
    let mut tail = n.powf(-s_minus_one) / s_minus_one + 0.5 * n.powf(-s);
    let mut factor = s * n.powf(-s) / n;
    for (k, &b) in BERNOULLI.iter().enumerate() {
        tail += b * factor;
        let m = 2.0 * k as f64 + 1.0;
        factor *= (s + m) * (s + m + 1.0) / (n * n);
    }
    tail + (1..12).rev().map(|j| f64::from(j).powf(-s)).sum::<f64>()
}

/// C(1, s) = Γ(1 + 2s) sin(πs)/π = 4^s Γ(s + 1/2) / (√π |Γ(−s)|), the constant of the integral fractional Laplacian on the line:
/// (−Δ)^s u(x) = C(1, s) PV∫ (u(x) − u(y)) / |x − y|^{1+2s} dy has the Fourier symbol |ξ|^{2s}, and its weak form is
/// C(1, s)/2 times the one of [`Gram::zero_outside`](crate::Gram::zero_outside).
///
/// ```
/// use fractional_sobolev::{Order, closed_forms};
/// let c = closed_forms::fractional_laplacian_constant(Order::HALF)?;
/// assert!((c.value - 1.0 / std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < s < 1.
#[doc(alias("fractional Laplacian", "normalization constant", "C(d,s)"))]
pub fn fractional_laplacian_constant(s: impl Given<Order>) -> Result<Estimate> {
    let value = 2.0 / symbol_constant(s.given()?);
    Estimate::new(value, ROUNDING * value, Work::default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeta_has_its_known_values() {
        let pi = std::f64::consts::PI;
        for (s, exact) in [(2.0, pi * pi / 6.0), (4.0, pi.powi(4) / 90.0), (1.5, 2.612375348685488)]
        {
            assert!((zeta(s, s - 1.0) / exact - 1.0).abs() < 1e-15, "{s}");
        }
    }

    #[test]
    fn series_and_gamma_agree_where_both_hold() {
        for alpha in [0.15, 0.2] {
            let direct = 2.0 * libm::lgamma(1.0 + alpha) - libm::lgamma(1.0 + 2.0 * alpha);
            assert!((log_gamma_defect(alpha) / direct - 1.0).abs() < 1e-13, "{alpha}");
        }
    }
}
