//! Pairs of pieces that do not touch, and the L² norm, by rules on single pieces.
//!
//! A piece longer than twice its distance is subdivided first. On a piece at a declared corner, x = ρ e(t),
//! cells of ln ρ extend to where r^{2a+2} and r² are negligible; t is divided into parts of the edge no longer
//! than their distance from the corner.

use super::piece::{Piece, View};
use super::radial::{self, Approach, Points};
use crate::error::Result;
use crate::numeric::scale::power_of_two;
use crate::plane::geometry::{Point, distance_from_segment, length, minus, product_difference};
use crate::plane::kernel::InversePower;
use crate::plane::leaves::{points, too_near};
use crate::quadrature::Rule;

/// Smallest ratio of distance to length of an admissible piece.
const ADMISSIBLE: f64 = 0.5;
/// Largest ratio of the length of a part of an edge to its distance from the corner.
const LONGEST: f64 = 1.1;
/// Largest number of pieces into which one pair is subdivided.
const PATIENCE: usize = 20_000;

/// A point relative to the base of its piece, the square root of a weight for the area, and the function
/// multiplied by that root: r^a may be so large that its square overflows.
type Placed = (Point, f64, f64);

/// Parameters of integrals over pieces.
pub(super) struct Apart<'a> {
    pub(super) view: &'a View<'a>,
    pub(super) kernel: &'a InversePower,
    /// 1 + s
    pub(super) power: f64,
    pub(super) points: usize,
    /// ln of the relative size of the part omitted next to a corner.
    pub(super) digits: f64,
}

impl Apart<'_> {
    /// ∫∫ (w(x)−w(y))² |x−y|^{-2-2s} over x in a and y in b, in units.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) if the two pieces touch or are too close to each other.
    pub(super) fn pair(&self, a: &Piece, b: &Piece, work: &mut u64) -> Result<f64> {
        let (mut open, mut patience, mut sum) = (vec![(*a, *b)], PATIENCE, 0.0);
        while let Some((a, b)) = open.pop() {
            let (x, y) = (a.simplex([0.0; 2]), b.simplex(b.shift_from(&a)));
            let (size, other) = (x.longest().1, y.longest().1);
            let distance = x.distance(&y);
            if patience == 0 || distance <= 0.0 {
                return Err(too_near(distance, size.max(other)));
            }
            patience -= 1;
            if size.max(other) * ADMISSIBLE <= distance {
                sum += self.leaf(&a, &b, distance, work)?;
            } else if size >= other {
                open.extend(a.parts().into_iter().map(|part| (part, b)));
            } else {
                open.extend(b.parts().into_iter().map(|part| (a, part)));
            }
        }
        Ok(sum)
    }

    fn leaf(&self, a: &Piece, b: &Piece, distance: f64, work: &mut u64) -> Result<f64> {
        let (first, second, shift) = (self.placed(a)?, self.placed(b)?, b.shift_from(a));
        let unit = power_of_two(distance);
        *work += (first.len() + second.len()) as u64;
        let mut sum = 0.0;
        for (x, v, u) in &first {
            let from = minus(*x, shift);
            for (y, w, z) in &second {
                let (dx, dy) = ((from[0] - y[0]) / unit, (from[1] - y[1]) / unit);
                let difference = (u * w - v * z) / unit;
                sum += self.kernel.at(dx * dx + dy * dy) * difference * difference;
            }
        }
        Ok(sum * unit.powf(2.0 - 2.0 * self.power))
    }

    /// ∫ w², in units, with a weighted rule at declared corners.
    pub(super) fn square(&self, piece: &Piece, approach: Approach, work: &mut u64) -> Result<f64> {
        let placed = if piece.is_singular {
            let radial = radial::rule(2.0, 2.0 * self.view.exponent(piece), approach)?;
            self.around(piece, &radial)?
        } else {
            self.placed(piece)?
        };
        *work += placed.len() as u64;
        Ok(placed.iter().map(|(_, _, value)| value * value).sum())
    }

    fn weighted(&self, piece: &Piece, at: Point, weight: f64) -> Placed {
        let root = weight.sqrt();
        (at, root, root * self.view.value(piece, at))
    }

    /// The points of a rule on a piece.
    fn placed(&self, piece: &Piece) -> Result<Vec<Placed>> {
        if piece.is_singular {
            let depth = radial::depth(self.digits, self.view.exponent(piece));
            return self.around(piece, &radial::cells(2.0, depth, self.points)?);
        }
        let ([a, b, c], area) = (piece.at, 0.5 * piece.twice_area());
        let place = |&([u, v], weight): &([f64; 2], f64)| {
            let at = [0, 1].map(|k| a[k] + (u * (b[k] - a[k]) + v * (c[k] - a[k])));
            self.weighted(piece, at, weight * area)
        };
        Ok(points(2, self.points)?.iter().map(place).collect())
    }

    /// The points of a rule on a piece at a declared corner, from a rule for ∫₀¹ ρ f dρ.
    fn around(&self, piece: &Piece, radial: &Points) -> Result<Vec<Placed>> {
        let plain = Rule::gauss_legendre(self.points)?;
        let (mut open, mut placed) = (vec![[piece.at[1], piece.at[2]]], Vec::new());
        while let Some([a, b]) = open.pop() {
            let along = minus(b, a);
            if length(along) > LONGEST * distance_from_segment([0.0; 2], a, b) {
                let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
                open.extend([[a, middle], [middle, b]]);
                continue;
            }
            let twice_area = product_difference(a[0], along[1], a[1], along[0]).abs();
            for (t, w) in plain.iter() {
                for &(rho, v) in radial {
                    let at = [rho * (a[0] + t * along[0]), rho * (a[1] + t * along[1])];
                    placed.push(self.weighted(piece, at, twice_area * v * w));
                }
            }
        }
        Ok(placed)
    }
}
