//! An optimiser: from any slope to better ones, in the continuous piecewise linears of a partition.
//!
//! A step replaces v by A⁻¹ B v, A the Gram matrix of |·|_ν and B that of the squared error norm: power iteration on the
//! extremal quotient of Lemma 6.1, which rises with every step. Constants, the common kernel, are taken out by adding m mᵀ
//! to A, m the integrals of the hats: A⁻¹ B v then has mean zero. A second road to the best constants, from below.
//! Cost O(N³) once, O(N²) per step.

use super::element::ErrorNorm;
use crate::error::{Error, Result};
use crate::quadrature::Rule;
use crate::sobolev::{FractionalOrder, Partition, PiecewisePolynomial, gram_linears, mass_linears};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// Steps from random values: the second eigenvalue is at most about 0.4 of the first, 0.4^24 = 3e-10.
const STEPS: usize = 24;

/// The slope, linear on each element, that [`STEPS`] steps reach from the given values at the nodes.
///
/// # Errors
/// [`Error::LengthMismatch`] unless there is a value per node; [`Error::NotFinite`] for bad values;
/// [`Error::NotPositiveDefinite`] when the Gram matrix breaks down to rounding (elements far too short).
pub fn ascend(
    norm: ErrorNorm,
    order: FractionalOrder,
    partition: &Partition,
    start: &[f64],
) -> Result<PiecewisePolynomial> {
    let size = partition.len() + 1;
    // Checks the count and the values.
    let first = PiecewisePolynomial::linears(partition.clone(), start)?;
    if start.iter().all(|v| *v == start[0]) {
        return Ok(first);
    }
    let integrals = hat_integrals(partition);
    let gram = gram_linears(partition, order);
    let fixed = Mat::from_fn(size, size, |i, j| gram[(i, j)] + integrals[i] * integrals[j]);
    let broken = |_| Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot: size };
    let factor = fixed.llt(Side::Lower).map_err(broken)?;
    let form = error_form(norm, partition, &integrals)?;
    let mut values = Mat::from_fn(size, 1, |i, _| start[i]);
    for _ in 0..STEPS {
        values = factor.solve(&form * &values);
        let largest = (0..size).map(|i| values[(i, 0)].abs()).fold(0.0, f64::max);
        values *= faer::Scale(largest.recip());
    }
    let values: Vec<f64> = (0..size).map(|i| values[(i, 0)]).collect();
    PiecewisePolynomial::linears(partition.clone(), &values)
}

fn hat_integrals(partition: &Partition) -> Vec<f64> {
    let mut integrals = vec![0.0; partition.len() + 1];
    for (i, h) in partition.lengths().iter().enumerate() {
        integrals[i] += 0.5 * h;
        integrals[i + 1] += 0.5 * h;
    }
    integrals
}

/// B: the squared error norm as a form of the nodal values of the slope.
fn error_form(norm: ErrorNorm, partition: &Partition, integrals: &[f64]) -> Result<Mat<f64>> {
    let total = partition.total();
    let derivative = || {
        let (diagonal, off_diagonal) = mass_linears(partition);
        Mat::from_fn(integrals.len(), integrals.len(), |i, j| {
            let mass = match i.abs_diff(j) {
                0 => diagonal[i],
                1 => off_diagonal[i.min(j)],
                _ => 0.0,
            };
            mass - integrals[i] * integrals[j] / total
        })
    };
    Ok(match norm {
        ErrorNorm::L2 => primitive_form(partition, integrals)?,
        ErrorNorm::Derivative => derivative(),
        ErrorNorm::H1 { h } => {
            let scale = h / total;
            derivative() + primitive_form(partition, integrals)? * faer::Scale(scale * scale)
        }
    })
}

/// ‖∫₀^x (v − v̄)‖₀² as a form of the nodal values: Eᵀ E with E at Gauss points, exact for the quadratic primitive.
fn primitive_form(partition: &Partition, integrals: &[f64]) -> Result<Mat<f64>> {
    let rule = Rule::gauss_legendre(3)?;
    let (lengths, total) = (partition.lengths(), partition.total());
    let mut rows = Mat::<f64>::zeros(3 * lengths.len(), integrals.len());
    for (i, &h) in lengths.iter().enumerate() {
        for (p, (t, w)) in rule.iter().enumerate() {
            let weight = (h * w).sqrt();
            let fraction = (partition.from_left()[i] + h * t) / total;
            for (k, &integral) in integrals.iter().enumerate() {
                let left_half = if k > 0 { 0.5 * lengths[k - 1] } else { 0.0 };
                let primitive = match k {
                    _ if k < i => integral,
                    _ if k == i => left_half + h * t * (1.0 - 0.5 * t),
                    _ if k == i + 1 => 0.5 * h * t * t,
                    _ => 0.0,
                };
                rows[(3 * i + p, k)] = weight * (primitive - fraction * integral);
            }
        }
    }
    Ok(rows.transpose() * &rows)
}
