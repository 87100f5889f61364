//! Integrals of |x − y|^{-1-2ν} times polynomials of low degree over pairs of elements, with integrands of one
//! sign and full relative accuracy.

pub(crate) mod cells;
pub(crate) mod chebyshev;
pub(crate) mod power;
