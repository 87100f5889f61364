//! (4.6), (4.7): the L² projection π^h onto piecewise constants.

mod constant;
mod on_mesh;
mod rates;
mod sample;
mod saturation;
mod supremum;

pub use constant::{ProjectionNorm, dual_projection_constant, projection_constant};
pub use on_mesh::{projection_norm_on_cells, projection_norm_on_mesh};
pub use rates::{DualRates, ProjectionRates, ProjectionStudy, sample_projection_rate};
pub use sample::{sample_projection_dual_error, sample_projection_error};
pub use saturation::{power_lagrange_rate, saturation_quotient};
pub use supremum::{SupremumRate, supremum_rate, wave_constant};
