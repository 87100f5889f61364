//! Dense matrices by columns: products, Cholesky factors, symmetric eigenvalues. Products are those of nalgebra, whose
//! kernels use what the processor has; factors and substitutions are arranged as products.
//!
//! A = L Lᵀ by halves of the columns: with A = [[A₁₁, ·], [A₂₁, A₂₂]],
//!
//! L₁₁ L₁₁ᵀ = A₁₁,  L₂₁ = A₂₁ L₁₁⁻ᵀ,  L₂₂ L₂₂ᵀ = A₂₂ − L₂₁ L₂₁ᵀ.

use nalgebra::{DMatrix, DMatrixView, DMatrixViewMut, Dyn, SymmetricEigen};
use rayon::prelude::*;

/// Number of columns that are factored one by one.
const NARROW: usize = 8;

/// Number of rows that are substituted at a time.
const ROWS: usize = 32;

/// Number of multiplications from which the threads of the caller are used; below, synchronisation dominates.
const MANY: f64 = 3e7;

/// Steps of the iteration for eigenvalues; each takes a few.
const STEPS: usize = 10_000;

/// Powers before the first shift, and factors for shifts, of the iteration for the largest eigenvalue.
const POWERS: usize = 5;
const SHIFTS: usize = 60;

type View<'a> = DMatrixView<'a, f64, Dyn, Dyn>;
type ViewMut<'a> = DMatrixViewMut<'a, f64, Dyn, Dyn>;

fn view(a: &[f64], rows: usize, columns: usize, strides: [usize; 2]) -> View<'_> {
    let [row, column] = strides.map(Dyn);
    View::from_slice_with_strides_generic(a, Dyn(rows), Dyn(columns), row, column)
}

fn view_mut(a: &mut [f64], rows: usize, columns: usize, distance: usize) -> ViewMut<'_> {
    let shape = (Dyn(rows), Dyn(columns));
    ViewMut::from_slice_with_strides_generic(a, shape.0, shape.1, Dyn(1), Dyn(distance))
}

/// Treats blocks of `width` columns of a matrix, by several threads if that is worth while. `treat` is given the first
/// column of its block.
fn by_blocks(
    a: &mut [f64],
    distance: usize,
    width: usize,
    multiplications: f64,
    treat: impl Fn(usize, &mut [f64]) + Sync,
) {
    let block = (width * distance).max(1);
    if multiplications > MANY {
        a.par_chunks_mut(block).enumerate().for_each(|(k, part)| treat(k * width, part));
    } else {
        a.chunks_mut(block).enumerate().for_each(|(k, part)| treat(k * width, part));
    }
}

/// The product A B.
#[must_use]
pub fn product(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let (m, k, n) = (a.nrows(), a.ncols(), b.ncols());
    let mut result = DMatrix::zeros(m, n);
    let width = n.div_ceil(2 * rayon::current_num_threads()).next_multiple_of(8);
    by_blocks(result.as_mut_slice(), m, width, m as f64 * n as f64 * k as f64, |first, part| {
        let count = part.len() / m;
        view_mut(part, m, count, m).gemm(1.0, a, &b.columns(first, count), 0.0);
    });
    result
}

/// The product A Bᵀ.
#[must_use]
pub fn times_transpose(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    product(a, &b.transpose())
}

/// The product Aᵀ B.
#[must_use]
pub fn transpose_times(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    product(&a.transpose(), b)
}

/// Replaces C by C − A Bᵀ in the rows i ≥ j of every column j. A has `rows` rows and `inner` columns, B is its first
/// `columns` rows, C has `columns` columns; the distances are those from column to column in the slices.
fn subtract_product(
    c: (&mut [f64], usize),
    a: (&[f64], usize),
    rows: usize,
    columns: usize,
    inner: usize,
) {
    let ((c, distance), (a, apart)) = (c, a);
    let width = (columns / 8).clamp(32, 128).next_multiple_of(16);
    let c = &mut c[..((columns - 1) * distance + rows)];
    by_blocks(c, distance, width, rows as f64 * columns as f64 * inner as f64, |first, part| {
        let (count, below) = (width.min(columns - first), rows - first);
        let left = view(&a[first..], below, inner, [1, apart]);
        let right = view(&a[first..], inner, count, [apart, 1]);
        view_mut(&mut part[first..], below, count, distance).gemm(-1.0, &left, &right, 1.0);
    });
}

