//! Lemma 6.2 for all functions: best constants on a mesh, and an ascent to functions that come near them.

mod ascent;
mod constant;

pub use ascent::ascend;
pub use constant::{mesh_constant, mesh_constant_on_cells};
