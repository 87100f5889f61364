//! Small numerical pieces that several rooms need, each once.
//!
//! | what | where |
//! | --- | --- |
//! | sums with compensation or by halving, inner products | [`sum`] |
//! | units that are powers of two | [`scale`] |
//! | lengths and finite values of input | [`check`] |
//! | what fits into memory | [`memory`] |
//! | text files from outside | [`text`] |
//! | sign changes, golden sections | [`search`] |
//! | the regression line | [`mod@line`] |
//! | Legendre polynomials | [`legendre`] |
//! | differences of ln Γ and ψ | `gamma` |
//! | random numbers with a seed | [`random`] |
//! | conjugate gradients | [`conjugate_gradients`] |
//! | loops dealt out over threads | `parallel` |
//! | dense matrices: products, Cholesky factors, eigenvectors | `dense` |
//! | extremal quotients of two quadratic forms | `pencil` |
//!
//! Plain `f64`; nothing here knows a norm, a mesh or a scene.

pub mod check;
pub mod conjugate_gradients;
pub(crate) mod dense;
pub(crate) mod gamma;
pub mod legendre;
pub mod line;
pub mod memory;
pub(crate) mod parallel;
pub(crate) mod pencil;
pub mod random;
pub mod scale;
pub mod search;
pub mod sum;
pub mod text;
