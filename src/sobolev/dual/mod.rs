//! Dual norms, sup ⟨f, v⟩ / ||v||, of functionals on a mesh and of piecewise polynomials.

mod functional;
mod modes;

pub use functional::{DualOf, dual_norm_of_functional};
