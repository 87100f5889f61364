//! The half-plane H = {y > 0}: |w(·,0)|²_{s−1/2,ℝ} ≤ C(s)² |w|²_{s,H}, the best constant C(s)
//! in closed form.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::numeric::gamma::digamma_above_one;
use crate::order::Order;
use std::f64::consts::PI;

/// Relative rounding error of the closed form: D is the difference of π tan(πσ) and a number of at most a third
/// of it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The best constant C(s) of the trace on the half-plane: the closed form of [`crate::trace_constant`]. Cost: twenty
/// terms.
///
/// The proof has three steps, given in full on the page of the book:
/// - y^{2s−1} is harmonic for Lw(x) = PV ∫_H (w(x)−w(z)) |x−z|^{-2-2s} dz, and L commutes with the inversion
///   w ↦ |x|^{2s−2} w(x/|x|²); so y^{2s−1}/|x|^{2s} is harmonic too, the Poisson kernel of the operator
///   div(y^{2−2s} ∇w).
/// - The least energy of the boundary values e^{iξx} is that of e^{iξx} φ(|ξ|y),
///   φ(y) = 2^{1−σ}/Γ(σ) y^σ K_σ(y) = 1 − b y^{2σ} + ..., σ = s − 1/2, b = 2^{-2σ} Γ(1−σ)/Γ(1+σ);
///   per length it is b A (D/s) |ξ|^{2σ}, A = √π Γ(s+1/2)/Γ(s+1).
/// - The edge has 2π/(Γ(2s) sin πσ) |ξ|^{2σ}; the Γ functions of the quotient cancel.
///
/// # Errors
/// [`Error::OutOfRange`] for s ≤ 1/2, where functions have no trace.
pub(super) fn half_plane_trace(order: Order) -> Result<Estimate> {
    let sigma = require_trace(order)?;
    // −π cot(πs) = π tan(πσ), from the nearer end.
    let tangent =
        if sigma < 0.25 { (PI * sigma).tan() } else { (PI * order.complement()).tan().recip() };
    let d = PI * tangent - digamma_above_one(2.0 * sigma);
    let value = 2.0 * order.value() / (2.0 * sigma * d).sqrt();
    // What the rounding of s itself does where 1 − s is small.
    let conditioning = f64::EPSILON / order.complement();
    Estimate::new(value, value * (ROUNDING + conditioning), Work::default())
}

/// The number σ = s − 1/2 if functions have a trace.
pub(super) fn require_trace(order: Order) -> Result<f64> {
    Error::require("s - 1/2", order.offset(), "(0, 1/2)", order.offset() > 0.0)
}

/// Range of the exponents, down to e^{-700}: the remainder is negligible.
const RANGE: f64 = 700.0;
/// Step of the trapezoidal rule in ln t: its error is below rounding for σ ≤ 1/2.
const STEP: f64 = 0.06;

/// The profile φ(y) = 2^{1−σ}/Γ(σ) y^σ K_σ(y), σ = s − 1/2: the extremal function on the half-plane is e^{ix}
/// φ(y).
///
/// It is computed from φ(y) = (1/Γ(σ)) ∫₀^∞ t^{σ−1} e^{−t−y²/(4t)} dt by the trapezoidal rule in ln t; φ(0) =
/// 1, and the relative error is below 1e-13 where φ > 1e-100. Cost: a few hundred exponentials.
///
/// # Errors
/// [`Error::OutOfRange`] for s ≤ 1/2 and unless 1e-30 ≤ y ≤ 1e3 or y = 0.
pub(super) fn extension_profile(order: Order, y: f64) -> Result<f64> {
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
    fn near_order_one_the_normalised_constant_is_that_of_the_gradient() {
        let near_one = Order::new(1.0 - 1e-8).unwrap();
        let normalised =
            half_plane_trace(near_one).unwrap().value * (0.5 * PI / near_one.complement()).sqrt();
        assert!((normalised - (2.0 * PI).sqrt()).abs() < 1e-7, "{normalised}");
    }

    #[test]
    fn the_extension_is_the_minimum_of_a_local_energy_too() {
        // ∫ y^{1−2σ} (φ'² + φ²) dy = 2σ b, b from φ = 1 − b y^{2σ} + ...: what the closed form takes from φ.
        let order = Order::new(0.75).unwrap();
        let profile = |y: f64| extension_profile(order, y).unwrap();
        let b = (1.0 - profile(1e-6)) / 1e-6f64.sqrt();
        let (step, mut energy) = (0.01, 0.0);
        for k in -1400..400 {
            let y = f64::exp(step * f64::from(k));
            let slope = (profile(y * 1.0001) - profile(y / 1.0001)) / (y * 2e-4);
            energy += step * y.powf(1.5) * (slope * slope + profile(y).powi(2));
        }
        assert!((energy / (0.5 * b) - 1.0).abs() < 2e-3, "{energy} {b}");
        // σ nearly 1/2: e^{-y}
        let value = extension_profile(Order::new(0.999999).unwrap(), 1.0).unwrap();
        assert!((value - (-1f64).exp()).abs() < 1e-5);
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
}
