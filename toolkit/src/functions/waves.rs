//! Functions with many oscillations between their breakpoints, as piecewise polynomials.
//!
//! Each half of an interval between breakpoints is bisected until a polynomial p of degree d agrees with the
//! function on every cell K: ε_K = max |u − p| at points between those of p. Where this requires many cells of
//! comparable lengths, the rules in logarithmic coordinates ([`super::log_energy`]) would need as many cells in
//! each of two variables, and |p|_ν is computed instead ([`PiecewisePolynomial::seminorm`], O(cells)).
//!
//! The error is | |u|_ν − |p|_ν | ≤ |u − p|_ν, bounded in [`super::resolution`].
//!
//! Cells that shrink geometrically towards a point indicate that u is not smooth there: the rules in
//! logarithmic coordinates are used for such functions. Cost: 3d values of u per cell.

use super::arm::Arm;
use super::function::SingularFunction;
use super::look::Look;
use super::resolution::of_residual;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::order::Order;
use crate::piecewise::{Piece, PiecewisePolynomial, bubbles_of};
use crate::quadrature::Rule;

/// Number of cells from which a function counts as oscillating.
const MANY: usize = 32;
/// Number of cells of one side above which the finest rules in logarithmic coordinates do not resolve them.
const BEYOND_RULES: usize = 512;
/// Largest number of cells, each with 3 d values and about 100 stored numbers.
const MOST: usize = 1 << 17;
/// Largest number of bisections of a side.
const DEEPEST: u32 = 40;
/// Cells count as graded if one of them has a cell GRADED times as long within REACH times its own length.
const GRADED: f64 = 8.0;
const REACH: f64 = 64.0;
/// Ratio of the cell at a breakpoint to the shortest cell, unless the latter lies at the breakpoint.
const INSIDE: f64 = 4.0;
/// Ratio of the distance of a cell from the breakpoint to its length, above which its structure lies inside.
const NARROW: f64 = 16.0;
/// Bound of the ratio of the largest residual to the largest residual at the points of a rule.
const UNSEEN: f64 = 2.0;
/// Number of refinement rounds, each to a tenth of the error of the previous one or less.
const ROUNDS: usize = 4;
/// Rounding error of values of size 1.
const FLOOR: f64 = 64.0 * f64::EPSILON;

/// Message: the oscillations are not resolved.
const TOO_MANY: &str =
    "the structure of the function between its breakpoints is not resolved by 131072 cells";
/// Message: the oscillations are not resolved to the tolerance.
const LIMIT: &str = "rounding of the values dominates the error";

/// The classification of a function by its cells.
pub(super) enum Waves {
    /// Few cells, or cells that shrink towards a breakpoint.
    None,
    /// Cells that shrink towards a point between the breakpoints.
    Inside,
    /// Resolved by more cells than the rules in logarithmic coordinates resolve.
    Resolved(Box<Resolved>),
    /// More oscillations than any method here resolves.
    TooMany,
}

/// The seminorm of a function with many oscillations, or the location of its structure.
pub(super) enum OfWaves {
    Found(Estimate),
    AtBreaks,
    Inside,
}

/// A function with its polynomials.
pub(super) struct Resolved {
    u: PiecewisePolynomial,
    degree: usize,
    /// ε_K of every cell
    residuals: Vec<f64>,
    points: u64,
}

/// A cell of a side: its distances from the breakpoint, end values, polynomial and residual.
struct Cell {
    near: f64,
    far: f64,
    /// u at both ends, from left to right
    ends: [f64; 2],
    bubbles: Vec<f64>,
    residual: f64,
    /// rounding error of the residuals, from the rounding of x and of u
    noise: f64,
}

/// The rules for polynomials of one degree and for the residual.
struct Fit {
    degree: usize,
    accuracy: f64,
    between: Rule,
}

