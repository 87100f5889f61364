//! A companion to one paper, and a fractional-Sobolev toolkit that stands on its own.
//!
//! The paper is P. Hild and Y. Renard, *An improved a priori error analysis for finite element approximations of
//! Signorini's problem*, SIAM J. Numer. Anal. 50 (2012) 2400-2419. It holds no computation; every number here is new.
//!
//! # The paper's table of contents
//!
//! | paper | here |
//! | --- | --- |
//! | **1. Introduction and notation** | [`sobolev`] |
//! | (1.1), norms of fractional order on a segment | [`sobolev::SingularFunction`], [`sobolev::PiecewisePolynomial`], [`sobolev::GramOperator`], [`sobolev::closed_forms`] |
//! | dual norms | [`sobolev::dual_norm_of_functional`], [`interpolation::DualNorm`] |
//! | **2. Signorini's problem** | [`contact`] |
//! | (2.1)-(2.7), body, conditions, weak form; Figure 2.1 | [`mesh`], [`fem`], [`contact::ContactProblem`], [`scenes::MeshScene`] |
//! | Remark 1, the scalar problem | [`fem::Form::Scalar`] |
//! | (2.8), (2.9), linear elements and the cone K^h | [`cone::Cone::Nodal`], [`contact::Solver`], [`cone::Judgement`] |
//! | the same on a strip, reduced to its contact edge | [`strip`] |
//! | **3. Error analysis** | [`edge`], [`proof`], [`convergence`] |
//! | Introduction, Theorems 3.1 and 4.1, Figure 3.1, rates old, new and measured | [`convergence::RateStudy`], [`convergence::Fit`] |
//! | why no contact set is bad | [`proof::worst_ratio`] |
//! | Figures 3.2 and 4.1, first and second case | [`proof::AlternativeCase`], [`proof::Classification`] |
//! | (3.3)-(3.15), (4.9)-(4.14), both sides of every line | [`proof::ProofCase`], [`proof::ProofConstants`], [`edge::ContactPair`] |
//! | "Globally", the choice of theta | [`proof::ElementBalance`] |
//! | Falk's lemma, (4.5), (4.8), term by term | [`proof::falk_terms`] |
//! | Remark 2, no better bound in the dual norm | [`interpolation::DualNorm`] |
//! | (3.6), (3.10), embedding constants C(q) | [`interpolation::embedding_upper_bound`], [`interpolation::EmbeddingSpace`] |
//! | **4. Another contact condition** | |
//! | (4.1), the midpoint cone | [`cone::Cone::Midpoint`] |
//! | Theorem 4.1, Figure 4.1, (4.5), (4.8)-(4.14) | [`proof`] |
//! | (4.6), (4.7), Remark 4, projection on constants | [`interpolation::projection_constant`], [`interpolation::dual_projection_constant`] |
//! | **5. Appendix A, Poincaré constants** | [`poincare`] |
//! | Lemma 5.1, (5.4), the constant exists | [`poincare::gamma`], [`poincare::extremal`] |
//! | Lemma 5.2, (5.1)-(5.3), its growth as the zone shrinks | [`poincare::ScalingCurve`], [`poincare::UniformLaw`], [`poincare::end_limit`], [`poincare::two_sided`] |
//! | (5.5)-(5.9), Remark 5 | [`poincare::printed_growth`], [`sobolev::closed_forms::log_power`] |
//! | Remark 6, one point; Remark 7, a zone anywhere | [`poincare::gamma_at_point`], [`poincare::Zone::at`] |
//! | **6. Appendix B, interpolation** | [`interpolation`] |
//! | Lemma 6.1, (6.1), one interval | [`interpolation::element_constant`], [`interpolation::longest_element`], [`interpolation::InterpolationError`] |
//! | Lemma 6.2, a mesh | [`interpolation::mesh_constant`] |
//! | **Every number** | [`Tolerance`], [`Estimate`], [`Error`], [`numeric`], [`quadrature`] |
//! | what is printed and drawn | [`report`], [`figures`] |
//!
//! ```
//! use signorini::poincare::{Condition, Zone, gamma};
//! use signorini::{Tolerance, sobolev::FractionalOrder};
//!
//! // Lemma 5.2 at ν = 1/2: the best constant for functions with mean zero on a zone of length 1e-6
//! let constant = gamma(FractionalOrder::HALF, Zone::end(1e-6)?, Condition::MeanZero, Tolerance::balanced())?;
//! assert!((constant.value - 1.444_490_180).abs() < 1e-8);
//! # Ok::<(), signorini::Error>(())
//! ```
//!
//! All quantities are nondimensional unless said otherwise. Arrows between rooms point downwards only.
#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

#[cfg(doctest)]
mod book;
pub mod cone;
pub mod contact;
pub mod convergence;
pub mod edge;
pub mod error;
pub mod estimate;
pub mod fem;
pub mod figures;
pub mod interpolation;
pub mod mesh;
pub mod numeric;
pub mod poincare;
pub mod proof;
pub mod quadrature;
pub mod report;
pub mod scenes;
pub mod sobolev;
pub mod strip;

pub use error::{Error, Result};
pub use estimate::{Estimate, Tolerance, Work};
