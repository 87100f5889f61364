//! The trace theorem with its constant: |w|\_{s−1/2, edge} ≤ C |w|\_{s,Ω}, 1/2 < s ≤ 1.
//!
//! |w|²_{s,Ω} = ∫_Ω∫_Ω (w(x)−w(y))² / |x−y|^{2+2s} dx dy and, for s = 1, ‖∇w‖²; the edge has the same double
//! integral with |x−y|^{-2s}.
//!
//! | what | where |
//! | --- | --- |
//! | half-plane: the constant, the extension | [`half_plane_trace`], [`extension_profile`] |
//! | a corner between two edges: the quotient of each Mellin mode | [`WedgeTrace`] |
//! | the square: lower bounds from trial functions | [`SquareTrace`] |

mod angular_kernel;
mod half_line;
mod half_plane;
mod increments;
mod square;
mod wedge;
mod wedge_elements;

pub(crate) use half_line::HalfLineSymbol;
pub use half_plane::{extension_profile, half_plane_trace, half_plane_trace_at_one};
pub use square::SquareTrace;
pub use wedge::WedgeTrace;
