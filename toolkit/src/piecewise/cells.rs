//! The cells of a piecewise polynomial, for the computation by moments.

use super::pairs::{Cell, PolynomialPairs};
use super::polynomial::PiecewisePolynomial;
use crate::energy::{CellEnergies, PairSum, Samples, energy};
use crate::error::Result;
use crate::estimate::{Estimate, Tolerance};
use crate::order::Order;
use crate::quadrature::Rule;

/// Largest degree for which leaves have several elements; for higher degrees a pair of cells costs as much as a
/// pair of clusters.
const LOW_DEGREE: usize = 2;
const LEAF: usize = 4;
/// Number of points of a rule in addition to the degree: half the number of points of a cluster, plus one.
const MOMENT_POINTS: usize = 15;
/// Ratio of the relative accuracy of the interpolated kernel to that of the seminorm.
const SHARE: f64 = 0.2;

/// A piecewise polynomial with rules for its degrees.
pub(crate) struct PolynomialCells<'a> {
    u: &'a PiecewisePolynomial,
    pairs: Vec<PolynomialPairs>,
    rules: Vec<Rule>,
}

impl<'a> PolynomialCells<'a> {
    /// The rules for the relative accuracy `target`.
    pub(crate) fn new(u: &'a PiecewisePolynomial, order: Order, target: f64) -> Result<Self> {
        let degrees = 0..=u.degree();
        Ok(Self {
            u,
            pairs: degrees
                .clone()
                .map(|d| PolynomialPairs::new(order, d.max(1), 0.1 * target))
                .collect::<Result<_>>()?,
            rules: degrees.map(|d| Rule::gauss_legendre(d + MOMENT_POINTS)).collect::<Result<_>>()?,
        })
    }

    fn cell(&self, e: usize) -> Cell<'_> {
        Cell { length: self.u.mesh().lengths()[e], piece: &self.u.pieces()[e] }
    }
}

impl Samples for PolynomialCells<'_> {
    fn level(&self, cell: usize) -> f64 {
        self.u.pieces()[cell].left
    }

    fn sample(&self, cell: usize, shift: f64, visit: &mut dyn FnMut(f64, f64, f64)) {
        let piece = &self.u.pieces()[cell];
        for (t, w) in self.rules[piece.degree()].iter() {
            visit(t, w, piece.value_above(shift, t));
        }
    }
}

impl CellEnergies for PolynomialCells<'_> {
    fn near(&self, e: usize, f: usize, gap: f64) -> PairSum {
        let (left, right) = (self.cell(e), self.cell(f));
        let pairs = &self.pairs[left.piece.degree().max(right.piece.degree())];
        match f - e {
            0 => pairs.own(left),
            1 => pairs.touching(left, right, self.u.jump(f)),
            _ => pairs.separate(left, right, gap),
        }
    }

    fn leaf(&self) -> usize {
        if self.u.degree() <= LOW_DEGREE { LEAF } else { 1 }
    }
}

impl PiecewisePolynomial {
    /// |u|²_ν by moments, with far pairs accurate to the tolerance.
    pub(super) fn by_moments(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let target = SHARE * tolerance.relative();
        energy(self.mesh(), &PolynomialCells::new(self, order, target)?, order, target)
    }
}
