//! Levels of increasing accuracy until two agree.

use super::function::SingularFunction;
use super::level::{Level, LevelValue};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};

/// Orders and cell widths of increasing accuracy: one and a half decades per step for functions analytic up to
/// their breakpoints.
const LEVELS: [Level; 11] = [
    Level { points: 4, width: 1.5 },
    Level { points: 6, width: 1.4 },
    Level { points: 8, width: 1.3 },
    Level { points: 11, width: 1.2 },
    Level { points: 15, width: 1.1 },
    Level { points: 18, width: 1.0 },
    Level { points: 18, width: 0.6 },
    Level { points: 20, width: 0.35 },
    Level { points: 22, width: 0.2 },
    Level { points: 24, width: 0.11 },
    Level { points: 26, width: 0.06 },
];

/// Upper bound of the integral of a function of size 1 that is constant to rounding: (64 ε)².
const ZERO: f64 = 2e-28;

/// Message: what limits the accuracy of a function given by code.
pub(super) const LIMIT: &str = "rounding of the values, or the limit at a breakpoint, dominates the error; Function::from_positions avoids rounding";

/// Message: the rounding of x = c + δ limits the accuracy.
const ROUNDED: &str = "x is rounded near a breakpoint other than 0, where the function depends on the distance to it: \
     use from_positions";

/// Largest ratio of the difference of two levels to the estimated error of the coarser one.
const EXPLAINED: f64 = 4.0;

/// Least ratio of the error of the finer level to the difference: where neither level resolves a feature, their estimates
/// may be small by accident.
const GAINED: f64 = 0.1;

/// Number of levels after which the errors of the ends of the sides and of rounding should have decreased, and
/// the factor by which they should have.
const TRIED: usize = 4;
const FALLS: f64 = 0.3;

/// The estimate from levels of increasing accuracy, until two agree to `factor` times the tolerance, the
/// accuracy of the integral for which the derived quantity meets the tolerance.
///
/// The iteration ends if finer rules do not help: if the total error does not decrease, or if the part independent
/// of the rules (rounding and the limit at a breakpoint) stays above the tolerance.
pub(super) fn refine(
    u: &SingularFunction,
    asked: Tolerance,
    factor: f64,
    is_constant: bool,
    compute: impl Fn(Level, f64) -> Result<LevelValue>,
) -> Result<Estimate> {
    let tolerance = factor * asked.relative();
    let digits = -tolerance.log10();
    // The first level to try leaves the second one likely to succeed.
    let first = ((digits - 2.0) / 3.0).floor().clamp(0.0, 3.0) as usize;
    let mut previous: Option<LevelValue> = None;
    let mut found: Vec<Estimate> = Vec::new();
    let (mut points, mut least, mut why) = (0, f64::INFINITY, LIMIT);
    for (tried, &level) in LEVELS[first..].iter().enumerate() {
        let current = match compute(level, tolerance) {
            Err(_) if u.work_left() == 0 => {
                why = SPENT;
                break;
            }
            other => other?,
        };
        points += current.points;
        let work = Work { points, ..Work::default() };
        let beside_rules = current.tail + current.rounding;
        if let Some(coarse) = &previous {
            let error = of_rules(&current, coarse)
                + beside_rules
                + 64.0 * f64::EPSILON * current.value.abs();
            let estimate = Estimate::new(current.value, error, work)?;
            // All that is found of a function without variation is its rounding; what is more than that is a value.
            let is_rounding = estimate.error.max(estimate.value.abs()) <= ZERO
                && estimate.value <= estimate.error;
            let is_zero = is_constant && is_rounding;
            if is_zero || estimate.relative_error() <= tolerance {
                return Ok(estimate);
            }
            let best = found.iter().map(|e| e.error).fold(f64::INFINITY, f64::min);
            found.push(estimate);
            if estimate.error > 0.5 * best && best < 1e-6 * estimate.value.abs() {
                break;
            }
        }
        let stays = beside_rules > tolerance * current.value.abs() && beside_rules > FALLS * least;
        if stays && u.has_rounded_distances() {
            why = ROUNDED;
        }
        if stays && tried + 1 >= TRIED {
            break;
        }
        least = least.min(beside_rules);
        previous = Some(current);
    }
    let best = match (best_of_levels(&found), previous) {
        (None, Some(level)) => {
            // One level alone: all that is known is its size.
            let work = Work { points, ..Work::default() };
            Some(Estimate::new(level.value, level.value.abs() + level.tail + level.rounding, work)?)
        }
        (best, _) => best,
    };
    Err(Error::best_of("integral", asked.relative(), best, why))
}

/// The error of the rules of the finer level, estimated by the difference from the coarser level: the sum of the differences
/// of all sides, because errors of 1e-10 on two sides may cancel to 1e-12 in the coarser sum, from which the finer one may
/// then differ by less than its own error. If the error estimates of both levels explain that difference, it is reduced by
/// the ratio of these estimates, by at most the factor [`GAINED`].
fn of_rules(fine: &LevelValue, coarse: &LevelValue) -> f64 {
    let pairs = fine.sides.iter().zip(&coarse.sides);
    let apart = pairs.map(|(fine, coarse)| (fine - coarse).abs()).sum::<f64>();
    match (fine.of_rules, coarse.of_rules) {
        (Some(after), Some(before)) if apart <= EXPLAINED * before && after < before => {
            (EXPLAINED * after + apart * (after / before)).max(GAINED * apart)
        }
        _ => apart + fine.missed,
    }
}

/// Ratio of error to difference for slowly converging levels: 1/(2^{1/3} − 1) for errors like h^{1/3}.
const UNSETTLED: f64 = 4.0;

/// The best of several levels that do not meet the tolerance: since two levels may agree by accident, the error
/// of a level includes its distance to all later ones. The last level is returned if each of the last three
/// gained a digit.
fn best_of_levels(found: &[Estimate]) -> Option<Estimate> {
    if let [.., a, b, c] = found
        && b.error <= 0.1 * a.error
        && c.error <= 0.1 * b.error
    {
        return Some(*c);
    }
    let judged = |(k, level): (usize, &Estimate)| {
        let later = found[k + 1..].iter().map(|later| (later.value - level.value).abs());
        Estimate { error: UNSETTLED * later.fold(level.error, f64::max), ..*level }
    };
    let confirmed = found.iter().enumerate().take(found.len().max(2) - 1);
    confirmed.map(judged).min_by(|a, b| a.error.total_cmp(&b.error))
}