/// Replaces C by C − A Aᵀ, lower triangle. C is n x n, A is n x k with columns `distance` apart.
pub fn subtract_square(c: &mut [f64], n: usize, a: &[f64], k: usize, distance: usize) {
    if n > 0 && k > 0 {
        subtract_product((c, n), (a, distance), n, n, k);
    }
}

/// Factors the first columns of a matrix: (A₁₁; A₂₁), by columns with `height` rows, becomes (L₁₁; L₂₁), A₁₁ = L₁₁ L₁₁ᵀ
/// and L₂₁ = A₂₁ L₁₁⁻ᵀ. Above the diagonal nothing is used, and what is left there means nothing.
///
/// Cost: height times the square of the number of columns.
///
/// # Errors
/// The first column whose pivot is not a positive finite number.
pub fn factor(a: &mut [f64], height: usize) -> Result<(), usize> {
    match a.len().checked_div(height) {
        Some(columns) => factor_columns(a, height, 0, columns),
        None => Ok(()),
    }
}

fn factor_columns(a: &mut [f64], height: usize, from: usize, to: usize) -> Result<(), usize> {
    if to - from <= NARROW {
        return (from..to).try_for_each(|j| factor_column(a, height, from, j));
    }
    let middle = from + ((to - from) / 2).next_multiple_of(NARROW);
    factor_columns(a, height, from, middle)?;
    let (known, rest) = a.split_at_mut(middle * height);
    let known = &known[from * height + middle..];
    let (rows, columns) = (height - middle, to - middle);
    subtract_product((&mut rest[middle..], height), (known, height), rows, columns, middle - from);
    factor_columns(a, height, middle, to)
}

/// Column j after the columns before `from`.
fn factor_column(a: &mut [f64], height: usize, from: usize, j: usize) -> Result<(), usize> {
    let (known, rest) = a.split_at_mut(j * height);
    let column = &mut rest[j..height];
    for k in from..j {
        let other = &known[k * height + j..(k + 1) * height];
        let factor = other[0];
        column.iter_mut().zip(other).for_each(|(x, y)| *x -= factor * y);
    }
    let pivot = column[0];
    if !(pivot > 0.0 && pivot.is_finite()) {
        return Err(j);
    }
    let root = pivot.sqrt();
    column.iter_mut().for_each(|x| *x /= root);
    column[0] = root;
    Ok(())
}

/// The factor L with A = L Lᵀ.
#[derive(Debug, Clone)]
pub struct Cholesky(DMatrix<f64>);

impl Cholesky {
    /// The factor of A, given by its lower half; `None` unless A is positive definite. Cost O(n³).
    #[must_use]
    pub fn new(a: &DMatrix<f64>) -> Option<Self> {
        let mut lower = a.clone();
        factor(lower.as_mut_slice(), a.nrows()).ok().map(|()| Self(lower))
    }

    /// The diagonal entry l_ii, the root of a pivot.
    #[must_use]
    pub fn root(&self, i: usize) -> f64 {
        self.0[(i, i)]
    }

    /// The product A⁻¹ B.
    #[must_use]
    pub fn solve(&self, b: &DMatrix<f64>) -> DMatrix<f64> {
        let mut x = b.clone();
        self.forward(&mut x);
        self.backward(&mut x);
        x
    }

