//! Numerical building blocks shared by several modules.
//!
//! | topic | module |
//! | --- | --- |
//! | compensated and pairwise sums, inner products | `sum`, of `fractional_sobolev_numeric` |
//! | units that are powers of two | [`scale`] |
//! | checks of lengths, of finite values and of memory | [`check`] |
//! | caches of the last value | `last` |
//! | remaining evaluations | `budget` |
//! | bisection, golden-section search | `search`, of `fractional_sobolev_numeric` |
//! | Legendre polynomials | [`legendre`] |
//! | differences of ln Γ and ψ | `gamma` |
//! | numbers of twice the digits | `twofold` |
//! | conjugate gradients | `conjugate_gradients`, of `fractional_sobolev_numeric` |
//! | extreme eigenvalues of large pencils | [`block_iteration`] |
//! | parallel maps | `parallel` |
//! | dense matrices: products, Cholesky factors, eigenvectors | `dense` |
//! | extremal quotients of two quadratic forms | `pencil` |
//!
//! Everything else is in `f64`; nothing here depends on norms or meshes.

pub(crate) mod block_iteration;
pub(crate) mod budget;
pub(crate) mod check;
pub(crate) mod dense;
pub(crate) mod gamma;
pub(crate) mod last;
pub(crate) mod legendre;
pub(crate) mod parallel;
pub(crate) mod pencil;
pub(crate) mod scale;
pub(crate) mod twofold;

use crate::error::Error;
pub(crate) use fractional_sobolev_numeric::{conjugate_gradients, search, sum};
