//! The forms of the error norms in the Legendre basis of one element.

use super::legendre::primitive_gram;
use crate::constant::ErrorNorm;
use crate::error::{Error, Result};
use nalgebra::DMatrix;

/// The form whose quotient by |v|²_ν is maximised, on the unit element.
///
/// # Errors
/// [`Error::Incompatible`] for a norm without a form.
pub(super) fn form(norm: ErrorNorm, h: f64, degrees: &[usize]) -> Result<DMatrix<f64>> {
    let mass = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
    let size = degrees.len();
    Ok(match norm {
        ErrorNorm::L2 => primitive_gram(degrees),
        ErrorNorm::Derivative => DMatrix::from_fn(size, size, mass),
        ErrorNorm::H1 => {
            let primitive = primitive_gram(degrees);
            DMatrix::from_fn(size, size, |i, j| mass(i, j) + h * h * primitive[(i, j)])
        }
        ErrorNorm::Dual | ErrorNorm::At(_) => return Err(refused(norm)),
    })
}

/// [`Error::Incompatible`] for a norm without a form.
pub(in crate::interpolation) fn refused(norm: ErrorNorm) -> Error {
    norm.refused("interpolation", "L2, Derivative or H1")
}
