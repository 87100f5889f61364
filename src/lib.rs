//! A fractional-Sobolev toolkit that stands on its own, and a companion to one paper on contact.
//!
//! Norms of order 0 < ν < 1 on intervals and polygons, dual norms, Poincaré constants, best constants of
//! interpolation, each with an error that holds. Everything is nondimensional unless said otherwise.
//!
//! | you have | you want | start here |
//! | --- | --- | --- |
//! | a formula, with kinks or singularities | Gagliardo-Slobodeckij seminorm, norm | [`sobolev::SingularFunction`] |
//! | values on a mesh of an interval | the same, 100 000 nodes in a second | [`sobolev::PiecewisePolynomial`] |
//! | values on a triangulation | norms in the plane | [`sobolev::PlaneFunction`] |
//! | values on the boundary of a polygon | norms of order 1/2, −1/2 and others | [`sobolev::BoundaryFunction`] |
//! | a load | its dual norm | [`sobolev::PiecewisePolynomial::dual_norm`] |
//! | a mesh | Gram and mass matrix, fast products | [`sobolev::GramOperator`], [`sobolev::gram_linears`] |
//! | a zone where the mean vanishes | the Poincaré constant | [`poincare::gamma`] |
//! | an element | the constant of interpolation | [`interpolation::element_constant`] |
//!
//! Orders are [`sobolev::FractionalOrder`] and tolerances, which are relative, [`Tolerance`]; where [`Given`]
//! stands, plain numbers do. What comes back is an [`Estimate`] with value, error and work. A tolerance that is
//! not met is an [`Error`] that carries the best estimate: [`Estimate::or_best`] takes it.
//!
//! # Five programs
//!
//! **A kink and a logarithm**, norms in H^{0.45}(0, 1). Break points are where the function is not smooth;
//! next to them a [`sobolev::Position`] knows the distance exactly.
//!
//! ```
//! use signorini::sobolev::SingularFunction;
//! let breaks = [0.0, 0.3, 1.0];
//! let kink = SingularFunction::from_positions(&breaks, |at| at.distance_to(1))?;
//! let logarithm = SingularFunction::from_positions(&breaks, |at| at.log_distance_to(1))?;
//! println!("{}, {}", kink.norm(0.45, 1e-8)?, logarithm.norm(0.45, 1e-8)?);
//! # Ok::<(), signorini::Error>(())
//! ```
//!
//! **A piecewise linear function with 100 000 nodes**, norm in H^{1/2}.
//!
//! ```
//! use signorini::sobolev::{Partition, PiecewisePolynomial};
//! let mesh = Partition::uniform(99_999, 1.0)?;
//! let values: Vec<f64> = mesh.nodes().iter().map(|x| (9.0 * x).sin()).collect();
//! println!("{}", PiecewisePolynomial::linears(mesh, &values)?.norm(0.5, 1e-8)?);
//! # Ok::<(), signorini::Error>(())
//! ```
//!
//! **A load in H^{−1/2}**: ±1 on 1000 elements, sup ⟨f, v⟩/‖v‖.
//!
//! ```
//! use signorini::sobolev::{DualOf, Partition, PiecewisePolynomial};
//! let signs: Vec<f64> = (0..1000).map(|k| if k * k % 7 < 3 { 1.0 } else { -1.0 }).collect();
//! let f = PiecewisePolynomial::constants(Partition::uniform(1000, 1.0)?, &signs)?;
//! println!("{}", f.dual_norm(0.5, 1e-8)?);
//! # Ok::<(), signorini::Error>(())
//! ```
//!
//! **A Poincaré constant**: ‖u‖₀ ≤ γ |u|_{1/2} for all u with mean zero on (0.3, 0.3 + 1e-6).
//!
//! ```
//! use signorini::{Tolerance, poincare::{Condition, Zone, gamma}, sobolev::FractionalOrder};
//! let zone = Zone::at(0.3, 1e-6)?;
//! println!("{}", gamma(FractionalOrder::HALF, zone, Condition::MeanZero, Tolerance::balanced())?);
//! # Ok::<(), signorini::Error>(())
//! ```
//!
//! **A body from Gmsh** on its floor takes the feature `contact`, which is on by default.
#![cfg_attr(feature = "contact", doc = include_str!("with_contact.md"))]
#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

#[cfg(all(doctest, feature = "contact"))]
mod book;
#[cfg(feature = "contact")]
pub mod cone;
#[cfg(feature = "contact")]
pub mod contact;
#[cfg(feature = "contact")]
pub mod convergence;
#[cfg(feature = "contact")]
pub mod edge;
pub mod error;
pub mod estimate;
#[cfg(feature = "contact")]
pub mod fem;
pub mod interpolation;
#[cfg(feature = "contact")]
pub mod mesh;
pub mod numeric;
pub mod poincare;
#[cfg(feature = "contact")]
pub mod proof;
pub mod quadrature;
#[cfg(feature = "contact")]
pub mod scenes;
#[cfg(feature = "contact")]
pub mod singular;
pub mod sobolev;
#[cfg(feature = "contact")]
pub mod strip;
pub mod value;

pub use error::{Error, Given, Result};
pub use estimate::{Estimate, Tolerance, Work};
