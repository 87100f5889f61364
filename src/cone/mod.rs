//! (2.9) and (4.1): the two discrete cones on a contact edge, open or closed, and the KKT residuals of
//! a solution in them.
//!
//! With w_i = (u_N)(x_i) at the nodes of the contact edge, in order, a cone is { w : B w ≤ g }:
//!
//! | cone | constraint | multiplier λ of B w ≤ g |
//! | --- | --- | --- |
//! | nodal K^h (2.9) | every node, B w = w | λ_i = −∫ σ_N φ_i |
//! | midpoint K̄^h (4.1) | every mean, (B w)_i = (w_i + w_{i+1})/2 | λ_i = −∫ σ_N over segment i |
//!
//! The multipliers are generalised forces: K u + B'λ = F, λ ≥ 0. In the nodal cone u_N ≤ g on the whole edge
//! if g is affine on every segment (u_N is); in the midpoint cone u_N may exceed g inside a segment. The
//! kernel of the midpoint B is the sawtooth (−1)^i.
//!
//! All other modules access the cones through this one: constraints and forces ([`EdgeCone`]), the faces of a
//! contact set and their coordinates, projections, multipliers from forces, refinement of a [`ContactSet`],
//! and the KKT residuals ([`KktResiduals`], [`Margins`]). It does not depend on meshes or
//! operators.

mod contact_set;
mod derivative;
mod edge_cone;
mod face;
mod kind;
mod kkt;
mod projection;
mod sawtooth;
mod status;

pub use contact_set::ContactSet;
pub use edge_cone::{EdgeCone, Ends};
pub(crate) use face::{Block, Face};
pub use kind::Cone;
pub(crate) use kkt::KktTerms;
pub use kkt::{KktResiduals, Margins};
pub(crate) use projection::{Weighted, active_on_ring, project_weighted};
pub(crate) use sawtooth::Coordinates;
pub use status::Status;
