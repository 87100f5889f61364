//! The hp space in which the constants of the appendices are computed: slopes on graded cells.
//!
//! Unknowns are the slopes of u, so that constants, the kernel of the seminorm, do not appear at all and no
//! position is ever subtracted from another. See [`cell`] for the parametrizations, [`gram`] for |u|_ν²,
//! [`mass`] for ‖u‖₀² under a condition that fixes the constant, [`local`] and [`hats`] for short zones
//! inside, [`links`] for functions that vanish on several intervals.

mod adjacent;
pub(crate) mod cell;
pub(crate) mod gram;
mod hats;
pub(crate) mod kernel;
pub(crate) mod links;
pub(crate) mod local;
pub(crate) mod mass;
mod nodes;
mod rules;
mod separated;
pub(crate) mod space;
