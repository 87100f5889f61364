//! Functions with structure on many scales as piecewise polynomials: layers far below the interval at a
//! breakpoint, short intervals next to long ones, undeclared kinks and peaks.
//!
//! Every side is cut at R/2^k towards its breakpoint, down to the scale below which u agrees with a single
//! polynomial to the tolerance at all scales ([`Profile`]); cells away from the breakpoint are bisected by the
//! same criterion. A difference ε at the scale δ contributes ε δ^{1/2−ν} to |u|_ν. The seminorm is |p|_ν of the
//! piecewise polynomial, which depends on lengths only and is accurate on all scales.
//!
//! The error of |p|_ν is at most |u − p|_ν, for which [`super::resolution`] gives a bound B. This bound adds
//! the residuals e of all cells with one sign; but e is orthogonal to polynomials of lower degree, and |u|²
//! − |p|² = 2(p, e)_ν + |e|²_ν is much smaller. The first term is estimated from polynomials with an error
//! ten times as large on every cell, obtained by dropping the last bubbles; the second term is at most B².

use super::arm::Arm;
use super::function::SingularFunction;
use super::resolution::of_residual;
use super::scales::Profile;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::order::Order;
use crate::piecewise::{Piece, PiecewisePolynomial, bubbles_of};
use crate::quadrature::Rule;
use std::cmp::Ordering;

/// Number of refinement rounds, each to a tenth of the error of the previous one or less.
const ROUNDS: usize = 4;
/// Largest number of cells of one side.
const MOST: usize = 6000;
/// Largest number of bisections of a cell away from the breakpoint.
const HALVINGS: u32 = 50;
/// Rounding error of values of size 1.
const FLOOR: f64 = 64.0 * f64::EPSILON;
/// Number of ulps up to which values count as linear.
const STRAIGHT: f64 = 8.0 * f64::EPSILON;
/// Share of the variation on a cell that the rounding of x may explain.
const MOVED: f64 = 0.1;
/// Relative rounding error of a polynomial.
const NOISE: f64 = 8.0 * f64::EPSILON;
/// Bound of the ratio of the largest residual to the largest residual at the points of a rule.
const UNSEEN: f64 = 2.0;

/// Factor by which the error of the comparison polynomials is larger.
const COARSER: f64 = 10.0;
/// Largest number of cells for which the comparison is made, at the cost of two sums over their pairs.
const COMPARED: usize = 400;
/// Coarsest accuracy with which a best value is computed.
const COARSEST: f64 = 1e-3;
/// Share of the requested accuracy for differences that are neglected.
const BELOW: f64 = 0.01;

/// Message: what limits the accuracy.
const LIMIT: &str = "structure on many scales limits the accuracy";
/// Message: the function is not smooth between its breakpoints.
pub(super) const UNDECLARED: &str =
    "the function is not smooth at a point between its breakpoints: declare it as a breakpoint";
/// Message: the contributions do not decay at a breakpoint.
const ENDLESS: &str = "contributions do not decay down to the smallest distance from a breakpoint at which the \
     function can be evaluated";
/// Message: too many cells.
const TOO_MANY: &str = "the structure of the function is not resolved by 6000 cells";

/// A cell of a side: its distances from the breakpoint and its polynomial, from left to right.
struct Cell {
    near: f64,
    far: f64,
    piece: Piece,
    /// max |u − p| between the points of p, less the rounding error
    residual: f64,
    /// Σ ε² δ^{1−2ν} / |u|²_ν, summed over the scales at the end of a side
    rest: f64,
}

/// Criterion for the choice of the cells.
struct Fit<'a> {
    profile: &'a Profile,
    kernel: PowerKernel,
    degree: usize,
    /// a crude value of |u|_ν
    size: f64,
    /// the requested accuracy times `size`
    goal: f64,
    between: Rule,
}

impl Fit<'_> {
    /// The largest error ε that is negligible at the scale δ.
    fn allowed(&self, delta: f64) -> f64 {
        self.goal * (-0.5 * self.kernel.one_minus * delta.ln()).exp()
    }
}

/// |u|_ν with its error for one choice of cells.
pub(super) struct Found {
    pub(super) value: Estimate,
    /// true if u is not smooth at a point between breakpoints
    pub(super) is_rough: bool,
}

