//! ‖·‖_{1/2,*} and Remark 2.

mod aliasing;
mod norm;
mod smooth;

pub use aliasing::{AliasedWave, all_waves_mean, all_waves_rate};
pub(crate) use norm::DualNorm;
pub use smooth::smooth_dual_error;
