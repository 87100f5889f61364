//! The level loop: operator and load, contact solution, error, level after level, each from the coarser one.

use fractional_sobolev::Estimate;
use signorini::Result;
use signorini::cone::{Cone, Status};
use std::time::Instant;

/// One problem on nested levels, coarsest first.
pub trait LevelProblem {
    /// A discrete solution.
    type Solution;

    /// How many levels.
    fn count(&self) -> usize;

    /// Operator, load and contact on a level, from the solution of the coarser level where there is one.
    ///
    /// # Errors
    /// Those of operators and solvers.
    fn solve(&self, level: usize, cone: Cone, coarser: Option<&Self::Solution>) -> Result<Self::Solution>;

    /// |u − u_h|_a.
    ///
    /// # Errors
    /// Those of error norms.
    fn error(&self, level: usize, solution: &Self::Solution) -> Result<Estimate>;

    /// How the solution of a level came about.
    fn facts(&self, level: usize, solution: &Self::Solution) -> Facts;
}

/// What a solution says of itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Facts {
    /// Cells n along the contact edge; h = 1/n.
    pub cells: usize,
    /// Unknowns of the two-dimensional problem.
    pub unknowns: f64,
    /// Maximal runs of active constraints.
    pub contact_runs: usize,
    /// Inner iterations of each step of the contact iteration; empty where the linear problems are
    /// factorized.
    pub inner_iterations: Vec<usize>,
    /// How the contact iteration ended.
    pub status: Status,
    /// The worst scaled KKT figure.
    pub kkt: f64,
}

impl Facts {
    /// The most inner iterations of a step.
    pub fn most_inner(&self) -> usize {
        self.inner_iterations.iter().copied().max().unwrap_or(0)
    }
}

/// What is kept of one level.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// How the solution came about.
    pub facts: Facts,
    /// |u − u_h|_a.
    pub error: Estimate,
    /// Seconds for operator, load and contact.
    pub seconds: f64,
    /// Seconds for the error.
    pub error_seconds: f64,
}

/// Solves all levels but those that `is_known`, each from the coarser one; after a known level the next one
/// starts cold. `report` is called with each solved level and its solution. Known levels are `None` in the
/// answer.
///
/// # Errors
/// Those of the parts and of `report`; a level that did not converge is not an error but a status.
pub fn solve_levels<P: LevelProblem>(
    problem: &P,
    cone: Cone,
    is_known: impl Fn(usize) -> bool,
    mut report: impl FnMut(usize, &Level, &P::Solution) -> Result<()>,
) -> Result<Vec<Option<Level>>> {
    let mut coarser: Option<P::Solution> = None;
    let mut levels = Vec::with_capacity(problem.count());
    for k in 0..problem.count() {
        if is_known(k) {
            coarser = None;
            levels.push(None);
            continue;
        }
        let start = Instant::now();
        let solution = problem.solve(k, cone, coarser.as_ref())?;
        let seconds = start.elapsed().as_secs_f64();
        let error = problem.error(k, &solution)?;
        let error_seconds = start.elapsed().as_secs_f64() - seconds;
        let level = Level { facts: problem.facts(k, &solution), error, seconds, error_seconds };
        report(k, &level, &solution)?;
        levels.push(Some(level));
        coarser = Some(solution);
    }
    Ok(levels)
}
