//! Extreme eigenvalues of A x = λ M x by the locally optimal block preconditioned conjugate
//! gradient method (LOBPCG; Knyazev 2001): each step minimises the Rayleigh quotient over the
//! block, its preconditioned residuals and the last directions.
//!
//! On very unequal elements the quotients of these directions differ by many orders of magnitude.
//! The smallest Ritz values of a positive definite form are therefore computed from its inverse,
//! after a scaling of all directions to energy 1: their errors are those of rounding relative to
//! themselves, not to the largest Ritz value (Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13
//! (1992) 1204-1245). Images are computed anew before a value is returned, which is then the
//! Rayleigh quotient of its vector.
//!
//! A residual of size r bounds the distance of θ_0 to the spectrum by r, and by r²/(σ − θ_0) if no
//! other eigenvalue lies below σ. Ritz values lie *above* the eigenvalues, by any amount for a
//! vector that the block has not found, so that they are no such σ: the eigenvalues below σ are
//! counted where the pencil can do so.

use super::dense::symmetric_eigen;
use super::sum::pairwise_dot;
use crate::error::Result;
use nalgebra::DMatrix;

/// Number of times eigenvalues are counted before the error is that of the residual alone.
const COUNTS: usize = 6;
/// Square of the relative size of a direction without its part in the block that is rounding.
const ROUNDED: f64 = 1e-26;
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
    /// Subtracts from x its component in the kernel of A, which is no part of the problem; true if
    /// there is such a kernel.
    fn without_kernel(&self, x: &mut [f64]) -> bool;
    /// The preconditioner applied to a residual.
    fn precondition(&self, r: &[f64]) -> Vec<f64>;
    /// True if the smallest eigenvalues are so well separated that gaps improve the bounds.
    fn is_separated(&self) -> bool;
    /// The number of positive eigenvalues below σ.
    ///
    /// # Errors
    /// Those of the matrix.
    fn counted_below(&self, sigma: f64) -> Result<Count>;
    /// The product M⁻¹ r.
    fn mass_inverse(&self, r: &[f64]) -> Vec<f64>;
    /// xᵀA x and a bound of its rounding error, from the product of x with A x.
    ///
    /// # Errors
    /// Those of a more accurate computation.
    fn form(&self, x: &[f64], product: f64) -> Result<(f64, f64)>;
}

/// The number of positive eigenvalues below a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Count {
    /// By the inertia of A − σ M.
    Exact(usize),
    /// An eigenvalue is so close to σ that rounding decides.
    Undecided,
    /// The matrix is too large to be factorized for a count.
    TooLarge,
}

/// σ − θ_0 as a share of the next Ritz value minus θ_0, where the eigenvalues below σ are counted.
pub(crate) const SHARES: [f64; 2] = [0.9, 0.5];

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

    /// The same vector with images that are not sums of others, and without what rounding left of
    /// the kernel.
    fn renewed(self, pencil: &impl Pencil) -> Result<Option<Self>> {
        let mut x = self.x;
        pencil.without_kernel(&mut x);
        Self::new(pencil, x)
    }

    /// A sum of vectors, in which large weights of both signs would leave a vector of the kernel.
    fn combined(pencil: &impl Pencil, basis: &[Self], weights: impl Fn(usize) -> f64) -> Self {
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
        // Elsewhere the three sums have the same rounding errors, and belong together.
        if pencil.without_kernel(&mut sum.x) {
            sum.m = pencil.mass(&sum.x);
        }
        sum
    }
}

/// The smallest eigenvalue of the pencil, a bound of its distance to the spectrum, and the number
/// of steps.
pub(crate) struct Smallest {
    pub(crate) value: f64,
    pub(crate) error: f64,
    pub(crate) steps: usize,
}