impl SingularFunction<'_> {
    /// |u|_ν of a function of size 1 on an interval of length 1.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`], [`Error::InfiniteNorm`] if u jumps at a breakpoint and ν ≥ 1/2.
    pub(super) fn seminorm_by_scales(
        &self,
        profile: &Profile,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let kernel = PowerKernel::new(order);
        let asked = tolerance.relative();
        // Nothing may be seen between the samples.
        let seen = (0.5 * profile.energies(kernel).whole).exp();
        let size = if seen > 0.0 { seen } else { 1.0 };
        let (mut best, mut why): (Option<Estimate>, _) = (None, LIMIT);
        let mut accuracy = 0.2 * asked * 0.03f64.powf(order.value());
        for _ in 0..ROUNDS {
            let degree = ((4.0 - 1.1 * accuracy.log10()).ceil() as usize).clamp(6, 18);
            let between = Rule::gauss_legendre(2 * degree)?;
            let size = best
                .map_or(size, |best: Estimate| if best.value > 0.0 { best.value } else { size });
            let goal = accuracy.max(f64::EPSILON) * size;
            let fit = Fit { profile, kernel, degree, size, goal, between };
            let found = match self.by_graded_cells(&fit, order, tolerance) {
                Err(_) if self.work_left() == 0 => {
                    why = SPENT;
                    break;
                }
                Err(Error::ToleranceNotMet { why: TOO_MANY, .. }) => {
                    // What fewer cells resolve is the best value.
                    why = TOO_MANY;
                    if best.is_some() || accuracy > COARSEST {
                        break;
                    }
                    accuracy *= 100.0;
                    continue;
                }
                other => other?,
            };
            // Of a value of zero the relative error is not known.
            if found.value.error <= asked * found.value.value {
                return Ok(found.value);
            }
            if found.is_rough {
                why = UNDECLARED;
            }
            let gained = best.is_none_or(|best| found.value.error < 0.5 * best.error);
            let missed = found.value.error / found.value.value;
            accuracy =
                if missed.is_finite() { 0.3 * accuracy * asked / missed } else { 0.1 * accuracy }
                    .min(0.1 * accuracy);
            if best.is_none_or(|best| found.value.error < best.error) {
                best = Some(found.value);
            }
            if why == TOO_MANY {
                break;
            }
            if !gained || accuracy < 0.1 * f64::EPSILON {
                break;
            }
        }
        Err(Error::best_of("seminorm", asked, best, why))
    }

    fn by_graded_cells(&self, fit: &Fit, order: Order, tolerance: Tolerance) -> Result<Found> {
        let (mut cells, mut slack) = (Vec::new(), Vec::new());
        let (mut is_rough, mut is_endless) = (false, false);
        for (k, arm) in self.arms().iter().enumerate() {
            let (mut found, rough) = self.graded_cells(k, arm, fit)?;
            is_rough |= rough;
            is_endless |= found[0].rest > 0.0;
            slack.push(found[0].slack(arm, fit.degree));
            if arm.sign < 0.0 {
                found.reverse();
            }
            cells.push(found);
        }
        let mut flat: Vec<Cell> = Vec::with_capacity(cells.iter().map(Vec::len).sum());
        for (k, arm) in cells.into_iter().enumerate() {
            let start = flat.len();
            flat.extend(arm);
            if k > 0 {
                let (left, right) = (flat[start - 1].piece.right, flat[start].piece.left);
                if k % 2 == 1 || (left - right).abs() <= slack[k - 1] + slack[k] {
                    // The limit on the longer scale: a step of its rounding error, seen from there, would outweigh a
                    // function that lives on the shorter one.
                    let limit = match slack[k - 1].total_cmp(&slack[k]) {
                        Ordering::Less => left,
                        Ordering::Equal => 0.5 * (left + right),
                        Ordering::Greater => right,
                    };
                    flat[start - 1].piece.right = limit;
                    flat[start].piece.left = limit;
                } else if is_endless && !order.is_below_half() {
                    return Err(Error::out_of_reach(
                        "seminorm",
                        tolerance.relative(),
                        f64::INFINITY,
                        ENDLESS,
                    ));
                }
            }
        }
        if is_rough && !order.is_below_half() {
            // A step there would make it infinite.
            return Err(Error::out_of_reach(
                "seminorm",
                tolerance.relative(),
                f64::INFINITY,
                UNDECLARED,
            ));
        }
        let (mut square, mut points) = (0.0, 0);
        let total = self.length();
        for cell in &flat {
            let (length, degree) = (cell.far - cell.near, cell.piece.degree());
            square += of_residual(fit.kernel, fit.degree, cell.residual / fit.size, length, total)
                + cell.rest;
            if is_rough && cell.residual > 0.0 && order.is_below_half() {
                // A step of this height within the cell.
                let step =
                    fit.kernel.scaling(length) * 4.0 / (fit.kernel.twice * fit.kernel.one_minus);
                square += step * (cell.residual / fit.size).powi(2);
            }
            let is_constant = cell.piece.bubbles.is_empty() && cell.piece.left == cell.piece.right;
            if !is_constant {
                let noise = NOISE * cell.piece.size() / fit.size;
                square += noise
                    * noise
                    * fit.kernel.scaling(length)
                    * (degree as f64).powf(fit.kernel.twice)
                    * (2.0 / fit.kernel.two_minus + 2.0 / fit.kernel.twice);
            }
            points += 3 * fit.degree as u64;
        }
        let lengths: Vec<f64> = flat.iter().map(|cell| cell.far - cell.near).collect();
        let ends: Vec<[f64; 2]> =
            flat.iter().map(|cell| [cell.piece.left, cell.piece.right]).collect();
        let coarse: Vec<Vec<f64>> = flat.iter().map(Cell::coarser).collect();
        let bubbles = flat.into_iter().map(|cell| cell.piece.bubbles).collect();
        let u = PiecewisePolynomial::with_bubbles(Mesh::from_lengths(&lengths)?, &ends, bubbles)?;
        let inner = Tolerance::new((0.3 * tolerance.relative()).max(1e-15))?;
        let found = Estimate::or_best(u.seminorm(order, inner))?;
        let bound = fit.size * square.sqrt();
        let error = if is_rough || is_endless || ends.len() > COMPARED {
            bound
        } else {
            let coarser = PiecewisePolynomial::with_bubbles(u.mesh().clone(), &ends, coarse)?;
            let coarser = Estimate::or_best(coarser.seminorm(order, inner))?;
            let second = if found.value > 0.0 { bound * (bound / found.value) } else { bound };
            bound.min((coarser.value - found.value).abs() + second + BELOW * fit.goal)
        };
        let work = Work { points: found.work.points + points, ..found.work };
        Ok(Found { value: Estimate::new(found.value, found.error + error, work)?, is_rough })
    }

    /// The cells of a side from its breakpoint outwards, and whether one of them is not resolved.
    fn graded_cells(&self, index: usize, arm: &Arm, fit: &Fit) -> Result<(Vec<Cell>, bool)> {
        let least = arm.delta(arm.depth);
        let (mut far, mut halvings) = (arm.length, Vec::new());
        // The end of the arm, halved until one polynomial is enough on all scales below.
        let end = loop {
            let cell = self.graded_cell(arm, fit, 0.0, far)?;
            let rest = self.rest(index, arm, fit, &cell);
            if rest == Some(0.0) && cell.residual <= fit.allowed(far) {
                break Cell { rest: 0.0, ..cell };
            }
            if 0.25 * far <= least {
                let residual = cell.residual;
                break Cell { rest: self.below(index, arm, fit, &cell), residual, ..cell };
            }
            halvings.push(far);
            far *= 0.5;
        };
        let (mut cells, mut is_rough) = (vec![end], false);
        for &outer in halvings.iter().rev() {
            let mut stack = vec![(0.5 * outer, outer, 0)];
            while let Some((near, far, count)) = stack.pop() {
                let cell = self.graded_cell(arm, fit, near, far)?;
                let fits = cell.residual <= fit.allowed(far - near);
                let short = far - near
                    <= 8.0 * f64::EPSILON * (far + self.coordinate_if_seen(arm.anchor).abs());
                if fits || count == HALVINGS || short {
                    is_rough |= !fits;
                    cells.push(cell);
                    if cells.len() > MOST {
                        return Err(Error::out_of_reach(
                            "seminorm",
                            fit.goal,
                            f64::INFINITY,
                            TOO_MANY,
                        ));
                    }
                } else {
                    let middle = 0.5 * (near + far);
                    stack.extend([(middle, far, count + 1), (near, middle, count + 1)]);
                }
            }
        }
        Ok((cells, is_rough))
    }

    /// Zero if all samples below a cell at the breakpoint are within the allowed error, else `None`.
    fn rest(&self, index: usize, arm: &Arm, fit: &Fit, cell: &Cell) -> Option<f64> {
        let at_break = if arm.sign > 0.0 { cell.piece.left } else { cell.piece.right };
        let mut inside = fit.profile.samples(index).filter(|(delta, _)| *delta < cell.far);
        let fits = inside.all(|(delta, value)| {
            // p is rounded less close to the break.
            let size = value.abs() + at_break.abs() + delta / cell.far * cell.piece.size();
            (value - cell.value(arm, delta)).abs() <= fit.allowed(delta).max(FLOOR * size)
        });
        fits.then_some(0.0)
    }

    /// Σ ε² δ^{1−2ν} / |u|²_ν over the samples below such a cell, times a factor that depends on ν, continued
    /// by a geometric series below the last sample.
    fn below(&self, index: usize, arm: &Arm, fit: &Fit, cell: &Cell) -> f64 {
        let kernel = fit.kernel;
        let factor = 16.0 * (1.0 / kernel.twice + 1.0 / kernel.two_minus);
        let (mut sum, mut last, mut ratio) = (0.0, 0.0_f64, 0.5_f64);
        for (delta, value) in
            fit.profile.samples(index).filter(|(delta, _)| *delta < 4.0 * cell.far)
        {
            let share = ((value - cell.value(arm, delta.min(cell.far))) / fit.size).powi(2)
                * kernel.scaling(delta);
            ratio = if last > 0.0 { share / last } else { 0.5 };
            (sum, last) = (sum + share, share);
        }
        factor * (sum + last * ratio / (1.0 - ratio.min(0.99)))
    }

    fn graded_cell(&self, arm: &Arm, fit: &Fit, near: f64, far: f64) -> Result<Cell> {
        let least = arm.delta(arm.depth);
        let value = |delta: f64| self.at(arm, delta.max(least));
        let length = far - near;
        let local = |t: f64| if arm.sign > 0.0 { near + length * t } else { far - length * t };
        let (at_near, at_far) = (value(near)?, value(far)?);
        let ends = if arm.sign > 0.0 { [at_near, at_far] } else { [at_far, at_near] };
        let fault = std::cell::RefCell::new(None);
        let seen = |t: f64| {
            value(local(t)).unwrap_or_else(|error| {
                fault.borrow_mut().get_or_insert(error);
                0.0
            })
        };
        let mut piece =
            Piece { left: ends[0], right: ends[1], bubbles: bubbles_of(fit.degree, ends, seen)? };
        let (mut places, mut values) = self.seen_in_cell(arm, near, far);
        places.extend(fit.between.points());
        values.extend(fit.between.points().iter().map(|&t| seen(t)));
        let bounds = values.iter().fold(ends, |[low, high], &v| [low.min(v), high.max(v)]);
        let (low, high) = (bounds[0].min(ends[1]), bounds[1].max(ends[0]));
        let off = |piece: &Piece| {
            values.iter().zip(piece.values(&places)).map(|(v, p)| (v - p).abs()).fold(0.0, f64::max)
        };
        // Rounding of a straight line is no bubble.
        let line = Piece { left: ends[0], right: ends[1], bubbles: Vec::new() };
        let mut residual = off(&line);
        if residual > STRAIGHT * low.abs().max(high.abs()) {
            residual = off(&piece);
        } else {
            piece = line;
        }
        // What x is rounded by moves a value along a slope, which may overflow where x is not rounded; a step is no
        // slope.
        let rounded = self.coordinate_if_seen(arm.anchor).abs() / length;
        let moved = (FLOOR * rounded).min(MOVED) * (high - low);
        let noise = FLOOR * low.abs().max(high.abs()) + moved;
        match fault.into_inner() {
            Some(error) => Err(error),
            None => Ok(Cell {
                near,
                far,
                piece,
                residual: UNSEEN * (residual - noise).max(0.0),
                rest: 0.0,
            }),
        }
    }
}

impl Cell {
    /// The bubbles of a polynomial whose error is larger by the factor COARSER, or a linear function.
    fn coarser(&self) -> Vec<f64> {
        let (mut bubbles, mut cut) = (self.piece.bubbles.clone(), 0.0);
        while cut < COARSER * self.residual
            && let Some(last) = bubbles.pop()
        {
            // |t (1 − t) P_k(2t − 1)| ≤ 1/4
            cut += 0.25 * last.abs();
        }
        bubbles
    }

    /// The value of p at δ.
    fn value(&self, arm: &Arm, delta: f64) -> f64 {
        let t = (delta - self.near) / (self.far - self.near);
        self.piece.value(if arm.sign > 0.0 { t } else { 1.0 - t })
    }

    /// A bound of the difference between the value at the breakpoint and the limit there.
    fn slack(&self, arm: &Arm, degree: usize) -> f64 {
        let size = self.piece.size();
        let slope = 2.0 * (degree * degree) as f64 * size / (self.far - self.near);
        FLOOR * size + slope * (arm.delta(arm.depth) + 16.0 * arm.blur)
    }
}
