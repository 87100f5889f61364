//! Norms of fractional order in the plane, on triangulations of polygons.
//!
//! |w|²_{s,Ω} = ∫_Ω∫_Ω (w(x)−w(y))² / |x−y|^{2+2s} dx dy, 0 < s < 1.
//!
//! | what | where |
//! | --- | --- |
//! | triangulations | [`Triangles`] |
//! | norms of piecewise constants, of continuous piecewise linears and of their gradients | [`PlaneFunction`] |

mod function;
mod geometry;
mod leaves;
mod means;
mod norms;
mod simplex;
mod triangles;

pub use function::PlaneFunction;
pub use triangles::Triangles;
