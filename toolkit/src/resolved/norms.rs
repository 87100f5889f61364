//! Norms of a resolved function: those of its polynomials, and the error of the polynomials.
//!
//! Let e = u − p, |e| ≤ ε_K on a cell K of length h_K. For L^q and the mean see the module above. For dual norms, with v
//! the maximiser for p and max |v| ≤ max |p| (the maximum principle for the resolvents and for the regional operator),
//!
//! ```text
//! | ‖u‖²_* − ‖p‖²_* | ≤ 2 max |p| ∫|e| + ‖e‖².
//! ```
//!
//! For seminorms | |u|_ν − |p|_ν | ≤ |e|_ν. If that exceeds the tolerance, and for at most 2000 cells, the smaller one of it
//! and of an estimate of first order is taken, |u|_ν − |p|_ν ≈ (p, e)_ν/|p|_ν, to which |e|²_ν/|p|_ν is added:
//!
//! |e|_ν is bounded cell by cell (`functions::resolution`); |u|²_ν − |p|²_ν = 2 (p, e)_ν + |e|²_ν, and the first term is
//! estimated from polynomials whose last coefficients are dropped and whose values at the nodes are moved. A jump J located
//! to a distance w changes |u|²_ν by at most
//!
//! ```text
//! 4 w |J| ( 2 max |u| d^{−2ν}/(2ν) + max |u′| d^{1−2ν}/(1−2ν) ),   ν < 1/2,
//! ```
//!
//! d the length of the shorter cell next to it: next to the jump the contributions of its two sides cancel.
//!
//! All of them are computed in units of length and value, powers of two near the length of the interval and the largest
//! value: squares of values of 1e-160 on cells of 1e-270 are no numbers.
//!
//! Towards a breakpoint cells are joined to one linear piece as far as Σ V² h^{1−2ν}, V the variation from the limit, is
//! negligible: the norm costs as many cells as the order and the tolerance require. Where u still varies at the smallest
//! distance, what lies beyond it is added as a geometric series if the contributions of the last cells fall like one;
//! otherwise the norm is infinite or refused.

use super::cells::{Cell, Place, Resolved, polynomials_of};
use crate::dual::DualOf;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::functions::{Units, of_residual};
use crate::kernel::power::PowerKernel;
use crate::numeric::scale::power_of_two;
use crate::order::Order;
use crate::piecewise::{Piece, PiecewisePolynomial};
use crate::root::{accept, whole};
use std::borrow::Cow;

/// Message: what limits the accuracy.
const LIMIT: &str = "the error of the polynomials that represent the function, or the rounding of its values, limits the accuracy";
/// Message: the function is not smooth between its breakpoints.
const UNDECLARED: &str =
    "the function is not smooth at a point between its breakpoints: declare it as a breakpoint";
/// Message: the norm may be infinite.
const GROWS: &str = "contributions do not decay down to the smallest distance from a breakpoint at which the \
     function can be evaluated";
/// Number of cells over which the decay of contributions at a breakpoint is observed, and the least number.
const OBSERVED: usize = 48;
const LEAST: usize = 8;
/// Ratios from one cell to the next above which contributions grow, and below which they fall.
const GROW: f64 = 1.02;
/// Share of the earlier rate of growth that is left where growth is exponential.
const STEADY: f64 = 0.8;
const FALLS: f64 = 0.995;
/// Ratio of the variations on neighbouring cells, towards a breakpoint, above which a function is not smooth there, and how far
/// the nearest ratio may be below the next ones.
const SMOOTH: f64 = 0.51;
const STEADIER: f64 = 0.9;
/// Margin of the sum of this series for the noise of x in its first terms.
const WIDER: f64 = 1.1;
/// Factor of the error of polynomials at a point: a singularity that is not declared lies between the points of comparison.
const BETWEEN: f64 = 4.0;
/// Share of the tolerance for the cells that are joined at a breakpoint.
const SHARE: f64 = 0.03;
/// The same for a dual norm, relative to the L² norm.
const IN_L2: f64 = 1e-4;
/// Factor by which the error of the comparison polynomials is larger.
const COARSER: f64 = 10.0;
/// Largest number of cells for which this comparison is made.
const COMPARED: usize = 2000;
/// Relative rounding error of values.
const FLOOR: f64 = 64.0 * f64::EPSILON;
/// Lengths and values between the reciprocal of this and this are not rescaled.
const MODERATE: f64 = 1e20;

