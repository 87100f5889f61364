//! Finished levels that need not be solved again: a study asks for them by what they depend on.

use super::level::RateLevel;
use super::levels::Levels;
use super::subject::FamilyScene;
use signorini::Result;
use signorini::cone::Cone;
use signorini::strip::StripKind;
use std::fmt;

/// Everything a level of a member of a family on a strip depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelKey {
    /// Which strip.
    pub kind: StripKind,
    /// The family of scenes.
    pub family: FamilyScene,
    /// τ of the family.
    pub tau: f64,
    /// The discrete cone.
    pub cone: Cone,
    /// Which member of how many.
    pub member: (usize, usize),
    /// The levels of the study: the coarsest one decides where members lie, each level starts from the
    /// coarser one.
    pub levels: Levels,
    /// Cells of the reference grid.
    pub reference_cells: usize,
    /// Cells of the level.
    pub cells: usize,
}

impl fmt::Display for LevelKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, family, tau, cone, member: (i, count), levels, reference_cells, cells } = self;
        write!(
            f,
            "strip {kind} {family} tau {tau} {cone} member {i}/{count} from {levels} on {reference_cells} n {cells}"
        )
    }
}

/// Where finished levels are kept.
pub trait LevelMemory {
    /// The level with this key, if it is finished.
    fn recall(&self, key: &LevelKey) -> Option<RateLevel>;

    /// Keeps a finished level.
    ///
    /// # Errors
    /// Whatever keeps it from being written.
    fn keep(&mut self, key: &LevelKey, level: &RateLevel) -> Result<()>;
}

/// Keeps nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoMemory;

impl LevelMemory for NoMemory {
    fn recall(&self, _: &LevelKey) -> Option<RateLevel> {
        None
    }

    fn keep(&mut self, _: &LevelKey, _: &RateLevel) -> Result<()> {
        Ok(())
    }
}
