//! Means of homogeneous integrands over pairs of simplices: every common corner reduces the dimension by one.
//!
//! Let F(x, y) be homogeneous of degree p about a corner that σ and σ' share, d and d' their dimensions, φ
//! and φ' the faces opposite that corner. Euler's identity and the divergence theorem in d + d' dimensions
//! give, with m(·,·) the mean of F,
//!
//! (p + d + d') m(σ, σ') = d m(φ, σ') + d' m(σ, φ').
//!
//! F = (w(x)−w(y))² |x−y|^{-2-2s} has p = −2s for a continuous piecewise linear w and p = −2 − 2s for a
//! piecewise constant one, about *every* common corner. So
//! - one triangle: m(T, T) = 8 / ((4−2s)(3−2s)(2−2s)) Σ_P m(P, edge opposite P), three integrals on segments;
//! - a common edge PQ: integrals point-triangle and segment-segment over pieces that do not touch;
//! - a common corner: integrals segment-triangle over pieces that do not touch.
//!
//! All factors are positive: there is no cancellation. Simplices that do not touch are integrated by
//! [`super::leaves`]; for a point and a segment, Gauss rules in θ are used, where the distance along the
//! segment from the foot of the perpendicular through the point is the length of the perpendicular times sinh
//! θ: exact to rounding for every sliver.

use super::geometry::{dot, length, minus, product_difference, twice_area};
use super::leaves::{LEVELS, Leaves, Levels, add_square};
use super::simplex::Simplex;
use crate::error::Result;
use crate::numeric::scale::power_of_two;
use crate::order::Order;
use crate::quadrature::Rule;

/// The integrand: differences of linear functions, or of constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    Constants,
    Linears,
}

/// Width of a cell in θ and points on it: cosh has its zeros at iπ/2, ρ = π + √(1+π²), ρ^{-22} < 1e-16.
const CELL: f64 = 1.0;
const CELL_POINTS: usize = 12;

/// The integrals for one order, one shape and one accuracy.
#[derive(Debug)]
pub(super) struct Means {
    order: Order,
    shape: Shape,
    leaves: Leaves,
}

impl Means {
    /// The integrals with at most this many kernel evaluations.
    pub(super) fn new(order: Order, shape: Shape, accuracy: f64, evaluations: u64) -> Self {
        Self { order, shape, leaves: Leaves::new(order.value(), accuracy, evaluations) }
    }

    /// The sum p + k, without cancellation.
    fn degree_plus(&self, k: usize) -> f64 {
        match self.shape {
            Shape::Constants if k == 3 => self.order.one_minus_twice(),
            Shape::Constants => k as f64 - 4.0 + 2.0 * self.order.complement(),
            Shape::Linears => k as f64 - 2.0 + 2.0 * self.order.complement(),
        }
    }

    /// `weight` times the mean of the products of differences over two simplices; the evaluations are counted
    /// in `work`.
    ///
    /// # Errors
    /// As [`Leaves::mean`].
    pub(super) fn mean<const K: usize>(
        &self,
        a: &Simplex<K>,
        b: &Simplex<K>,
        weight: [f64; 2],
        work: &mut u64,
    ) -> Result<Levels<K>> {
        let (d, e) = (a.dimension(), b.dimension());
        let Some((i, j)) = a.shared(b) else {
            return match (d, e) {
                (0, 1) => self.point_and_segment(a, b, weight, work),
                (1, 0) => self.point_and_segment(b, a, weight, work),
                _ => self.leaves.mean(a, b, weight, work),
            };
        };
        let over = 1.0 / self.degree_plus(d + e);
        let mut sum = [[[0.0; K]; K]; LEVELS];
        let faces = [(d, a.face(i), *b), (e, *a, b.face(j))];
        for (dimension, a, b) in faces {
            if dimension > 0 {
                let factor = dimension as f64 * over;
                add(&mut sum, &self.mean(&a, &b, weight, work)?, factor);
            }
        }
        Ok(sum)
    }

    /// The mean over a point A and a segment BC, with u = h sinh θ along the segment.
    fn point_and_segment<const K: usize>(
        &self,
        point: &Simplex<K>,
        segment: &Simplex<K>,
        weight: [f64; 2],
        work: &mut u64,
    ) -> Result<Levels<K>> {
        let (a, b, c) = (point.corners()[0], segment.corners()[0], segment.corners()[1]);
        let along = minus(c.at, b.at);
        let size = length(along);
        let height = twice_area(a.at, b.at, c.at).abs() / size;
        let start = dot(minus(b.at, a.at), along) / size;
        let end = dot(minus(c.at, a.at), along) / size;
        let (from, to) = ((start / height).asinh(), (end / height).asinh());
        let cells = ((to - from) / CELL).ceil().max(1.0);
        let (width, rule) = ((to - from) / cells, Rule::gauss_legendre(CELL_POINTS)?);
        let unit = power_of_two(height);
        let s = self.order.value();
        let half = |w: f64| w / unit * unit.powf(-s);
        let factor = half(weight[0])
            * half(weight[1])
            * (height / size)
            * (height / unit).powf(-2.0 - 2.0 * s);
        // w − w(A) is a linear function of u: its value at the foot, and its slope.
        let ends: [[f64; 2]; K] =
            std::array::from_fn(|k| [b.values[k] - a.values[k], c.values[k] - a.values[k]]);
        let at_foot = ends.map(|[first, last]| product_difference(first, end, last, start) / size);
        let slopes: [f64; K] = std::array::from_fn(|k| (c.values[k] - b.values[k]) / size);
        let mut entries = [[0.0; K]; K];
        for cell in 0..cells as usize {
            for (t, w) in rule.iter() {
                let theta = from + (cell as f64 + t) * width;
                let u = height * theta.sinh();
                let kernel = factor * w * width * theta.cosh().powf(-1.0 - 2.0 * s);
                let difference: [f64; K] =
                    std::array::from_fn(|k| slopes[k].mul_add(u, at_foot[k]));
                add_square(&mut entries, kernel, difference);
            }
        }
        *work += CELL_POINTS as u64 * cells as u64;
        Ok([entries; LEVELS])
    }
}

fn add<const K: usize>(sum: &mut Levels<K>, other: &Levels<K>, factor: f64) {
    for (sum, other) in sum.iter_mut().flatten().flatten().zip(other.iter().flatten().flatten()) {
        *sum += factor * other;
    }
}
