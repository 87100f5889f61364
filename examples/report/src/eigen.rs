//! The one step of linear algebra that most computations "from the definition" share.

use crate::{Error, Result};
use nalgebra::DMatrix;

/// The largest λ with M u = λ A u for a vector u ≠ 0, M symmetric and A symmetric positive definite: that of
/// L⁻¹ M L⁻ᵀ, A = L Lᵀ. Its root is the best constant in uᵀMu ≤ λ uᵀAu. O(n³); rounding ε κ(A) relatively.
///
/// # Errors
/// [`Error::Option`] where A is not positive definite to rounding.
pub fn largest_eigenvalue(m: &DMatrix<f64>, a: &DMatrix<f64>) -> Result<f64> {
    let failed = || Error::Option("the form is not positive definite on this mesh".to_owned());
    let root = a.clone().cholesky().ok_or_else(failed)?.l();
    let half: DMatrix<f64> = root.solve_lower_triangular(m).ok_or_else(failed)?;
    let whole: DMatrix<f64> = root.solve_lower_triangular(&half.transpose()).ok_or_else(failed)?;
    Ok(whole.symmetric_eigenvalues().max())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pencil_of_two_by_two() {
        let m = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]);
        let a = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 4.0]);
        // det(M − λ A) = (2 − λ)(2 − 4λ) − 1 = 4 λ² − 10 λ + 3
        assert!((largest_eigenvalue(&m, &a).unwrap() - (10.0 + 52f64.sqrt()) / 8.0).abs() < 1e-14);
        assert!(largest_eigenvalue(&m, &-a).is_err());
    }
}