impl Resolved {
    /// ‖u‖_ν.
    ///
    /// # Errors
    /// As [`Resolved::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let parts = [self.seminorm(order, tolerance), self.l2_norm(tolerance)];
        whole(parts, tolerance, LIMIT)
    }

    /// ‖u‖.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`], [`Error::ToleranceNotMet`].
    pub(crate) fn l2_norm(&self, tolerance: Tolerance) -> Result<Estimate> {
        self.lq_norm(2.0, tolerance)
    }

    /// ‖u‖ in L^q, 1 ≤ q ≤ ∞.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q < 1 or NaN, [`Error::InfiniteNorm`], [`Error::ToleranceNotMet`].
    pub(crate) fn lq_norm(&self, q: f64, tolerance: Tolerance) -> Result<Estimate> {
        Error::require("q", q, "[1, inf]", q >= 1.0)?;
        let units = self.units();
        let back = |found: Estimate| units.in_lq(q, found);
        let found = self.in_units(units).lq_norm_of_normalized(q, tolerance);
        found.map_err(|error| error.carry("L^q norm", back)).and_then(back)
    }

    fn lq_norm_of_normalized(&self, q: f64, tolerance: Tolerance) -> Result<Estimate> {
        let u = self.polynomials()?;
        if q == f64::INFINITY {
            let found = Estimate::or_best(u.lq_norm(q, tolerance))?;
            let off = |cell: &Cell| {
                let off = BETWEEN * cell.off;
                off.min((cell.piece.size() + off - found.value).max(0.0))
            };
            let off = self.cells.iter().map(off).fold(0.0, f64::max);
            let error = found.error + off + self.above(found.value, tolerance)?;
            let found = Estimate::new(found.value, error, found.work)?;
            return accept("L^inf norm", found, tolerance, LIMIT);
        }
        let rest =
            self.beyond(Some(0.0), tolerance, |cell| cell.length * cell.piece.size().powf(q))?;
        let found =
            if q == 2.0 { u.l2_norm()? } else { Estimate::or_best(u.lq_norm(q, tolerance))? };
        // In units of the largest error and value: powers of them over- or underflow.
        let worst = self.cells.iter().map(|cell| cell.off).fold(0.0, f64::max);
        let sum = |of: &dyn Fn(&Cell) -> f64| self.cells.iter().map(of).sum::<f64>();
        let alone = if worst > 0.0 {
            worst * sum(&|cell| cell.length * (cell.off / worst).powf(q)).powf(1.0 / q)
        } else {
            0.0
        };
        let value = found.value;
        let together = if value > 0.0 {
            let relative = |cell: &Cell| (cell.piece.size() + cell.off) / value;
            value * sum(&|cell| cell.length * (cell.off / value) * relative(cell).powf(q - 1.0))
        } else {
            f64::INFINITY
        };
        // Jumps are displaced by the rounding of their places.
        let moved: f64 = self
            .displacements()
            .map(|(by, [left, right])| by * (left.abs().max(right.abs()) / value).powf(q))
            .sum();
        let error = found.error
            + if value > 0.0 { value * moved } else { 0.0 }
            + alone.min(together)
            + rest.powf(1.0 / q).min(rest / value.powf(q - 1.0));
        accept("L^q norm", Estimate::new(value, error, found.work)?, tolerance, LIMIT)
    }

    /// The mean of u; the tolerance is relative to the mean of |u|.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`], [`Error::ToleranceNotMet`].
    pub(crate) fn mean(&self, tolerance: Tolerance) -> Result<Estimate> {
        let units = self.units();
        let back = |found: Estimate| found.times(units.size);
        let found = self.in_units(units).mean_of_normalized(tolerance);
        found.map_err(|error| error.carry("mean", back)).and_then(back)
    }

    fn mean_of_normalized(&self, tolerance: Tolerance) -> Result<Estimate> {
        let u = self.polynomials()?;
        let rest = self.beyond(Some(0.0), tolerance, |cell| cell.length * cell.piece.size())?;
        let found = u.mean()?;
        let sum = |of: &dyn Fn(&Cell) -> f64| self.cells.iter().map(of).sum::<f64>();
        let total = u.mesh().total();
        let moved: f64 =
            self.displacements().map(|(by, [left, right])| by * (left - right).abs()).sum();
        let error = found.error + (sum(&|cell| cell.length * cell.off) + rest + moved) / total;
        let size =
            sum(&|cell| cell.length * 0.5 * (cell.piece.left.abs() + cell.piece.right.abs()))
                / total;
        let found = Estimate::new(found.value, error, Work::default())?;
        if error <= tolerance.relative() * size.max(found.value.abs()) || size == 0.0 {
            return Ok(found);
        }
        Err(Error::not_met("mean", tolerance.relative(), found, LIMIT))
    }

    /// The dual norm sup ∫ u v / ‖v‖.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`].
    pub(crate) fn dual_norm(
        &self,
        of: DualOf,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let units = Units { length: 1.0, ..self.units() };
        let back = |found: Estimate| found.times(units.size);
        let found = self.in_units(units).dual_norm_of_normalized(of, order, tolerance);
        found.map_err(|error| error.carry("dual norm", back)).and_then(back)
    }

    /// The same of values of size 1. The dual norm is not homogeneous in the length: integrals are relative to that.
    fn dual_norm_of_normalized(
        &self,
        of: DualOf,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let total = self.end.from(self.first());
        let square = |cell: &Cell| cell.length / total * cell.piece.size().powi(2);
        let rest = self.beyond(Some(0.0), tolerance, square)?;
        let inner =
            Tolerance::new((0.5 * tolerance.relative()).max(1e-15))?.with_work(tolerance.work());
        let mut goal =
            (IN_L2 * tolerance.relative()).powi(2) * self.cells.iter().map(square).sum::<f64>();
        loop {
            let (cells, joined) = self.joined(|h| 4.0 * (h / total), goal);
            let found = Estimate::or_best(polynomials_of(&cells)?.dual_norm(of, order, inner))?;
            // A dual norm much smaller than the L² norm requires more of its digits.
            let needed = (SHARE * tolerance.relative() * (found.value / total.sqrt())).powi(2);
            if joined > needed && needed < 0.5 * goal {
                goal = needed;
                continue;
            }
            let (mut first, mut second, mut size) = (0.0, 0.0, 0.0_f64);
            for cell in &cells {
                first += cell.length / total * cell.off;
                second += cell.length / total * cell.off * cell.off;
                size = size.max(cell.piece.size());
            }
            for (by, [left, right]) in self.displacements() {
                first += by / total * (left - right).abs();
                second += by / total * (left - right).powi(2);
            }
            let together = if found.value > 0.0 {
                (2.0 * size * first + second) * (total / found.value)
            } else {
                f64::INFINITY
            };
            let together = together.min(second.sqrt() * total.sqrt());
            let error = found.error + together + (rest.sqrt() + joined.sqrt()) * total.sqrt();
            let found = Estimate::new(found.value, error, found.work)?;
            return accept("dual norm", found, tolerance, LIMIT);
        }
    }

    /// |u|_ν.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] if u jumps and ν ≥ 1/2; [`Error::ToleranceNotMet`], without a value where it is not known
    /// whether the seminorm is finite.
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let units = self.units();
        let back = |found: Estimate| units.seminorm(order, found);
        let found = self.in_units(units).seminorm_of_normalized(order, tolerance);
        found.map_err(|error| error.carry("seminorm", back)).and_then(back)
    }

    /// Powers of two near the length of the interval and the largest value; 1 where both are moderate.
    fn units(&self) -> Units {
        let total = self.end.from(self.first());
        let size = self.cells.iter().map(|cell| cell.piece.size()).fold(0.0, f64::max);
        let is_moderate = |x: f64| x == 0.0 || (1.0 / MODERATE..MODERATE).contains(&x);
        if is_moderate(total) && is_moderate(size) {
            return Units { length: 1.0, size: 1.0 };
        }
        Units { length: power_of_two(total), size: power_of_two(size) }
    }

    /// The same function in these units.
    fn in_units(&self, Units { length, size }: Units) -> Cow<'_, Self> {
        if length == 1.0 && size == 1.0 {
            return Cow::Borrowed(self);
        }
        let place = |at: Place| Place { base: at.base / length, offset: at.offset / length };
        let cell = |cell: &Cell| Cell {
            start: place(cell.start),
            length: cell.length / length,
            piece: cell.piece.scaled(1.0 / size),
            off: cell.off / size,
            is_rough: cell.is_rough,
        };
        Cow::Owned(Self {
            cells: self.cells.iter().map(cell).collect(),
            end: place(self.end),
            breaks: self.breaks.iter().map(|c| c / length).collect(),
            open: self.open.iter().map(|c| c / length).collect(),
            is_noisy: self.is_noisy,
        })
    }

    fn seminorm_of_normalized(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let kernel = PowerKernel::new(order);
        let asked = tolerance.relative();
        let is_rough = self.is_rough();
        if !order.is_below_half() {
            if is_rough {
                return Err(Error::out_of_reach("seminorm", asked, f64::INFINITY, UNDECLARED));
            }
            if self.jumps() {
                let why = "a function with a jump is not in H^nu for nu >= 1/2";
                return Err(Error::InfiniteNorm { order: order.value(), why });
            }
        }
        let beyond = self.beyond(None, tolerance, |cell| {
            kernel.scaling(cell.length) * variation(cell).powi(2)
        })?;
        let mut size = self.crude(kernel);
        let mut best: Option<Estimate> = None;
        for _ in 0..2 {
            // The square of the seminorm of what is neglected, from its variations.
            let factor = 64.0 * (1.0 / kernel.twice + 1.0 / kernel.two_minus);
            let goal = (SHARE * asked * size).powi(2) / factor;
            let (cells, joined) = self.joined(|h| kernel.scaling(h), goal);
            let joined = factor * joined;
            let off: Vec<f64> = cells.iter().map(|cell| cell.off).collect();
            let cells = shortened(cells, kernel, (SHARE * asked * size).powi(2));
            let u = polynomials_of(&cells)?;
            let inner = Tolerance::new((0.3 * asked).max(1e-15))?.with_work(tolerance.work());
            let found = Estimate::or_best(u.seminorm(order, inner))?;
            let total = u.mesh().total();
            let mut square = joined + beyond;
            for cell in &cells {
                let degree = cell.piece.bubbles.len() + 1;
                square += of_residual(kernel, degree, cell.off, cell.length, total);
                if cell.is_rough {
                    // A step of this height within the cell.
                    let step = 4.0 / (kernel.twice * kernel.one_minus);
                    square += step * kernel.scaling(cell.length) * cell.off * cell.off;
                }
            }
            let bound = square.sqrt();
            let mut error = bound;
            if found.error + bound > asked * found.value && cells.len() <= COMPARED && !is_rough {
                let coarse = coarser(&u, &cells, &off)?;
                let coarse = Estimate::or_best(coarse.seminorm(order, inner))?;
                let second = if found.value > 0.0 { bound * (bound / found.value) } else { bound };
                error = bound.min((coarse.value - found.value).abs() + second + joined.sqrt());
            }
            if found.value > 0.0 {
                error += displaced(&cells, order, kernel) / (2.0 * found.value);
            }
            let found = Estimate::new(found.value, found.error + error, found.work)?;
            if found.work.points > tolerance.work() {
                return Err(Error::not_met("seminorm", asked, found, crate::estimate::SPENT));
            }
            if best.is_none_or(|best| found.error < best.error) {
                best = Some(found);
            }
            if found.error <= asked * found.value || found.value >= 0.5 * size {
                break;
            }
            size = found.value;
        }
        match best {
            Some(found) => accept("seminorm", found, tolerance, LIMIT),
            None => Err(Error::out_of_reach("seminorm", asked, f64::INFINITY, LIMIT)),
        }
    }

    /// The jumps at places that are not declared: the rounding of the place, and the values on both sides.
    fn displacements(&self) -> impl Iterator<Item = (f64, [f64; 2])> {
        let jumps = self.cells.windows(2).filter(|pair| pair[0].piece.right != pair[1].piece.left);
        jumps.map(|pair| (pair[1].blur(), [pair[0].piece.right, pair[1].piece.left]))
    }

    /// Checks that u′ is in L².
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] of this order, [`Error::ToleranceNotMet`] if that is not known.
    pub(crate) fn require_derivative(&self, order: f64, tolerance: Tolerance) -> Result<()> {
        if self.jumps() {
            let why = "a function that jumps has no derivative in L^2";
            return Err(Error::InfiniteNorm { order, why });
        }
        self.beyond(Some(order), tolerance, |cell| {
            variation(cell) * (variation(cell) / cell.length)
        })
        .map(|_| ())
    }

    /// What lies beyond the smallest distances of contributions that fall like a geometric series.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] of this order, if there is one, where they grow like a power of the distance;
    /// [`Error::ToleranceNotMet`] if they do not fall.
    fn beyond(
        &self,
        order: Option<f64>,
        asked: Tolerance,
        contribution: impl Fn(&Cell) -> f64,
    ) -> Result<f64> {
        let mut rest = 0.0;
        for node in 0..=self.cells.len() {
            let Place { base, offset } = self.place(node);
            if offset != 0.0 || !self.open.contains(&base) {
                continue;
            }
            for is_right in [true, false] {
                let near = self.beside(node, is_right);
                let Some(last) = near.clone().next().map(&contribution) else { continue };
                let (count, before) = near
                    .take(OBSERVED)
                    .map(&contribution)
                    .enumerate()
                    .last()
                    .map_or((0, last), |(count, value)| (count, value));
                if last == 0.0 {
                    continue;
                }
                let ratio = (last / before).powf(1.0 / count.max(1) as f64);
                // The cell at the breakpoint is longer than its neighbours, and its size is that at the smallest distance.
                let inner: Vec<f64> =
                    self.beside(node, is_right).skip(1).take(OBSERVED).map(&contribution).collect();
                if let Some(order) = order
                    && grows(&inner)
                {
                    let why = "the contributions near a breakpoint do not decay";
                    return Err(Error::InfiniteNorm { order, why });
                }
                if count < LEAST || ratio.is_nan() || ratio > FALLS {
                    return Err(Error::out_of_reach(
                        "norm",
                        asked.relative(),
                        f64::INFINITY,
                        GROWS,
                    ));
                }
                rest += last * ratio / (1.0 - ratio);
            }
        }
        Ok(rest)
    }

    /// By how much |u| may exceed a value nearer to a breakpoint than the cell next to it.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] where |u| grows towards a breakpoint next to which its variation has not ended and is no
    /// series as in [`Resolved::hidden`].
    fn above(&self, value: f64, asked: Tolerance) -> Result<f64> {
        let mut above = 0.0_f64;
        for node in (0..=self.cells.len()).filter(|&node| self.place(node).offset == 0.0) {
            for is_right in [true, false] {
                let Some(Piece { left, right, .. }) =
                    self.beside(node, is_right).next().map(|cell| &cell.piece)
                else {
                    continue;
                };
                let [near, far] = if is_right { [left, right] } else { [right, left] };
                let is_open = self.open.contains(&self.place(node).base);
                if let Some(hidden) = self.hidden(node, is_right) {
                    above = above.max(far.abs() + hidden - value);
                } else if is_open && (near.abs() > far.abs() || near.abs() >= 0.5 * value) {
                    let asked = asked.relative();
                    return Err(Error::out_of_reach("L^inf norm", asked, f64::INFINITY, GROWS));
                }
            }
        }
        Ok(above)
    }

    /// The variation of u on the cell next to a breakpoint if u is like a power of the distance there, which the rounding of x
    /// may hide from the polynomial: the variations on the next cells are a geometric series then,
    ///
    /// ```text
    /// |u(δ) − u(0)| = V₁ r/(1 − r),    V_k = V₁ r^{1−k} on cells of length 2^{k−1} δ,
    /// ```
    ///
    /// and r > 1/2, the ratio of a smooth function. `None` if they are not.
    pub(super) fn hidden(&self, node: usize, is_right: bool) -> Option<f64> {
        let next: Vec<&Cell> = self.beside(node, is_right).skip(1).take(LEAST).collect();
        let doubles = |pair: &[&Cell]| pair[1].length > 1.5 * pair[0].length;
        if next.len() < LEAST || !next.windows(2).all(doubles) {
            return None;
        }
        let step = |cell: &Cell| (cell.piece.right - cell.piece.left).abs();
        let steps: Vec<f64> = next.into_iter().map(step).collect();
        let over =
            |from: usize, to: usize| (steps[from] / steps[to]).powf(1.0 / (to - from) as f64);
        let is_series = steps.windows(2).all(|pair| pair[0] < pair[1])
            && over(0, 1) > STEADIER * over(LEAST / 2, LEAST - 1);
        let ratio = over(0, LEAST - 1);
        let is_power = is_series && ratio > SMOOTH && ratio < FALLS;
        is_power.then(|| WIDER * steps[0] * ratio / (1.0 - ratio))
    }

    /// The cells on one side of a node that are known from it, from the nearest one on.
    fn beside(&self, node: usize, is_right: bool) -> impl Iterator<Item = &Cell> + Clone {
        let base = self.place(node).base;
        let other = move |k: usize| if is_right { k + 1 } else { k };
        let cell = move |n: usize| {
            let k = if is_right { Some(node + n) } else { node.checked_sub(n + 1) }?;
            let far = self.place(other(k));
            let is_known =
                k < self.cells.len() && (n == 0 || far.base == base && far.offset != 0.0);
            is_known.then(|| &self.cells[k])
        };
        (0..=self.cells.len()).map_while(cell)
    }

    /// The size of |u|_ν, up to a factor.
    fn crude(&self, kernel: PowerKernel) -> f64 {
        let own = |cell: &Cell| kernel.scaling(cell.length) * variation(cell).powi(2);
        let jump = |pair: &[Cell]| {
            let height = pair[1].piece.left - pair[0].piece.right;
            kernel.scaling(pair[0].length.min(pair[1].length)) * height * height
        };
        let jumps = self.cells.windows(2).map(jump).filter(|jump| jump.is_finite()).sum::<f64>();
        (self.cells.iter().map(own).sum::<f64>() + jumps).sqrt()
    }

    /// The cells with those at every breakpoint joined to a linear piece as far as Σ V² w(h) is less than `goal`, h the
    /// lengths and V the variation from the limit, and that sum. The linear piece itself counts with its whole length:
    /// where the last cell is short, the tail of a bell, its slope is felt far from that cell.
    fn joined(&self, weight: impl Fn(f64) -> f64, goal: f64) -> (Vec<Cell>, f64) {
        let n = self.cells.len();
        let mut keep = vec![true; n];
        let (mut whole, mut joined) = (0.0, vec![None; n]);
        for node in (0..=n).filter(|&k| self.place(k).offset == 0.0) {
            for is_right in [true, false] {
                let near = self.beside(node, is_right);
                let ends = |piece: &Piece| match is_right {
                    true => (piece.left, piece.right),
                    false => (piece.right, piece.left),
                };
                let Some((limit, _)) = near.clone().next().map(|cell| ends(&cell.piece)) else {
                    continue;
                };
                let (mut sum, mut length, mut count, mut last) = (0.0, 0.0, 0, limit);
                let mut slope = 0.0;
                for cell in near {
                    let (from, to) = ends(&cell.piece);
                    let bubbles: f64 = cell.piece.bubbles.iter().map(|c| 0.25 * c.abs()).sum();
                    let off = (from - limit).abs().max((to - limit).abs()) + bubbles + cell.off;
                    let next = sum + weight(cell.length) * off * off;
                    let sloping = weight(length + cell.length) * (to - limit).powi(2);
                    if cell.is_rough || next + sloping > goal {
                        break;
                    }
                    (sum, length, count, last) = (next, length + cell.length, count + 1, to);
                    slope = sloping;
                }
                if count < 2 {
                    continue;
                }
                whole += sum + slope;
                let cells = if is_right { node..node + count } else { node - count..node };
                keep[cells.clone()].fill(false);
                let [left, right] = if is_right { [limit, last] } else { [last, limit] };
                let piece = Piece { left, right, bubbles: Vec::new() };
                let start = self.cells[cells.start].start;
                joined[cells.start] =
                    Some(Cell { start, length, piece, off: 0.0, is_rough: false });
            }
        }
        let cells = (0..n)
            .filter_map(|k| joined[k].take().or_else(|| keep[k].then(|| self.cells[k].clone())))
            .collect();
        (cells, whole)
    }
}

