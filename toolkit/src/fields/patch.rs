//! The patch of a breakpoint: both halves next to it, as a function with one breakpoint.

use super::fit::{Difference, Fitted};
use super::layout::Part;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::functions::{Position, SingularFunction};
use crate::mesh::Mesh;
use crate::order::Order;
use crate::piecewise::PiecewisePolynomial;

/// Largest number of polynomials on a patch of a smooth function.
const MOST: usize = 64;
/// Number of standard deviations by which independent rounding errors may exceed their expectation.
const SAFETY: f64 = 4.0;

/// The difference u − u_h on the patch of breakpoint k, whose parts are given from left to right.
pub(super) fn patch<'a>(
    function: &'a SingularFunction<'a>,
    field: &'a PiecewisePolynomial,
    k: usize,
    parts: &[Part],
) -> Result<SingularFunction<'a>> {
    let left: Vec<&Part> = parts.iter().filter(|part| part.gap < k).collect();
    let right: Vec<&Part> = parts.iter().filter(|part| part.gap == k).collect();
    // The element on either side, and where the break lies in it.
    let before = left.last().map(|part| (part.element, part.to));
    let after = right.first().map(|part| (part.element, part.from));
    let length = |parts: &[&Part]| parts.iter().map(|part| part.length).sum::<f64>();
    let (reach, other) = (length(&left), length(&right));
    let centre = function.coordinate_if_seen(k);
    let mut breaks = vec![centre];
    let at = usize::from(!left.is_empty());
    if !left.is_empty() {
        breaks.insert(0, centre - reach);
    }
    if !right.is_empty() {
        breaks.push(centre + other);
    }
    let lengths = field.mesh().lengths();
    let difference = move |position: Position| {
        let (offset, depth) = if position.anchor() == at {
            (position.offset(), Some(position.log_distance()))
        } else if position.anchor() < at {
            (position.offset() - reach, None)
        } else {
            (position.offset() + other, None)
        };
        let is_before = if offset == 0.0 { offset.is_sign_negative() } else { offset < 0.0 };
        let side = if is_before { before.or(after) } else { after.or(before) };
        let Some((element, place)) = side else { return f64::NAN };
        let local = (place + offset / lengths[element]).clamp(0.0, 1.0);
        let value = function.value_at(k, offset, depth).unwrap_or(f64::NAN);
        value - field.pieces()[element].value(local)
    };
    function.seen_likewise(&breaks, difference)
}

/// |u − u_h|_ν on a patch from polynomials: if u is smooth at the breakpoint and rounding dominates the
/// difference, [`SingularFunction::seminorm`] would treat rounding errors as oscillations.
pub(super) fn by_polynomials(
    difference: &Difference,
    parts: &[Part],
    order: Order,
    tolerance: Tolerance,
) -> Result<Option<Estimate>> {
    let mut fitted: Vec<Fitted> = Vec::new();
    for part in parts {
        fitted.extend(difference.fit(*part, 0.02 * tolerance.relative())?);
        if fitted.len() > MOST {
            return Ok(None);
        }
    }
    let mut ends: Vec<[f64; 2]> = fitted.iter().map(|f| [f.piece.left, f.piece.right]).collect();
    for k in 1..ends.len() {
        let (left, right) = (ends[k - 1][1], ends[k][0]);
        let slack = SAFETY * (fitted[k - 1].noise + fitted[k].noise);
        if (left - right).abs() > slack {
            return Ok(None);
        }
        let mean = 0.5 * (left + right);
        (ends[k - 1][1], ends[k][0]) = (mean, mean);
    }
    let nu = order.value();
    let both = 2.0 / ((1.0 - nu) * (3.0 - 2.0 * nu)) + 2.0 / nu;
    let left_over = fitted.iter().map(|f| {
        let size = f.rest * f.piece.degree() as f64 + SAFETY * f.noise;
        both * f.part.length.powf(1.0 - 2.0 * nu) * size * size
    });
    let error = left_over.sum::<f64>().sqrt();
    let lengths = fitted.iter().map(|f| f.part.length).collect::<Vec<_>>();
    let bubbles = fitted.into_iter().map(|f| f.piece.bubbles).collect();
    let smooth = PiecewisePolynomial::with_bubbles(Mesh::from_lengths(&lengths)?, &ends, bubbles)?;
    let found = match Estimate::or_best(smooth.seminorm(order, tolerance)) {
        Err(Error::ToleranceNotMet { .. } | Error::NotFinite { .. }) => return Ok(None),
        other => other?,
    };
    Estimate::new(found.value, found.error + error, found.work).map(Some)
}
