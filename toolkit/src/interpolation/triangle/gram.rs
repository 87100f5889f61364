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

/// One rule in τ with the radial functions and their differences.
struct Radial {
    points: Vec<(f64, f64)>,
}

impl Radial {
    fn new(count: usize, power: f64) -> Result<Self> {
        Ok(Self { points: Rule::gauss_jacobi(count, 0.0, power)?.iter().collect() })
    }

    /// (R(τ) − R(τq), R(τq)) as matrices of functions by points.
    fn at(&self, set: Polynomials, epsilon: f64) -> Result<[DMatrix<f64>; 2]> {
        let size = set.index().len();
        let (mut differences, mut values) =
            (DMatrix::zeros(size, self.points.len()), DMatrix::zeros(size, self.points.len()));
        for (j, (tau, _)) in self.points.iter().enumerate() {
            let (difference, value) =
                (set.radial_differences(*tau, epsilon)?, set.radials(tau * (1.0 - epsilon)));
            for i in 0..size {
                differences[(i, j)] = difference[i];
                values[(i, j)] = value[i];
            }
        }
        Ok([differences, values])
    }

    fn product(&self, a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
        let weighted = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| self.points[j].1 * a[(i, j)]);
        times_transpose(&weighted, b)
    }

    fn sums(&self, a: &DMatrix<f64>) -> Vec<f64> {
        (0..a.nrows()).map(|i| (0..a.ncols()).map(|j| self.points[j].1 * a[(i, j)]).sum()).collect()
    }
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
        let plain = Radial::new(set.0 + 4, power)?;
        let singular = Radial::new(set.0 + 4, power + exponent - 1.0)?;
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
                let [u, v] = plain.at(set, epsilon)?;
                let (uu, uv, vv) = (plain.product(&u, &u), plain.product(&u, &v), plain.product(&v, &v));
                DMatrix::from_fn(size, size, |i, j| {
                    let (k, l) = (angular[i], angular[j]);
                    let first = uu[(i, j)] * aa(k, l) + uv[(i, j)] * ad(k, l);
                    factor / shape.twice() * (first + uv[(j, i)] * ad(l, k) + vv[(i, j)] * dd(k, l))
                })
            } else {
                DMatrix::zeros(size, size)
            };
            let [u, v] = singular.at(set, epsilon)?;
            let (u, v) = (singular.sums(&u), singular.sums(&v));
            let there = (1.0 - epsilon).powf(exponent - 1.0);
            let change = -((exponent - 1.0) * (-epsilon).ln_1p()).exp_m1();
            let mixed = DMatrix::from_fn(size, count, |i, l| {
                let k = angular[i];
                let first = u[i] * (change * aa(k, l) + there * ad(k, l));
                factor / shape.twice().sqrt() * (first + v[i] * (change * ad(l, k) + there * dd(k, l)))
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
