//! (4.6), (4.7): the L² projection π^h onto piecewise constants.

mod constant;
mod on_mesh;

pub use constant::{ProjectionNorm, dual_projection_constant, projection_constant};
pub use on_mesh::{projection_norm_on_cells, projection_norm_on_mesh};
