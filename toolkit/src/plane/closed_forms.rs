//! Squared seminorms in the plane in closed form.

use crate::error::{Given, Result};
use crate::estimate::{Estimate, Work};
use crate::order::Order;
use crate::quadrature::Rule;
use crate::root::ENTRY_ROUNDING;

/// Points for an integrand analytic in an ellipse with ρ = 2 + √5 about (0, 1), singular at ±i: ρ^{-2n} <
/// 1e-24.
const POINTS: usize = 20;

/// |x₁|²_s on the unit square: 4 ∫₀¹ (1+k²)^{-s} (p − qk) dk, p = 1/((2−2s)(3−2s)), q = 1/((3−2s)(4−2s)).
///
/// The covariogram of the square is (1−|z₁|)(1−|z₂|), so that |x₁|²_s = 4 ∫∫ (1−u)(1−v) u² (u²+v²)^{-1-s}
/// over (0,1)². With v = uk for v < u and u = vk for v > u the integral in the larger variable is p − qk,
/// times (1+k²)^{-1-s} and k² (1+k²)^{-1-s}. As s → 1, (1−s)|x₁|²_s → π/2.
///
/// ```
/// use fractional_sobolev::{Order, coordinate_on_unit_square};
/// let s = 1.0 - 1e-9;
/// let squared = coordinate_on_unit_square(Order::new(s)?)?;
/// assert!(((1.0 - s) * squared.value - std::f64::consts::FRAC_PI_2).abs() < 1e-8);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// None for an order in (0, 1).
pub fn coordinate_on_unit_square(order: impl Given<Order>) -> Result<Estimate> {
    let order = order.given()?;
    let two = 2.0 * order.complement();
    let (p, q) = (1.0 / (two * (1.0 + two)), 1.0 / ((1.0 + two) * (2.0 + two)));
    let part = |k: f64| (p - q * k) * (-order.value() * (k * k).ln_1p()).exp();
    let value = 4.0 * Rule::gauss_legendre(POINTS)?.integrate(part);
    Estimate::new(value, ENTRY_ROUNDING * value, Work { points: POINTS as u64, ..Work::default() })
}
