//! The largest quotient of two forms on a subspace, and the coefficients of a function that attains it.

use crate::error::{Error, Result};
use crate::numeric::dense::{product, symmetric_eigen, transpose_times};
use nalgebra::DMatrix;

/// Directions in which the scaled seminorm is below this share of its largest value are omitted, since
/// rounding dominates them. The quotient on the remaining space is still a lower bound.
const CUT: f64 = 1e-11;

/// The largest λ with B x = λ A x on the span of the `kept` functions, and its vector with xᵀ A x = 1.
///
/// # Errors
/// [`Error::NotPositiveDefinite`] if A is not positive definite.
pub(super) fn largest_quotient(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    kept: &[usize],
) -> Result<(f64, Vec<f64>)> {
    let size = kept.len();
    let bad = || Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot: size };
    let scale: Vec<f64> = kept.iter().map(|&i| a[(i, i)].sqrt().recip()).collect();
    let part = |form: &DMatrix<f64>| {
        DMatrix::from_fn(size, size, |i, j| scale[i] * scale[j] * form[(kept[i], kept[j])])
    };
    let (values, vectors) = symmetric_eigen(&part(a)).ok_or_else(bad)?;
    let least = CUT * values.last().ok_or_else(bad)?;
    let from = values.iter().position(|value| *value > least).ok_or_else(bad)?;
    let root = DMatrix::from_fn(size, size - from, |i, j| {
        vectors[(i, from + j)] / values[from + j].sqrt()
    });
    let (found, inner) =
        symmetric_eigen(&transpose_times(&root, &product(&part(b), &root))).ok_or_else(bad)?;
    let last = found.len() - 1;
    let entry = |i: usize| (0..=last).map(|j| root[(i, j)] * inner[(j, last)]).sum::<f64>();
    let mut vector = vec![0.0; a.nrows()];
    (0..size).for_each(|i| vector[kept[i]] = scale[i] * entry(i));
    Ok((found[last], vector))
}
