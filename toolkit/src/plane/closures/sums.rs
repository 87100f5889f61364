//! |w|²_s of a function given by code, as a sum over pairs of triangles, each computed by rules of increasing
//! order until it converges.
//!
//! Pairs with a common corner are treated by [`super::fan`], seen from a declared corner if both triangles have
//! it; a triangle at a declared corner that touches another one elsewhere is subdivided first. The radial rule
//! at a declared corner is chosen once: at a few points (t, t', τ) the radial integral with cells down to
//! e^{-230} is compared with shorter rules, and the shortest rule that agrees is used.

use super::apart::Apart;
use super::fan::{Contact, Fan};
use super::piece::{Piece, View};
use super::radial::{self, Approach};
use super::side::Side;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};
use crate::numeric::parallel;
use crate::numeric::sum::compensated;
use crate::order::Order;
use crate::plane::kernel::InversePower;
use crate::root::ENTRY_ROUNDING;
use std::sync::atomic::{AtomicU64, Ordering};

/// Successive numbers of points of the rules.
const POINTS: [usize; 6] = [4, 6, 9, 13, 18, 24];
/// Points and cells of the radial rules at a corner, from the shortest to the longest; 92 cells reach 1e-100.
const SHORT: [usize; 4] = [2, 4, 7, 12];
const CELLS: [usize; 7] = [1, 3, 7, 15, 30, 55, 92];
const CELL_POINTS: [usize; 3] = [6, 9, 13];
/// Points (t, t', τ) at which radial rules are compared.
const PROBES: [[f64; 3]; 5] =
    [[0.5, 0.5, 0.4], [0.1, 0.8, 0.7], [0.9, 0.3, 0.2], [0.3, 0.4, 0.9], [0.6, 0.05, 0.05]];
/// Part of the tolerance that is allowed for the radial rule and the depths.
const PART: f64 = 1e-2;
/// Value of x from which e^{-x} is negligible.
const NOTHING: f64 = 40.0;
/// Smallest accepted ratio of successive changes, and of an error to a change.
const LEAST_CHANGE: f64 = 2e-3;
const LEAST: f64 = 0.1;

/// A pair of pieces: how often it is counted, and where the pieces meet.
struct Task {
    times: f64,
    pieces: [Piece; 2],
    /// Positions of the common corner P, and of a second one.
    meeting: Option<([usize; 2], Option<[usize; 2]>)>,
}

/// A value with its error.
#[derive(Clone, Copy)]
struct Found {
    value: f64,
    change: f64,
    error: f64,
    level: usize,
    work: Work,
}

/// The sums for one function and one order.
pub(super) struct ClosureSum<'a> {
    view: View<'a>,
    order: Order,
    kernel: InversePower,
    /// Requested relative accuracy of the square.
    accuracy: f64,
    /// Limit for the number of evaluations of the function.
    work: u64,
    approaches: Vec<Approach>,
    /// Error of the radial rules, relative to the whole.
    radial_error: f64,
}

/// The quantity integrated along rays from a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    Seminorm,
    Square,
}

impl<'a> ClosureSum<'a> {
    pub(super) fn new(
        view: View<'a>,
        order: Order,
        tolerance: Tolerance,
        quantity: Quantity,
    ) -> Result<Self> {
        let kernel = InversePower::new(1.0 + order.value());
        let (accuracy, work) = (tolerance.relative(), tolerance.work());
        let mut sum =
            Self { view, order, kernel, accuracy, work, approaches: Vec::new(), radial_error: 0.0 };
        let pieces = view.pieces();
        for corner in 0..view.function.corners().all.len() {
            let (approach, error) = sum.approach_of(corner, &pieces, quantity)?;
            sum.approaches.push(approach);
            sum.radial_error = sum.radial_error.max(error);
        }
        Ok(sum)
    }

    /// |w|²_s in units.
    pub(super) fn seminorm(&self) -> Result<Estimate> {
        let pieces = self.view.pieces();
        let mut tasks = Vec::new();
        for (i, a) in pieces.iter().enumerate() {
            tasks.push(self.alone(a));
            pieces[i + 1..].iter().for_each(|b| self.together(a, b, &mut tasks));
        }
        let Estimate { value, error, work } =
            self.settled(&tasks, |task, level| self.integral(task, level))?;
        let exponents = || self.view.function.corners().all.iter().map(|corner| corner.exponent);
        let gap = exponents().fold(1.0, |gap: f64, a| gap.min(a + self.order.complement()));
        let left_out = |sum: f64, a: f64| sum + radial::left_out(self.digits(), a);
        let relative = self.radial_error + f64::EPSILON / gap + exponents().fold(0.0, left_out);
        Estimate::new(value, error + relative * value, work)
    }

