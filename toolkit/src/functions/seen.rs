//! What a function sees of its breakpoints, for others made of it.

use super::function::{Position, Sight, SingularFunction};
use crate::error::Result;

impl<'a> SingularFunction<'a> {
    /// What is left of the work that a tolerance allows.
    pub(crate) fn work_left(&self) -> u64 {
        self.budget.left()
    }

    /// The size of the rounded coordinates near breakpoint k; 0 where the function sees offsets.
    pub(crate) fn blur(&self, k: usize) -> f64 {
        self.coordinate_if_seen(k).abs()
    }

    /// The coordinate of breakpoint k where that is what the function sees, else 0.
    pub(crate) fn coordinate_if_seen(&self, k: usize) -> f64 {
        if self.sight == Sight::Coordinate { self.breaks()[k] } else { 0.0 }
    }

    /// Whether the distance to some breakpoint is only known up to the rounding of a coordinate.
    pub(super) fn has_rounded_distances(&self) -> bool {
        self.sight == Sight::Coordinate && self.breaks().iter().any(|&at| at != 0.0)
    }

    /// Counts kernel values against the work that is allowed.
    ///
    /// # Errors
    /// [`crate::Error::ToleranceNotMet`] when it is spent.
    pub(super) fn spend(&self, count: u64) -> Result<()> {
        self.budget.spend(count)
    }

    /// A function of positions that are known as this one's are.
    pub(crate) fn seen_likewise<'b>(
        &self,
        breaks: &[f64],
        f: impl Fn(Position<'_>) -> f64 + Sync + 'b,
    ) -> Result<SingularFunction<'b>> {
        let mut found = SingularFunction::build(breaks, Box::new(f), self.sight)?;
        found.unit = self.unit;
        Ok(found)
    }

    /// The smallest distance to a breakpoint at which the function is asked, in units of the breakpoints.
    pub(crate) fn closest(&self) -> f64 {
        1e-290 * self.unit.recip().max(1.0)
    }
}
