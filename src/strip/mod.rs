//! Contact on a strip, reduced exactly to its contact edge by Fourier modes.
//!
//! The rows of a uniform mesh on a strip are translation invariant: Fourier modes diagonalise them, and eliminating all rows
//! but the contact edge is exact. What is left is a dense symmetric operator A on n edge unknowns, known by its symbol and applied
//! in O(n log n); n = 2^20 stands for 10^12 nodes. Sign convention of the paper: u_N ≤ 0, λ = −σ_N ≥ 0 on the contact edge
//! y = 0, whose outward normal points down; in the scalar strip u itself plays the part of u_N (Remark 1).
//!
//! | symbol | here |
//! | --- | --- |
//! | n, m, h = 1/n, H = m/n | cells along the edge, layers, mesh size, height |
//! | A, S(θ) | [`EdgeOperator`] and its symbol |
//! | b, c | [`EdgeLoad`]: J(g) = ½ g'A g − b'g + c |
//! | u − u_h | [`ExactEdge`], [`ExactElastic`]: energy norms from the edge alone; [`study`] over levels |
//! | K^h, K̄^h | [`crate::cone::Cone`], solved by [`solve_contact`] |

mod defect;
mod edge;
mod edge_data;
mod elastic;
mod elastic_defect;
mod exact;
mod exact_elastic;
mod inner;
mod listing;
mod precondition;
mod scalar;
mod sides;
mod slab;
mod solution;
mod solve;
mod study;
mod transfer;

pub use edge::EdgeOperator;
pub use edge_data::EdgeData;
pub use elastic::{ElasticLoad, ElasticStrip};
pub use exact::{ExactEdge, Reference};
pub use exact_elastic::ExactElastic;
pub use listing::{level_table, mean_order};
pub use scalar::{EdgeLoad, ScalarStrip};
pub use sides::Sides;
pub use solution::{EdgeSolution, Settings};
pub use solve::solve_contact;
pub use study::{Level, Levels, StripKind, StripProblem, study};
pub(crate) use transfer::restrict;
