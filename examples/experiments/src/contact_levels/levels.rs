//! A family of problems on finer and finer meshes, solved by one solver or by two.

use fractional_sobolev::Estimate;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, ContactSolution, Progress, Settings, Solver, Start};
use signorini::mesh::Hierarchy;
use signorini::{Error, Result, ToolkitError};
use std::fmt;

/// Unknowns up to which elimination is one of two solvers: n = 1024, some 4 GB.
const ELIMINATED: usize = 2_200_000;
/// Algebraic error over the error of discretisation where multigrid is the only solver.
const SHARE: f64 = 0.01;
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
}

impl SceneRun {
    /// |u_h|_a with the estimated algebraic error, from multigrid.
    pub fn error(&self) -> Option<Estimate> {
        self.solution.multigrid.as_ref()?.error
    }
}

/// What a study is doing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StudyProgress {
    /// Cells along each side.
    pub n: usize,
    /// The solver.
    pub solver: Solver,
    /// Where multigrid is; `None` when a solver begins.
    pub multigrid: Option<Progress>,
}

impl fmt::Display for StudyProgress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "n = {}, {}", self.n, self.solver)?;
        self.multigrid.map_or(Ok(()), |at| {
            write!(f, ": level {} of {}, step {}, error {:.0e}", at.level, at.levels - 1, at.step, at.error)
        })
    }
}

/// The accuracy of multigrid unless given: twelve digits beside another solver, else a hundredth of the error of
/// discretisation.
pub(super) fn asked(solver: Option<Solver>, accuracy: Option<Accuracy>) -> Accuracy {
    let alone = Accuracy::OfDiscretisation(SHARE);
    accuracy.unwrap_or(if solver.is_none() { Accuracy::default() } else { alone })
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
            let mut heard = |at: &Progress| observe(&StudyProgress { n, solver, multigrid: Some(*at) });
            let coarser = coarser.as_ref().filter(|_| solver == Solver::ActiveSet && is_chain);
            let solution = problem.solve(
                cone,
                Settings {
                    solver,
                    start: coarser.map_or(Start::Open, Start::Coarse),
                    accuracy: asked,
                    hierarchy: hierarchy.as_ref(),
                    progress: Some(&mut heard),
                    ..Settings::default()
                },
            )?;
            // The same problem from no contact.
            let cold = coarser.map(|_| problem.solve(cone, solver)).transpose()?;
            let cold_steps = cold.map(|cold| cold.work.iterations);
            runs.push(SceneRun { n, problem: problem.clone(), solution, cold_steps });
        }
    }
    Ok(runs)
}
