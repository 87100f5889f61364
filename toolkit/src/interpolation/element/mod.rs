//! Lemma 6.1 for all functions: best constants on one element, their limits, and the Legendre basis they are
//! found in.

mod constant;
mod deviation;
mod legendre;
pub mod limits;
mod local;

pub use constant::{ElementExtremal, ErrorNorm, element_constant, element_extremal, longest_element};
pub use deviation::{extremal_slopes, largest_share, mean_deviation};
pub(super) use legendre::{converge, odd_degrees, seminorm_gram, stiffness_gram};
pub use local::LocalConstants;
