//! Piecewise polynomials and their norms.

mod cells;
mod lebesgue;
mod norms;
mod pairs;
mod polynomial;
mod rearrangement;
mod squares;

pub(crate) use pairs::{Cell, PolynomialPairs};
pub use polynomial::PiecewisePolynomial;
pub(crate) use polynomial::{Piece, bubbles_of};
