//! Extremal quotients for a symmetric positive definite matrix A: largest eigenvalues and dual norms.
//!
//! A is scaled to unit diagonal and factorized by Cholesky, A = D L Lᵀ D. The largest λ with B x = λ A x is
//! the largest eigenvalue of L⁻¹ D⁻¹ B D⁻¹ L⁻ᵀ, a symmetric matrix that is divided by its largest diagonal
//! entry first. The value returned is the Rayleigh quotient of the eigenvector, whose error is the square of
//! the eigenvector's: a lower bound of λ up to the rounding of A and B.

use super::eigen::symmetric_eigen;
use crate::error::{Error, Result};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltRegularization, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, Par};

/// One thread: on a few hundred rows threads would spend their time waiting for each other. Callers solve
/// several problems at once.
const PAR: Par = Par::Seq;

/// Rows of the reduced matrix, relative to its norm, that do not matter to the largest eigenvalue.
const INSIGNIFICANT: f64 = 1e-13;

/// What does not matter as an entry either, and would only slow the arithmetic down as a subnormal number.
const NEGLIGIBLE: f64 = 1e-30;

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
        let lower = cholesky(scaled.clone()).ok_or(indefinite(size))?;
        Ok(Self { scale, scaled, lower })
    }

    /// Largest λ with B x = λ A x, and its vector with xᵀ B x = 1.
    pub(crate) fn largest_eigenvalue(&self, b: &Mat<f64>) -> Result<(f64, Vec<f64>)> {
        let size = self.scale.len();
        let scaled = Mat::from_fn(size, size, |i, j| b[(i, j)] / self.scale[i] / self.scale[j]);
        let norm = (0..size).map(|i| scaled[(i, i)].abs()).fold(0.0, f64::max);
        let flushed = |value: f64| if value.abs() < NEGLIGIBLE { 0.0 } else { value };
        let unit = Mat::from_fn(size, size, |i, j| flushed(scaled[(i, j)] / norm));
        let mut half = unit.clone();
        solve_lower_triangular_in_place(self.lower.as_ref(), half.as_mut(), PAR);
        let mut reduced = half.transpose().to_owned();
        solve_lower_triangular_in_place(self.lower.as_ref(), reduced.as_mut(), PAR);
        let symmetric = |i: usize, j: usize| 0.5 * (reduced[(i, j)] + reduced[(j, i)]);
        // Rows of size ε change λ by ε²; without them the matrix is smaller and holds no subnormal numbers.
        let largest = |i: &usize| (0..size).map(|j| symmetric(*i, j).abs()).fold(0.0, f64::max);
        let kept: Vec<usize> = (0..size).filter(|i| largest(i) > INSIGNIFICANT).collect();
        let essential = Mat::from_fn(kept.len(), kept.len(), |i, j| symmetric(kept[i], kept[j]));
        let first = dominant(&essential).ok_or(indefinite(size))?;
        let mut vector = Mat::<f64>::zeros(size, 1);
        for (i, &row) in kept.iter().enumerate() {
            vector[(row, 0)] = first[i];
        }
        solve_upper_triangular_in_place(self.lower.transpose(), vector.as_mut(), PAR);
        let quadratic = |matrix: &Mat<f64>| {
            let mut image = Mat::<f64>::zeros(size, 1);
            matmul(image.as_mut(), Accum::Replace, matrix.as_ref(), vector.as_ref(), 1.0, PAR);
            (0..size).map(|i| vector[(i, 0)] * image[(i, 0)]).sum::<f64>()
        };
        let of_b = quadratic(&unit);
        let length = of_b.sqrt() * norm.sqrt();
        let vector = (0..size).map(|i| vector[(i, 0)] / length / self.scale[i]).collect();
        Ok((of_b / quadratic(&self.scaled) * norm, vector))
    }

    /// A⁻¹ b.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let size = self.scale.len();
        let mut x = Mat::from_fn(size, 1, |i, _| b[i] / self.scale[i]);
        solve_lower_triangular_in_place(self.lower.as_ref(), x.as_mut(), PAR);
        solve_upper_triangular_in_place(self.lower.transpose(), x.as_mut(), PAR);
        (0..size).map(|i| x[(i, 0)] / self.scale[i]).collect()
    }
}

/// L with A = L Lᵀ.
fn cholesky(mut a: Mat<f64>) -> Option<Mat<f64>> {
    let size = a.nrows();
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(size, PAR, Default::default()));
    let stack = MemStack::new(&mut memory);
    cholesky_in_place(a.as_mut(), LltRegularization::default(), PAR, stack, Default::default()).ok()?;
    for j in 0..size {
        for i in 0..j {
            a[(i, j)] = 0.0;
        }
    }
    Some(a)
}

/// The unit eigenvector of the largest eigenvalue.
fn dominant(a: &Mat<f64>) -> Option<Vec<f64>> {
    let (values, vectors) = symmetric_eigen(a)?;
    let last = values.len().checked_sub(1)?;
    Some((0..values.len()).map(|i| vectors[(i, last)]).collect())
}

fn indefinite(pivot: usize) -> Error {
    Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot }
}
