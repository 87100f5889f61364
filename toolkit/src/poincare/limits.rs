//! The limits of the law of γ_θ(ν) as θ → 0 that have a closed form.

use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use std::f64::consts::PI;

/// A = 3/(2π²), the slope of γ² with respect to ln(1/θ) at ν = 1/2 for a zone at an end.
pub(super) const END_SLOPE: f64 = 3.0 / (2.0 * PI * PI);

/// Relative rounding error of a tangent, two products and a square root; 1/2 − ν is known exactly.
const CLOSED_FORM: f64 = 8.0 * f64::EPSILON;

/// The limit of θ^{1/2−ν} γ_θ for a zone in the interior of (0,1), ν < 1/2: √( tan(πν) / (2π(1+2ν)) ).
pub(super) fn interior_limit(order: Order) -> Result<Estimate> {
    Error::require("nu", order.value(), "(0, 1/2)", order.is_below_half())?;
    // tan(πν) = cot(π(1/2 − ν))
    let tangent = 1.0 / (PI * -order.offset()).tan();
    let limit = (tangent / (2.0 * PI * (1.0 + 2.0 * order.value()))).sqrt();
    Estimate::new(limit, CLOSED_FORM * limit, Work { points: 1, ..Work::default() })
}
