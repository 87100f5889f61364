//! The largest eigenvalue of B x = λ A x for symmetric A > 0, B ≥ 0.
//!
//! Both matrices are scaled so that A has unit diagonal, A is factorized by Cholesky, and the symmetric eigenproblem of
//! L⁻¹ B L⁻ᵀ, divided by its largest entry, is solved. The value returned is the Rayleigh quotient of the eigenvector,
//! whose error is the square of the eigenvector's: a lower bound of λ up to the rounding of A and B.

use crate::error::{Error, Result};
use faer::{Mat, Side};

/// Largest λ with B x = λ A x, and its vector.
pub(crate) fn largest_eigenvalue(a: &Mat<f64>, b: &Mat<f64>) -> Result<(f64, Vec<f64>)> {
    let size = a.nrows();
    let scale: Vec<f64> = (0..size).map(|i| a[(i, i)].sqrt()).collect();
    if let Some(pivot) = scale.iter().position(|s| !(*s > 0.0 && s.is_finite())) {
        return Err(indefinite(pivot));
    }
    let scaled_a = Mat::from_fn(size, size, |i, j| a[(i, j)] / scale[i] / scale[j]);
    let scaled_b = Mat::from_fn(size, size, |i, j| b[(i, j)] / scale[i] / scale[j]);
    let norm = (0..size).map(|i| scaled_b[(i, i)].abs()).fold(0.0, f64::max);
    let unit_b = Mat::from_fn(size, size, |i, j| scaled_b[(i, j)] / norm);
    let factor = scaled_a.llt(Side::Lower).map_err(|_| indefinite(size))?;
    let lower = factor.L();
    let mut half = unit_b.clone();
    lower.solve_lower_triangular_in_place(half.as_mut());
    let mut reduced = half.transpose().to_owned();
    lower.solve_lower_triangular_in_place(reduced.as_mut());
    let symmetric = Mat::from_fn(size, size, |i, j| 0.5 * (reduced[(i, j)] + reduced[(j, i)]));
    let eigen = symmetric.self_adjoint_eigen(Side::Lower).map_err(|_| indefinite(size))?;
    let mut vector = Mat::from_fn(size, 1, |i, _| eigen.U()[(i, size - 1)]);
    lower.transpose().solve_upper_triangular_in_place(vector.as_mut());
    let quadratic = |matrix: &Mat<f64>| (vector.transpose() * (matrix * &vector))[(0, 0)];
    let value = quadratic(&unit_b) / quadratic(&scaled_a) * norm;
    let vector = (0..size).map(|i| vector[(i, 0)] / scale[i]).collect();
    Ok((value, vector))
}

fn indefinite(pivot: usize) -> Error {
    Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot }
}
