//! The hp space in which the Poincaré constants are computed: slopes on graded cells.
//!
//! The unknowns are the slopes of u, so that constants, on which the seminorm vanishes, do not occur and
//! positions are never subtracted. See [`cell`] for the parametrizations, [`gram`] for |u|_ν², [`mass`] for
//! ‖u‖₀² under a condition that determines the constant, [`local`] and [`hats`] for short zones in the
//! interior, [`links`] for functions that vanish on several intervals.

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
