//! Section 1: fractional Sobolev spaces on intervals.

mod cells;
pub mod closed_forms;
mod gram;
mod lebesgue;
mod order;
mod partition;
mod piecewise;
mod polynomial_pairs;
mod power;
mod seminorm;

pub use gram::{gram_constants, gram_linears, mass_constants, mass_linears};
pub use order::FractionalOrder;
pub use partition::Partition;
pub(crate) use partition::RunningSum;
pub use piecewise::PiecewisePolynomial;
pub(crate) use seminorm::root_of_squares;
