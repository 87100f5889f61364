//! Dual norms, sup ⟨f, v⟩ / ||v||, of functionals on a mesh and of piecewise polynomials.

mod cells;
mod closure;
mod cosines;
mod functional;
mod regional;
mod resolvent;

pub use functional::{DualOf, dual_norm_of_functional};
