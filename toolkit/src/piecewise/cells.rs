//! The cells of a piecewise polynomial, for the computation by moments.

use super::pairs::{Cell, DegreeRules};
use super::polynomial::{Piece, PiecewisePolynomial};
use crate::energy::{CellEnergies, PairSum, Samples, energy};
use crate::error::Result;
use crate::estimate::{Estimate, Tolerance};
use crate::order::Order;

/// Largest degree for which leaves have several elements; for higher degrees a pair of cells costs as much as a
/// pair of clusters.
const LOW_DEGREE: usize = 2;
const LEAF: usize = 4;
/// Ratio of the relative accuracy of the interpolated kernel to that of the seminorm.
const SHARE: f64 = 0.2;

/// A piecewise polynomial with rules for its degrees.
pub(crate) struct PolynomialCells<'a> {
    u: &'a PiecewisePolynomial,
    rules: DegreeRules,
}

impl<'a> PolynomialCells<'a> {
    /// The rules for the relative accuracy `target`.
    pub(crate) fn new(u: &'a PiecewisePolynomial, order: Order, target: f64) -> Result<Self> {
        let degrees = u.pieces().iter().map(Piece::degree);
        Ok(Self { u, rules: DegreeRules::new(order, degrees, target)? })
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
        self.rules.sample(&self.u.pieces()[cell], shift, visit);
    }
}

impl CellEnergies for PolynomialCells<'_> {
    fn near(&self, e: usize, f: usize, gap: f64) -> PairSum {
        self.rules.near([self.cell(e), self.cell(f)], f - e, gap, || self.u.jump(f))
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
