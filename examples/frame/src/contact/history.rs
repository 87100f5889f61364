//! Picture of an active-set iteration: which constraints were active at which step.

use crate::figures::{Axis, Chart, Series};
use experiments::contact_levels::SceneRun;

/// The active constraints of every step; `None` when the solver keeps no sets.
pub(super) fn history_chart(run: &SceneRun, scene: &str) -> Option<Chart> {
    let solution = &run.solution;
    if solution.history.is_empty() {
        return None;
    }
    let steps = solution.history.len() as f64;
    let points: Vec<(f64, f64)> = solution
        .history
        .iter()
        .enumerate()
        .flat_map(|(step, set)| set.indices().into_iter().map(move |i| (i, step + 1)))
        .map(|(i, step)| (solution.positions[i], step as f64))
        .collect();
    let length = run.problem.edge().arc().last().copied().unwrap_or(1.0);
    let title = format!("{scene}: contact set of every step, {} cone", solution.cone);
    let chart = Chart::new(
        title,
        Axis::linear("x along the contact edge").range(0.0, length),
        Axis::linear("step").range(0.0, steps + 1.0),
    );
    Some(chart.with(Series::points("active constraints", points)))
}
