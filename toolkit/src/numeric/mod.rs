//! Numerical building blocks shared by several modules.
//!
//! | topic | module |
//! | --- | --- |
//! | compensated and pairwise sums, inner products | [`sum`] |
//! | units that are powers of two | [`scale`] |
//! | checks of lengths and of finite values | [`check`] |
//! | available memory | [`memory`] |
//! | remaining evaluations | `budget` |
//! | bisection, golden-section search | [`search`] |
//! | Legendre polynomials | [`legendre`] |
//! | differences of ln Γ and ψ | `gamma` |
//! | seeded random numbers | [`random`] |
//! | conjugate gradients | [`conjugate_gradients`] |
//! | extreme eigenvalues of large pencils | [`block_iteration`] |
//! | parallel maps | `parallel` |
//! | dense matrices: products, Cholesky factors, eigenvectors | `dense` |
//! | extremal quotients of two quadratic forms | `pencil` |
//!
//! Everything is in `f64`; nothing here depends on norms or meshes.

pub(crate) mod block_iteration;
pub(crate) mod budget;
pub(crate) mod check;
pub(crate) mod conjugate_gradients;
pub(crate) mod dense;
pub(crate) mod gamma;
pub(crate) mod legendre;
pub(crate) mod memory;
pub(crate) mod parallel;
pub(crate) mod pencil;
#[cfg(test)]
pub(crate) mod random;
pub(crate) mod scale;
pub(crate) mod search;
pub(crate) mod sum;

use crate::error::Error;
