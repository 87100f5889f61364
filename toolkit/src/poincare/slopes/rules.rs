//! Gauss rules for the weights that arise at the diagonal of the kernel: t^{p+k} and t^k (1 − t^p)/p, k = 0, 1.
//!
//! The second weight is positive for either sign of p and becomes −t^k ln t at p = 0. Because (1 − t^p)/p =
//! ∫_t^1 τ^{p−1} dτ, its integrals are ∫₀¹ τ^{p+k} ∫₀¹ κ^k f(τκ) dκ dτ: the product of a Gauss-Jacobi and a
//! Gauss-Legendre rule with n + 1 points each is exact for polynomials of degree 2n. The n-point rule is
//! obtained from that product rule by the Stieltjes procedure.

use crate::error::{Error, Result};
use crate::numeric::dense::symmetric_eigen;
use crate::quadrature::Rule;
use nalgebra::DMatrix;

/// Points and weights, as pairs.
pub(crate) type Pairs = Vec<(f64, f64)>;

/// All one-dimensional rules of the assembly.
#[derive(Debug, Clone)]
pub(crate) struct Rules {
    /// Weight 1.
    pub(crate) plain: Pairs,
    /// Weight t^{p+k}, k = 0, 1.
    pub(crate) power: [Pairs; 2],
    /// Weight t^k (1 − t^p)/p, k = 0, 1.
    pub(crate) logarithm: [Pairs; 2],
}

impl Rules {
    /// The n-point rules for the exponent p = 1 − 2ν > −1.
    pub(crate) fn new(n: usize, p: f64) -> Result<Self> {
        let power =
            |k: f64| -> Result<Pairs> { Ok(Rule::gauss_jacobi(n, 0.0, p + k)?.iter().collect()) };
        Ok(Self {
            plain: Rule::gauss_legendre(n)?.iter().collect(),
            power: [power(0.0)?, power(1.0)?],
            logarithm: [logarithmic(n, p, 0)?, logarithmic(n, p, 1)?],
        })
    }
}

fn logarithmic(n: usize, p: f64, k: i32) -> Result<Pairs> {
    let outer = Rule::gauss_jacobi(n + 1, 0.0, p + f64::from(k))?;
    let inner = Rule::gauss_legendre(n + 1)?;
    let product: Pairs = outer
        .iter()
        .flat_map(|(t, w)| inner.iter().map(move |(s, v)| (t * s, w * v * s.powi(k))))
        .collect();
    gauss_of_discrete(n, &product)
}

/// The n-point Gauss rule of a discrete positive measure with more than n points (Stieltjes; Golub & Welsch).
fn gauss_of_discrete(n: usize, measure: &[(f64, f64)]) -> Result<Pairs> {
    let mass: f64 = measure.iter().map(|&(_, w)| w).sum();
    let mut previous = vec![0.0; measure.len()];
    let mut current = vec![1.0 / mass.sqrt(); measure.len()];
    let mut jacobi = DMatrix::<f64>::zeros(n, n);
    let mut below = 0.0;
    for k in 0..n {
        let moment = |f: &dyn Fn(usize) -> f64| -> f64 {
            measure.iter().enumerate().map(|(i, &(_, w))| w * f(i)).sum()
        };
        let diagonal = moment(&|i| measure[i].0 * current[i] * current[i]);
        jacobi[(k, k)] = diagonal;
        let mut next: Vec<f64> = (0..measure.len())
            .map(|i| (measure[i].0 - diagonal) * current[i] - below * previous[i])
            .collect();
        let norm = moment(&|i| next[i] * next[i]).sqrt();
        next.iter_mut().for_each(|value| *value /= norm);
        if k + 1 < n {
            jacobi[(k, k + 1)] = norm;
            jacobi[(k + 1, k)] = norm;
        }
        below = norm;
        previous = std::mem::replace(&mut current, next);
    }
    let (points, vectors) = symmetric_eigen(&jacobi).ok_or(Error::NotFinite {
        name: "Jacobi matrix",
        index: 0,
        value: mass,
    })?;
    Ok(points.into_iter().enumerate().map(|(j, t)| (t, mass * vectors[(0, j)].powi(2))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding error of the Stieltjes procedure and of the eigenvectors, n <= 16.
    const MOMENT_TOLERANCE: f64 = 1e-12;

    #[test]
    fn moments_of_the_logarithmic_weight_are_rational() {
        for n in [4, 9, 16] {
            for p in [0.98, 0.5, 1e-7, 0.0, -1e-7, -0.5, -0.98, -0.998] {
                let rules = Rules::new(n, p).unwrap();
                for k in 0..2 {
                    for degree in 0..2 * n - 1 {
                        let moment: f64 = rules.logarithm[k]
                            .iter()
                            .map(|&(t, w)| w * t.powi(degree as i32))
                            .sum();
                        let j = (degree + k + 1) as f64;
                        let exact = 1.0 / (j * (j + p));
                        assert!(
                            (moment / exact - 1.0).abs() < MOMENT_TOLERANCE,
                            "n {n} p {p} k {k} degree {degree}: {moment} against {exact}"
                        );
                    }
                }
            }
        }
    }
}
