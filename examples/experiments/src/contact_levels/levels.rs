//! A family of problems on finer and finer meshes, solved by one solver or by two.

use fractional_sobolev::{Estimate, Tolerance};
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, ContactSolution, Fallback, MultigridProgress, Solver};
use signorini::mesh::Hierarchy;
use signorini::{Error, Result, ToolkitError};
use std::fmt;

/// Unknowns up to which elimination is one of two solvers: n = 1024, some 4 GB.
const ELIMINATED: usize = 2_200_000;
/// Most meshes of a study.
pub(super) const LEVELS: usize = 12;

/// One solution of a study.
#[derive(Debug, Clone)]
pub struct SceneRun {
    /// Cells along each side.
    pub n: usize,
    /// The assembled problem.
    pub problem: ContactProblem,
    /// Its solution.
    pub solution: ContactSolution,
    /// Steps of the active set from an empty contact set, when `solution` started from a coarser one.
    pub cold_steps: Option<u64>,
    /// |u_h|_a with the estimated algebraic error, from multigrid.
    pub error: Option<Estimate>,
    /// Why multigrid left the problem to elimination, if it did.
    pub fallback: Option<Fallback>,
}

/// What a study is doing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StudyProgress {
    /// Cells along each side.
    pub n: usize,
    /// The solver.
    pub solver: Solver,
    /// Where multigrid is; `None` when a solver begins.
    pub multigrid: Option<MultigridProgress>,
}

impl fmt::Display for StudyProgress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "n = {}, {}", self.n, self.solver)?;
        self.multigrid.map_or(Ok(()), |at| {
            write!(f, ": level {} of {}, step {}, error {:.0e}", at.level, at.levels - 1, at.step, at.error)
        })
    }
}

/// What is asked of multigrid unless said: twelve digits beside another solver, else its default.
pub(super) fn asked(solver: Option<Solver>, accuracy: Option<Accuracy>) -> Accuracy {
    let beside =
        if solver.is_none() { Accuracy::Relative(Tolerance::reference()) } else { Accuracy::default() };
    accuracy.unwrap_or(beside)
}

/// The solvers on a mesh that is small enough for the interior point, or is not.
pub(super) fn solvers_for(is_small: bool, unknowns: usize) -> Vec<Solver> {
    match unknowns {
        _ if is_small => vec![Solver::ActiveSet, Solver::InteriorPoint],
        0..=ELIMINATED => vec![Solver::ActiveSet, Solver::Multigrid],
        _ => vec![Solver::Multigrid],
    }
}

/// Unknowns of a problem, prescribed ones included.
pub(super) fn unknowns(problem: &ContactProblem) -> usize {
    problem.mesh().nodes().len() * problem.form().components()
}

/// One problem of a family, with the meshes below it where they are known.
pub(super) struct Level {
    pub(super) n: usize,
    pub(super) problem: ContactProblem,
    pub(super) hierarchy: Option<Hierarchy>,
}

/// How a family is solved.
pub(super) struct How {
    pub(super) cone: Cone,
    pub(super) levels: usize,
    pub(super) asked: Accuracy,
}

/// Solves a family, coarsest first, the active set before the second solver and from the contact set of the
/// mesh before.
pub(super) fn solve_levels(
    How { cone, levels, asked }: How,
    mut level: impl FnMut(usize) -> Result<Level>,
    solvers: impl Fn(usize, &ContactProblem) -> Vec<Solver>,
    mut observe: impl FnMut(&StudyProgress) -> Result<()> + Send,
) -> Result<Vec<SceneRun>> {
    if !(1..=LEVELS).contains(&levels) {
        return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
            name: "levels",
            value: levels,
            range: "[1, 12]",
        }));
    }
    let mut runs: Vec<SceneRun> = Vec::new();
    for number in 0..levels {
        let Level { n, problem, hierarchy } = level(number)?;
        let coarser = runs.iter().rev().find(|run| run.solution.solver == Solver::ActiveSet);
        let coarser = coarser.map(|run| run.solution.clone());
        let is_chain = !problem.edge().is_closed() && problem.edge().pieces().len() == 1;
        for solver in solvers(n, &problem) {
            observe(&StudyProgress { n, solver, multigrid: None })?;
            let (mut cold_steps, mut error, mut fallback) = (None, None, None);
            let solution = match (&coarser, solver) {
                (Some(coarse), Solver::ActiveSet) if is_chain => {
                    let (solution, cold) = problem.solve_after_beside_cold(coarse)?;
                    cold_steps = cold;
                    solution
                }
                (_, Solver::Multigrid) => {
                    let heard =
                        |at: &MultigridProgress| observe(&StudyProgress { n, solver, multigrid: Some(*at) });
                    let found = problem.solve_by_multigrid(cone, hierarchy.as_ref(), asked, heard)?;
                    (error, fallback) = (found.error, found.fallback);
                    found.solution
                }
                _ => problem.solve(cone, solver)?,
            };
            runs.push(SceneRun { n, problem: problem.clone(), solution, cold_steps, error, fallback });
        }
    }
    Ok(runs)
}
