//! A companion to one paper, and a fractional-Sobolev toolkit that stands on its own.
//!
//! The paper is P. Hild and Y. Renard, *An improved a priori error analysis for finite element approximations of
//! Signorini's problem*, SIAM J. Numer. Anal. 50 (2012) 2400-2419. It holds no computation; every number here is new.
//!
//! # The paper's table of contents
//!
//! <!-- labels -->
//! | paper | here |
//! | --- | --- |
//! | (1.1): norms of fractional order on a segment | [`sobolev::SingularFunction`], [`sobolev::PiecewisePolynomial`], [`sobolev::GramOperator`] |
//! | Section 1, the plane: norms of fractional order on triangulations | [`sobolev::PlaneFunction`], [`sobolev::Triangles`], [`sobolev::GridOperator`], [`sobolev::SectorPower`] |
//! | Section 1, corners: norms of fractional order of corner singularities | [`sobolev::SingularPlaneFunction`], [`sobolev::PlanePosition`], [`sobolev::SectorPower`] |
//! | Section 1, cost: what norms in the plane cost | [`sobolev::SingularPlaneFunction`], [`sobolev::PlaneFunction`], [`sobolev::GridOperator`] |
//! | Section 1, traces: the trace theorem with its constant | [`sobolev::half_plane_trace`], [`sobolev::extension_profile`], [`sobolev::WedgeTrace`], [`sobolev::SquareTrace`] |
//! | (E1) to (E4), (N1), (N2): rates known before, and the new ones | [`convergence::Bound`] |
//! | Section 1, clamped end: contact at a clamped end | [`convergence::EndRun`], [`contact::solve_by_barrier`], [`scenes::ClampedEnd`], [`singular::ContactZone`], [`mesh::polar_rings`] |
//! | Figure 2.1, (2.1) to (2.7): body, conditions, weak form | [`contact::ContactProblem`], [`mesh`], [`fem`] |
//! | Section 2, your own body: a mesh of Gmsh, a load in x and y | [`mesh::read_msh`], [`mesh::ContactEdge`], [`scenes::OwnBody`] |
//! | where tau comes from: singular exponents of corners and transitions | [`singular::Wedge`], [`scenes::body_regularity`], [`convergence::CornerReading`] |
//! | Remark 1: the scalar problem | [`fem::Form::Scalar`], [`scenes::MeshScene::MembraneReaction`] |
//! | Remark 1, as printed: a reaction term, contact on the whole boundary | [`scenes::MeshTransition`], [`convergence::TransitionRates`] |
//! | (2.8), (2.9): linear elements and the cone K^h | [`cone::Cone::Nodal`], [`cone::EdgeCone`], [`contact::Solver`], [`cone::Judgement`] |
//! | Theorem 3.1, (3.1), (3.2): rates for K^h | [`convergence::Bound`], [`convergence::RateStudy`], [`convergence::Fit`] |
//! | Theorem 3.1 on a strip: any contact set, reduced exactly to its edge | [`strip::EdgeOperator`], [`strip::StripProblem`], [`scenes::StripScene`] |
//! | Figure 3.1: exponents over tau | [`convergence::Bound::exponent`] |
//! | (3.2), (4.3): tau = 2 and its logarithm | [`convergence::LogarithmFit`], [`scenes::TransitionPowers`] |
//! | Remark 2: no better bound in the dual norm | [`interpolation::AliasedWave`], [`interpolation::DualNorm`] |
//! | Remark 3, a face: one face with small gaps about its corners | [`proof::FaceGaps`] |
//! | Figure 3.2: first and second case, nodal cone | [`proof::NearVertices`], [`proof::Classification`] |
//! | (3.3) to (3.9), (3.11) to (3.15): both sides of every line | [`proof::section_three_checks`], [`proof::ProofCase`], [`proof::ProofConstants`] |
//! | (3.6), (3.10): embedding constants C(q) | [`interpolation::EmbeddingSpace`], [`interpolation::embedding_upper_bound`] |
//! | Section 3, Globally: the choice of theta | [`proof::ElementBalance`] |
//! | (4.1): the midpoint cone | [`cone::Cone::Midpoint`], [`cone::EdgeCone`] |
//! | Theorem 4.1, (4.2) to (4.4): rates for the midpoint cone | [`convergence::Bound`], [`convergence::RateStudy`], [`convergence::Fit`] |
//! | Remark 4: constants gain nothing beyond H^1 | [`interpolation::saturation_quotient`] |
//! | Falk's lemma, (4.5), (4.8): every term | [`proof::falk_terms`] |
//! | (4.6), (4.7): projection on constants, L^2 and dual norm | [`interpolation::projection_constant`], [`interpolation::dual_projection_constant`] |
//! | Figure 4.1: first and second case, midpoint cone | [`proof::SetDiameter`], [`proof::Classification`] |
//! | (4.9) to (4.14): both sides of every line | [`proof::section_four_checks`] |
//! | Theorems 3.1 and 4.1, any contact set: is any contact set bad? | [`proof::SegmentSets`], [`proof::one_gap_ratio`], [`proof::worst_ratio`] |
//! | Lemma 5.1: Peetre-Tartar | [`poincare::gamma`] |
//! | Lemma 5.2, (5.1) to (5.3): Poincaré constant of a small zone | [`poincare::gamma`], [`poincare::two_sided`], [`poincare::LimitLaw`] |
//! | Remark 5: no constant at nu = 1/2 | [`poincare::TruncatedFamily`], [`sobolev::closed_forms::log_power`] |
//! | (5.4): the constant exists and is attained | [`poincare::extremal`] |
//! | (5.5) to (5.9): scaling, one step, the product | [`poincare::InductionStep`], [`poincare::growth`], [`poincare::printed_growth`] |
//! | Remark 6: one point is enough above 1/2 | [`poincare::gamma_at_point`] |
//! | Remark 7: the zone may lie anywhere | [`poincare::Places`], [`poincare::Zone::at`] |
//! | Lemma 6.1, (6.1): interpolation on one interval | [`interpolation::element_constant`], [`interpolation::InterpolationError`] |
//! | Lemma 6.1, triangles: interpolation on one triangle: best constants | [`interpolation::TriangleConstants`], [`interpolation::TriangleShape`], [`interpolation::kobayashi`] |
//! | Lemma 6.1, shapes: interpolation on triangles of all angles | [`interpolation::TriangleShape`], [`interpolation::TriangleExtremal`] |
//! | (6.2): deviation from the mean | [`interpolation::limits::pointwise`], [`interpolation::mean_deviation`] |
//! | Lemma 6.2: interpolation on a mesh | [`interpolation::mesh_constant`] |
//! | Remark 7, sharp: of all sets of one measure the end is the worst | [`poincare::Zones`], [`poincare::ZoneCase`], [`poincare::MovedZone`], [`sobolev::PiecewisePolynomial::decreasing_rearrangement`] |
//! | (5.2), exact: the law at one half between two bounds | [`poincare::HalfBracket`], [`poincare::UniformLaw`] |
//! | Theorems 3.1 and 4.1, one segment: the best constants of the consistency term | [`proof::consistency_constant`], [`proof::product_constant`], [`poincare::moment_norm`], [`poincare::StrongForm`], [`poincare::half_order_moment`] |
//! | Theorems 3.1 and 4.1, tau = 2: a bound without C | [`proof::BoundWithoutC`], [`proof::MeshShape`], [`scenes::ClosedForm`] |
//! | Theorems 3.1 and 4.1, numbers: a bound with every constant a number, below tau = 2 | [`proof::TheoremNumbers`], [`proof::NumberedStudy`], [`scenes::RoughTransition`] |
//! | Theorems 3.1 and 4.1, numbers, elastic: the same bound for elastic bodies | [`proof::TheoremNumbers`], [`scenes::RoughTransition`], [`sobolev::SectorPower`] |
//! | Theorems 3.1 and 4.1, numbers, extrapolated: the same bounds where the solution is not known | [`proof::ExtrapolatedStudy`], [`proof::FineNorms`], [`scenes::LoadedBody`] |
//! | Theorem 3.1, the limit: contact costs nothing | [`proof::contact_cost`] |
//! | the knob: every tolerance is met | [`Tolerance`], [`Estimate`] |
//! | extremes: hard input gets digits, bad input an error | [`Error`] |
//! <!-- end of labels -->
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

pub use error::{Error, Result};
pub use estimate::{Estimate, Tolerance, Work};
