//! |u|²_ν of piecewise polynomials with moderate lengths: by all pairs, by the fast product, or by moments.

use super::pairs::{Cell, PolynomialPairs};
use super::polynomial::{Piece, PiecewisePolynomial};
use crate::energy::PairSum;
use crate::error::Result;
use crate::estimate::{Estimate, Tolerance, Work};
use crate::gram::GramOperator;
use crate::gram::dense::{FarRow, constants_on, neighbours_linear};
use crate::kernel::cells::CellPairs;
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use crate::root::ENTRY_ROUNDING;
use rayon::prelude::*;
use std::ops::Add;

/// Largest number of elements for which all pairs are summed directly, for degrees above one.
const DIRECT: usize = 150;
const DIRECT_POLYNOMIALS: usize = 24;
/// Largest number of elements for which all pairs are summed if no faster method is accurate enough.
const PATIENT: usize = 16_000;
const PATIENT_POLYNOMIALS: usize = 1000;
/// Accuracy of the rules for all pairs: the level of rounding.
const EXACT: f64 = 1e-17;
/// Accuracy of the fast product.
const FAST_FORM: Tolerance = Tolerance::reference();
/// Error of every entry of the fast product, relative to |A| |x|; it is below 1e-14 in experiments.
const FAST_ROUNDING: f64 = 1e-13;

impl PiecewisePolynomial {
    /// The squared seminorm of a function of moderate size and lengths.
    pub(super) fn seminorm_squared_of_moderate(
        &self,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        if self.is_exactly(|piece| piece.left == piece.right) {
            self.constants_squared(order, tolerance)
        } else if self.is_exactly(|_| true) && self.is_continuous() {
            self.linears_squared(order, tolerance)
        } else {
            self.pairs_squared(order, tolerance)
        }
    }

    /// The square by the fast product on a uniform mesh; otherwise, or if that is not accurate enough, by
    /// moments; `None` if these are not accurate enough either and all pairs can be summed.
    fn faster(
        &self,
        product: impl FnOnce() -> Result<Estimate>,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Option<Estimate>> {
        if self.mesh().uniform_length().is_some() {
            let found = product()?;
            if is_enough(&found, tolerance) {
                return Ok(Some(found));
            }
        }
        let found = self.by_moments(order, tolerance)?;
        Ok((is_enough(&found, tolerance) || self.mesh().len() > PATIENT).then_some(found))
    }

    fn is_exactly(&self, shape: impl Fn(&Piece) -> bool) -> bool {
        self.pieces().iter().all(|piece| piece.bubbles.is_empty() && shape(piece))
    }

    fn constants_squared(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let (partition, pieces) = (self.mesh(), self.pieces());
        if pieces.iter().all(|piece| piece.left == pieces[0].left) {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        let n = pieces.len();
        if n > DIRECT {
            let product = || {
                let values: Vec<f64> = pieces.iter().map(|piece| piece.left).collect();
                fast_form(&GramOperator::constants(partition, order, FAST_FORM)?, &values)
            };
            if let Some(found) = self.faster(product, order, tolerance)? {
                return Ok(found);
            }
        }
        let cells = CellPairs::new(order);
        let value: f64 = (0..n)
            .into_par_iter()
            .map(|i| {
                let (mut sum, mut gap) = (0.0, RunningSum::default());
                for j in i + 1..n {
                    let difference = pieces[i].left - pieces[j].left;
                    if difference != 0.0 {
                        sum += constants_on(partition, &cells, i, j, gap.value())
                            * difference
                            * difference;
                    }
                    gap.add(partition.lengths()[j]);
                }
                2.0 * sum
            })
            .sum();
        Estimate::new(value, ENTRY_ROUNDING * value, pair_work(n))
    }

    fn linears_squared(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let partition = self.mesh();
        let cells = CellPairs::new(order);
        let n = partition.len();
        let mut nodal: Vec<f64> = self.pieces().iter().map(|piece| piece.left).collect();
        nodal.push(self.pieces()[n - 1].right);
        if n > DIRECT {
            let product =
                || fast_form(&GramOperator::linears(partition, order, FAST_FORM)?, &nodal);
            if let Some(found) = self.faster(product, order, tolerance)? {
                return Ok(found);
            }
        }
        let square = |i: usize, j: usize| (nodal[i] - nodal[j]) * (nodal[i] - nodal[j]);
        let (value, absolute) = (0..n)
            .into_par_iter()
            .map(|e| {
                let entry = neighbours_linear(partition, &cells, e) * square(e, e + 1);
                let (mut sum, mut absolute) = (-entry, entry.abs());
                for (k, [near, far]) in
                    FarRow::new(partition, &cells, e).values.into_iter().enumerate()
                {
                    let term = -near * square(e + 1, e + 2 + k) - far * square(e, e + 2 + k);
                    sum += term;
                    absolute += term;
                }
                (sum, absolute)
            })
            .reduce(|| (0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        Estimate::new(value, ENTRY_ROUNDING * absolute, pair_work(n))
    }

    fn pairs_squared(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        if self.mesh().len() > DIRECT_POLYNOMIALS {
            let found = self.by_moments(order, tolerance)?;
            if is_enough(&found, tolerance) || self.mesh().len() > PATIENT_POLYNOMIALS {
                return Ok(found);
            }
        }
        let pairs = PolynomialPairs::new(order, self.degree().max(1), EXACT)?;
        let lengths = self.mesh().lengths();
        let n = lengths.len();
        let cell = |i: usize| Cell { length: lengths[i], piece: &self.pieces()[i] };
        let total = (0..n)
            .into_par_iter()
            .map(|i| {
                let mut sum = pairs.own(cell(i));
                if i + 1 < n {
                    sum = sum + pairs.touching(cell(i), cell(i + 1), self.jump(i + 1));
                }
                let mut gap = RunningSum::default();
                for j in i + 2..n {
                    gap.add(lengths[j - 1]);
                    sum = sum + pairs.separate(cell(i), cell(j), gap.value());
                }
                sum
            })
            .reduce(PairSum::default, PairSum::add);
        let work = Work { points: total.points, ..pair_work(n) };
        Estimate::new(total.value, ENTRY_ROUNDING * total.value + total.rounding, work)
    }
}

/// xᵀ A x by the fast product.
fn fast_form(operator: &GramOperator, x: &[f64]) -> Result<Estimate> {
    let image = operator.apply(x)?;
    let mean = x.iter().map(|v| v / x.len() as f64).sum::<f64>();
    let (mut sum, mut absolute) = (RunningSum::default(), 0.0);
    for ((v, y), a) in x.iter().zip(&image).zip(operator.diagonal()) {
        let v = v - mean;
        sum.add(v * y);
        // |x|ᵀ |A| |x| ≤ 2 Σ a_ii x_i², since rows sum to zero
        absolute += 2.0 * a * v * v;
    }
    Estimate::new(
        sum.value(),
        FAST_ROUNDING * absolute,
        Work { points: x.len() as u64, ..Work::default() },
    )
}

/// True if the square of the seminorm is accurate to twice the tolerance.
fn is_enough(squared: &Estimate, tolerance: Tolerance) -> bool {
    squared.relative_error() <= 2.0 * tolerance.relative()
}

fn pair_work(n: usize) -> Work {
    Work { pairs: (n * (n + 1) / 2) as u64, ..Work::default() }
}
