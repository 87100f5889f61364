//! Piecewise polynomials and their norms.

mod cells;
mod lebesgue;
mod norms;
mod pairs;
mod polynomial;
mod squares;

pub(crate) use pairs::{Cell, DegreeRules};
pub(crate) use polynomial::{Piece, PiecewisePolynomial, bubbles_of};
