//! The numbers of cells of a study of the strip, from a range of levels.

use signorini::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;

/// Levels n = 2^coarsest ... 2^finest; read from `3-14`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Levels {
    coarsest: u32,
    finest: u32,
}

impl Levels {
    /// 1 ≤ coarsest ≤ finest ≤ 22.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) otherwise.
    pub fn new(coarsest: u32, finest: u32) -> Result<Self> {
        for (name, value) in [("coarsest level", coarsest), ("finest level", finest)] {
            if !(1..=22).contains(&value) {
                return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                    name,
                    value: value as usize,
                    range: "[1, 22]",
                }));
            }
        }
        if coarsest > finest {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "coarsest level",
                value: coarsest as usize,
                range: "[1, finest level]",
            }));
        }
        Ok(Self { coarsest, finest })
    }

    /// Fails unless there are at least `least` levels; `range` says so.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange).
    pub fn require_count(self, least: usize, range: &'static str) -> Result<()> {
        let value = self.cells().count();
        if value >= least {
            Ok(())
        } else {
            Err(Error::Toolkit(ToolkitError::CountOutOfRange { name: "number of levels", value, range }))
        }
    }

    /// The numbers of cells, coarsest first.
    pub fn cells(self) -> impl Iterator<Item = usize> {
        (self.coarsest..=self.finest).map(|level| 1 << level)
    }

    /// h = 1/n, coarsest first.
    pub fn mesh_sizes(self) -> impl Iterator<Item = f64> {
        self.cells().map(|n| 1.0 / n as f64)
    }

    /// Cells of the coarsest level.
    pub fn coarsest_cells(self) -> usize {
        1 << self.coarsest
    }

    /// Cells of the finest level.
    pub fn finest_cells(self) -> usize {
        1 << self.finest
    }

    /// Cells of the grid the scene lives on: 64 times the finest level, but not above 2^20 unless four times
    /// the finest level is.
    pub fn reference_cells(self) -> usize {
        1 << (self.finest + 6).min(20).max(self.finest + 2)
    }
}

impl fmt::Display for Levels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.coarsest, self.finest)
    }
}

impl FromStr for Levels {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let unknown = || {
            Error::Toolkit(ToolkitError::UnknownName {
                what: "levels",
                given: text.to_owned(),
                expected: "COARSEST-FINEST, powers of two, for example 3-14",
            })
        };
        let (coarsest, finest) = text.split_once('-').ok_or_else(unknown)?;
        let number = |word: &str| word.trim().parse().map_err(|_| unknown());
        Self::new(number(coarsest)?, number(finest)?)
    }
}
