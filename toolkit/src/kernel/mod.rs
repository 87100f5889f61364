//! Integrals of |x − y|^{-1-2ν} over pairs of elements against polynomials of low degree: one sign, full
//! relative accuracy.

pub(crate) mod cells;
pub(crate) mod chebyshev;
pub(crate) mod power;
