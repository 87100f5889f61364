//! A scene on one mesh or on nested ones, by one solver or by two, and how far two solutions are apart.

use super::mesh::{MeshScene, Setting};
use crate::cone::{Cone, Evidence, Judgement, NOISE};
use crate::contact::{Accuracy, ContactProblem, ContactSolution, Fallback, MultigridProgress, Solver};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use std::fmt;

/// Both force and gap below this, relative to their largest: √(duality gap) of the interior-point method.
const WEAK: f64 = 1e-6;
/// Cells along each side up to which the interior point is the second solver: there it takes seconds.
const INTERIOR: usize = 128;
/// Unknowns up to which elimination is one of two solvers: n = 1024, some 4 GB.
const ELIMINATED: usize = 2_200_000;
/// Most meshes of a study.
const LEVELS: usize = 12;

/// What to solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneStudy {
    /// The scene.
    pub scene: MeshScene,
    /// Its parameters.
    pub setting: Setting,
    /// The cone.
    pub cone: Cone,
    /// One solver. When `None` two: the active set, and beside it the interior point up to n = 128, multigrid
    /// above; beyond two million unknowns multigrid alone.
    pub solver: Option<Solver>,
    /// Cells along each side of the coarsest mesh.
    pub n: usize,
    /// Number of meshes n, 2n, 4n, ...; the active set starts from the contact set of the mesh before.
    pub levels: usize,
    /// What is asked of multigrid; when `None` twelve digits beside another solver, else its default.
    pub accuracy: Option<Accuracy>,
}

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

impl SceneStudy {
    /// J on n × n squares as other packages have found it ([`MeshScene::known_energy`]); `None` for another
    /// setting.
    pub fn known_energy(&self, n: usize) -> Option<f64> {
        self.scene.known_energy(self.cone, n).filter(|_| self.setting == Setting::default())
    }

    /// About what the finest level takes, in bytes: elimination 100 log₂ N for each of N unknowns, multigrid
    /// and its meshes 260 for each node.
    pub fn bytes(&self) -> f64 {
        let n = self.n as f64 * 2f64.powi(self.levels.min(LEVELS) as i32 - 1);
        let nodes = (n + 1.0).powi(2);
        let unknowns = nodes * if self.scene.is_elastic() { 2.0 } else { 1.0 };
        let counted = unknowns.min(1e18) as usize;
        let solvers = self.solvers_for(n.min(1e18) as usize, counted);
        let is_direct = solvers.iter().any(|solver| *solver != Solver::Multigrid);
        if is_direct { 100.0 * unknowns * unknowns.log2() } else { 260.0 * nodes }
    }

    /// Solves on every level, coarsest first, the active set before the second solver; `observe` hears of
    /// every beginning and of every step of multigrid, and its error ends the study.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without levels; whatever meshes, problems, solvers and `observe` return.
    pub fn run_observed(
        &self,
        mut observe: impl FnMut(&StudyProgress) -> Result<()> + Send,
    ) -> Result<Vec<SceneRun>> {
        if !(1..=LEVELS).contains(&self.levels) {
            return Err(Error::CountOutOfRange { name: "levels", value: self.levels, range: "[1, 12]" });
        }
        let mut runs: Vec<SceneRun> = Vec::new();
        for level in 0..self.levels {
            let n = self.n.saturating_mul(1 << level);
            let problem = self.scene.problem_with(n, &self.setting)?;
            let coarser = runs.iter().rev().find(|run| run.solution.solver == Solver::ActiveSet);
            let coarser = coarser.map(|run| run.solution.clone());
            for solver in self.solvers(n, &problem) {
                observe(&StudyProgress { n, solver, multigrid: None })?;
                let (mut cold_steps, mut error, mut fallback) = (None, None, None);
                let solution = match (&coarser, solver) {
                    (Some(coarse), Solver::ActiveSet) if !problem.edge().is_closed() => {
                        let (solution, cold) = problem.solve_after_beside_cold(coarse)?;
                        cold_steps = cold;
                        solution
                    }
                    (_, Solver::Multigrid) => {
                        let heard = |at: &MultigridProgress| {
                            observe(&StudyProgress { n, solver, multigrid: Some(*at) })
                        };
                        let found = problem.solve_by_multigrid(self.cone, None, self.asked(), heard)?;
                        (error, fallback) = (found.error, found.fallback);
                        found.solution
                    }
                    _ => problem.solve(self.cone, solver)?,
                };
                runs.push(SceneRun { n, problem: problem.clone(), solution, cold_steps, error, fallback });
            }
        }
        Ok(runs)
    }

