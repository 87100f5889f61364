//! Norms of fractional order in the plane, on triangulations of polygons.
//!
//! |w|²_{s,Ω} = ∫_Ω∫_Ω (w(x)−w(y))² / |x−y|^{2+2s} dx dy, 0 < s < 1.
//!
//! | quantity | type |
//! | --- | --- |
//! | triangulations | [`Triangles`] |
//! | corner singularities r^a sin(bφ) on sectors | [`SectorPower`] |
//! | norms of piecewise constants, of continuous piecewise linear functions and of their gradients | [`PlaneFunction`] |
//! | norms of formulas with declared corner singularities | [`SingularPlaneFunction`] |

mod closures;
mod far;
mod function;
mod geometry;
mod kernel;
mod leaves;
mod means;
mod norms;
mod overlap;
mod sector;
mod simplex;
mod sums;
mod tree;
mod triangles;

pub use closures::PlanePosition;
pub(crate) use closures::SingularPlaneFunction;
pub(crate) use function::PlaneFunction;
pub(crate) use sector::{ElasticCorner, SectorPower};
pub use triangles::Triangles;
