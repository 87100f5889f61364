//! Rate studies of one transition on meshes, whose solution is known.
//!
//! The transition lies at one third of the edge and at two thirds: doubling exchanges the two places in their
//! cells, so that the mean of the squared errors has no phase. Errors are exact, by quadrature: nothing
//! stands for the solution. Every level starts without contact, a closed edge too.

use super::level::RateLevel;
use super::level_loop::{Facts, LevelProblem, solve_levels};
use super::study::{RateReference, RateStudy};
use super::subject::Subject;
use fractional_sobolev::Estimate;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::problems::{KnownSolution, TransitionPowers};
use signorini::{Error, Result, ToolkitError};

/// Where the transition lies.
const POSITIONS: [f64; 2] = [1.0 / 3.0, 2.0 / 3.0];
/// Squares along each side of the finest mesh: by elimination some ten seconds.
const LARGEST: usize = 1024;
/// Relative accuracy of the errors: what rules with four and five points leave.
const QUADRATURE: f64 = 1e-2;

/// One transition on uniform meshes of the square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransitionRates {
    /// Its powers.
    pub powers: TransitionPowers,
    /// The supremum of the τ with u ∈ H^τ.
    pub tau: f64,
    /// Contact conditions and a reaction term on the whole boundary, or on the bottom of a square held on the
    /// other sides.
    pub whole_boundary: bool,
    /// Squares along each side of the coarsest mesh.
    pub coarsest: usize,
    /// Number of meshes n, 2n, 4n, ...
    pub levels: usize,
}

impl TransitionRates {
    /// Levels at all positions: steps of a progress bar for one cone.
    pub fn steps(&self) -> usize {
        POSITIONS.len() * self.levels
    }

    /// The studies of the given cones; `report` is called for each level at each position.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) for no level or a finest mesh of more than 1024 squares; as
    /// [`KnownSolution::transition`]; those of solvers and norms.
    pub fn study(&self, cones: &[Cone], mut report: impl FnMut()) -> Result<Vec<RateStudy>> {
        let finest = u32::try_from(self.levels.saturating_sub(1))
            .ok()
            .and_then(|k| 1usize.checked_shl(k))
            .and_then(|factor| self.coarsest.checked_mul(factor));
        let cells = finest.filter(|&n| self.coarsest > 0 && self.levels > 0 && n <= LARGEST);
        let Some(cells) = cells else {
            let range = "[1, levels whose finest mesh has at most 1024 squares along each side]";
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "levels",
                value: self.levels,
                range,
            }));
        };
        let of_cone = |&cone: &Cone| {
            let mut members: Vec<Vec<RateLevel>> = Vec::new();
            for position in POSITIONS {
                let scene = match self.whole_boundary {
                    true => KnownSolution::whole_boundary(self.powers, position)?,
                    false => KnownSolution::transition(self.powers, position)?,
                };
                let problem = OnePosition { scene, coarsest: self.coarsest, levels: self.levels };
                let note = |_, _: &_, _: &_| {
                    report();
                    Ok(())
                };
                let solved = solve_levels(&problem, cone, |_| false, note)?;
                let judged = solved.iter().flatten().map(|level| RateLevel::of(level, cells, 1));
                members.push(judged.collect());
            }
            let levels = RateLevel::means(&members)?;
            let subject = Subject::Transition { powers: self.powers, whole_boundary: self.whole_boundary };
            let (reference, planned) = (RateReference::Exact, self.levels);
            Ok(RateStudy { subject, tau: self.tau, cone, norm: None, reference, planned, levels })
        };
        cones.iter().map(of_cone).collect()
    }
}

/// The levels at one position.
struct OnePosition {
    scene: KnownSolution,
    coarsest: usize,
    levels: usize,
}

impl LevelProblem for OnePosition {
    type Solution = (ContactProblem, ContactSolution);

    fn count(&self) -> usize {
        self.levels
    }

    fn solve(&self, level: usize, cone: Cone, _: Option<&Self::Solution>) -> Result<Self::Solution> {
        let problem = self.scene.problem(self.coarsest << level)?;
        let solution = problem.solve(cone, Solver::ActiveSet)?;
        Ok((problem, solution))
    }

    fn error(&self, _: usize, (problem, solution): &Self::Solution) -> Result<Estimate> {
        self.scene.error(problem, &solution.displacement, QUADRATURE)
    }

    fn facts(&self, level: usize, (problem, solution): &Self::Solution) -> Facts {
        Facts {
            cells: self.coarsest << level,
            unknowns: problem.free_unknowns() as f64,
            contact_runs: solution.contact_set.runs().len(),
            inner_iterations: Vec::new(),
            status: solution.status,
            kkt: solution.kkt.worst(),
        }
    }
}
