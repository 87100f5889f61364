//! Numerical building blocks shared by several modules.
//!
//! | topic | module |
//! | --- | --- |
//! | compensated and pairwise sums, inner products | [`sum`] |
//! | units that are powers of two | [`scale`] |
//! | checks of lengths and of finite values | [`check`] |
//! | available memory | [`memory`] |
//! | caches of the last value | `last` |
//! | remaining evaluations | `budget` |
//! | bisection, golden-section search | [`search`] |
//! | Legendre polynomials | [`legendre`] |
//! | differences of ln Γ and ψ | `gamma` |
//! | numbers of twice the digits | `twofold` |
//! | conjugate gradients | [`conjugate_gradients`] |
//! | extreme eigenvalues of large pencils | [`block_iteration`] |
//! | parallel maps | `parallel` |
//! | dense matrices: products, Cholesky factors, eigenvectors | `dense` |
//! | extremal quotients of two quadratic forms | `pencil` |
//!
//! Everything else is in `f64`; nothing here depends on norms or meshes.

pub(crate) mod block_iteration;
pub(crate) mod budget;
pub(crate) mod check;
pub(crate) mod conjugate_gradients;
pub(crate) mod dense;
pub(crate) mod gamma;
pub(crate) mod last;
pub(crate) mod legendre;
pub(crate) mod memory;
pub(crate) mod parallel;
pub(crate) mod pencil;
pub(crate) mod scale;
pub(crate) mod search;
pub(crate) mod sum;
pub(crate) mod twofold;

use crate::error::Error;

/// True if n has no prime factor above 5: Fourier transforms of such lengths are fast.
pub(crate) fn is_smooth(mut n: usize) -> bool {
    for prime in [2, 3, 5] {
        while n.is_multiple_of(prime) {
            n /= prime;
        }
    }
    n == 1
}
