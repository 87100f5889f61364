//! Dense matrices: products, Cholesky factors, eigenvectors, by faer on nalgebra's column-major storage. Small matrices are processed on one thread: for a few dozen rows
//! synchronisation dominates, and callers solve several problems at once.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltRegularization, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd, self_adjoint_evd_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::{Accum, Mat, MatMut, MatRef, Par};
use nalgebra::DMatrix;

/// Number of rows from which the threads of the caller are used, except for eigenvectors, which have a few
/// hundred rows at most.
const LARGE: usize = 200;

fn threads(rows: usize) -> Par {
    if rows < LARGE { Par::Seq } else { faer::get_global_parallelism() }
}

fn view(a: &DMatrix<f64>) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(a.as_slice(), a.nrows(), a.ncols())
}

fn view_mut(a: &mut DMatrix<f64>) -> MatMut<'_, f64> {
    let (rows, columns) = a.shape();
    MatMut::from_column_major_slice_mut(a.as_mut_slice(), rows, columns)
}

fn multiplied(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> DMatrix<f64> {
    let mut result = DMatrix::zeros(a.nrows(), b.ncols());
    let par = threads(a.nrows().min(b.ncols()));
    matmul(view_mut(&mut result), Accum::Replace, a, b, 1.0, par);
    result
}

/// The product A B.
pub(crate) fn product(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    multiplied(view(a), view(b))
}

/// The product A Bᵀ.
pub(crate) fn times_transpose(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    multiplied(view(a), view(b).transpose())
}

/// The product Aᵀ B.
pub(crate) fn transpose_times(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    multiplied(view(a).transpose(), view(b))
}

/// The factor L with A = L Lᵀ.
#[derive(Debug, Clone)]
pub(crate) struct Cholesky(Mat<f64>);

impl Cholesky {
    /// The factor of A, given by its lower half; `None` unless A is positive definite. Cost O(n³).
    pub(crate) fn new(a: &DMatrix<f64>) -> Option<Self> {
        let (size, par) = (a.nrows(), threads(a.nrows()));
        let mut lower = view(a).to_owned();
        let mut memory =
            MemBuffer::new(cholesky_in_place_scratch::<f64>(size, par, Default::default()));
        let stack = MemStack::new(&mut memory);
        cholesky_in_place(
            lower.as_mut(),
            LltRegularization::default(),
            par,
            stack,
            Default::default(),
        )
        .ok()?;
        Some(Self(lower))
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
        let par = threads(b.ncols());
        solve_lower_triangular_in_place(self.0.as_ref(), view_mut(b), par);
    }

    /// Replaces B by L⁻ᵀ B.
    pub(crate) fn backward(&self, b: &mut DMatrix<f64>) {
        let par = threads(b.ncols());
        solve_upper_triangular_in_place(self.0.transpose(), view_mut(b), par);
    }
}

/// The eigenvalues, in increasing order, and the unit eigenvectors, as columns, of the symmetric matrix whose
/// lower half is given.
///
/// `None` if the iteration does not converge, as for entries that are not finite. Cost O(n³).
pub(crate) fn symmetric_eigen(a: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let size = a.nrows();
    // faer's own matrices start every column where its kernels are fastest.
    let (matrix, mut vectors) = (view(a).to_owned(), Mat::<f64>::zeros(size, size));
    let mut values = Mat::<f64>::zeros(size, 1);
    let wanted = ComputeEigenvectors::Yes;
    let mut memory =
        MemBuffer::new(self_adjoint_evd_scratch::<f64>(size, wanted, Par::Seq, Default::default()));
    let stack = MemStack::new(&mut memory);
    let diagonal = values.as_mut().col_mut(0).as_diagonal_mut();
    self_adjoint_evd(
        matrix.as_ref(),
        diagonal,
        Some(vectors.as_mut()),
        Par::Seq,
        stack,
        Default::default(),
    )
    .ok()?;
    let values = (0..size).map(|i| values[(i, 0)]).collect();
    Some((values, DMatrix::from_fn(size, size, |i, j| vectors[(i, j)])))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn some(rows: usize, columns: usize, seed: usize) -> DMatrix<f64> {
        DMatrix::from_fn(rows, columns, |i, j| {
            ((seed + i * i + 7 * j * j + 3 * i * j) as f64).sin()
        })
    }

    fn distance(a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
        assert_eq!(a.shape(), b.shape());
        (a - b).amax() / b.amax().max(f64::MIN_POSITIVE)
    }

    #[test]
    fn nalgebra_has_the_same_products_solutions_and_eigenvalues() {
        for n in [1, 2, 3, 17, 64, 150, 210] {
            let (a, b) = (some(n, n + 2, 1), some(n + 2, 5, 2));
            assert!(distance(&product(&a, &b), &(&a * &b)) < 1e-13);
            assert!(distance(&times_transpose(&a, &a), &(&a * a.transpose())) < 1e-13);
            assert!(distance(&transpose_times(&a, &a), &a.tr_mul(&a)) < 1e-13);
            let gram = times_transpose(&a, &a) + DMatrix::identity(n, n) * n as f64;
            let (right, factor) = (some(n, 3, 3), Cholesky::new(&gram).unwrap());
            let other = nalgebra::Cholesky::new(gram.clone()).unwrap();
            assert!(distance(&factor.solve(&right), &other.solve(&right)) < 1e-12);
            let mut half = right.clone();
            factor.forward(&mut half);
            assert!(distance(&(other.l() * half), &right) < 1e-12);
            let (values, vectors) = symmetric_eigen(&gram).unwrap();
            assert!(values.is_sorted());
            assert!(
                (values[n - 1] / gram.symmetric_eigenvalues().max() - 1.0).abs() < 1e-13,
                "{n}"
            );
            let back = &vectors * DMatrix::from_diagonal(&values.into()) * vectors.transpose();
            assert!(distance(&back, &gram) < 1e-12, "{n}");
            assert!(distance(&vectors.tr_mul(&vectors), &DMatrix::identity(n, n)) < 1e-12, "{n}");
        }
    }

    #[test]
    fn what_is_not_positive_definite_or_not_finite_is_none() {
        for bad in [-1.0, 0.0, f64::NAN] {
            let mut a = DMatrix::identity(3, 3);
            a[(1, 1)] = bad;
            assert!(Cholesky::new(&a).is_none(), "{bad}");
            assert!(symmetric_eigen(&a).is_none() == bad.is_nan(), "{bad}");
        }
    }
}
