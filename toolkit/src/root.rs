//! Square roots of estimates with their errors, and the comparison of estimates with a tolerance.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};

/// Relative rounding error of one entry of a Gram matrix or of one pair of elements: a few dozen operations on
/// terms of one sign.
pub(super) const ENTRY_ROUNDING: f64 = 32.0 * f64::EPSILON;

/// √(Σ v²) without overflow, with its error ([`Estimate::hypot`]).
pub(crate) fn root_of_squares(parts: &[Estimate]) -> Result<Estimate> {
    let zero = Estimate::new(0.0, 0.0, Work::default())?;
    parts.iter().try_fold(zero, |root, part| root.hypot(*part))
}

/// The estimate, or [`Error::ToleranceNotMet`] with the reason if its error exceeds the tolerance.
pub(super) fn accept(
    what: &'static str,
    estimate: Estimate,
    tolerance: Tolerance,
    why: &'static str,
) -> Result<Estimate> {
    // Nothing can be asked below the rounding of the result itself.
    let asked = tolerance.relative().max(ENTRY_ROUNDING);
    if estimate.relative_error() <= asked || estimate.value == 0.0 {
        return Ok(estimate);
    }
    Err(Error::not_met(what, tolerance.relative(), estimate, why))
}

/// √(Σ parts²) from the best estimates of the parts, if it meets the tolerance; otherwise with the
/// reason for which a part was refused, the work limit before others, or `why`.
pub(super) fn whole(
    parts: [Result<Estimate>; 2],
    tolerance: Tolerance,
    why: &'static str,
) -> Result<Estimate> {
    let reason = |part: &Result<Estimate>| match part {
        Err(Error::ToleranceNotMet { why, .. }) => Some(*why),
        _ => None,
    };
    let reasons = parts.iter().rev().filter_map(reason);
    let why = reasons.max_by_key(|why| *why == SPENT).unwrap_or(why);
    let [a, b] = parts.map(Estimate::or_best);
    accept("norm", root_of_squares(&[a?, b?])?, tolerance, why)
}
