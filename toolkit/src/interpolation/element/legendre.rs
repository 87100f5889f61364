//! Polynomials on one element in the Legendre basis: the Gram matrices of |·|_ν and of the primitives.
//!
//! φ_k(x) = √(2k+1) P_k(2x−1), orthonormal in L²(0,1). With x = y + r and y = (1−r)s,
//! a(φ_j, φ_k) = 2 ∫₀¹ r^{1-2ν} (1−r) ∫₀¹ q_j q_k ds dr,  q_k = (φ_k(y+r) − φ_k(y))/r,
//! and q_k is a polynomial: Gauss-Jacobi rules in r and Gauss-Legendre rules in s are exact. The quotients are
//! computed from the three-term recurrence itself, (k+1) Q_{k+1} = (2k+1)(x Q_k + P_k(y)) − k Q_{k−1}, Q_k =
//! (P_k(x) − P_k(y))/(x − y), without cancellation. Domain 0 < ν < 1. Cost: O(d²) points, O(d² K²) operations
//! for K functions of degree at most d.

use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::dense::transpose_times;
use crate::numeric::legendre;
use crate::quadrature::Rule;
use nalgebra::DMatrix;

/// The Gram matrix of |·|_ν on (0, 1) for the φ_k of the given degrees (increasing, none of them zero), and its
/// cost.
pub(in crate::interpolation) fn seminorm_gram(
    order: Order,
    degrees: &[usize],
) -> Result<(DMatrix<f64>, Work)> {
    let top = degrees.last().copied().unwrap_or(1);
    let outer = Rule::gauss_jacobi(top, 1.0, order.one_minus_twice())?;
    let inner = Rule::gauss_legendre(top)?;
    let mut quotients = DMatrix::<f64>::zeros(top * top, degrees.len());
    let (mut values, mut all) = (vec![0.0; top + 1], vec![0.0; top + 1]);
    let mut row = 0;
    for (r, w) in outer.iter() {
        for (s, v) in inner.iter() {
            let y = (1.0 - r) * s;
            let weight = (2.0 * w * v).sqrt();
            let [from, to] = [2.0 * y - 1.0, 2.0 * (y + r) - 1.0];
            legendre::fill_with_quotients(&mut values, &mut all, from, to);
            for (column, &k) in degrees.iter().enumerate() {
                // The factor 2 is d(2x − 1)/dx.
                quotients[(row, column)] = 2.0 * (weight * (2.0 * k as f64 + 1.0).sqrt() * all[k]);
            }
            row += 1;
        }
    }
    Ok((
        transpose_times(&quotients, &quotients),
        Work { points: (top * top) as u64, pairs: 1, ..Work::default() },
    ))
}

/// The Gram matrix of L² for the primitives ∫₀^x φ_k, which vanish at both ends, since no degree is zero.
///
/// ∫₀^x φ_k = [φ_{k+1}/√(2k+3) − φ_{k−1}/√(2k−1)] / (2√(2k+1)).
pub(super) fn primitive_gram(degrees: &[usize]) -> DMatrix<f64> {
    let part = |k: usize, m: usize| -> f64 {
        let size = 0.5 / ((2.0 * k as f64 + 1.0) * (2.0 * m as f64 + 1.0)).sqrt();
        if m == k + 1 {
            size
        } else if m + 1 == k {
            -size
        } else {
            0.0
        }
    };
    DMatrix::from_fn(degrees.len(), degrees.len(), |i, j| {
        let (k, l) = (degrees[i], degrees[j]);
        [k - 1, k + 1].into_iter().map(|m| part(k, m) * part(l, m)).sum()
    })
}

/// The sum Σ c_i φ_{k_i}(x) and its primitive from 0, x ∈ [0, 1].
pub(super) fn evaluate(degrees: &[usize], coefficients: &[f64], x: f64) -> (f64, f64) {
    let top = degrees.last().copied().unwrap_or(0);
    let t = 2.0 * x - 1.0;
    let mut legendre = vec![0.0; top + 2];
    legendre::fill(&mut legendre, t);
    degrees.iter().zip(coefficients).fold((0.0, 0.0), |(value, primitive), (&k, &c)| {
        let root = (2.0 * k as f64 + 1.0).sqrt();
        (
            value + c * root * legendre[k],
            primitive + c * 0.5 / root * (legendre[k + 1] - legendre[k - 1]),
        )
    })
}

/// The Gram matrix of ‖v'‖₀² for degrees of one parity: 2 √((2j+1)(2k+1)) m(m+1), m = min(j, k).
pub(in crate::interpolation) fn stiffness_gram(degrees: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(degrees.len(), degrees.len(), |i, j| {
        let [k, l, m] = [degrees[i], degrees[j], degrees[i.min(j)]].map(|d| d as f64);
        2.0 * ((2.0 * k + 1.0) * (2.0 * l + 1.0)).sqrt() * m * (m + 1.0)
    })
}

/// The degrees 1, 3, ..., 2·count − 1.
pub(in crate::interpolation) fn odd_degrees(count: usize) -> Vec<usize> {
    (0..count).map(|k| 2 * k + 1).collect()
}

/// Successive numbers of functions.
const COUNTS: [usize; 5] = [4, 8, 16, 32, 64];

/// Doubling the count divides the error by 2^{5.6} = 48; half of that is assumed.
const GAIN_OF_DOUBLING: f64 = 24.0;

/// Relative rounding error of an extremal quotient, which grows with the number of functions.
const ROUNDING_PER_FUNCTION: f64 = 4.0 * f64::EPSILON;

