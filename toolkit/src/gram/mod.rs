//! Gram matrices of |·|_ν and of L² for piecewise constant and piecewise linear functions: dense, and as fast
//! products.

mod band;
mod circulant;
pub(super) mod cluster;
pub(super) mod dense;
mod eigenvalues;
mod elimination;
mod hierarchical;
mod operator;
mod solve;
mod spectral;
mod toeplitz;
mod tridiagonal;

pub(crate) use dense::{
    add_mass, gram_constants, gram_linears, gram_zero_outside, mass_form, mass_linears,
    require_constants_finite, tridiagonal,
};
pub(crate) use eigenvalues::{Forms, extreme_eigenvalues};
pub(crate) use operator::GramOperator;
pub(crate) use solve::solve;
pub(crate) use spectral::Spectral;
pub(crate) use tridiagonal::{Basis, Network};
