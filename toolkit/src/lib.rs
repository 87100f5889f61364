#![doc = include_str!("../README.md")]
#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod boundary;
pub mod closed_forms;
mod dual;
mod energy;
mod error;
mod estimate;
mod fields;
mod function;
mod functions;
mod grading;
mod gram;
pub mod interpolation;
mod kernel;
mod matrix;
mod mesh;
mod nearly_one;
mod numeric;
mod order;
mod piecewise;
mod plane;
mod poincare;
mod quadrature;
mod root;
mod trace;
mod value;

pub use boundary::Curve;
pub use dual::DualOf;
pub use error::{Error, Given, Result};
pub use estimate::{Estimate, Tolerance, Work};
pub use function::Function;
pub use functions::Position;
pub(crate) use gram::{gram_linears, mass_linears};
pub use matrix::Gram;
pub use mesh::Mesh;
pub use order::Order;
pub use plane::{PlanePosition, Triangles};
pub use poincare::{
    Constraint, ExtremalFunction, Gamma, GammaBounds, Law, Moment, MomentConstant, Zones, gamma, law, moment,
};
pub use quadrature::Rule;
pub(crate) use trace::HalfLineSymbol;
pub use trace::{SquareTrace, WedgeTrace, extension_profile, half_plane_trace, half_plane_trace_at_one};