/// The smallest eigenvalue from a block of start vectors, when the error is below `tolerance` times
/// the value or the number of steps is reached.
///
/// The error is the smaller of ‖R_k‖ and, if eigenvalues are separated, ‖R_k‖²/(σ − θ_0 − ‖R_k‖),
/// where R_k are the residuals of the first k Ritz vectors in the norm of M⁻¹ and σ has k
/// eigenvalues below: there is an eigenvalue within ‖R_1‖. The rounding error of the quotient is
/// added. During the iteration, and where eigenvalues are not counted, σ is the next Ritz value
/// minus the size of its own residual.
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
    let (mut is_renewed, mut counts) = (false, 0);
    for steps in 0.. {
        let size = block.len();
        let mut basis = std::mem::take(&mut block);
        basis.append(&mut directions);
        let found = if pencil.is_separated() { ritz_of_inverse(&basis) } else { ritz(&basis) };
        let Some((values, vectors)) = found else { return Ok(None) };
        let kept = wanted.min(values.len());
        block = (0..kept).map(|j| Imaged::combined(pencil, &basis, |k| vectors[(k, j)])).collect();
        let new = |k: usize, j: usize| if k < size { 0.0 } else { vectors[(k, j)] };
        if basis.len() > size {
            directions =
                (0..kept).map(|j| Imaged::combined(pencil, &basis, |k| new(k, j))).collect();
        }
        let residual = |j: usize| -> Vec<f64> {
            block[j].a.iter().zip(&block[j].m).map(|(a, m)| a - values[j] * m).collect()
        };
        let mut residuals: Vec<Vec<f64>> = (0..kept).map(residual).collect();
        let squares: Vec<f64> =
            residuals.iter().map(|r| pairwise_dot(r, &pencil.mass_inverse(r)).max(0.0)).collect();
        // The error by gaps, for those k whose σ is known; by residuals alone without one.
        let bound = |sigma: &mut dyn FnMut(usize) -> Result<Option<f64>>| -> Result<f64> {
            let (mut error, mut sum) = (f64::INFINITY, 0.0);
            for (k, square) in squares.iter().enumerate() {
                sum += square;
                let size = f64::sqrt(sum);
                error = error.min(size);
                let gap = sigma(k)?.map_or(0.0, |sigma| sigma - values[0] - size);
                if gap > size {
                    error = error.min(sum / gap);
                }
            }
            Ok(error)
        };
        let by_ritz = |k: usize| {
            let own = squares.get(k + 1).copied()?;
            pencil.is_separated().then(|| values[k + 1] - own.sqrt())
        };
        let error = bound(&mut |k| Ok(by_ritz(k)))?;
        if error <= tolerance * values[0].abs() || steps >= most {
            if is_renewed {
                counts += 1;
                let first = &block[0];
                let product = pairwise_dot(&first.x, &first.a);
                let error = bound(&mut |k| {
                    let Some(next) = values.get(k + 1).filter(|_| pencil.is_separated()) else {
                        return Ok(None);
                    };
                    for share in SHARES {
                        let sigma = values[0] + share * (next - values[0]);
                        match pencil.counted_below(sigma)? {
                            Count::Exact(count) if count == k + 1 => return Ok(Some(sigma)),
                            Count::TooLarge => return Ok(by_ritz(k)),
                            Count::Exact(_) | Count::Undecided => {}
                        }
                    }
                    Ok(None)
                })?;
                if error <= tolerance * product.abs() || steps >= most || counts == COUNTS {
                    let (form, rounding) = pencil.form(&first.x, product)?;
                    let size = pairwise_dot(&first.x, &first.m);
                    let (value, error) = (form / size, error + rounding / size);
                    return Ok(Some(Smallest { value, error, steps }));
                }
            }
            if !is_renewed {
                let mut renewed = Vec::with_capacity(block.len());
                for one in block {
                    renewed.extend(one.renewed(pencil)?);
                }
                (block, is_renewed) = (renewed, true);
                directions.clear();
                continue;
            }
            // An eigenvector below σ is missing in the block: a vector with a share of all of them.
            let load: Vec<f64> = (0..block[0].x.len())
                .map(|i| ((1.7 * i as f64 + 0.9 * steps as f64).cos() + 0.3) * block[0].m[i].abs())
                .collect();
            residuals.push(load);
        }
        is_renewed = false;
        for r in &residuals {
            let mut direction = pencil.precondition(r);
            let before = pairwise_dot(&direction, &pencil.mass(&direction));
            for one in &block {
                let share = pairwise_dot(&direction, &one.m);
                direction.iter_mut().zip(&one.x).for_each(|(d, x)| *d -= share * x);
            }
            pencil.without_kernel(&mut direction);
            // What rounding leaves of a direction in the block is mostly a vector of the kernel.
            if pairwise_dot(&direction, &pencil.mass(&direction)) > ROUNDED * before {
                directions.extend(Imaged::new(pencil, direction)?);
            }
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

/// The Ritz values in ascending order and the coefficients of their vectors, which have norm 1 with
/// respect to M.
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
