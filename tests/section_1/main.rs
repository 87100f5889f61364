//! Section 1: norms on segments, boundaries and in the plane, and the rates of the introduction.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/plane_polar.rs"]
mod plane_polar;

mod errors_and_boundaries;
mod functions_in_the_plane;
mod norms_in_the_plane;
mod rates;
mod trace_constants;
