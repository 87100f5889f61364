//! Quadrature rules on the unit interval, used by all double integrals.
//!
//! All rules are given on (0, 1), so that a point close to the end 0 keeps its relative accuracy, which t = 1 +
//! x on (−1, 1) does not.

mod power_weight;
mod rules;
mod tail;

pub(crate) use power_weight::PowerWeightRule;
pub use rules::{Rule, gauss_jacobi, gauss_legendre};
pub(crate) use tail::{Limit, extrapolate};
