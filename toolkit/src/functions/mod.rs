//! Norms of functions given by code with declared breakpoints.

mod arm;
mod arm_integral;
mod budget;
mod by_scales;
mod deep_tail;
mod function;
mod graded;
mod interpolant;
mod level;
mod log_energy;
mod norms;
mod partials;
mod refine;
mod resolution;
mod rest;
mod scales;
mod seen;
mod supremum;
mod two_rates;
mod waves;

pub(crate) use arm::Arm;
pub use function::Position;
pub(crate) use function::{Normalized, SingularFunction};