impl Fit {
    fn to(accuracy: f64) -> Result<Self> {
        let degree = ((4.0 - 1.1 * accuracy.log10()).ceil() as usize).clamp(6, 18);
        Ok(Self { degree, accuracy, between: Rule::gauss_legendre(2 * degree)? })
    }
}

impl SingularFunction<'_> {
    /// |u|_ν of a function of size 1 with many oscillations; for all others the location of their
    /// structure.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`], [`Error::InfiniteNorm`] if it jumps at a breakpoint and ν ≥ 1/2.
    pub(super) fn seminorm_of_waves(&self, order: Order, tolerance: Tolerance) -> Result<OfWaves> {
        let asked = tolerance.relative();
        let mut best: Option<Estimate> = None;
        // A cell of about a wave: |e|_ν/|u|_ν is about ε (D/6)^ν.
        let mut accuracy = 0.1 * asked * 0.03f64.powf(order.value());
        for _ in 0..ROUNDS {
            let waves = match self.waves(accuracy.max(FLOOR), MOST) {
                Err(_) if best.is_some() && self.work_left() == 0 => {
                    return Err(Error::best_of("seminorm", asked, best, SPENT));
                }
                other => other?,
            };
            let resolved = match (waves.0, &best) {
                (Waves::Resolved(resolved), _) => resolved,
                (Waves::None, None) => return Ok(OfWaves::AtBreaks),
                (Waves::Inside, None) => return Ok(OfWaves::Inside),
                (Waves::TooMany, None) => {
                    return Err(Error::out_of_reach("seminorm", asked, f64::INFINITY, TOO_MANY));
                }
                _ => break,
            };
            let found = resolved.seminorm(order, tolerance)?;
            if found.relative_error() <= asked {
                return Ok(OfWaves::Found(found));
            }
            let gained = best.is_none_or(|best| found.error < 0.5 * best.error);
            accuracy = (0.3 * accuracy * asked / found.relative_error()).min(0.1 * accuracy);
            if best.is_none_or(|best| found.error < best.error) {
                best = Some(found);
            }
            if !gained || accuracy < FLOOR {
                break;
            }
        }
        Err(Error::best_of("seminorm", asked, best, LIMIT))
    }

    /// The L² norm of a function of size 1 with many oscillations, if it is one, and the cells of the function.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`].
    pub(super) fn l2_norm_of_waves(
        &self,
        tolerance: Tolerance,
    ) -> Result<(Option<Estimate>, Look)> {
        let (waves, mut look) = self.waves((0.1 * tolerance.relative()).max(FLOOR), MOST)?;
        look.is_inside |= matches!(waves, Waves::Inside);
        let found = match waves {
            Waves::Resolved(resolved) => Some(resolved.l2_norm()?),
            Waves::Inside | Waves::None | Waves::TooMany => None,
        };
        Ok((found, look))
    }

    /// The cells of the function at a tolerance; none where thousands of cells do not resolve it.
    ///
    /// # Errors
    /// Those of the values.
    pub(crate) fn looked(&self, tolerance: Tolerance) -> Result<Look> {
        let most = BEYOND_RULES * self.breaks().len();
        Ok(self.waves((0.1 * tolerance.relative()).max(FLOOR), most)?.1)
    }

    /// The classification of the function by polynomials that agree with it to the given accuracy, on at most `most`
    /// cells, with these cells.
    fn waves(&self, accuracy: f64, most: usize) -> Result<(Waves, Look)> {
        let fit = Fit::to(accuracy)?;
        let (mut cells, mut slack) = (Vec::new(), Vec::new());
        let (mut is_smooth, mut is_inside, mut look) = (true, false, Look::default());
        for arm in self.arms() {
            let Some((mut found, all)) = self.cells_of(&arm, &fit, most - cells.len().min(most))?
            else {
                return Ok((if is_smooth { Waves::TooMany } else { Waves::None }, Look::default()));
            };
            let ends = std::iter::once(0.0).chain(found.iter().map(|cell| cell.far));
            look.push(&ends.collect::<Vec<f64>>());
            is_smooth &= all;
            is_inside |= shrinks_inside(&found);
            if arm.sign < 0.0 {
                found.reverse();
            }
            let at_break = if arm.sign < 0.0 { found.len() - 1 } else { 0 };
            slack.push(found[at_break].slack(&arm, fit.degree));
            cells.push(found);
        }
        let count: usize = cells.iter().map(Vec::len).sum();
        if is_inside && (!is_smooth || count < MANY) {
            return Ok((Waves::Inside, look));
        }
        if count < MANY {
            return Ok((Waves::None, look));
        }
        let mut flat: Vec<Cell> = Vec::with_capacity(count);
        for (k, arm) in cells.into_iter().enumerate() {
            let start = flat.len();
            flat.extend(arm);
            // Where two arms meet: in the middle of an interval the value is the same, at a break its limits.
            if k > 0 {
                let (left, right) = (flat[start - 1].ends[1], flat[start].ends[0]);
                if k % 2 == 1 || (left - right).abs() <= slack[k - 1] + slack[k] {
                    let mean = 0.5 * (left + right);
                    flat[start - 1].ends[1] = mean;
                    flat[start].ends[0] = mean;
                }
            }
        }
        if !is_smooth || is_graded(&flat) {
            let waves = if is_inside {
                Waves::Inside
            } else if count > BEYOND_RULES * self.breaks().len() {
                Waves::TooMany
            } else {
                Waves::None
            };
            return Ok((waves, look));
        }
        let lengths: Vec<f64> = flat.iter().map(|cell| cell.far - cell.near).collect();
        let ends: Vec<[f64; 2]> = flat.iter().map(|cell| cell.ends).collect();
        let residuals = flat.iter().map(|cell| cell.residual).collect();
        let points = 3 * (fit.degree * count) as u64;
        let bubbles = flat.into_iter().map(|cell| cell.bubbles).collect();
        let u = PiecewisePolynomial::with_bubbles(Mesh::from_lengths(&lengths)?, &ends, bubbles)?;
        Ok((Waves::Resolved(Box::new(Resolved { u, degree: fit.degree, residuals, points })), look))
    }

    /// The cells of a side from its breakpoint outwards, and whether all are resolved; `None` if there are more
    /// than `most`.
    fn cells_of(&self, arm: &Arm, fit: &Fit, most: usize) -> Result<Option<(Vec<Cell>, bool)>> {
        let mut cells = Vec::new();
        let mut is_resolved = true;
        // Nearest to the break on top.
        let mut stack = vec![(0.0, arm.length, 0)];
        while let Some((near, far, halvings)) = stack.pop() {
            let cell = self.cell(arm, fit, near, far)?;
            let is_fitted = cell.residual <= fit.accuracy.max(cell.noise);
            if is_fitted || halvings == DEEPEST {
                is_resolved &= is_fitted;
                cells.push(cell);
                if cells.len() > most {
                    return Ok(None);
                }
            } else {
                let middle = 0.5 * (near + far);
                stack.extend([(middle, far, halvings + 1), (near, middle, halvings + 1)]);
            }
        }
        Ok(Some((cells, is_resolved)))
    }

    fn cell(&self, arm: &Arm, fit: &Fit, near: f64, far: f64) -> Result<Cell> {
        let least = arm.delta(arm.depth);
        let value = |delta: f64| self.at(arm, delta.max(least));
        let local =
            |t: f64| if arm.sign > 0.0 { near + (far - near) * t } else { far - (far - near) * t };
        let ends = [value(local(0.0))?, value(local(1.0))?];
        let fault = std::cell::RefCell::new(None);
        let seen = |t: f64| {
            value(local(t)).unwrap_or_else(|error| {
                fault.borrow_mut().get_or_insert(error);
                0.0
            })
        };
        let bubbles = bubbles_of(fit.degree, ends, seen)?;
        let piece = Piece { left: ends[0], right: ends[1], bubbles };
        let (mut residual, mut low, mut high) =
            (0.0_f64, ends[0].min(ends[1]), ends[0].max(ends[1]));
        let between = fit.between.points();
        for (&t, of_piece) in between.iter().zip(piece.values(between)) {
            let found = seen(t);
            residual = residual.max((found - of_piece).abs());
            (low, high) = (low.min(found), high.max(found));
        }
        let noise = |low: f64, high: f64| {
            let slope = (high - low) / (far - near);
            FLOOR * (low.abs().max(high.abs()) + slope * (arm.start.abs() + far))
        };
        // A cell that is bisected for its points between need not be compared with the samples.
        if UNSEEN * residual <= fit.accuracy.max(noise(low, high)) {
            let (places, samples) = self.seen_in_cell(arm, near, far);
            for (found, value) in samples.iter().zip(piece.values(&places)) {
                residual = residual.max((found - value).abs());
                (low, high) = (low.min(*found), high.max(*found));
            }
        }
        let (residual, noise) = (UNSEEN * residual, noise(low, high));
        match fault.into_inner() {
            Some(error) => Err(error),
            None => Ok(Cell { near, far, ends, bubbles: piece.bubbles, residual, noise }),
        }
    }
}

