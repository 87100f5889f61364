//! Double integrals of polynomials and powers about one corner.
//!
//! The integrals are taken over the pairs with x farther from the corner than y, and doubled: with the weight
//! 2 (2|T|)² q τ^{1−2s} dτ dq, T the triangle, and the integrals over a and b of [`super::ring`]. For the
//! powers τ^{μ−1} the integral over τ is in closed form, 1/(2μ − 2s).

use super::basis::Polynomials;
use super::ring::{directions, nodes};
use super::shape::TriangleShape;
use crate::Order;
use crate::error::Result;
use crate::numeric::dense::times_transpose;
use crate::quadrature::Rule;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// ∫∫ (w(x)−w(y)) (v(x)−v(y)) |x−y|^{-2-2s} over the triangle.
pub(super) struct CornerGram {
    /// Entries of polynomials with polynomials, seen from this corner.
    pub(super) polynomials: DMatrix<f64>,
    /// Polynomials with τ^{μ−1} P_k(a).
    pub(super) mixed: DMatrix<f64>,
    /// Powers with powers.
    pub(super) powers: DMatrix<f64>,
}

/// (R(τ) − R(τq), R(τq)) at the points τ of a rule, as matrices of functions by points.
fn radials(set: Polynomials, rule: &Rule, epsilon: f64) -> Result<[DMatrix<f64>; 2]> {
    let shape = (set.index().len(), rule.points().len());
    let (mut differences, mut values) =
        (DMatrix::zeros(shape.0, shape.1), DMatrix::zeros(shape.0, shape.1));
    for (j, &tau) in rule.points().iter().enumerate() {
        differences.column_mut(j).copy_from_slice(&set.radial_differences(tau, epsilon)?);
        values.column_mut(j).copy_from_slice(&set.radials(tau * (1.0 - epsilon)));
    }
    Ok([differences, values])
}

/// The matrix of ∫ a_i b_j by the weights of the rule.
fn integrals(rule: &Rule, a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let weighted = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| rule.weights()[j] * a[(i, j)]);
    times_transpose(&weighted, b)
}

impl CornerGram {
    /// Polynomials of that degree and powers τ^{μ−1} P_k, k < `count`, seen from a corner; polynomials with
    /// polynomials only if requested.
    ///
    /// # Errors
    /// As the rules.
    pub(super) fn new(
        shape: &TriangleShape,
        apex: usize,
        order: Order,
        set: Polynomials,
        (exponent, count): (f64, usize),
        is_first: bool,
    ) -> Result<Self> {
        let angular: Vec<usize> = set.index().iter().map(|(k, _)| *k).collect();
        let (size, all) = (angular.len(), count.max(set.0 + 1));
        let power = 1.0 - 2.0 * order.value();
        let plain = Rule::gauss_jacobi(set.0 + 4, 0.0, power)?;
        let singular = Rule::gauss_jacobi(set.0 + 4, 0.0, power + exponent - 1.0)?;
        let over = 0.5 / (exponent - order.value());
        let part = |&(epsilon, weight): &(f64, f64)| -> Result<Self> {
            let ring = directions(shape, apex, order, all, epsilon)?;
            let factor = 2.0 * shape.twice() * shape.twice() * (1.0 - epsilon) * weight;
            let (aa, ad, dd) = (
                |i, j| ring[(i, j)],
                |i, j: usize| ring[(i, all + j)],
                |i: usize, j: usize| ring[(all + i, all + j)],
            );
            let polynomials = if is_first {
                let [u, v] = radials(set, &plain, epsilon)?;
                let [uu, uv, vv] =
                    [(&u, &u), (&u, &v), (&v, &v)].map(|(a, b)| integrals(&plain, a, b));
                DMatrix::from_fn(size, size, |i, j| {
                    let (k, l) = (angular[i], angular[j]);
                    let first = uu[(i, j)] * aa(k, l) + uv[(i, j)] * ad(k, l);
                    factor / shape.twice() * (first + uv[(j, i)] * ad(l, k) + vv[(i, j)] * dd(k, l))
                })
            } else {
                DMatrix::zeros(size, size)
            };
            let [u, v] = radials(set, &singular, epsilon)?.map(|values| -> Vec<f64> {
                let sum = |i| {
                    values.row(i).iter().zip(singular.weights()).map(|(value, w)| w * value).sum()
                };
                (0..size).map(sum).collect()
            });
            let there = (1.0 - epsilon).powf(exponent - 1.0);
            let change = -((exponent - 1.0) * (-epsilon).ln_1p()).exp_m1();
            let mixed = DMatrix::from_fn(size, count, |i, l| {
                let k = angular[i];
                let first = u[i] * (change * aa(k, l) + there * ad(k, l));
                factor / shape.twice().sqrt()
                    * (first + v[i] * (change * ad(l, k) + there * dd(k, l)))
            });
            let powers = DMatrix::from_fn(count, count, |k, l| {
                let cross = change * there * (ad(k, l) + ad(l, k));
                factor * over * (change * change * aa(k, l) + cross + there * there * dd(k, l))
            });
            Ok(Self { polynomials, mixed, powers })
        };
        let zero = || Ok(Self::zeros(size, count));
        nodes(order)?.par_iter().map(part).reduce(zero, |a, b| Ok(a?.plus(&b?)))
    }

    fn zeros(size: usize, count: usize) -> Self {
        let (polynomials, mixed) = (DMatrix::zeros(size, size), DMatrix::zeros(size, count));
        Self { polynomials, mixed, powers: DMatrix::zeros(count, count) }
    }

    fn plus(mut self, other: &Self) -> Self {
        self.polynomials += &other.polynomials;
        self.mixed += &other.mixed;
        self.powers += &other.powers;
        self
    }
}
