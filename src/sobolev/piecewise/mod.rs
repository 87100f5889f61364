//! Piecewise polynomials and their norms.

mod lebesgue;
mod norms;
mod pairs;
mod polynomial;

#[cfg(feature = "contact")]
pub(crate) use lebesgue::linear_power;
pub use polynomial::PiecewisePolynomial;
