//! The patch of a break: both halves beside it, as a function with a break of its own.

use super::layout::Part;
use crate::error::Result;
use crate::sobolev::functions::{Position, SingularFunction};
use crate::sobolev::piecewise::PiecewisePolynomial;

/// u − u_h on the patch of break k, whose parts are given left to right.
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
    let lengths = field.partition().lengths();
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