    /// [`SceneStudy::run_observed`] by nobody.
    ///
    /// # Errors
    /// As there.
    pub fn run(&self) -> Result<Vec<SceneRun>> {
        self.run_observed(|_| Ok(()))
    }

    /// The solvers on one mesh.
    fn solvers(&self, n: usize, problem: &ContactProblem) -> Vec<Solver> {
        self.solvers_for(n, problem.mesh().nodes().len() * problem.form().components())
    }

    fn solvers_for(&self, n: usize, unknowns: usize) -> Vec<Solver> {
        match self.solver {
            Some(solver) => vec![solver.for_unknowns(unknowns)],
            None if n <= INTERIOR => vec![Solver::ActiveSet, Solver::InteriorPoint],
            None if unknowns <= ELIMINATED => vec![Solver::ActiveSet, Solver::Multigrid],
            None => vec![Solver::Multigrid],
        }
    }

    fn asked(&self) -> Accuracy {
        let beside = if self.solver.is_none() {
            Accuracy::Relative(Tolerance::reference())
        } else {
            Accuracy::default()
        };
        self.accuracy.unwrap_or(beside)
    }
}

impl SceneRun {
    /// The Karush-Kuhn-Tucker figures of multipliers and gaps as they stand; the balance is that of the
    /// solution.
    ///
    /// # Errors
    /// [`Error::NotFinite`] where a multiplier or a gap is not a number.
    pub fn judged(&self) -> Result<Judgement> {
        let solution = &self.solution;
        let evidence = Evidence {
            residual: &[],
            multiplier: &solution.multiplier,
            gap: &solution.gap,
            force: solution.force_scale,
            displacement: solution.displacement_scale,
        };
        Ok(Judgement { balance: solution.judgement.balance, ..evidence.judge()? })
    }

    /// How many constraints are weak: force and gap both below 1e-6 of their largest, so that no solver can
    /// tell contact from none.
    pub fn weak_constraints(&self) -> usize {
        let solution = &self.solution;
        let force = solution.multiplier.iter().fold(0.0, |m: f64, l| m.max(l.abs()));
        let is_weak =
            |(l, g): &(&f64, &f64)| l.abs() <= WEAK * force && g.abs() <= WEAK * solution.displacement_scale;
        solution.multiplier.iter().zip(&solution.gap).filter(is_weak).count()
    }
}

/// Pairs of solutions on the same mesh.
fn pairs(runs: &[SceneRun]) -> impl Iterator<Item = [&SceneRun; 2]> {
    runs.windows(2).filter(|pair| pair[0].n == pair[1].n).map(|pair| [&pair[0], &pair[1]])
}

/// The largest difference in J between two solutions on the same mesh, relative, and what rounding leaves
/// uncertain in it. `None` without two solutions on a mesh; not a number if a J is not.
pub fn energies_apart(runs: &[SceneRun]) -> Option<(f64, f64)> {
    pairs(runs)
        .map(|[a, b]| {
            let difference = (a.solution.energy - b.solution.energy).abs();
            let rounding = a.solution.energy_rounding + b.solution.energy_rounding;
            let scale = energy_scale(&a.solution);
            let share = |part: f64| if part == 0.0 { 0.0 } else { part / scale };
            (share(difference), share(rounding))
        })
        .reduce(|worst, apart| if worst.0 >= apart.0 || worst.0.is_nan() { worst } else { apart })
}

/// The largest number of constraints that are active in one of two solutions on the same mesh only, and how
/// many are weak there. `None` without two solutions on a mesh.
pub fn sets_apart(runs: &[SceneRun]) -> Option<(usize, usize)> {
    pairs(runs)
        .map(|[a, b]| {
            let (one, other) = (a.solution.contact_set.indices(), b.solution.contact_set.indices());
            let common = one.iter().filter(|i| other.binary_search(i).is_ok()).count();
            (one.len() + other.len() - 2 * common, a.weak_constraints().max(b.weak_constraints()))
        })
        .max()
}

/// |J|; where contact prevents every displacement J is rounding, and force times displacement is its scale.
fn energy_scale(solution: &ContactSolution) -> f64 {
    let largest = solution.displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    if largest <= NOISE * solution.displacement_scale {
        solution.force_scale * solution.displacement_scale
    } else {
        solution.energy.abs()
    }
}
