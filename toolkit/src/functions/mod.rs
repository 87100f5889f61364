//! Norms of functions given by code with declared breakpoints.
//!
//! Each interval between breakpoints is divided at its midpoint into two *sides*. A side of length R consists
//! of the points c ± δ, 0 < δ < R, c its breakpoint; t = ln(R/δ) is the *depth* of a point, and the depth of
//! a side is the largest t at which the function is evaluated. Norms are sums of integrals ∫₀^∞ ℓ(t) dt along
//! the sides ([`log_energy`]).

mod arm;
mod arm_integral;
mod by_scales;
mod combined;
mod deep_tail;
mod function;
mod interpolant;
mod level;
mod log_energy;
mod look;
mod norms;
mod octaves;
mod partials;
mod refine;
mod resolution;
mod rest;
mod scales;
mod supremum;
mod two_rates;
mod waves;

pub(crate) use arm::Arm;
pub(crate) use combined::break_of;
pub use function::Position;
pub(crate) use function::{Normalized, SingularFunction, Units};
pub(crate) use look::Look;
pub(crate) use resolution::of_residual;