    /// Replaces B by L⁻¹ B.
    pub fn forward(&self, b: &mut DMatrix<f64>) {
        let (l, n) = (&self.0, self.0.nrows());
        self.substitute(b, |mut b| {
            for first in (0..n).step_by(ROWS) {
                let end = n.min(first + ROWS);
                let (mut own, mut below) = b.rows_range_pair_mut(first..end, end..n);
                l.view((first, first), (end - first, end - first))
                    .solve_lower_triangular_mut(&mut own);
                if end < n {
                    below.gemm(-1.0, &l.view((end, first), (n - end, end - first)), &own, 1.0);
                }
            }
        });
    }

    /// Replaces B by L⁻ᵀ B.
    pub fn backward(&self, b: &mut DMatrix<f64>) {
        let (l, n) = (&self.0, self.0.nrows());
        self.substitute(b, |mut b| {
            for first in (0..n).step_by(ROWS).rev() {
                let end = n.min(first + ROWS);
                let (mut own, below) = b.rows_range_pair_mut(first..end, end..n);
                if end < n {
                    own.gemm_tr(-1.0, &l.view((end, first), (n - end, end - first)), &below, 1.0);
                }
                l.view((first, first), (end - first, end - first))
                    .tr_solve_lower_triangular_mut(&mut own);
            }
        });
    }

