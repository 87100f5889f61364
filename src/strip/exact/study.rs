//! Level after level: the discrete solutions of one scene and their exact errors.
//!
//! Each level starts from the contact set of the coarser one. The observed order between n/2 and n is log₂ of
//! the ratio of errors. For a transition it alternates with the position of the transition in its cell.

use super::levels::Levels;
use super::problem::StripProblem;
use crate::cone::{Cone, Status};
use crate::error::Result;
use crate::estimate::Estimate;
use crate::strip::solver::solution::EdgeSolution;
use crate::strip::solver::solve::solve_contact;
use std::time::Instant;

/// What is kept of one level.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Cells n; h = 1/n.
    pub cells: usize,
    /// Unknowns of the two-dimensional problem this stands for.
    pub virtual_unknowns: f64,
    /// |u − u_h|_a.
    pub error: Estimate,
    /// Maximal runs of active constraints.
    pub contact_runs: usize,
    /// Inner iterations of each step.
    pub inner_iterations: Vec<usize>,
    /// How the contact iteration ended.
    pub status: Status,
    /// The worst KKT figure.
    pub kkt: f64,
    /// Seconds for operator, load and contact.
    pub seconds: f64,
    /// Seconds for the error.
    pub error_seconds: f64,
}

impl Level {
    /// The most inner iterations of a step.
    pub fn most_inner(&self) -> usize {
        self.inner_iterations.iter().copied().max().unwrap_or(0)
    }
}

/// Solves all levels, each from the coarser one; `report` is called after each.
///
/// # Errors
/// Those of the parts; a level that did not converge is not an error but a status.
pub fn study(
    problem: &StripProblem,
    levels: Levels,
    cone: Cone,
    mut report: impl FnMut(&Level),
) -> Result<Vec<Level>> {
    let mut previous: Option<EdgeSolution> = None;
    let mut rows = Vec::new();
    for cells in levels.cells() {
        let start = Instant::now();
        let (operator, virtual_unknowns) = problem.operator(cells)?;
        let load = problem.load(cells)?;
        let solution = solve_contact(&operator, &load, cone, previous.as_ref())?;
        let seconds = start.elapsed().as_secs_f64();
        let error = problem.error(cells, &solution.values)?;
        let level = Level {
            cells,
            virtual_unknowns,
            error,
            contact_runs: solution.contact.runs().len(),
            inner_iterations: solution.inner_iterations.clone(),
            status: solution.status,
            kkt: solution.judgement.worst(),
            seconds,
            error_seconds: start.elapsed().as_secs_f64() - seconds,
        };
        report(&level);
        rows.push(level);
        previous = Some(solution);
    }
    Ok(rows)
}
