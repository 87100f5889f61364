//! Fractional Sobolev norms and best constants on intervals, polygons and triangulations, each with an error
//! bound.
//!
//! Norms of order 0 < ν < 1 on intervals and polygons, dual norms, Poincaré constants, best constants of
//! interpolation, each with an error that holds. Everything is nondimensional unless said otherwise.
//!
//! | you have | you want | start here |
//! | --- | --- | --- |
//! | a formula, with kinks or singularities | Gagliardo-Slobodeckij seminorm, norm | [`SingularFunction`] |
//! | values on a mesh of an interval | the same, 100 000 nodes in a second | [`PiecewisePolynomial`] |
//! | values on a triangulation | norms in the plane | [`PlaneFunction`] |
//! | values on the boundary of a polygon | norms of order 1/2, −1/2 and others | [`BoundaryFunction`] |
//! | a load | its dual norm | [`PiecewisePolynomial::dual_norm`] |
//! | a mesh | Gram and mass matrix, fast products | [`GramOperator`], [`gram_linears`] |
//! | a zone where the mean vanishes | the Poincaré constant | [`gamma`] |
//! | an element | the constant of interpolation | [`interpolation::element_constant`] |
//!
//! Orders are [`FractionalOrder`] and tolerances, which are relative, [`Tolerance`]; where [`Given`]
//! stands, plain numbers do. What comes back is an [`Estimate`] with value, error and work. A tolerance that is
//! not met is an [`Error`] that carries the best estimate: [`Estimate::or_best`] takes it.
//!
//! The seminorm is |u|²_ν = ∫∫ (u(x)−u(y))² / |x−y|^{1+2ν} dx dy over the square of the interval, 0 < ν < 1,
//! (1.1) of the paper; the norm of order m + ν adds the L² norms of the derivatives up to m.
//!
//! # Programs
//!
//! **A kink and a logarithm**, norms in H^{0.45}(0, 1). Break points are where the function is not smooth;
//! next to them a [`Position`] knows the distance exactly.
//!
//! ```
//! use fractional_sobolev::SingularFunction;
//! let breaks = [0.0, 0.3, 1.0];
//! let kink = SingularFunction::from_positions(&breaks, |at| at.distance_to(1))?;
//! let logarithm = SingularFunction::from_positions(&breaks, |at| at.log_distance_to(1))?;
//! println!("{}, {}", kink.norm(0.45, 1e-8)?, logarithm.norm(0.45, 1e-8)?);
//! # Ok::<(), fractional_sobolev::Error>(())
//! ```
//!
//! **A piecewise linear function with 100 000 nodes**, norm in H^{1/2}.
//!
//! ```
//! use fractional_sobolev::{Partition, PiecewisePolynomial};
//! let mesh = Partition::uniform(99_999, 1.0)?;
//! let values: Vec<f64> = mesh.nodes().iter().map(|x| (9.0 * x).sin()).collect();
//! println!("{}", PiecewisePolynomial::linears(mesh, &values)?.norm(0.5, 1e-8)?);
//! # Ok::<(), fractional_sobolev::Error>(())
//! ```
//!
//! **A load in H^{−1/2}**: ±1 on 1000 elements, sup ⟨f, v⟩/‖v‖.
//!
//! ```
//! use fractional_sobolev::{DualOf, Partition, PiecewisePolynomial};
//! let signs: Vec<f64> = (0..1000).map(|k| if k * k % 7 < 3 { 1.0 } else { -1.0 }).collect();
//! let f = PiecewisePolynomial::constants(Partition::uniform(1000, 1.0)?, &signs)?;
//! println!("{}", f.dual_norm(0.5, 1e-8)?);
//! # Ok::<(), fractional_sobolev::Error>(())
//! ```
//!
//! **A Poincaré constant**: ‖u‖₀ ≤ γ |u|_{1/2} for all u with mean zero on (0.3, 0.3 + 1e-6).
//!
//! ```
//! use fractional_sobolev::{Constraint, FractionalOrder, gamma, Tolerance, Zone};
//! let zone = Zone::at(0.3, 1e-6)?;
//! println!("{}", gamma(FractionalOrder::HALF, Constraint::mean_zero_on(zone), Tolerance::balanced())?.constant);
//! # Ok::<(), fractional_sobolev::Error>(())
//! ```
#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod boundary;
pub mod closed_forms;
pub mod dual;
mod energy;
mod error;
mod estimate;
mod fields;
mod function;
mod functions;
mod gallery;
mod gallery_norms;
mod grading;
mod gram;
pub mod interpolation;
mod kernel;
mod matrix;
mod nearly_one;
mod numeric;
mod order;
mod partition;
mod piecewise;
mod plane;
mod poincare;
mod quadrature;
mod root;
mod trace;
mod value;

pub use boundary::{BoundaryFunction, PolygonalCurve};
pub use dual::{DualOf, MeshFunctional};
pub use error::{Error, Given, Result};
pub use estimate::{Estimate, Tolerance, Work};
pub use fields::FieldError;
pub use function::Function;
pub use functions::{Position, SingularFunction};
pub use gallery::GalleryFunction;
pub use gram::{GramOperator, gram_constants, gram_linears, mass_constants, mass_linears};
pub use matrix::Gram;
pub use order::{FractionalOrder, SobolevOrder};
pub use partition::Partition;
pub use piecewise::PiecewisePolynomial;
pub use plane::{
    GridOperator, PlaneFunction, PlanePosition, SectorPower, SingularPlaneFunction, Triangles,
    coordinate_on_unit_square,
};
pub use poincare::{
    Constraint, END_SLOPE, ExtremalFunction, Gamma, GammaBounds, HalfBracket, INTERIOR_SLOPE, LawRest,
    LimitLaw, Moment, MomentBounds, StrongForm, UniformLaw, Zone, Zones, end_limit, gamma, half_order_moment,
    interior_limit, largest_mean, moment_extremal, moment_norm, moment_norm_beside,
};
pub use quadrature::Rule;
pub(crate) use trace::HalfLineSymbol;
pub use trace::{SquareTrace, WedgeTrace, extension_profile, half_plane_trace, half_plane_trace_at_one};
