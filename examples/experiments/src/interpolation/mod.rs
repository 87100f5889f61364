//! Lemmas 6.1 and 6.2, (4.6), (4.7) and Remarks 2 and 4 for single functions: both sides of the estimates, functions
//! to try them on, and the rates that sequences of meshes show.

mod aliasing;
mod deviation;
mod dual_norm;
mod elements;
mod error;
mod local;
mod mesh_ratios;
mod norms;
mod panels;
mod projection_rates;
mod projection_sample;
mod rate;
mod rearranged;
mod rearrangement;
mod rough;
mod sample;
mod saturation;
mod smooth;
mod supremum;
mod worst;

pub use aliasing::{AliasedWave, all_waves_mean, all_waves_rate};
pub use deviation::{extremal_slopes, largest_share, mean_deviation, pointwise};
pub use elements::ElementMesh;
pub use error::{InterpolationError, power_slope};
pub use local::{LocalConstants, full_constant, longest_element};
pub use mesh_ratios::MeshRatios;
pub use projection_rates::{DualRates, ProjectionRates, ProjectionStudy, sample_projection_rate};
pub use projection_sample::{sample_projection_dual_error, sample_projection_error};
pub use rearranged::rearranged_shares;
pub use rough::{RoughFamily, RoughSlopes};
pub use sample::SampleSlope;
pub use saturation::{power_lagrange_rate, saturation_quotient};
pub use smooth::smooth_dual_error;
pub use supremum::{SupremumRate, rate_of, supremum_rate, wave_constant};
pub use worst::{WorstRatios, worst_ratios};
