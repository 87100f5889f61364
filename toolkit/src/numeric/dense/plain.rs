//! Dense linear algebra by nalgebra, on one thread.

use nalgebra::{DMatrix, SymmetricEigen};

/// The product A B.
pub(crate) fn product(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    a * b
}

/// The product A Bᵀ.
pub(crate) fn times_transpose(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    a * b.transpose()
}

/// The product Aᵀ B.
pub(crate) fn transpose_times(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    a.tr_mul(b)
}

/// The factor L with A = L Lᵀ.
#[derive(Debug, Clone)]
pub(crate) struct Cholesky(DMatrix<f64>);

impl Cholesky {
    /// The factor of A, given by its lower half; `None` unless A is positive definite. Cost O(n³).
    pub(crate) fn new(a: &DMatrix<f64>) -> Option<Self> {
        nalgebra::Cholesky::new(a.clone()).map(|factor| Self(factor.unpack_dirty()))
    }

    /// The product A⁻¹ B.
    pub(crate) fn solve(&self, b: &DMatrix<f64>) -> DMatrix<f64> {
        let mut x = b.clone();
        self.forward(&mut x);
        self.backward(&mut x);
        x
    }

    /// Replaces B by L⁻¹ B.
    pub(crate) fn forward(&self, b: &mut DMatrix<f64>) {
        self.0.solve_lower_triangular_unchecked_mut(b);
    }

    /// Replaces B by L⁻ᵀ B.
    pub(crate) fn backward(&self, b: &mut DMatrix<f64>) {
        self.0.tr_solve_lower_triangular_unchecked_mut(b);
    }
}

/// Largest number of rotations per row; two or three are typical.
const ROTATIONS: usize = 60;

/// The eigenvalues, in increasing order, and the unit eigenvectors, as columns, of the symmetric matrix whose
/// lower half is given.
///
/// `None` if the iteration does not converge, as for entries that are not finite. Cost O(n³).
pub(crate) fn symmetric_eigen(a: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let size = a.nrows();
    if size == 0 || !a.iter().all(|entry| entry.is_finite()) {
        return (size == 0).then(|| (Vec::new(), DMatrix::zeros(0, 0)));
    }
    let found = SymmetricEigen::try_new(a.clone(), f64::EPSILON, ROTATIONS * size)?;
    let mut by_size: Vec<usize> = (0..size).collect();
    by_size.sort_by(|&i, &j| found.eigenvalues[i].total_cmp(&found.eigenvalues[j]));
    let values = by_size.iter().map(|&i| found.eigenvalues[i]).collect();
    Some((values, DMatrix::from_fn(size, size, |i, j| found.eigenvectors[(i, by_size[j])])))
}
