//! Lemma 6.1 for all functions: best constants on one element, their limits, and the Legendre basis in which
//! they are computed.

mod constant;
mod form;
mod legendre;
mod limits;

pub(super) use constant::{of_mean, on_interval, require_length, scale};
pub(super) use form::refused;
pub(super) use legendre::{converge, odd_degrees, seminorm_gram, stiffness_gram};
pub(super) use limits::pointwise;
