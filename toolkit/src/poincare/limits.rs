//! The exact limits that the printed laws (5.1)-(5.3) should be compared with.

use crate::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Work};
use std::f64::consts::PI;

/// A = 3/(2π²): slope of γ² against ln(1/θ) at ν = 1/2 for a zone at an end.
pub const END_SLOPE: f64 = 3.0 / (2.0 * PI * PI);

/// 1/(2π²): the slope for a zone inside.
///
/// ```
/// use fractional_sobolev::{END_SLOPE, INTERIOR_SLOPE};
/// assert!((END_SLOPE / INTERIOR_SLOPE - 3.0).abs() < 1e-15); // an end is three times as bad
/// ```
pub const INTERIOR_SLOPE: f64 = 1.0 / (2.0 * PI * PI);

/// Rounding of a tangent, two products and a root, relative; 1/2 − ν is known exactly.
const CLOSED_FORM: f64 = 8.0 * f64::EPSILON;

/// lim θ^{1/2−ν} γ_θ for a zone inside (0,1), ν < 1/2: √( tan(πν) / (2π(1+2ν)) ).
///
/// ```
/// use fractional_sobolev::{Order, interior_limit};
/// let limit = interior_limit(Order::new(0.25)?)?;
/// assert!((limit.value - (1.0 / (3.0 * std::f64::consts::PI)).sqrt()).abs() <= limit.error);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for ν ≥ 1/2.
pub fn interior_limit(order: impl Given<Order>) -> Result<Estimate> {
    let order = order.given()?;
    Error::require("nu", order.value(), "(0, 1/2)", order.is_below_half())?;
    // tan(πν) = cot(π(1/2 − ν))
    let tangent = 1.0 / (PI * -order.offset()).tan();
    let limit = (tangent / (2.0 * PI * (1.0 + 2.0 * order.value()))).sqrt();
    Estimate::new(limit, CLOSED_FORM * limit, Work { points: 1, ..Work::default() })
}
