//! ‖·‖_{1/2,*} and Remark 2.

mod aliasing;
mod norm;

pub use aliasing::{AliasedWave, all_waves_mean};
pub use norm::DualNorm;
