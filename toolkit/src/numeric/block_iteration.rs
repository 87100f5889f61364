//! Extreme eigenvalues of A x = λ M x by the locally optimal block preconditioned conjugate gradient method (LOBPCG;
//! Knyazev 2001): each step minimises the Rayleigh quotient over the block, its preconditioned residuals and the last
//! directions.
//!
//! On very unequal elements the quotients of these directions differ by many orders of magnitude. The smallest Ritz values of a
//! positive definite form are therefore computed from its inverse, after a scaling of all directions to energy 1:
//! their errors are those of rounding relative to themselves, not to the largest Ritz value (Demmel & Veselić, SIAM J.
//! Matrix Anal. Appl. 13 (1992) 1204-1245). Images are computed anew before a value is accepted.

use super::dense::symmetric_eigen;
use super::sum::pairwise_dot;
use crate::error::Result;
use nalgebra::DMatrix;

/// Smallest relative size of an independent direction.
const DEPENDENT: f64 = 1e-11;

/// A pencil with an approximate inverse of A − λ M, up to a factor.
pub(crate) trait Pencil {
    /// The product A x, or −A x for the largest eigenvalues.
    ///
    /// # Errors
    /// Those of the product.
    fn apply(&self, x: &[f64]) -> Result<Vec<f64>>;
    /// The product M x.
    fn mass(&self, x: &[f64]) -> Vec<f64>;
    /// The preconditioner applied to a residual.
    fn precondition(&self, r: &[f64]) -> Vec<f64>;
    /// True if the smallest eigenvalues are so well separated that the Ritz values give their gaps.
    fn is_separated(&self) -> bool;
    /// The product M⁻¹ r.
    fn mass_inverse(&self, r: &[f64]) -> Vec<f64>;
    /// A bound of the rounding error of xᵀA x.
    fn rounding(&self, x: &[f64]) -> f64;
}

/// A vector with its images under A and M.
#[derive(Clone)]
struct Imaged {
    x: Vec<f64>,
    a: Vec<f64>,
    m: Vec<f64>,
}

impl Imaged {
    fn new(pencil: &impl Pencil, mut x: Vec<f64>) -> Result<Option<Self>> {
        let m = pencil.mass(&x);
        let size = pairwise_dot(&x, &m).sqrt();
        if !(size > 0.0 && size.is_finite()) {
            return Ok(None);
        }
        x.iter_mut().for_each(|x| *x /= size);
        Ok(Some(Self { a: pencil.apply(&x)?, m: m.iter().map(|m| m / size).collect(), x }))
    }

    /// The same vector with images that are not sums of others.
    fn renewed(self, pencil: &impl Pencil) -> Result<Option<Self>> {
        Self::new(pencil, self.x)
    }

    fn combined(basis: &[Self], weights: impl Fn(usize) -> f64) -> Self {
        let n = basis[0].x.len();
        let mut sum = Self { x: vec![0.0; n], a: vec![0.0; n], m: vec![0.0; n] };
        for (k, one) in basis.iter().enumerate() {
            let weight = weights(k);
            for i in 0..n {
                sum.x[i] += weight * one.x[i];
                sum.a[i] += weight * one.a[i];
                sum.m[i] += weight * one.m[i];
            }
        }
        sum
    }
}

/// The smallest eigenvalue of the pencil, a bound of its distance to the spectrum, and the number of steps.
pub(crate) struct Smallest {
    pub(crate) value: f64,
    pub(crate) error: f64,
    pub(crate) steps: usize,
}

