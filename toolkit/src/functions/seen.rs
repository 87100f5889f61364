//! Evaluation of a function near its breakpoints, for functions derived from it.

use super::function::{Position, Sight, SingularFunction};
use crate::error::Result;

impl<'a> SingularFunction<'a> {
    /// The number of evaluations that remain within the work limit.
    pub(crate) fn work_left(&self) -> u64 {
        self.budget.left()
    }

    /// The size of the rounded coordinates near breakpoint k; 0 for a function of the offset.
    pub(crate) fn blur(&self, k: usize) -> f64 {
        self.coordinate_if_seen(k).abs()
    }

    /// The coordinate of breakpoint k for a function of x, 0 for a function of positions.
    pub(crate) fn coordinate_if_seen(&self, k: usize) -> f64 {
        if self.sight == Sight::Coordinate { self.breaks()[k] } else { 0.0 }
    }

    /// True if the distance to some breakpoint is known only up to the rounding of a coordinate.
    pub(super) fn has_rounded_distances(&self) -> bool {
        self.sight == Sight::Coordinate && self.breaks().iter().any(|&at| at != 0.0)
    }

    /// Deducts kernel values from the work limit.
    ///
    /// # Errors
    /// [`crate::Error::ToleranceNotMet`] if the limit is exceeded.
    pub(super) fn spend(&self, count: u64) -> Result<()> {
        self.budget.spend(count)
    }

    /// A function of positions with the same arguments as this one.
    pub(crate) fn seen_likewise<'b>(
        &self,
        breaks: &[f64],
        f: impl Fn(Position<'_>) -> f64 + Sync + 'b,
    ) -> Result<SingularFunction<'b>> {
        let mut found = SingularFunction::build(breaks, Box::new(f), self.sight)?;
        found.unit = self.unit;
        Ok(found)
    }

    /// The smallest distance to a breakpoint at which the function is evaluated, in units of the
    /// breakpoints.
    pub(crate) fn closest(&self) -> f64 {
        1e-290 * self.unit.recip().max(1.0)
    }
}
