//! Piecewise polynomials and their norms.

mod lebesgue;
mod norms;
mod pairs;
mod polynomial;

pub(crate) use lebesgue::linear_power;
pub use polynomial::PiecewisePolynomial;
