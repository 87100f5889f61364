//! Picture of an active-set iteration: which constraints were active at which step.

use super::problem::ContactProblem;
use super::solution::ContactSolution;
use crate::error::Result;
use crate::figures::{Axis, Chart, Series};
use std::path::{Path, PathBuf};

impl ContactSolution {
    /// Draws the active constraints of every step as `directory/name.svg`; `None` when the solver keeps no sets.
    ///
    /// # Errors
    /// Those of [`Chart::save`].
    pub fn save_history(
        &self,
        problem: &ContactProblem,
        scene: &str,
        directory: &Path,
        name: &str,
    ) -> Result<Option<PathBuf>> {
        if self.history.is_empty() {
            return Ok(None);
        }
        let points: Vec<(f64, f64)> = self
            .history
            .iter()
            .enumerate()
            .flat_map(|(step, set)| set.indices().into_iter().map(move |i| (i, step + 1)))
            .map(|(i, step)| (self.positions[i], step as f64))
            .collect();
        let length = problem.edge().arc().last().copied().unwrap_or(1.0);
        let steps = self.history.len() as f64;
        let title = format!("{scene}: contact set of every step, {} cone", self.cone);
        Chart::new(
            title,
            Axis::linear("x along the contact edge").range(0.0, length),
            Axis::linear("step").range(0.0, steps + 1.0),
        )
        .with(Series::points("active constraints", points))
        .save(directory, name)
        .map(Some)
    }
}
