//! The contact edge of a solution: its trace, the pair (u_N, σ_N) as functions, the norms of the proofs on each
//! segment, and the consistency terms of Sections 3 and 4.
//!
//! | paper | here |
//! | --- | --- |
//! | u_N and −σ_N dΓ of a computed solution | [`EdgeTrace`]: nodal values and point forces |
//! | (u_N, σ_N) with finite norms of order ν = τ − 3/2 | [`ContactPair`] |
//! | norms (1.1) on each segment T ∩ Γ_C | [`ContactPair::norms`], [`SegmentNorms`] |
//! | ∫ σ_N (I^h u)_N, ∫ (σ_N − π^h σ_N)(π^h u_N − u_N) | [`consistency_terms`] |
//! | contact and non-contact intervals in ln r, r the distance from an end | [`radial_intervals`] |
//!
//! The consistency term is computed in two ways, depending on the data:
//!
//! * [`consistency_terms`]: point forces on a uniform edge, on all coarser grids at once; restriction is
//!   exact, so all levels together cost O(N).
//! * [`SegmentNorms`]: densities. The inequalities of the proofs contain ‖σ_N‖₀ and |σ_N|_ν, which are infinite for a
//!   point force and finite for a force distributed over the adjacent cells; the consistency term of the distributed
//!   force differs from that of the point force.
//!
//! Lengths are in the units of the data. Sign convention of the paper: u_N ≤ 0, σ_N ≤ 0.

mod consistency_levels;
mod pair;
mod problem_trace;
mod radial;
mod segment;
mod seminorm;
mod trace;

pub use consistency_levels::consistency_terms;
pub use pair::{ContactPair, Traces};
pub use radial::{RadialInterval, radial_intervals};
pub use segment::{SegmentNorms, TraceNorms};
pub use trace::{EdgeTrace, Interval};
