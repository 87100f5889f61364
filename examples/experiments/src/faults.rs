//! Refusals that the experiments share.

use fractional_sobolev::{Error, Result};

/// Constructors of the toolkit's error.
pub trait ErrorExt: Sized {
    /// The parameter `name` if it satisfies `admissible`. NaN is never admissible.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] otherwise.
    fn require(name: &'static str, value: f64, range: &'static str, admissible: bool) -> Result<f64>;

    /// No value of `what` was reached, only this relative uncertainty.
    fn out_of_reach(what: &'static str, asked: f64, reached: f64, why: &'static str) -> Self;
}

impl ErrorExt for Error {
    fn require(name: &'static str, value: f64, range: &'static str, admissible: bool) -> Result<f64> {
        if admissible && !value.is_nan() { Ok(value) } else { Err(Self::OutOfRange { name, value, range }) }
    }

    fn out_of_reach(what: &'static str, asked: f64, reached: f64, why: &'static str) -> Self {
        Self::ToleranceNotMet { what, asked, reached, best: None, why }
    }
}
