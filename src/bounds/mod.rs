//! Two-sided energies and a guaranteed error of a body in contact.
//!
//! See the module parts.
mod boundary_values;
mod dual;
mod element;
mod enclosure;
mod lift;
mod parts;
mod polynomial;
mod refine;
mod rule;
mod setting;

pub use enclosure::{Enclosure, Interval};
pub use refine::{Ended, Refinement};
