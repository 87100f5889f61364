//! Section 1: norms on segments, boundaries and in the plane, and the rates of the introduction.

/// Sizes of random searches: the few that decide here, or as many as the target `attacks` takes.
pub const MANY: bool = false;

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/plane_polar.rs"]
mod plane_polar;

mod errors_and_boundaries;
mod functions_in_the_plane;
mod norms_in_the_plane;
mod trace_constants;