/// The value for a number of functions that is doubled until the value, which increases with it, meets the
/// tolerance.
pub(in crate::interpolation) fn converge(
    what: &'static str,
    tolerance: Tolerance,
    mut value_of: impl FnMut(usize) -> Result<(f64, Work)>,
) -> Result<Estimate> {
    let mut work = Work::default();
    let mut coarse: Option<f64> = None;
    let mut best: Option<Estimate> = None;
    for count in COUNTS {
        let (value, cost) = value_of(count)?;
        work += cost + Work { iterations: 1, ..Work::default() };
        if let Some(previous) = coarse {
            let truncation = (value - previous).abs() / GAIN_OF_DOUBLING;
            let rounding = ROUNDING_PER_FUNCTION * count as f64 * value;
            let estimate = Estimate::new(value, truncation + rounding, work)?;
            if estimate.relative_error() <= tolerance.relative() {
                return Ok(estimate);
            }
            if best.is_none_or(|best| estimate.relative_error() < best.relative_error()) {
                best = Some(estimate);
            }
        }
        coarse = Some(value);
    }
    let why = "rounding, which grows with the number of polynomials, limits the accuracy";
    Err(Error::best_of(what, tolerance.relative(), best, why))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn low_degrees_have_their_closed_forms() {
        // |x|²_ν on (0,1) = 2/((2−2ν)(3−2ν)); φ_1 = √3 (2x−1).
        for nu in [1e-6, 0.3, 0.5, 0.7, 1.0 - 1e-6] {
            let order = Order::new(nu).unwrap();
            let (gram, _) = seminorm_gram(order, &[1, 2, 3]).unwrap();
            let exact = 12.0 / ((1.0 - nu) * (3.0 - 2.0 * nu));
            assert!((gram[(0, 0)] / exact - 1.0).abs() < 1e-14, "{nu}: {} {exact}", gram[(0, 0)]);
            // opposite parities are orthogonal
            assert!(
                gram[(0, 1)].abs() < 1e-13 * exact && gram[(1, 2)].abs() < 1e-13 * gram[(2, 2)]
            );
        }
    }

    #[test]
    fn legendre_polynomials_are_eigenfunctions_in_the_limit_zero() {
        // ν → 0: eigenvalues 4 H_k of the form with 1/|x−y|.
        let (gram, _) = seminorm_gram(Order::new(1e-12).unwrap(), &[1, 2, 3, 4, 5]).unwrap();
        let mut harmonic = 0.0;
        for k in 0..5 {
            harmonic += 1.0 / (k as f64 + 1.0);
            assert!((gram[(k, k)] / (4.0 * harmonic) - 1.0).abs() < 1e-10, "{k}: {}", gram[(k, k)]);
            for j in 0..k {
                assert!(gram[(j, k)].abs() < 1e-10, "{j} {k}: {}", gram[(j, k)]);
            }
        }
    }

    /// The slopes of Appendix A assemble the same form, where no cell touches both ends: φ_k′ = Σ 2 √(2k+1) (2j+1) P_j, the
    /// sum over j = k−1, k−3, ..., is expanded on four cells.
    #[test]
    fn slopes_on_four_cells_assemble_the_same_form() {
        use crate::poincare::slopes::{cell::Cell, gram, space::SlopeSpace};
        let (count, cells, length) = (8, 4, 0.25);
        let degrees: Vec<usize> = (1..=count).collect();
        let root = |m: usize| (2.0 * m as f64 + 1.0).sqrt();
        let polynomial = |m: usize, t: f64| {
            let mut values = vec![0.0; m + 1];
            crate::numeric::legendre::fill(&mut values, 2.0 * t - 1.0);
            values[m]
        };
        let slope = |k: usize, x: f64| -> f64 {
            let terms = (0..k).filter(|j| (k - j) % 2 == 1);
            terms.map(|j| 2.0 * root(k) * (2 * j + 1) as f64 * polynomial(j, x)).sum()
        };
        let rule = Rule::gauss_legendre(20).unwrap();
        let change = DMatrix::from_fn(cells * count, count, |row, column| {
            let (cell, m) = (row / count, row % count);
            let x = |t: f64| length * (cell as f64 + t);
            length * rule.integrate(|t| slope(column + 1, x(t)) * root(m) * polynomial(m, t))
        });
        let space = SlopeSpace::new(vec![Cell::uniform(length, count); cells], 1.0);
        for nu in [0.02, 0.3, 0.5, 0.8] {
            let order = Order::new(nu).unwrap();
            let (exact, _) = seminorm_gram(order, &degrees).unwrap();
            let (slopes, _) = gram::seminorm_gram(&space, None, order, 20).unwrap();
            let found = change.transpose() * slopes * &change;
            for (a, b) in found.iter().zip(exact.iter()) {
                let apart = (a - b).abs() / exact[(count - 1, count - 1)];
                assert!(apart < 2e-12, "{nu}: {a} {b}");
            }
        }
    }

    #[test]
    fn primitives_vanish_at_both_ends_and_have_their_gram_matrix() {
        let degrees = [1, 2, 4];
        let coefficients = [0.3, -1.0, 0.7];
        assert!(evaluate(&degrees, &coefficients, 0.0).1.abs() < 1e-15);
        assert!(evaluate(&degrees, &coefficients, 1.0).1.abs() < 1e-15);
        let gram = primitive_gram(&degrees);
        let form: f64 = (0..3)
            .flat_map(|i| (0..3).map(move |j| (i, j)))
            .map(|(i, j)| coefficients[i] * coefficients[j] * gram[(i, j)])
            .sum();
        let rule = Rule::gauss_legendre(8).unwrap();
        let direct = rule.integrate(|x| evaluate(&degrees, &coefficients, x).1.powi(2));
        assert!((form / direct - 1.0).abs() < 1e-14);
    }
}
