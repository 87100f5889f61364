//! One level of a rate study, and why it may not enter a fit.

use crate::error::{Error, Result};
use serde_json::{Value, json};
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

/// Largest KKT figure of a level that counts.
const KKT: f64 = 1e-10;
/// Largest relative uncertainty of an error that counts.
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
    /// The consistency term of the cone, ≥ 0; mean over positions. Missing where only a discrete solution is known.
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

    /// Sets the flag from what the level says of itself, the status of its solver and the resolution of the reference.
    #[must_use]
    pub(super) fn judged(mut self, converged: bool, reference_cells: usize, nearest: usize) -> Self {
        self.flag = if !converged {
            Some(Flag::NotConverged)
        } else if self.kkt.is_nan() || self.kkt > KKT {
            Some(Flag::Unbalanced)
        } else if self.error.is_nan() || self.error_bound > DIGITS * self.error {
            Some(Flag::LostDigits)
        } else if nearest.saturating_mul(self.cells) > reference_cells {
            Some(Flag::NearReference)
        } else {
            None
        };
        self
    }

    /// The mean of the same level at several positions: errors as root mean square, terms as mean, the rest as worst or sum.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without any level.
    pub fn mean(levels: &[RateLevel]) -> Result<RateLevel> {
        let Some(first) = levels.first() else {
            return Err(Error::CountOutOfRange { name: "positions", value: 0, range: "[1, inf)" });
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

    /// As one JSON object, all digits.
    pub fn json(&self) -> Value {
        json!({
            "cells": self.cells,
            "unknowns": self.unknowns,
            "error": self.error,
            "error_bound": self.error_bound,
            "consistency": self.consistency,
            "contact_runs": self.contact_runs,
            "kkt": self.kkt,
            "seconds": self.seconds,
            "flag": self.flag.map(|flag| flag.to_string()),
        })
    }

    /// Reads [`RateLevel::json`] back; `None` for anything else.
    pub fn from_json(value: &Value) -> Option<Self> {
        let number = |key: &str| value.get(key)?.as_f64().filter(|v| v.is_finite());
        let count = |key: &str| usize::try_from(value.get(key)?.as_u64()?).ok();
        let consistency = match value.get("consistency")? {
            Value::Null => None,
            term => Some(term.as_f64()?),
        };
        let flag = match value.get("flag")? {
            Value::Null => None,
            name => {
                Some(Flag::ALL.into_iter().find(|flag| Some(flag.to_string().as_str()) == name.as_str())?)
            }
        };
        Some(Self {
            cells: count("cells").filter(|&cells| cells > 0)?,
            unknowns: number("unknowns")?,
            error: number("error")?,
            error_bound: number("error_bound")?,
            consistency,
            contact_runs: count("contact_runs")?,
            kkt: number("kkt")?,
            seconds: number("seconds")?,
            flag,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level() -> RateLevel {
        RateLevel {
            cells: 64,
            unknowns: 4160.0,
            error: 0.1,
            error_bound: 1e-15,
            consistency: Some(1.0 / 3.0),
            contact_runs: 2,
            kkt: 1e-16,
            seconds: 0.25,
            flag: None,
        }
    }

    #[test]
    fn levels_are_read_back_and_anything_else_is_not() {
        for flag in Flag::ALL.map(Some).into_iter().chain([None]) {
            let level = RateLevel { flag, ..level() };
            let text = level.json().to_string();
            assert_eq!(RateLevel::from_json(&serde_json::from_str(&text).unwrap()), Some(level));
        }
        for bad in ["{}", "[1]", "{\"cells\": 0}"] {
            assert_eq!(RateLevel::from_json(&serde_json::from_str(bad).unwrap()), None);
        }
    }

    #[test]
    fn what_cannot_be_trusted_is_flagged() {
        let flag = |level: RateLevel, converged| level.judged(converged, 1024, 16).flag;
        assert_eq!(flag(level(), true), None);
        assert_eq!(flag(level(), false), Some(Flag::NotConverged));
        assert_eq!(flag(RateLevel { kkt: f64::NAN, ..level() }, true), Some(Flag::Unbalanced));
        assert_eq!(flag(RateLevel { error_bound: 1e-3, ..level() }, true), Some(Flag::LostDigits));
        assert_eq!(flag(RateLevel { cells: 128, ..level() }, true), Some(Flag::NearReference));
        let mean =
            RateLevel::mean(&[level(), RateLevel { flag: Some(Flag::LostDigits), ..level() }]).unwrap();
        assert_eq!(mean.flag, Some(Flag::LostDigits));
        assert!(RateLevel::mean(&[]).is_err());
    }
}
