//! Extremal quotients for a symmetric positive definite matrix A: largest eigenvalues and dual norms.
//!
//! A is scaled to unit diagonal and factorized by Cholesky, A = D L Lᵀ D. The largest λ with B x = λ A x is the largest
//! eigenvalue of L⁻¹ D⁻¹ B D⁻¹ L⁻ᵀ, a symmetric matrix that is divided by its largest diagonal entry first. The value returned is
//! the Rayleigh quotient of the eigenvector, whose error is the square of the eigenvector's: a lower bound of λ up to the
//! rounding of A and B.

use crate::error::{Error, Result};
use faer::{Mat, Side};

/// Rows of the reduced matrix, relative to its norm, that do not matter to the largest eigenvalue.
const INSIGNIFICANT: f64 = 1e-13;

/// The factorized matrix.
pub(crate) struct Factored {
    scale: Vec<f64>,
    scaled: Mat<f64>,
    lower: Mat<f64>,
}

impl Factored {
    pub(crate) fn new(a: &Mat<f64>) -> Result<Self> {
        let size = a.nrows();
        let scale: Vec<f64> = (0..size).map(|i| a[(i, i)].sqrt()).collect();
        if let Some(pivot) = scale.iter().position(|s| !(*s > 0.0 && s.is_finite())) {
            return Err(indefinite(pivot));
        }
        let scaled = Mat::from_fn(size, size, |i, j| a[(i, j)] / scale[i] / scale[j]);
        let factor = scaled.llt(Side::Lower).map_err(|_| indefinite(size))?;
        let lower = factor.L().to_owned();
        Ok(Self { scale, scaled, lower })
    }

    /// Largest λ with B x = λ A x, and its vector with xᵀ B x = 1.
    pub(crate) fn largest_eigenvalue(&self, b: &Mat<f64>) -> Result<(f64, Vec<f64>)> {
        let size = self.scale.len();
        let scaled = Mat::from_fn(size, size, |i, j| b[(i, j)] / self.scale[i] / self.scale[j]);
        let norm = (0..size).map(|i| scaled[(i, i)].abs()).fold(0.0, f64::max);
        // Entries that cannot matter would only slow the arithmetic down as subnormal numbers.
        let flushed = |value: f64| if value.abs() < 1e-30 { 0.0 } else { value };
        let unit = Mat::from_fn(size, size, |i, j| flushed(scaled[(i, j)] / norm));
        let mut half = unit.clone();
        self.lower.solve_lower_triangular_in_place(half.as_mut());
        let mut reduced = half.transpose().to_owned();
        self.lower.solve_lower_triangular_in_place(reduced.as_mut());
        let symmetric = |i: usize, j: usize| 0.5 * (reduced[(i, j)] + reduced[(j, i)]);
        // Rows of size ε change λ by ε²; without them the matrix is smaller and holds no subnormal numbers.
        let largest = |i: &usize| (0..size).map(|j| symmetric(*i, j).abs()).fold(0.0, f64::max);
        let kept: Vec<usize> = (0..size).filter(|i| largest(i) > INSIGNIFICANT).collect();
        let essential = Mat::from_fn(kept.len(), kept.len(), |i, j| symmetric(kept[i], kept[j]));
        let eigen = essential.self_adjoint_eigen(Side::Lower).map_err(|_| indefinite(size))?;
        let mut vector = Mat::<f64>::zeros(size, 1);
        for (i, &row) in kept.iter().enumerate() {
            vector[(row, 0)] = eigen.U()[(i, kept.len() - 1)];
        }
        self.lower.transpose().solve_upper_triangular_in_place(vector.as_mut());
        let quadratic = |matrix: &Mat<f64>| (vector.transpose() * (matrix * &vector))[(0, 0)];
        let of_b = quadratic(&unit);
        let length = of_b.sqrt() * norm.sqrt();
        let vector = (0..size).map(|i| vector[(i, 0)] / length / self.scale[i]).collect();
        Ok((of_b / quadratic(&self.scaled) * norm, vector))
    }

    /// A⁻¹ b.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let size = self.scale.len();
        let mut x = Mat::from_fn(size, 1, |i, _| b[i] / self.scale[i]);
        self.lower.solve_lower_triangular_in_place(x.as_mut());
        self.lower.transpose().solve_upper_triangular_in_place(x.as_mut());
        (0..size).map(|i| x[(i, 0)] / self.scale[i]).collect()
    }
}

fn indefinite(pivot: usize) -> Error {
    Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot }
}
