//! Section 1: fractional Sobolev spaces on intervals.

mod cells;
pub mod closed_forms;
mod gram;
mod order;
mod partition;
mod power;

pub use gram::{gram_constants, gram_linears, mass_constants, mass_linears};
pub use order::FractionalOrder;
pub use partition::Partition;
