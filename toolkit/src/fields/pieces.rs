//! L^q norms and dual norms of u − u_h: cell by cell away from the breakpoints, and the patches of the
//! breakpoints.

use super::cells::{Content, FieldCells};
use super::fit::Difference;
use super::norms::{FieldError, LIMIT, l2};
use super::patch::patch;
use crate::dual::DualOf;
use crate::dual::closure::Interpolant;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::functions::{Look, Normalized, SingularFunction};
use crate::mesh::Mesh;
use crate::order::Order;
use crate::piecewise::PiecewisePolynomial;
use crate::root::accept;

/// Ratio of the accuracy of the cells to that of a dual norm: an oscillating error has a dual norm much smaller
/// than its L² norm, in which the remainder on the cells is measured.
const OF_CELLS: f64 = 1e-3;
/// Smallest tolerance of the cells.
const LEAST: f64 = 1e-14;
/// Degree of the polynomials in a patch.
const DEGREE: usize = 18;

/// A piece of u − u_h, from left to right.
enum Part<'a> {
    /// length, polynomial by end values and bubbles, and its error
    Cell(f64, [f64; 2], &'a [f64], f64),
    Patch(SingularFunction<'a>),
}

impl FieldError<'_> {
    /// The norm ||u − u_h||\_{L^q}, 1 ≤ q ≤ ∞. At q = ∞ the maximum between the points of a patch is estimated
    /// as in [`SingularFunction::lq_norm`].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q < 1 or NaN, else as [`FieldError::l2_norm`].
    pub(crate) fn lq_norm(&self, q: f64, tolerance: Tolerance) -> Result<Estimate> {
        Error::require("q", q, "[1, inf]", q >= 1.0)?;
        let (Normalized { units, u }, field) = self.normalized(tolerance)?;
        let difference = Difference { function: &u, field: &field };
        let cells = FieldCells::new(&difference, 0.1 * tolerance.relative())?;
        let (mut lengths, mut ends, mut bubbles) = (Vec::new(), Vec::new(), Vec::new());
        let (mut found, mut left) = (Vec::new(), Vec::new());
        for part in parts(&cells, &difference)? {
            match part {
                Part::Cell(length, pair, inside, off) => {
                    lengths.push(length);
                    ends.push(pair);
                    bubbles.push(inside.to_vec());
                    left.push((length, off));
                }
                Part::Patch(function) => {
                    found.push(Estimate::or_best(function.lq_norm(q, tolerance))?)
                }
            }
        }
        if !lengths.is_empty() {
            let smooth =
                PiecewisePolynomial::with_bubbles(Mesh::from_lengths(&lengths)?, &ends, bubbles)?;
            found.push(Estimate::or_best(smooth.lq_norm(q, tolerance))?);
        }
        let largest = found.iter().map(|e| e.value).fold(0.0, f64::max);
        let worst = left.iter().map(|(_, off)| *off).fold(0.0, f64::max);
        // Minkowski: errors of parts, and what polynomials leave, add up at most.
        let join = |of: &mut dyn Iterator<Item = (f64, f64)>, size: f64| match size {
            0.0 => 0.0,
            _ if q == f64::INFINITY => size,
            _ => {
                size * of.map(|(weight, v)| weight * (v / size).powf(q)).sum::<f64>().powf(1.0 / q)
            }
        };
        let value = join(&mut found.iter().map(|e| (1.0, e.value)), largest);
        let beyond = join(&mut left.iter().copied(), worst);
        let error =
            found.iter().map(|e| e.error).sum::<f64>() + beyond + 16.0 * f64::EPSILON * value;
        let work = found.iter().fold(Work::default(), |sum, e| sum + e.work);
        accept("L^q norm", units.in_lq(q, Estimate::new(value, error, work)?)?, tolerance, LIMIT)
    }

    /// The dual norm sup ∫ (u − u_h) v / ||v||_ν with respect to the norm of [`FieldError::norm`], as
    /// [`SingularFunction::dual_norm`].
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] with the best value, [`Error::NotFinite`] if a value of the function is not
    /// finite, [`Error::OutOfRange`] unless both are defined on the same interval.
    pub(crate) fn dual_norm(
        &self,
        of: DualOf,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let (Normalized { units, u: function }, field) = self.normalized(tolerance)?;
        let difference = Difference { function: &function, field: &field };
        let asked = (OF_CELLS * tolerance.relative()).max(LEAST);
        let cells = FieldCells::new(&difference, asked)?;
        let goal = asked * l2(&cells)?.value;
        let mut pieces = Interpolant::default();
        for part in parts(&cells, &difference)? {
            match part {
                Part::Cell(length, ends, bubbles, off) => {
                    pieces.push(length, ends, bubbles.to_vec());
                    pieces.leave(length * off * off);
                }
                Part::Patch(function) => {
                    for arm in function.arms() {
                        pieces.add(&function, &arm, &Look::default(), DEGREE, goal * goal)?;
                    }
                }
            }
        }
        let (u, left) = pieces.finish(units.length)?;
        let inner =
            Tolerance::new((0.5 * tolerance.relative()).max(1e-15))?.with_work(tolerance.work());
        let found = Estimate::or_best(u.dual_norm(of, order, inner))?;
        let found = Estimate::new(found.value, found.error + left, found.work)?;
        accept("dual norm", found.times(units.size)?, tolerance, LIMIT)
    }
}

/// The parts of u − u_h from left to right: cells away from the breakpoints, and one patch per breakpoint.
fn parts<'a>(cells: &'a FieldCells, difference: &Difference<'a>) -> Result<Vec<Part<'a>>> {
    let mut found = Vec::with_capacity(cells.parts.len());
    let mut last = None;
    for (k, (part, content)) in cells.parts.iter().zip(&cells.contents).enumerate() {
        match (part.patch, content) {
            (Some(at), _) => {
                if last != Some(at) {
                    let rest = &cells.parts[k..];
                    let count = rest.iter().take_while(|part| part.patch == Some(at)).count();
                    found.push(Part::Patch(patch(
                        difference.function,
                        difference.field,
                        at,
                        &rest[..count],
                    )?));
                }
                last = Some(at);
            }
            (None, Content::Smooth { piece, rest, noise }) => {
                let ends = [piece.left, piece.right];
                found.push(Part::Cell(
                    part.length,
                    ends,
                    &piece.bubbles,
                    0.25 * rest.abs() + noise,
                ));
            }
            (None, Content::Singular(_)) => {
                return Err(Error::CountOutOfRange {
                    name: "index of a singular cell",
                    value: k,
                    range: "the set of cells adjacent to a breakpoint",
                });
            }
        }
    }
    Ok(found)
}
