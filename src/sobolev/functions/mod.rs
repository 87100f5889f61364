//! Norms of functions given by a closure with declared break points.

mod arm_integral;
mod deep_tail;
mod function;
mod level;
mod log_energy;
mod norms;
mod seen;
mod supremum;
mod two_rates;

pub(crate) use function::Arm;
pub use function::{Position, SingularFunction};
