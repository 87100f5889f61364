//! Triangles seen from one of their corners.

use super::piece::{Piece, View};
use super::radial::Points;
use crate::plane::geometry::{Point, distance_from_segment, length, minus, product_difference};

/// Largest ratio of the length of a piece of an edge to its distance from P.
const LONGEST: f64 = 1.1;

/// A triangle seen from its corner P, in units of length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side<'a> {
    view: &'a View<'a>,
    piece: &'a Piece,
    origin: Point,
    unit: f64,
    pub(super) from: Point,
    pub(super) along: Point,
}

impl<'a> Side<'a> {
    /// The sides of a piece seen from its corner `vertex`, whose opposite edge is divided if it is long,
    /// beginning with the corner `first`.
    pub(super) fn of(
        view: &'a View<'a>,
        piece: &'a Piece,
        vertex: usize,
        first: usize,
        unit: f64,
    ) -> Vec<Self> {
        let origin = piece.at[vertex];
        let from_origin = |k: usize| minus(piece.at[k], origin).map(|x| x / unit);
        let mut open = vec![[from_origin(first), from_origin(3 - vertex - first)]];
        let mut sides = Vec::new();
        while let Some([a, b]) = open.pop() {
            let along = minus(b, a);
            if length(along) <= LONGEST * distance_from_segment([0.0; 2], a, b) {
                sides.push(Self { view, piece, origin, unit, from: a, along });
            } else {
                let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
                open.extend([[middle, b], [a, middle]]);
            }
        }
        sides
    }

    /// The radial integral of the difference to another side, at t, t' and τ.
    pub(super) fn radial(&self, other: &Self, rule: &Points, [t, r, tau]: [f64; 3]) -> f64 {
        let square = |&(rho, weight): &(f64, f64)| {
            let difference = self.value(rho, t) - other.value(rho * tau, r);
            weight * difference * difference
        };
        rule.iter().map(square).sum()
    }

    /// The radial integral of the square of the function, at t.
    pub(super) fn radial_square(&self, rule: &Points, t: f64) -> f64 {
        rule.iter().map(|(rho, weight)| weight * self.value(*rho, t).powi(2)).sum()
    }

    /// The side with the direction of its edge reversed.
    pub(super) fn turned(self) -> Self {
        Self { from: self.edge(1.0), along: self.along.map(|x| -x), ..self }
    }

    pub(super) fn edge(&self, t: f64) -> Point {
        [self.from[0] + t * self.along[0], self.from[1] + t * self.along[1]]
    }

    pub(super) fn twice_area(&self) -> f64 {
        product_difference(self.from[0], self.along[1], self.from[1], self.along[0]).abs()
    }

    /// The value of w at P + ρ e(t).
    #[inline]
    pub(super) fn value(&self, rho: f64, t: f64) -> f64 {
        let (edge, scale) = (self.edge(t), rho * self.unit);
        self.view
            .value(self.piece, [self.origin[0] + scale * edge[0], self.origin[1] + scale * edge[1]])
    }
}