/// The largest difference of two values on a cell, up to a factor.
fn variation(cell: &Cell) -> f64 {
    let bubbles: f64 = cell.piece.bubbles.iter().map(|c| 0.25 * c.abs()).sum();
    (cell.piece.right - cell.piece.left).abs() + bubbles
}

/// The polynomials without the last bubbles, as far as a bound of the square of the seminorm of what is cut off is less than
/// `goal`: few digits take few coefficients.
fn shortened(mut cells: Vec<Cell>, kernel: PowerKernel, goal: f64) -> Vec<Cell> {
    let total: f64 = cells.iter().map(|cell| cell.length).sum();
    let share = goal / cells.len() as f64;
    for cell in &mut cells {
        let degree = cell.piece.bubbles.len() + 1;
        let allowed = (share / of_residual(kernel, degree, 1.0, cell.length, total)).sqrt();
        let mut cut = 0.0;
        while let Some(last) = cell.piece.bubbles.last() {
            // |t (1 − t) P_k(2t − 1)| ≤ 1/4
            let next = cut + 0.25 * last.abs();
            if next > allowed || next.is_nan() {
                break;
            }
            cut = next;
            cell.piece.bubbles.pop();
        }
        cell.off += cut;
    }
    cells
}

/// True if contributions grow towards the breakpoint like a power of the distance. A power of its logarithm grows by ever
/// smaller ratios, and may still fall beyond the smallest distance.
fn grows(nearest_first: &[f64]) -> bool {
    let [half, last] = [nearest_first.len() / 2, nearest_first.len().saturating_sub(1)];
    if half < LEAST / 2 {
        return false;
    }
    let rate = |near: usize, far: usize| {
        (nearest_first[near] / nearest_first[far]).ln() / (far - near) as f64
    };
    let [late, early] = [rate(0, half), rate(half, last)];
    late > GROW.ln() && late > STEADY * early
}

