//! Section 1: fractional Sobolev spaces on intervals.
//!
//! The seminorm is |u|²_ν = ∫∫ (u(x)−u(y))² / |x−y|^{1+2ν} dx dy over the square of the interval, 0 < ν < 1,
//! (1.1) of the paper; the norm of order m + ν adds the L² norms of the derivatives up to m.
//!
//! | what | where |
//! | --- | --- |
//! | orders and meshes | [`FractionalOrder`], [`Partition`] |
//! | norms of piecewise polynomials and of closures | [`PiecewisePolynomial`], [`SingularFunction`] |
//! | norms of u − u_h | [`SingularFunction::minus`], [`FieldError`] |
//! | monotone rearrangements | [`PiecewisePolynomial::decreasing_rearrangement`], [`near_differences`] |
//! | norms of named functions | [`GalleryFunction`] |
//! | Gram matrices, dense and as fast operators | [`gram_constants`], [`gram_linears`], [`GramOperator`] |
//! | dual norms | [`dual`], [`PiecewisePolynomial::dual_norm`], [`DualOf`], [`MeshFunctional`] |
//! | norms on polygons' boundaries | [`BoundaryFunction`], [`PolygonalCurve`] |
//! | norms in the plane, on triangulations | [`PlaneFunction`], [`SingularPlaneFunction`], [`Triangles`] |
//! | traces with their constants | [`half_plane_trace`], [`WedgeTrace`], [`SquareTrace`] |
//! | exact values | [`closed_forms`] |

mod boundary;
pub mod closed_forms;
pub mod dual;
mod energy;
mod fields;
mod functions;
mod gallery;
mod gallery_norms;
mod grading;
mod gram;
mod kernel;
mod nearly_one;
mod order;
mod partition;
mod piecewise;
mod plane;
mod root;
mod trace;

pub use boundary::{BoundaryFunction, PolygonalCurve};
pub use dual::{DualOf, MeshFunctional};
pub use fields::FieldError;
pub use functions::{Position, SingularFunction};
pub use gallery::GalleryFunction;
pub use gram::{GramOperator, gram_constants, gram_linears, mass_constants, mass_linears};
pub use order::FractionalOrder;
pub use partition::Partition;
#[cfg(feature = "contact")]
pub(crate) use piecewise::linear_power;
pub use piecewise::{
    PiecewisePolynomial, near_differences, sorted_share, sorted_share_of_orders, sorted_share_of_random,
};
pub use plane::{
    GridOperator, PlaneFunction, PlanePosition, SectorPower, SingularPlaneFunction, Triangles,
    coordinate_on_unit_square, gradient_limit, perimeter_limit,
};
pub(crate) use root::root_of_squares;
pub(crate) use trace::HalfLineSymbol;
pub use trace::{SquareTrace, WedgeTrace, extension_profile, half_plane_trace, half_plane_trace_at_one};
