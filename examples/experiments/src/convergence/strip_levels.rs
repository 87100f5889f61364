//! The levels of a problem on a strip, for the level loop.
//!
//! The operator of a level depends on the kind of strip alone: made when the level is solved and dropped
//! after it, or once for many scenes and lent. For a transition the observed order between n/2 and n, log₂ of
//! the ratio of errors, alternates with the position of the transition in its cell.

use super::level_loop::{Facts, Level, LevelProblem, solve_levels};
use super::levels::Levels;
use fractional_sobolev::Estimate;
use signorini::cone::Cone;
use signorini::strip::{EdgeOperator, EdgeSolution, StripProblem};
use signorini::{Error, Result, ToolkitError};

/// Relative residual of the discrete solutions: below every discretisation error.
const SOLVED: f64 = 1e-13;

/// A problem on a strip with its levels.
#[derive(Debug, Clone, Copy)]
pub struct StripLevels<'a> {
    problem: &'a StripProblem,
    levels: Levels,
    /// Of all levels, with the unknowns they stand for.
    operators: Option<&'a [(EdgeOperator, f64)]>,
}

impl<'a> StripLevels<'a> {
    /// Each operator is made when its level is solved: no more than one is held.
    pub fn new(problem: &'a StripProblem, levels: Levels) -> Self {
        Self { problem, levels, operators: None }
    }

    /// With the operators of all levels, coarsest first, as [`StripProblem::operator`] makes them.
    pub fn with_operators(
        problem: &'a StripProblem,
        levels: Levels,
        operators: &'a [(EdgeOperator, f64)],
    ) -> Self {
        Self { problem, levels, operators: Some(operators) }
    }

    fn cells(&self, level: usize) -> Result<usize> {
        let range = "the levels of the strip";
        self.levels.cells().nth(level).ok_or(Error::Toolkit(ToolkitError::CountOutOfRange {
            name: "level",
            value: level,
            range,
        }))
    }
}

/// A discrete solution with the unknowns of the two-dimensional problem it stands for.
#[derive(Debug, Clone)]
pub struct StripSolution {
    /// On the edge.
    pub edge: EdgeSolution,
    /// Of the two-dimensional problem.
    pub unknowns: f64,
}

impl LevelProblem for StripLevels<'_> {
    type Solution = StripSolution;

    fn count(&self) -> usize {
        self.levels.cells().count()
    }

    fn solve(&self, level: usize, cone: Cone, coarser: Option<&StripSolution>) -> Result<StripSolution> {
        let cells = self.cells(level)?;
        let coarser = coarser.map(|solution| &solution.edge);
        let solve = |(operator, unknowns): &(EdgeOperator, f64)| {
            let edge = operator.solve_contact(&self.problem.load(cells)?, cone, coarser, SOLVED)?;
            Ok(StripSolution { edge, unknowns: *unknowns })
        };
        match self.operators.and_then(|operators| operators.get(level)) {
            Some(known) => solve(known),
            None => solve(&self.problem.operator(cells)?),
        }
    }

    fn error(&self, level: usize, solution: &StripSolution) -> Result<Estimate> {
        self.problem.error(self.cells(level)?, &solution.edge.values)
    }

    fn facts(&self, level: usize, StripSolution { edge, unknowns }: &StripSolution) -> Facts {
        Facts {
            cells: self.levels.coarsest_cells() << level,
            unknowns: *unknowns,
            contact_runs: edge.contact.runs().len(),
            inner_iterations: edge.inner_iterations.clone(),
            status: edge.status,
            kkt: edge.kkt.worst(),
        }
    }
}

/// Solves all levels, each from the coarser one; `report` is called after each.
///
/// # Errors
/// Those of the parts; a level that did not converge is not an error but a status.
pub fn strip_levels(
    problem: &StripProblem,
    levels: Levels,
    cone: Cone,
    mut report: impl FnMut(&Level),
) -> Result<Vec<Level>> {
    let keep = |_, level: &Level, _: &StripSolution| {
        report(level);
        Ok(())
    };
    let solved = solve_levels(&StripLevels::new(problem, levels), cone, |_| false, keep)?;
    Ok(solved.into_iter().flatten().collect())
}
