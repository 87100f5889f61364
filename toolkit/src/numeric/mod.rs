//! Small numerical pieces that several rooms need, each once.
//!
//! | what | where |
//! | --- | --- |
//! | sums with compensation or by halving, inner products | [`sum`] |
//! | units that are powers of two | [`scale`] |
//! | lengths and finite values of input | [`check`] |
//! | what fits into memory | [`memory`] |
//! | sign changes, golden sections | [`search`] |
//! | Legendre polynomials | [`legendre`] |
//! | differences of ln Γ and ψ | `gamma` |
//! | random numbers with a seed | [`random`] |
//! | conjugate gradients | [`conjugate_gradients`] |
//! | extreme eigenvalues of large pencils | [`block_iteration`] |
//! | loops dealt out over threads | `parallel` |
//! | dense matrices: products, Cholesky factors, eigenvectors | `dense` |
//! | extremal quotients of two quadratic forms | `pencil` |
//!
//! Plain `f64`; nothing here knows a norm or a mesh.

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
