//! Singular exponents: r^λ at corners and transitions of plane problems, and the regularity they imply.
//!
//! Near a corner of opening ω the solution of an elliptic problem with smooth data is a sum of terms r^λ U(θ) and a
//! smoother function; λ depends on ω, on the boundary conditions on the two sides, and for elasticity on Poisson's
//! ratio. Two conditions that meet within a side, such as contact and no contact, form a corner of opening π.
//!
//! | | content | module |
//! | --- | --- | --- |
//! | [`Wedge`] | opening, medium, sides; the characteristic equations | `wedge`, `factor` |
//! | [`Wedge::exponents`] | all λ with 0 < Re λ < 3; checked by zero counts | `spectrum`, `zeros`, `count` |
//! | [`Wedge::count`] | the argument principle alone | `count` |
//! | [`Mode`] | angular functions: displacement, traction | `mode`, `basis` |
//! | [`Wedge::sign_condition`], [`Wedge::regularity`] | sign conditions of contact; u ∈ H^τ, τ < 1 + Re λ | `regularity` |
//!
//! P. Grisvard, *Elliptic Problems in Nonsmooth Domains* (1985); V. A. Kozlov, V. G. Maz'ya and J. Rossmann,
//! *Spectral Problems Associated with Corner Singularities* (2001).

mod basis;
mod count;
mod factor;
mod mode;
mod regularity;
mod spectrum;
mod wedge;
mod zeros;

pub use mode::Mode;
pub use regularity::{CornerRegularity, SignCondition};
pub use spectrum::{Exponent, LARGEST, Spectrum};
pub use wedge::{Medium, SideCondition, SideConditions, Wedge};