    /// Treats columns of B, which do not depend on each other.
    fn substitute(&self, b: &mut DMatrix<f64>, treat: impl Fn(ViewMut<'_>) + Sync) {
        let (n, columns) = b.shape();
        let width = columns.div_ceil(2 * rayon::current_num_threads()).next_multiple_of(8);
        let multiplications = n as f64 * n as f64 * columns as f64;
        by_blocks(b.as_mut_slice(), n, width, multiplications, |_, part| {
            let count = part.len() / n;
            treat(view_mut(part, n, count, n));
        });
    }
}

/// The eigenvalues, in increasing order, and the unit eigenvectors, as columns, of the symmetric matrix whose
/// lower half is given.
///
/// `None` if an entry is not finite, or if the iteration does not converge. Cost O(n³).
#[must_use]
pub fn symmetric_eigen(a: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let size = a.nrows();
    if size == 0 {
        return Some((Vec::new(), DMatrix::zeros(0, 0)));
    }
    let eigen = SymmetricEigen::try_new(whole(a)?, f64::EPSILON, STEPS)?;
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
    let values = order.iter().map(|&i| eigen.eigenvalues[i]).collect();
    Some((values, eigen.eigenvectors.select_columns(&order)))
}

/// A unit eigenvector of the largest eigenvalue of the symmetric matrix whose lower half is given: a third of the time
/// of all eigenvectors. Of a multiple eigenvalue any eigenvector.
///
/// Inverse iteration, x ← (μ − A)⁻¹ x, with a shift μ = θ + 2|A x − θ x| beside the quotient θ = xᵀ A x, |x| = 1. That
/// μ − A has a Cholesky factor shows that no eigenvalue is above μ; if it has none, μ moves away. The end is where the
/// residual is rounding and a shift beside θ by rounding has a factor.
///
/// `None` if there are no rows or an entry is not finite.
#[must_use]
pub fn largest_eigenvector(a: &DMatrix<f64>) -> Option<Vec<f64>> {
    let (mut a, size) = (whole(a)?, a.nrows());
    let unit = a.amax();
    if unit > 0.0 {
        a /= unit;
    }
    // No symmetry of A is one of the start.
    let start = |i: usize| 1.0 + 0.5 * (0.618_033_988_749_895 * i as f64).fract();
    let mut x = DMatrix::from_fn(size, 1, |i, _| start(i));
    let rounding = f64::EPSILON * size as f64 * a.norm();
    let mut far = 0.0;
    for step in 0..SHIFTS {
        let length = x.norm();
        if !(length > 0.0 && length.is_finite()) {
            break;
        }
        x /= length;
        let image = &a * &x;
        let quotient = x.dot(&image);
        let residual = (&image - &x * quotient).norm();
        if step < POWERS {
            x = image + x;
            continue;
        }
        let beside = f64::max(2.0 * residual, 4.0 * rounding);
        far = f64::max(far, beside);
        let mut shifted = -&a;
        shifted.set_diagonal(&a.diagonal().map(|entry| quotient + far - entry));
        match Cholesky::new(&shifted) {
            Some(_) if residual <= rounding && far <= 64.0 * rounding => {
                return Some(x.iter().copied().collect());
            }
            Some(factor) => {
                for _ in 0..3 {
                    x = factor.solve(&x);
                    x /= x.amax();
                }
                far = 0.0;
            }
            None => far *= 16.0,
        }
    }
    let (_, vectors) = symmetric_eigen(&a)?;
    vectors.column_iter().next_back().map(|last| last.iter().copied().collect())
}

/// Both halves of a symmetric matrix, from the lower one; `None` if an entry of this is not finite.
fn whole(a: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let mut whole = a.clone();
    whole.fill_upper_triangle_with_lower_triangle();
    whole.iter().all(|x| x.is_finite()).then_some(whole)
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

    fn positive(n: usize) -> DMatrix<f64> {
        let a = some(n, n + 2, 1);
        &a * a.transpose() + DMatrix::identity(n, n) * n as f64
    }

    /// Sizes below and above one block of columns or rows, and beyond the limit of one thread.
    const SIZES: [usize; 12] = [1, 2, 3, 8, 9, 17, 32, 33, 64, 150, 210, 401];

    #[test]
    fn products_solutions_and_factors_are_those_of_plain_loops() {
        for n in SIZES {
            let (a, b) = (some(n, n + 2, 1), some(n + 2, n / 2 + 5, 2));
            let entry = |i: usize, j: usize| (0..n + 2).map(|k| a[(i, k)] * b[(k, j)]).sum();
            let plain = DMatrix::from_fn(n, b.ncols(), entry);
            assert!(distance(&product(&a, &b), &plain) < 1e-13, "{n}");
            assert!(distance(&times_transpose(&a, &b.transpose()), &plain) < 1e-13, "{n}");
            assert!(distance(&transpose_times(&a.transpose(), &b), &plain) < 1e-13, "{n}");
            let gram = positive(n);
            // What stands above the diagonal is not read.
            let mut lower = gram.clone();
            lower.fill_upper_triangle(f64::NAN, 1);
            let factor = Cholesky::new(&lower).unwrap();
            let l = factor.0.lower_triangle();
            assert!(distance(&(&l * l.transpose()), &gram) < 1e-14, "{n}");
            assert!((0..n).all(|i| factor.root(i) == l[(i, i)] && l[(i, i)] > 0.0));
            for columns in [1, 3, n + 7] {
                let right = some(n, columns, 3);
                let mut half = right.clone();
                factor.forward(&mut half);
                assert!(distance(&(&l * &half), &right) < 1e-13, "{n} {columns}");
                let mut back = half.clone();
                factor.backward(&mut back);
                assert!(distance(&(l.transpose() * &back), &half) < 1e-12, "{n} {columns}");
                assert!(distance(&(&gram * factor.solve(&right)), &right) < 1e-12, "{n} {columns}");
            }
        }
    }

    /// A front with p pivots and r rows below them, of a matrix whose whole factor is known.
    #[test]
    fn a_part_of_the_columns_is_factored_and_the_rest_updated() {
        for (p, r) in [(1, 0), (1, 1), (5, 3), (8, 40), (9, 200), (70, 1), (130, 310), (300, 500)] {
            let (whole, height) = (positive(p + r), p + r);
            let known = Cholesky::new(&whole).unwrap().0.lower_triangle();
            let mut panel = whole.columns(0, p).into_owned();
            factor(panel.as_mut_slice(), height).unwrap();
            assert!(distance(&panel.lower_triangle(), &known.columns(0, p).into_owned()) < 1e-13);
            let mut update = whole.view((p, p), (r, r)).into_owned();
            subtract_square(update.as_mut_slice(), r, &panel.as_slice()[p..], p, height);
            let rest = known.view((p, p), (r, r)).into_owned();
            let expected = (&rest * rest.transpose()).lower_triangle();
            assert!(distance(&update.lower_triangle(), &expected) < 1e-13, "{p} {r}");
        }
    }

    #[test]
    fn eigenvectors_are_orthogonal_and_give_the_matrix_back() {
        for n in SIZES {
            let gram = positive(n);
            let (values, vectors) = symmetric_eigen(&gram.lower_triangle()).unwrap();
            assert!(values.is_sorted());
            let back =
                &vectors * DMatrix::from_diagonal(&values.clone().into()) * vectors.transpose();
            assert!(distance(&back, &gram) < 1e-12, "{n}");
            assert!(distance(&vectors.tr_mul(&vectors), &DMatrix::identity(n, n)) < 1e-12, "{n}");
            let largest = DMatrix::from_vec(n, 1, largest_eigenvector(&gram).unwrap());
            let residual = &gram * &largest - &largest * values[n - 1];
            assert!(residual.amax() < 1e-13 * values[n - 1], "{n}");
            assert!((largest.norm() - 1.0).abs() < 1e-14, "{n}");
        }
    }

    /// 2 − 2 cos kπ/(n + 1), from 1e-5 to 4; and entries that span two hundred decades.
    #[test]
    fn eigenvalues_have_their_closed_form() {
        let n = 250;
        let second = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        });
        for unit in [1.0, 1e-100, 1e100] {
            let (values, _) = symmetric_eigen(&(&second * unit)).unwrap();
            for (k, value) in values.iter().enumerate() {
                let angle = (k + 1) as f64 * std::f64::consts::PI / (n + 1) as f64;
                assert!((value / unit - (2.0 - 2.0 * angle.cos())).abs() < 2e-14, "{unit} {k}");
            }
        }
        let diagonal = DMatrix::from_diagonal(&vec![1e-100, 1.0, 1e100, 0.0, -1.0].into());
        assert_eq!(symmetric_eigen(&diagonal).unwrap().0, [-1.0, 0.0, 1e-100, 1.0, 1e100]);
        let largest = largest_eigenvector(&diagonal).unwrap();
        assert!((0..5).all(|i| (largest[i] - f64::from(i == 2)).abs() < 1e-30), "{largest:?}");
    }

    #[test]
    fn multiple_eigenvalues_have_some_eigenvector() {
        for a in [DMatrix::identity(7, 7), DMatrix::zeros(5, 5), DMatrix::from_element(6, 6, 1.0)] {
            let vector = DMatrix::from_vec(a.nrows(), 1, largest_eigenvector(&a).unwrap());
            let value = a.symmetric_eigenvalues().max();
            assert!((&a * &vector - &vector * value).amax() < 1e-14);
            assert!((vector.norm() - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn what_is_not_positive_definite_or_not_finite_is_none() {
        for n in [3, 40] {
            for bad in [-1.0, 0.0, f64::NAN, f64::INFINITY] {
                let mut a = DMatrix::identity(n, n);
                a[(n - 2, n - 2)] = bad;
                assert!(Cholesky::new(&a).is_none(), "{bad}");
                assert_eq!(factor(a.as_mut_slice(), n), Err(n - 2));
                let mut a = DMatrix::identity(n, n);
                a[(n - 2, n - 2)] = bad;
                assert!(symmetric_eigen(&a).is_none() != bad.is_finite(), "{bad}");
                assert!(largest_eigenvector(&a).is_none() != bad.is_finite(), "{bad}");
            }
        }
        let empty = DMatrix::zeros(0, 0);
        assert_eq!(symmetric_eigen(&empty), Some((Vec::new(), empty.clone())));
        assert!(largest_eigenvector(&empty).is_none() && Cholesky::new(&empty).is_some());
        assert_eq!(product(&DMatrix::zeros(0, 3), &DMatrix::zeros(3, 2)).shape(), (0, 2));
    }
}
