//! Quadrature rules on the unit interval, used by all double integrals.
//!
//! All rules are given on (0, 1), so that a point t close to 0 has full relative accuracy; the distance 1 + x
//! of a point x ∈ (−1, 1) from −1 would not.

mod jacobi;
mod power_weight;
mod rules;
mod tail;

pub use rules::{Rule, gauss_jacobi, gauss_legendre};
pub(crate) use tail::{Limit, extrapolate};
