//! Lemmas 6.1 and 6.2 and (4.6) for one function: both sides of the estimates, and functions to try them on.

mod error;
mod norms;
mod panels;
mod rearranged;
mod rough;
mod sample;
mod worst;

pub use error::{InterpolationError, power_slope};
pub use rearranged::rearranged_shares;
pub use rough::{RoughFamily, RoughSlopes};
pub use sample::SampleSlope;
pub use worst::{WorstRatios, worst_ratios};

pub(super) use norms::{require_unit, sample_norms};
pub(super) use panels::PanelRules;