/// The smallest eigenvalue from a block of start vectors, when the error is below `tolerance` times the value
/// or the number of steps is reached.
///
/// The error is the smaller of ‖R_k‖ and, if eigenvalues are separated, ‖R_k‖²/(θ_k − θ_0 − ‖R_k‖), where R_k are the
/// residuals of the first k Ritz vectors in the norm of M⁻¹ and θ_j the Ritz values: there is an eigenvalue within
/// ‖R_1‖. The rounding error of the quotient is added.
pub(crate) fn smallest(
    pencil: &impl Pencil,
    start: Vec<Vec<f64>>,
    tolerance: f64,
    most: usize,
) -> Result<Option<Smallest>> {
    let wanted = start.len();
    let mut block = Vec::new();
    for x in start {
        block.extend(Imaged::new(pencil, x)?);
    }
    let mut directions: Vec<Imaged> = Vec::new();
    let mut is_renewed = false;
    for steps in 0.. {
        let size = block.len();
        let mut basis = std::mem::take(&mut block);
        basis.append(&mut directions);
        let found = if pencil.is_separated() { ritz_of_inverse(&basis) } else { ritz(&basis) };
        let Some((values, vectors)) = found else { return Ok(None) };
        let kept = wanted.min(values.len());
        block = (0..kept).map(|j| Imaged::combined(&basis, |k| vectors[(k, j)])).collect();
        let new = |k: usize, j: usize| if k < size { 0.0 } else { vectors[(k, j)] };
        if basis.len() > size {
            directions = (0..kept).map(|j| Imaged::combined(&basis, |k| new(k, j))).collect();
        }
        let residual = |j: usize| -> Vec<f64> {
            block[j].a.iter().zip(&block[j].m).map(|(a, m)| a - values[j] * m).collect()
        };
        let residuals: Vec<Vec<f64>> = (0..kept).map(residual).collect();
        let (mut error, mut squares) = (f64::INFINITY, 0.0);
        for (k, r) in residuals.iter().enumerate() {
            squares += pairwise_dot(r, &pencil.mass_inverse(r)).max(0.0);
            let size = f64::sqrt(squares);
            let gap = values.get(k + 1).map_or(0.0, |next| next - values[0] - size);
            error = f64::min(
                error,
                if pencil.is_separated() && gap > size { squares / gap } else { size },
            );
        }
        if error <= tolerance * values[0].abs() || steps == most {
            if is_renewed || steps == most {
                let error = error + pencil.rounding(&block[0].x);
                return Ok(Some(Smallest { value: values[0], error, steps }));
            }
            let mut renewed = Vec::with_capacity(block.len());
            for one in block {
                renewed.extend(one.renewed(pencil)?);
            }
            (block, is_renewed) = (renewed, true);
            directions.clear();
            continue;
        }
        is_renewed = false;
        for r in &residuals {
            let mut direction = pencil.precondition(r);
            for one in &block {
                let share = pairwise_dot(&direction, &one.m);
                direction.iter_mut().zip(&one.x).for_each(|(d, x)| *d -= share * x);
            }
            directions.extend(Imaged::new(pencil, direction)?);
        }
        directions.retain_mut(|one| {
            let size = pairwise_dot(&one.x, &one.m).sqrt();
            let usable = size > 0.0 && size.is_finite();
            if usable {
                one.x.iter_mut().chain(&mut one.a).chain(&mut one.m).for_each(|x| *x /= size);
            }
            usable
        });
    }
    Ok(None)
}

/// The Ritz values in ascending order and the coefficients of their vectors, which have norm 1 with respect to
/// M.
fn ritz(basis: &[Imaged]) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let n = basis.len();
    let (a, m) = (products(basis, |one| &one.a), products(basis, |one| &one.m));
    let (sizes, vectors) = symmetric_eigen(&m)?;
    let largest = sizes.last().copied()?;
    let kept: Vec<usize> = (0..n).filter(|&k| sizes[k] > DEPENDENT * largest).collect();
    let reduce =
        DMatrix::from_fn(n, kept.len(), |i, k| vectors[(i, kept[k])] / sizes[kept[k]].sqrt());
    let (values, inner) = symmetric_eigen(&(reduce.transpose() * a * &reduce))?;
    Some((values, reduce * inner))
}

/// The same for a positive definite A, from the largest eigenvalues of M x = λ⁻¹ A x.
fn ritz_of_inverse(basis: &[Imaged]) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let n = basis.len();
    let (a, m) = (products(basis, |one| &one.a), products(basis, |one| &one.m));
    let units: Vec<f64> = (0..n).map(|i| a[(i, i)].max(0.0).sqrt().recip()).collect();
    if units.iter().any(|unit| !unit.is_finite()) {
        return ritz(basis);
    }
    let scaled =
        |of: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| units[i] * of[(i, j)] * units[j]);
    let (sizes, vectors) = symmetric_eigen(&scaled(&a))?;
    let largest = sizes.last().copied()?;
    let kept: Vec<usize> = (0..n).filter(|&k| sizes[k] > DEPENDENT * largest).collect();
    let reduce =
        DMatrix::from_fn(n, kept.len(), |i, k| vectors[(i, kept[k])] / sizes[kept[k]].sqrt());
    let (inverses, inner) = symmetric_eigen(&(reduce.transpose() * scaled(&m) * &reduce))?;
    let positive: Vec<usize> = (0..inverses.len()).rev().filter(|&k| inverses[k] > 0.0).collect();
    let values = positive.iter().map(|&k| inverses[k].recip()).collect();
    let unscaled = DMatrix::from_fn(n, kept.len(), |i, k| units[i] * reduce[(i, k)]);
    let all = unscaled * inner;
    let vectors = DMatrix::from_fn(n, positive.len(), |i, k| {
        all[(i, positive[k])] / inverses[positive[k]].sqrt()
    });
    Some((values, vectors))
}

/// The symmetric matrix of the products of a basis with its images.
fn products(basis: &[Imaged], of: fn(&Imaged) -> &Vec<f64>) -> DMatrix<f64> {
    let n = basis.len();
    let raw = DMatrix::from_fn(n, n, |i, j| pairwise_dot(&basis[i].x, of(&basis[j])));
    (&raw + raw.transpose()) * 0.5
}