/// The polynomials without their last bubbles, as far as these are no larger than [`COARSER`] times the errors, and with
/// the values at the nodes moved away from their neighbours by the errors `off` of the values that exceed rounding.
fn coarser(u: &PiecewisePolynomial, cells: &[Cell], off: &[f64]) -> Result<PiecewisePolynomial> {
    let mut ends: Vec<[f64; 2]> =
        cells.iter().map(|cell| [cell.piece.left, cell.piece.right]).collect();
    let error = |k: usize| if off[k] > FLOOR * cells[k].piece.size() { off[k] } else { 0.0 };
    let slope = |cell: &Cell| (cell.piece.right - cell.piece.left) / cell.length;
    for node in 0..=cells.len() {
        let beside = [node.checked_sub(1), (node < cells.len()).then_some(node)];
        let [before, after] = beside.map(|k| k.map_or(0.0, |k| slope(&cells[k])));
        let by = beside.into_iter().flatten().map(error).fold(0.0, f64::max);
        let by = by.copysign(before - after);
        if node > 0 {
            ends[node - 1][1] += by;
        }
        if node < cells.len() {
            ends[node][0] += by;
        }
    }
    let shorter = |cell: &Cell| {
        let (mut bubbles, mut cut) = (cell.piece.bubbles.clone(), 0.0);
        while cut < COARSER * cell.off
            && let Some(last) = bubbles.pop()
        {
            cut += 0.25 * last.abs();
        }
        bubbles
    };
    PiecewisePolynomial::with_bubbles(u.mesh().clone(), &ends, cells.iter().map(shorter).collect())
}

/// The bound of the change of |u|²_ν by the displacement of jumps.
fn displaced(cells: &[Cell], order: Order, kernel: PowerKernel) -> f64 {
    if !order.is_below_half() {
        return 0.0;
    }
    let size = cells.iter().map(|cell| cell.piece.size()).fold(0.0, f64::max);
    let of = |pair: &[Cell]| {
        let jump = (pair[1].piece.left - pair[0].piece.right).abs();
        if jump == 0.0 {
            return 0.0;
        }
        let d = pair[0].length.min(pair[1].length);
        let steep = |cell: &Cell| variation(cell) * (kernel.scaling(d) / cell.length);
        let near = steep(&pair[0]).max(steep(&pair[1])) / kernel.one_minus;
        let far = 2.0 * size * d.powf(-kernel.twice) / kernel.twice;
        4.0 * pair[1].blur() * jump * (far + near)
    };
    cells.windows(2).map(of).sum()
}
