//! Extremal quotients for a symmetric positive definite matrix A: largest eigenvalues and dual norms.
//!
//! A is scaled to unit diagonal and factorized by Cholesky's method, A = D L Lᵀ D. The largest λ with B x = λ A
//! x is the largest eigenvalue of L⁻¹ D⁻¹ B D⁻¹ L⁻ᵀ, a symmetric matrix that is first divided by its largest
//! diagonal entry. The value returned is the Rayleigh quotient of the eigenvector, whose error is of the
//! order of the square of that of the eigenvector: a lower bound of λ up to the rounding of A and B.

use super::dense::{Cholesky, product, symmetric_eigen};
use crate::error::{Error, Result};
use nalgebra::DMatrix;

/// Relative norm of those rows of the reduced matrix that do not affect the largest eigenvalue.
const INSIGNIFICANT: f64 = 1e-13;

/// Size below which an entry is set to zero, since subnormal numbers slow the arithmetic down.
const NEGLIGIBLE: f64 = 1e-30;

/// The factorized matrix.
#[derive(Debug, Clone)]
pub(crate) struct Factored {
    scale: Vec<f64>,
    scaled: DMatrix<f64>,
    factor: Cholesky,
}

impl Factored {
    pub(crate) fn new(a: &DMatrix<f64>) -> Result<Self> {
        let size = a.nrows();
        let scale: Vec<f64> = (0..size).map(|i| a[(i, i)].sqrt()).collect();
        if let Some(pivot) = scale.iter().position(|s| !(*s > 0.0 && s.is_finite())) {
            return Err(indefinite(pivot));
        }
        let scaled = DMatrix::from_fn(size, size, |i, j| a[(i, j)] / scale[i] / scale[j]);
        let factor = Cholesky::new(&scaled).ok_or(indefinite(size))?;
        Ok(Self { scale, scaled, factor })
    }

    /// The largest λ with B x = λ A x, and its vector with xᵀ B x = 1.
    pub(crate) fn largest_eigenvalue(&self, b: &DMatrix<f64>) -> Result<(f64, Vec<f64>)> {
        let size = self.scale.len();
        let scaled = DMatrix::from_fn(size, size, |i, j| b[(i, j)] / self.scale[i] / self.scale[j]);
        let norm = (0..size).map(|i| scaled[(i, i)].abs()).fold(0.0, f64::max);
        let flushed = |value: f64| if value.abs() < NEGLIGIBLE { 0.0 } else { value };
        let unit = DMatrix::from_fn(size, size, |i, j| flushed(scaled[(i, j)] / norm));
        let mut half = unit.clone();
        self.factor.forward(&mut half);
        let mut reduced = half.transpose();
        self.factor.forward(&mut reduced);
        let symmetric = |i: usize, j: usize| 0.5 * (reduced[(i, j)] + reduced[(j, i)]);
        // Rows of size ε change λ by ε²; without them the matrix is smaller and holds no subnormal numbers.
        let largest = |i: &usize| (0..size).map(|j| symmetric(*i, j).abs()).fold(0.0, f64::max);
        let kept: Vec<usize> = (0..size).filter(|i| largest(i) > INSIGNIFICANT).collect();
        let essential =
            DMatrix::from_fn(kept.len(), kept.len(), |i, j| symmetric(kept[i], kept[j]));
        let (values, vectors) = symmetric_eigen(&essential).ok_or(indefinite(size))?;
        let last = values.len().checked_sub(1).ok_or(indefinite(size))?;
        let mut vector = DMatrix::zeros(size, 1);
        for (i, &row) in kept.iter().enumerate() {
            vector[(row, 0)] = vectors[(i, last)];
        }
        self.factor.backward(&mut vector);
        let quadratic = |matrix: &DMatrix<f64>| {
            let image = product(matrix, &vector);
            (0..size).map(|i| vector[(i, 0)] * image[(i, 0)]).sum::<f64>()
        };
        let of_b = quadratic(&unit);
        let length = of_b.sqrt() * norm.sqrt();
        let vector = (0..size).map(|i| vector[(i, 0)] / length / self.scale[i]).collect();
        Ok((of_b / quadratic(&self.scaled) * norm, vector))
    }

    /// The product A⁻¹ b.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let size = self.scale.len();
        let x = self.factor.solve(&DMatrix::from_fn(size, 1, |i, _| b[i] / self.scale[i]));
        (0..size).map(|i| x[(i, 0)] / self.scale[i]).collect()
    }
}

fn indefinite(pivot: usize) -> Error {
    Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot }
}