    /// ∫ w² in units.
    pub(super) fn square(&self) -> Result<Estimate> {
        let Estimate { value, error, work } =
            self.settled(&self.view.pieces(), |piece, level| {
                let mut work = 0;
                let value =
                    self.apart(level).square(piece, self.approach(piece, level), &mut work)?;
                Ok((value, work))
            })?;
        Estimate::new(value, error + self.radial_error * value, work)
    }

    /// The sum of parts, each refined until its change is a small part of the whole.
    fn settled<T: Sync>(
        &self,
        parts: &[T],
        integral: impl Fn(&T, usize) -> Result<(f64, u64)> + Sync,
    ) -> Result<Estimate> {
        let spent = AtomicU64::new(0);
        let evaluate = |part: &T, before: Option<Found>| -> Result<Found> {
            let level = before.map_or(0, |found| found.level + 1);
            if spent.load(Ordering::Relaxed) > self.work {
                // A part that was seen once is of the size that was seen, no more is known.
                let reason = || Error::out_of_reach("norm", self.accuracy, f64::INFINITY, SPENT);
                return before
                    .map(|found| Found {
                        error: found.error.min(found.value.abs()),
                        level,
                        ..found
                    })
                    .ok_or_else(reason);
            }
            let (value, points) = integral(part, level)?;
            spent.fetch_add(points, Ordering::Relaxed);
            let mut work = Work { points, pairs: 1, ..Work::default() };
            let (mut change, mut error) = (f64::INFINITY, f64::INFINITY);
            if let Some(found) = before {
                change = (value - found.value).abs();
                // Rules converge faster and faster; a change that is small by accident is not believed.
                let believed = change.max(LEAST_CHANGE * found.change.min(value.abs()));
                let falls = if found.change.is_finite() && believed > 0.0 {
                    believed / found.change
                } else {
                    1.0
                };
                error = believed * falls.sqrt().clamp(LEAST, 1.0);
                work += found.work;
            }
            Ok(Found { value, change, error, level, work })
        };
        let start = parallel::over(parts, |part| evaluate(part, None))
            .into_iter()
            .collect::<Result<Vec<_>>>()?;
        let whole = compensated(start.iter().map(|found| found.value));
        // Nothing is refined where the radial rules do not reach the tolerance.
        let levels = if self.radial_error > self.accuracy { 2 } else { POINTS.len() };
        let share = 0.3 * self.accuracy * whole;
        let refine = |k: usize| -> Result<Found> {
            let (part, mut found) = (&parts[k], evaluate(&parts[k], Some(start[k]))?);
            while found.level + 1 < levels && found.error > share / (parts.len() as f64).sqrt() {
                found = evaluate(part, Some(found))?;
            }
            Ok(found)
        };
        let found = parallel::map(parts.len(), &refine).into_iter().collect::<Result<Vec<_>>>()?;
        let value = compensated(found.iter().map(|found| found.value));
        let error = found.iter().map(|found| found.error).sum::<f64>();
        let work = found.iter().fold(Work::default(), |work, found| work + found.work);
        Estimate::new(value, error + ENTRY_ROUNDING * value, work)
    }

    fn digits(&self) -> f64 {
        (-(PART * PART * self.accuracy).ln()).min(NOTHING)
    }