impl Cell {
    /// A bound of the difference between the value at the breakpoint and the limit there, from the distance of
    /// evaluation and the rounding of x.
    fn slack(&self, arm: &Arm, degree: usize) -> f64 {
        let size = self.ends[0].abs().max(self.ends[1].abs()).max(1.0);
        let slope = 2.0 * (degree * degree) as f64 * size / (self.far - self.near);
        FLOOR * size + slope * (arm.delta(arm.depth) + 16.0 * f64::EPSILON * arm.start.abs())
    }
}

/// True if the shortest cell of a side is not the one at its breakpoint, or some cell is narrow.
fn shrinks_inside(cells: &[Cell]) -> bool {
    let length = |cell: &Cell| cell.far - cell.near;
    let shortest = cells.iter().map(length).fold(f64::INFINITY, f64::min);
    let is_narrow = |cell: &Cell| NARROW * length(cell) < cell.near;
    length(&cells[0]) >= INSIDE * shortest || cells.iter().any(is_narrow)
}

/// True if cells shrink geometrically somewhere.
fn is_graded(cells: &[Cell]) -> bool {
    let length = |k: usize| cells[k].far - cells[k].near;
    let sees_long = |from: usize, others: &mut dyn Iterator<Item = usize>| {
        let own = length(from);
        let mut distance = 0.0;
        for k in others {
            if length(k) >= GRADED * own {
                return true;
            }
            distance += length(k);
            if distance > REACH * own {
                break;
            }
        }
        false
    };
    (0..cells.len())
        .any(|k| sees_long(k, &mut (0..k).rev()) || sees_long(k, &mut (k + 1..cells.len())))
}

impl Resolved {
    fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let found = Estimate::or_best(self.u.seminorm(order, tolerance))?;
        let work = Work { points: found.work.points + self.points, ..found.work };
        Estimate::new(found.value, found.error + self.error(order), work)
    }

    fn l2_norm(&self) -> Result<Estimate> {
        let found = self.u.l2_norm()?;
        let squares = self.residuals.iter().zip(self.u.mesh().lengths());
        let error = squares.map(|(e, h)| h * e * e).sum::<f64>().sqrt();
        Estimate::new(found.value, found.error + error, found.work)
    }

    /// The bound of |e|_ν.
    fn error(&self, order: Order) -> f64 {
        let (kernel, total) = (PowerKernel::new(order), self.u.mesh().total());
        let squares =
            self.residuals.iter().zip(self.u.mesh().lengths()).map(|(residual, &length)| {
                of_residual(kernel, self.degree, residual + 4.0 * f64::EPSILON, length, total)
            });
        squares.sum::<f64>().sqrt()
    }
}
