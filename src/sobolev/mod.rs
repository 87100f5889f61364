//! Section 1: fractional Sobolev spaces on intervals.

mod arm_integral;
mod cells;
pub mod closed_forms;
mod function;
mod function_norms;
mod gram;
mod lebesgue;
mod log_energy;
mod order;
mod partition;
mod piecewise;
mod polynomial_pairs;
mod power;
mod seminorm;

pub use function::{Position, SingularFunction};
pub use gram::{gram_constants, gram_linears, mass_constants, mass_linears};
pub use order::FractionalOrder;
pub use partition::Partition;
pub use piecewise::PiecewisePolynomial;
