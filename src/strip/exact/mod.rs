//! Exact solutions of a strip, and the energy norms of errors with respect to them.

mod difference;
mod elastic;
mod grids;
mod problem;
mod reference;
mod scalar;

pub use problem::{StripKind, StripProblem};
pub use reference::Reference;
