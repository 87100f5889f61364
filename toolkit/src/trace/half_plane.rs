//! The half-plane H = {y > 0}: |w(·,0)|²_{s−1/2,ℝ} ≤ C(s)² |w|²_{s,H} with the best constant

use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Work};
use crate::numeric::gamma::digamma_above_one;
use crate::order::Order;
use std::f64::consts::PI;

/// Rounding of the closed form, relative: D is a difference of π tan(πσ) and at most a third of it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// C(s), the best constant of the trace on the half-plane; no edge of a domain has a smaller one.
///
/// Invariant under scaling. Cost: twenty terms.
///
/// # Method
///
/// C(s)² = 4s² / ((2s−1) D(s)),  D(s) = −π cot(πs) − ψ(2s) − γ,  1/2 < s < 1,
///
/// ψ = Γ'/Γ, γ Euler's constant. Three steps, proved in full on the page of the book:
/// - y^{2s−1} is harmonic for Lw(x) = PV ∫_H (w(x)−w(z)) |x−z|^{-2-2s} dz, and L commutes with the inversion
///   w ↦ |x|^{2s−2} w(x/|x|²); so y^{2s−1}/|x|^{2s} is harmonic too, the Poisson kernel of the operator
///   div(y^{2−2s} ∇w).
/// - The least energy of the boundary values e^{iξx} is that of e^{iξx} φ(|ξ|y),
///   φ(y) = 2^{1−σ}/Γ(σ) y^σ K_σ(y) = 1 − b y^{2σ} + ..., σ = s − 1/2, b = 2^{-2σ} Γ(1−σ)/Γ(1+σ);
///   per length it is b A (D/s) |ξ|^{2σ}, A = √π Γ(s+1/2)/Γ(s+1).
/// - The edge has 2π/(Γ(2s) sin πσ) |ξ|^{2σ}; the Γ functions of the quotient cancel.
///
/// Limits: C(s)² (2s−1)² → 3/π² as s → 1/2; π/(2(1−s)) C(s)² → 2π as s → 1, the square of the constant of
/// the Dirichlet integral.
///
/// ```
/// use fractional_sobolev::{Order, half_plane_trace};
/// let near: Order = "1/2+1e-9".parse()?;
/// let limit = half_plane_trace(near)?.value * 2e-9;
/// assert!((limit - 3f64.sqrt() / std::f64::consts::PI).abs() < 1e-8);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for s ≤ 1/2, where functions have no trace.
#[doc(alias("trace theorem", "trace constant"))]
pub fn half_plane_trace(order: impl Given<Order>) -> Result<Estimate> {
    let order = order.given()?;
    let sigma = require_trace(order)?;
    // −π cot(πs) = π tan(πσ), from the nearer end.
    let tangent = if sigma < 0.25 { (PI * sigma).tan() } else { (PI * order.complement()).tan().recip() };
    let d = PI * tangent - digamma_above_one(2.0 * sigma);
    let value = 2.0 * order.value() / (2.0 * sigma * d).sqrt();
    // What the rounding of s itself does where 1 − s is small.
    let conditioning = f64::EPSILON / order.complement();
    Estimate::new(value, value * (ROUNDING + conditioning), Work::default())
}

/// √(2π), the best constant for s = 1 with ‖∇w‖ on the right: half-plane and square.
///
/// ```
/// assert!((fractional_sobolev::half_plane_trace_at_one().powi(2) - std::f64::consts::TAU).abs() < 1e-14);
/// ```
pub fn half_plane_trace_at_one() -> f64 {
    (2.0 * PI).sqrt()
}

/// σ = s − 1/2 where there is a trace.
pub(super) fn require_trace(order: Order) -> Result<f64> {
    Error::require("s - 1/2", order.offset(), "(0, 1/2)", order.offset() > 0.0)
}

/// Width of the exponents e^{-700}: what follows is nothing.
const RANGE: f64 = 700.0;
/// Step of the trapezoidal rule in ln t: its error is below rounding for σ ≤ 1/2.
const STEP: f64 = 0.06;

/// φ(y) = 2^{1−σ}/Γ(σ) y^σ K_σ(y), σ = s − 1/2: the extremal function on the half-plane is e^{ix} φ(y).
///
/// From φ(y) = (1/Γ(σ)) ∫₀^∞ t^{σ−1} e^{−t−y²/(4t)} dt by the trapezoidal rule in ln t; φ(0) = 1, relative
/// error below 1e-13 where φ > 1e-100. Cost: a few hundred exponentials.
///
/// ```
/// use fractional_sobolev::{Order, extension_profile};
/// // sigma nearly 1/2: e^{-y}
/// let value = extension_profile(Order::new(0.999999)?, 1.0)?;
/// assert!((value - (-1f64).exp()).abs() < 1e-5);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for s ≤ 1/2 and unless 1e-30 ≤ y ≤ 1e3 or y = 0.
pub fn extension_profile(order: impl Given<Order>, y: f64) -> Result<f64> {
    let order = order.given()?;
    let sigma = require_trace(order)?;
    if y == 0.0 {
        return Ok(1.0);
    }
    Error::require("y", y, "0 or [1e-30, 1e3]", (1e-30..=1e3).contains(&y))?;
    let quarter = 0.25 * y * y;
    let (low, high) = ((quarter / RANGE).ln(), RANGE.ln());
    let steps = ((high - low) / STEP).ceil() as usize;
    let term = |k: usize| {
        let x = low + k as f64 * STEP;
        (sigma * x - x.exp() - quarter * (-x).exp()).exp()
    };
    Ok(STEP * (0..=steps).map(term).sum::<f64>() / libm::tgamma(sigma))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_constants_of_thirty_digits_and_both_limits() {
        // 4 s²/((2s−1) D(s)) by mpmath.
        let squares = [
            ("0.6", 9.828_149_853_218_818),
            ("0.8", 1.178_387_131_293_67),
            ("0.99", 0.040_416_295_790_515_6),
        ];
        for (s, square) in squares {
            let found = half_plane_trace(s.parse::<Order>().unwrap()).unwrap();
            let error = (found.value - f64::sqrt(square)).abs();
            assert!(error < 1e-13 * found.value && found.relative_error() < 1e-13, "{s}: {found}");
        }
        let near_one = Order::new(1.0 - 1e-8).unwrap();
        let normalised =
            half_plane_trace(near_one).unwrap().value * (0.5 * PI / near_one.complement()).sqrt();
        assert!((normalised - half_plane_trace_at_one()).abs() < 1e-7, "{normalised}");
    }

    #[test]
    fn the_profile_solves_its_equation() {
        // φ'' + (1−2σ)/y φ' = φ
        let order = Order::new(0.8).unwrap();
        let (y, h) = (0.7, 1e-3);
        let [a, b, c] = [y - h, y, y + h].map(|y| extension_profile(order, y).unwrap());
        let rest = (a - 2.0 * b + c) / (h * h) + 0.4 / y * (c - a) / (2.0 * h) - b;
        assert!(rest.abs() < 1e-6, "{rest}");
    }

    #[test]
    fn no_trace_up_to_one_half() {
        assert!(half_plane_trace(Order::HALF).is_err());
        assert!(extension_profile(Order::new(0.3).unwrap(), 1.0).is_err());
        assert!(extension_profile(Order::new(0.8).unwrap(), f64::NAN).is_err());
    }
}