    fn apart(&self, level: usize) -> Apart<'_> {
        let (view, kernel, digits) = (&self.view, &self.kernel, self.digits());
        Apart { view, kernel, power: 1.0 + self.order.value(), points: POINTS[level], digits }
    }

    /// The radial rule at the corner of a piece, longer at higher levels; a single rule if the function is
    /// smooth there.
    fn approach(&self, piece: &Piece, level: usize) -> Approach {
        match piece.corner().map(|corner| self.approaches[corner]) {
            Some(short) => longer(short, level),
            None => Approach { cells: 0, points: POINTS[level] },
        }
    }

    /// The exponent of differences at a corner of a piece.
    fn exponent(&self, piece: &Piece) -> f64 {
        let declared = if piece.is_singular { self.view.exponent(piece) } else { 1.0 };
        if self.view.function.jumps() { declared.min(0.0) } else { declared }
    }

    /// The shortest radial rule at a corner that agrees with the longest one at all probe points, and its
    /// error; if there is none, the longest one and its difference from a shorter one.
    fn approach_of(
        &self,
        corner: usize,
        pieces: &[Piece],
        quantity: Quantity,
    ) -> Result<(Approach, f64)> {
        let fan: Vec<&Piece> =
            pieces.iter().filter(|piece| piece.corner() == Some(corner)).collect();
        let sides: Vec<Side<'_>> =
            fan.iter().flat_map(|piece| Side::of(&self.view, piece, 0, 1, 1.0)).collect();
        let probes = |approach: Approach| -> Result<Vec<f64>> {
            let rule = match quantity {
                Quantity::Seminorm => {
                    radial::for_differences(self.order, self.exponent(fan[0]), approach)?
                }
                Quantity::Square => radial::rule(2.0, 2.0 * self.view.exponent(fan[0]), approach)?,
            };
            let pairs = sides.iter().enumerate().flat_map(|(i, x)| {
                let y = &sides[(i * 7 + 1) % sides.len()];
                PROBES.iter().map(move |probe| (x, y, *probe))
            });
            let value = |(x, y, [t, r, tau]): (&Side<'_>, &Side<'_>, [f64; 3])| match quantity {
                Quantity::Seminorm => x.radial(y, &rule, [t, r, tau]),
                Quantity::Square => x.radial_square(&rule, t),
            };
            Ok(pairs.map(value).collect())
        };
        let short = SHORT.map(|points| Approach { cells: 0, points });
        let cells = |&points: &usize| CELLS.map(|cells| Approach { cells, points });
        let mut all: Vec<Approach> =
            short.into_iter().chain(CELL_POINTS.iter().flat_map(cells)).collect();
        all.sort_by_key(|approach| (approach.cells + 1) * approach.points);
        let longest = all[all.len() - 1];
        let deep = probes(longer(longest, 3))?;
        let largest = deep.iter().fold(f64::MIN_POSITIVE, |largest, value| largest.max(*value));
        let off = |approach: Approach| -> Result<f64> {
            let found = probes(approach)?;
            let differences = found.iter().zip(&deep).map(|(a, b)| (a - b).abs() / largest);
            Ok(differences.fold(0.0, f64::max))
        };
        for approach in all {
            if off(approach)? <= PART * self.accuracy {
                return Ok((approach, PART * self.accuracy));
            }
        }
        Ok((longest, off(Approach { cells: longest.cells / 2, ..longest })?))
    }

    fn alone(&self, piece: &Piece) -> Task {
        let vertex = if piece.is_singular { 0 } else { piece.sharpest() };
        Task { times: 1.0, pieces: [*piece; 2], meeting: Some(([vertex; 2], None)) }
    }

    /// The pairs into which two different pieces are subdivided.
    fn together(&self, a: &Piece, b: &Piece, tasks: &mut Vec<Task>) {
        let shared = a.shared(b);
        let is_fan = a.corner().is_some() && a.corner() == b.corner();
        if shared.is_empty() || is_fan || !(a.is_singular || b.is_singular) {
            let sharp = |&[i, j]: &[usize; 2]| a.cosine(i).min(b.cosine(j));
            let corner = shared.iter().position(|at| is_fan && at[0] == 0);
            let best =
                (0..shared.len()).max_by(|i, j| sharp(&shared[*i]).total_cmp(&sharp(&shared[*j])));
            let meeting = corner.or(best).map(|k| {
                let other = (shared.len() > 1).then(|| shared[1 - k]);
                (shared[k], other)
            });
            tasks.push(Task { times: 2.0, pieces: [*a, *b], meeting });
        } else if a.is_singular {
            a.parts().iter().for_each(|part| self.together(part, b, tasks));
        } else {
            b.parts().iter().for_each(|part| self.together(a, part, tasks));
        }
    }

    fn integral(&self, task: &Task, level: usize) -> Result<(f64, u64)> {
        let ([a, b], mut work) = (&task.pieces, 0);
        let Some(([i, j], other)) = task.meeting else {
            return Ok((task.times * self.apart(level).pair(a, b, &mut work)?, work));
        };
        let exponent = self.exponent(a);
        let radial = radial::for_differences(self.order, exponent, self.approach(a, level))?;
        let depth = a.is_singular.then(|| radial::depth(self.digits() + level as f64, exponent));
        let fan = Fan {
            order: self.order,
            kernel: &self.kernel,
            points: POINTS[level],
            radial: &radial,
            depth,
            jumps: self.view.function.jumps(),
        };
        let unit = a.size();
        let contact = match other {
            _ if task.times == 1.0 => Contact::Same,
            Some(_) => Contact::Edge,
            None => Contact::Corner,
        };
        let [p, q] = other.unwrap_or([(i + 1) % 3, (j + 1) % 3]);
        let (first, second) =
            (Side::of(&self.view, a, i, p, unit), Side::of(&self.view, b, j, q, unit));
        let value = fan.pair(&first, &second, contact, &mut work)?;
        Ok((task.times * unit.powf(2.0 * self.order.complement()) * value, work))
    }
}

/// A radial rule with more cells, if any, and more points.
fn longer(Approach { cells, points }: Approach, level: usize) -> Approach {
    Approach {
        cells: if cells > 0 { cells + level } else { 0 },
        points: points + level.div_ceil(2),
    }
}
