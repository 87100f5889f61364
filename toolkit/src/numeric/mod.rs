//! Numerical building blocks shared by several modules.
//!
//! | what | where |
//! | --- | --- |
//! | sums with compensation or by halving, inner products | [`sum`] |
//! | units that are powers of two | [`scale`] |
//! | lengths and finite values of input | [`check`] |
//! | available memory | [`memory`] |
//! | sign changes, golden sections | [`search`] |
//! | Legendre polynomials | [`legendre`] |
//! | differences of ln Γ and ψ | `gamma` |
//! | random numbers with a seed | [`random`] |
//! | conjugate gradients | [`conjugate_gradients`] |
//! | extreme eigenvalues of large pencils | [`block_iteration`] |
//! | parallel maps | `parallel` |
//! | dense matrices: products, Cholesky factors, eigenvectors | `dense` |
//! | extremal quotients of two quadratic forms | `pencil` |
//!
//! All in `f64`; nothing here depends on norms or meshes.

pub(crate) mod block_iteration;
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
