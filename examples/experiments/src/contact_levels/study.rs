//! A scene on one mesh or on nested ones, by one solver or by two, and how far two solutions are apart.

use super::known::known_energy;
use super::levels::{
    How, LEVELS, Level, SceneRun, StudyProgress, asked, solve_levels, solvers_for, unknowns,
};
use signorini::Result;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, Solver};
use signorini::problems::{Parameters, TestProblem};

/// Cells along each side up to which the interior point is the second solver: there it takes seconds.
pub(super) const INTERIOR: usize = 128;

/// What to solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneStudy {
    /// The scene.
    pub scene: TestProblem,
    /// Its parameters.
    pub setting: Parameters,
    /// The cone.
    pub cone: Cone,
    /// One solver. When `None` two: the active set, and beside it the interior point up to n = 128, multigrid
    /// above; beyond two million unknowns multigrid alone.
    pub solver: Option<Solver>,
    /// Cells along each side of the coarsest mesh.
    pub n: usize,
    /// Number of meshes n, 2n, 4n, ...; the active set starts from the contact set of the mesh before.
    pub levels: usize,
    /// The accuracy of multigrid; when `None` twelve digits beside another solver, else a hundredth of the error of
    /// discretisation.
    pub accuracy: Option<Accuracy>,
}

impl SceneStudy {
    /// J on n × n squares as other packages have found it ([`known_energy`]); `None` for another
    /// setting.
    pub fn known_energy(&self, n: usize) -> Option<f64> {
        known_energy(self.scene, self.cone, n).filter(|_| self.setting == Parameters::default())
    }

    /// About what the finest level takes, in bytes: elimination 100 log₂ N for each of N unknowns, the interior
    /// point 250 log₂ N, multigrid and its meshes 260 for each node.
    pub fn bytes(&self) -> f64 {
        let n = self.n as f64 * 2f64.powi(self.levels.min(LEVELS) as i32 - 1);
        let nodes = (n + 1.0).powi(2);
        let unknowns = nodes * if self.scene.is_elastic() { 2.0 } else { 1.0 };
        let counted = unknowns.min(1e18) as usize;
        let solvers = self.solvers_for(n.min(1e18) as usize, counted);
        let per_unknown = |solver: &Solver| match solver {
            Solver::Multigrid => 260.0 * nodes / unknowns,
            Solver::InteriorPoint => 250.0 * unknowns.log2(),
            _ => 100.0 * unknowns.log2(),
        };
        unknowns * solvers.iter().map(per_unknown).fold(0.0, f64::max)
    }

    /// Solves on every level, coarsest first, the active set before the second solver; `observe` hears of
    /// every beginning and of every step of multigrid, and its error ends the study.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) without levels; whatever meshes, problems, solvers and `observe`
    /// return.
    pub fn run_observed(
        &self,
        observe: impl FnMut(&StudyProgress) -> Result<()> + Send,
    ) -> Result<Vec<SceneRun>> {
        let level = |level: usize| {
            let n = self.n.saturating_mul(1 << level);
            Ok(Level { n, problem: self.scene.problem_with(n, &self.setting)?, hierarchy: None })
        };
        let how = How { cone: self.cone, levels: self.levels, asked: self.asked() };
        let solvers = |n: usize, problem: &ContactProblem| self.solvers_for(n, unknowns(problem));
        solve_levels(how, level, solvers, observe)
    }

    /// [`SceneStudy::run_observed`] by nobody.
    ///
    /// # Errors
    /// As there.
    pub fn run(&self) -> Result<Vec<SceneRun>> {
        self.run_observed(|_| Ok(()))
    }

    fn solvers_for(&self, n: usize, unknowns: usize) -> Vec<Solver> {
        self.solver.map_or_else(
            || solvers_for(n <= INTERIOR, unknowns),
            |solver| vec![solver.for_unknowns(unknowns)],
        )
    }

    fn asked(&self) -> Accuracy {
        asked(self.solver, self.accuracy)
    }
}
