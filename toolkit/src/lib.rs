#![doc = include_str!("../README.md")]
#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod boundary;
pub mod closed_forms;
mod constant;
mod corner;
mod dual;
mod energy;
mod error;
mod estimate;
mod fields;
mod function;
mod functions;
mod grading;
mod gram;
mod interpolation;
mod kernel;
mod load;
mod matrix;
mod mesh;
mod nearly_one;
mod numeric;
mod order;
mod piecewise;
mod plane;
mod poincare;
mod quadrature;
mod resolved;
mod root;
mod trace;
mod value;

pub use boundary::Curve;
pub use constant::{BestConstant, Domain, ErrorNorm, Extremal};
pub use corner::CornerFunction;
pub use dual::DualOf;
pub use error::{Error, Given, Result};
pub use estimate::{Estimate, Tolerance, Work};
pub use function::Function;
pub use functions::Position;
pub use interpolation::{
    Target, embedding_bound, embedding_constant, interpolation_constant, projection_constant,
};
pub use load::Load;
pub use matrix::Gram;
pub use mesh::Mesh;
pub use order::Order;
pub use plane::{PlanePosition, Triangles};
pub use poincare::{Constraint, Law, Moment, Zones, gamma, law, mean_constant, moment};
pub use quadrature::{Rule, gauss_jacobi, gauss_legendre};
pub(crate) use trace::HalfLineSymbol;
pub use trace::{trace_constant, trace_constant_of_mode};
