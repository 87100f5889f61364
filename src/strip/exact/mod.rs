//! Exact solutions of a strip, and the energy norms of errors with respect to them.

mod difference;
mod problem;

pub use problem::{Reference, StripKind, StripProblem};
