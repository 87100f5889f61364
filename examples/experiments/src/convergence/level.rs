//! One level of a rate study, and why it may not enter a fit.

use super::level_loop::{Facts, Level};
use signorini::{Error, Result, ToolkitError};
use std::fmt;

/// Why a level is left out of every fit and bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flag {
    /// The contact iteration did not converge.
    NotConverged,
    /// A scaled KKT figure exceeds 1e-10.
    Unbalanced,
    /// The estimated error of the error exceeds one part in a thousand.
    LostDigits,
    /// The reference is less than 16 times finer.
    NearReference,
}

impl Flag {
    /// All flags.
    pub const ALL: [Flag; 4] = [Flag::NotConverged, Flag::Unbalanced, Flag::LostDigits, Flag::NearReference];
}

impl fmt::Display for Flag {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Flag::NotConverged => "not converged",
            Flag::Unbalanced => "KKT",
            Flag::LostDigits => "digits lost",
            Flag::NearReference => "near reference",
        })
    }
}

/// Largest scaled KKT figure of a level that counts: rounding on the largest levels is below 1e-12.
const KKT: f64 = 1e-10;
/// Largest relative uncertainty of an error that counts: it moves an order by less than 1e-3 over a few
/// levels.
const DIGITS: f64 = 1e-3;

/// One level of a study, at one position or as mean over several.
#[derive(Debug, Clone, PartialEq)]
pub struct RateLevel {
    /// Contact segments per unit length: h = 1/cells.
    pub cells: usize,
    /// Unknowns of the two-dimensional problem.
    pub unknowns: f64,
    /// Error in the energy norm; root mean square over positions.
    pub error: f64,
    /// Estimated error of it.
    pub error_bound: f64,
    /// The consistency term of the cone, ≥ 0; mean over positions. Missing where only a discrete solution is
    /// known.
    pub consistency: Option<f64>,
    /// Maximal runs of active constraints, the most over positions.
    pub contact_runs: usize,
    /// Worst scaled KKT figure.
    pub kkt: f64,
    /// Seconds, all positions together.
    pub seconds: f64,
    /// Why it does not count.
    pub flag: Option<Flag>,
}

impl RateLevel {
    /// h = 1/cells.
    pub fn mesh_size(&self) -> f64 {
        1.0 / self.cells as f64
    }

    /// A solved level, judged by what it says of itself and by the resolution of the reference, which must be
    /// `nearest` times finer.
    pub(super) fn of(level: &Level, reference_cells: usize, nearest: usize) -> Self {
        let Facts { cells, unknowns, contact_runs, status, kkt, .. } = level.facts;
        let (error, error_bound) = (level.error.value, level.error.error);
        let flag = if !status.is_converged() {
            Some(Flag::NotConverged)
        } else if kkt.is_nan() || kkt > KKT {
            Some(Flag::Unbalanced)
        } else if error.is_nan() || error_bound > DIGITS * error {
            Some(Flag::LostDigits)
        } else if nearest.saturating_mul(cells) > reference_cells {
            Some(Flag::NearReference)
        } else {
            None
        };
        let seconds = level.seconds;
        Self { cells, unknowns, error, error_bound, consistency: None, contact_runs, kkt, seconds, flag }
    }

    /// The mean of the same level at several positions: errors as root mean square, terms as mean, the rest
    /// as worst or sum.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) without any level.
    pub fn mean(levels: &[RateLevel]) -> Result<RateLevel> {
        let Some(first) = levels.first() else {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "positions",
                value: 0,
                range: "[1, inf)",
            }));
        };
        let count = levels.len() as f64;
        let terms: Option<Vec<f64>> = levels.iter().map(|level| level.consistency).collect();
        Ok(RateLevel {
            error: (levels.iter().map(|level| level.error.powi(2)).sum::<f64>() / count).sqrt(),
            error_bound: levels.iter().fold(0.0, |w, level| level.error_bound.max(w)),
            consistency: terms.map(|terms| terms.iter().sum::<f64>() / count),
            contact_runs: levels.iter().map(|level| level.contact_runs).max().unwrap_or(0),
            kkt: levels.iter().fold(0.0, |w, level| level.kkt.max(w)),
            seconds: levels.iter().map(|level| level.seconds).sum(),
            flag: levels.iter().find_map(|level| level.flag),
            ..first.clone()
        })
    }

    /// [`RateLevel::mean`] of each level over members that have the same levels.
    ///
    /// # Errors
    /// As [`RateLevel::mean`].
    pub(super) fn means(members: &[Vec<RateLevel>]) -> Result<Vec<RateLevel>> {
        let count = members.iter().map(Vec::len).min().unwrap_or(0);
        (0..count)
            .map(|k| Self::mean(&members.iter().map(|levels| levels[k].clone()).collect::<Vec<_>>()))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fractional_sobolev::{Estimate, Work};
    use signorini::cone::Status;

    fn level(cells: usize, status: Status, kkt: f64, error_bound: f64) -> RateLevel {
        let facts = Facts { cells, unknowns: 4160.0, contact_runs: 2, inner_iterations: vec![], status, kkt };
        let error = Estimate { value: 0.1, error: error_bound, work: Work::default() };
        RateLevel::of(&Level { facts, error, seconds: 0.25, error_seconds: 0.0 }, 1024, 16)
    }

    #[test]
    fn what_cannot_be_trusted_is_flagged() {
        let converged = Status::Converged;
        let good = level(64, converged, 1e-16, 1e-15);
        assert_eq!(good.flag, None);
        assert_eq!(level(64, Status::StepLimit { steps: 9 }, 1e-16, 1e-15).flag, Some(Flag::NotConverged));
        assert_eq!(level(64, converged, f64::NAN, 1e-15).flag, Some(Flag::Unbalanced));
        let lost = level(64, converged, 1e-16, 1e-3);
        assert_eq!(lost.flag, Some(Flag::LostDigits));
        assert_eq!(level(128, converged, 1e-16, 1e-15).flag, Some(Flag::NearReference));
        assert_eq!(RateLevel::mean(&[good, lost]).unwrap().flag, Some(Flag::LostDigits));
        assert!(RateLevel::mean(&[]).is_err());
    }
}
