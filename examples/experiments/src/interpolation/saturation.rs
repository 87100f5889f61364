//! Remark 4: ‖φ − π^h φ‖₀ = h ‖φ'‖₀/√12 (1 + o(1)) for φ ∈ H¹, whatever the further smoothness.

use super::projection_rates::MESHES;
use super::projection_sample::sample_projection_error;
use super::rate::last_order;
use super::{error::InterpolationError, sample::SampleSlope};
use crate::ErrorExt;
use fractional_sobolev::Estimate;
use fractional_sobolev::{Error, Result};
use fractional_sobolev::{Mesh, Order};

/// ‖φ − π^h φ‖₀ / (h ‖φ'‖₀/√12) for φ = x^a on N equal elements of (0, 1): tends to 1.
///
/// # Method
///
/// On an element of length h, φ − π^h φ is φ' times the distance from the centre to first order, of mean
/// square h²/12.
///
/// ```
/// use experiments::interpolation::{power_lagrange_rate, saturation_quotient};
/// assert!((saturation_quotient(2.0, 100)?.value - 1.0).abs() < 1e-3);
/// assert!((power_lagrange_rate(2.0)?.value - 2.0).abs() < 1e-3); // piecewise linears do gain
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for a ≤ 1/2, where φ is not in H¹; [`Error::CountOutOfRange`] without elements.
pub fn saturation_quotient(a: f64, elements: usize) -> Result<Estimate> {
    Error::require("exponent a", a, "(1/2, 1e4], where x^a is in H^1", a > 0.5 && a <= 1e4)?;
    let error = sample_projection_error(SampleSlope::Power(a), &Mesh::uniform(elements, 1.0)?)?;
    // ‖φ'‖₀ = a/√(2a − 1)
    let unit = elements as f64 * 12f64.sqrt() * (2.0 * a - 1.0).sqrt() / a;
    Estimate::new(error.value * unit, error.error * unit, error.work)
}

/// The exponent of h in ‖φ − I^h φ‖₀ for φ = x^a between 4096 and 65 536 elements: what piecewise linears do.
///
/// # Errors
/// As [`saturation_quotient`].
pub fn power_lagrange_rate(a: f64) -> Result<Estimate> {
    let on = |n: usize| -> Result<_> { Ok((n, power_lagrange_error(a, n)?)) };
    last_order([on(MESHES[0])?, on(MESHES[1])?, on(MESHES[2])?])
}

/// ‖φ − I^h φ‖₀ for φ = x^a on N equal elements of (0, 1).
///
/// # Errors
/// As [`saturation_quotient`].
fn power_lagrange_error(a: f64, elements: usize) -> Result<Estimate> {
    Error::require("exponent a", a, "(1/2, 1e4], where x^a is in H^1", a > 0.5 && a <= 1e4)?;
    // The slope a x^{a−1}; the order only has to admit it.
    let order = Order::new((0.5 * (a - 0.5)).clamp(1e-3, 0.5))?;
    let mesh = Mesh::uniform(elements, 1.0)?;
    let error = InterpolationError::of_sample(SampleSlope::Power(a - 1.0), &mesh, order)?.l2()?;
    Estimate::new(a * error.value, a * error.error, error.work)
}
