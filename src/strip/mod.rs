//! Contact on a strip, reduced exactly to its contact edge by Fourier modes.
//!
//! The rows of a uniform mesh on a strip are translation invariant: they are diagonalised by Fourier modes, and the
//! elimination of all rows but the contact edge is exact. The result is a dense symmetric operator A on n edge
//! unknowns, given by its symbol and applied in O(n log n); n = 2^20 represents 10^12 nodes. Sign convention of the
//! paper: u_N ≤ 0, λ = −σ_N ≥ 0 on the contact edge y = 0, whose outward normal points down; in the scalar strip u
//! replaces u_N (Remark 1).
//!
//! | symbol | here |
//! | --- | --- |
//! | n, m, h = 1/n, H = m/n | cells along the edge, layers, mesh size, height |
//! | A, S(θ) | [`EdgeOperator`] and its symbol |
//! | b, c | J(g) = ½ g'A g − b'g + c of a volume load: [`Strip::condense`] |
//! | u − u_h | [`StripProblem::error`]: energy norms from the edge alone |
//! | K^h, K̄^h | [`crate::cone::Cone`], solved by [`EdgeOperator::solve_contact`] |

mod edge_data;
mod exact;
mod operator;
mod reduced;
mod sides;
mod solver;
mod transfer;

pub use edge_data::EdgeData;
pub use exact::{Reference, StripKind, StripProblem};
pub use operator::edge::EdgeOperator;
pub use reduced::Strip;
pub use sides::LateralCondition;
pub use solver::solution::EdgeSolution;
pub(crate) use transfer::restrict;
