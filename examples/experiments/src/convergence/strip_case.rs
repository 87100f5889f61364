//! A case of the strip: one scene, or one transition at several positions, on all levels.

use super::levels::Levels;
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::strip::{Reference, StripKind};
use signorini::{Error, Result, ToolkitError};

/// Largest number of positions of a transition.
const POSITIONS: usize = 1024;

/// What is solved.
#[derive(Debug, Clone, PartialEq)]
pub struct StripCase {
    /// Which strip.
    pub kind: StripKind,
    /// The levels.
    pub levels: Levels,
    /// The scene.
    pub source: StripData,
    /// τ of the scene; samples bring their own.
    pub tau: f64,
    /// The discrete cone.
    pub cone: Cone,
    /// What u is.
    pub reference: Reference,
    /// Over how many positions in the coarsest cell a single transition is moved, 1 ... 1024.
    pub positions: usize,
}

impl StripCase {
    /// The scene, or the transition at several places of one coarsest cell. Doubling permutes the multiples
    /// of 1/count for an odd count, so that the places are evenly spread over the cells of every level.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) for no position or too many.
    pub fn sources(&self) -> Result<Vec<StripData>> {
        let count = self.positions;
        if !(1..=POSITIONS).contains(&count) {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "positions",
                value: count,
                range: "[1, 1024]",
            }));
        }
        let StripData::Transition { position } = self.source else {
            return Ok(vec![self.source.clone()]);
        };
        let cell = 1.0 / self.levels.coarsest_cells() as f64;
        let shifted =
            |i: usize| StripData::Transition { position: position + i as f64 / count as f64 * cell };
        Ok((0..count).map(shifted).collect())
    }
}
