//! Numerical utilities of the contact library: sums, scales, searches, checks of input, conjugate gradients, double-double.
//!
//! What the toolkit computes with too stands in the crate `fractional_sobolev_numeric`.

pub(crate) mod check;
pub(crate) mod real;
pub(crate) mod scale;

pub(crate) use fractional_sobolev_numeric::{conjugate_gradients, parallel, search, sum};
