//! Rate studies on a strip: many scenes on the same levels.
//!
//! The operators of all levels and the exact error forms depend on the kind of strip and the grids alone;
//! they are made once and serve every scene, τ and cone. Each level starts from the coarser one. Below h_r,
//! the mesh size of the reference grid, the data are smooth: a singularity of order p lacks a share
//! (h_r/h)^{2p} of e²; [`RateStudy::fit`] accounts for it.

use super::family::SceneFamily;
use super::level::RateLevel;
use super::level_loop::solve_levels;
use super::levels::Levels;
use super::memory::{LevelKey, LevelMemory};
use super::strip_levels::StripLevels;
use super::study::{RateReference, RateStudy};
use super::subject::Subject;
use signorini::cone::Cone;
use signorini::edge::{consistency_terms, edge_norms};
use signorini::strip::{EdgeData, EdgeOperator, Reference, StripKind, StripProblem};
use signorini::{Error, Result, ToolkitError};

/// The reference grid is this much finer than the finest level that counts.
const RESOLVED: usize = 16;

/// A strip with its levels and its reference grid.
#[derive(Debug)]
pub struct RateStrip {
    kind: StripKind,
    levels: Levels,
    reference_cells: usize,
    problem: Option<StripProblem>,
    operators: Vec<(EdgeOperator, f64)>,
}

impl RateStrip {
    /// A strip with the given levels and reference grid.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) unless the reference grid is a power of two that is finer than every level
    /// and has at most 2^22 cells.
    pub fn new(kind: StripKind, levels: Levels, reference_cells: usize) -> Result<Self> {
        let finest = levels.cells().max().unwrap_or(0);
        if !reference_cells.is_power_of_two() || reference_cells <= finest || reference_cells > 1 << 22 {
            let range = "the powers of two above the finest level, at most 2^22";
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "reference cells",
                value: reference_cells,
                range,
            }));
        }
        Ok(Self { kind, levels, reference_cells, problem: None, operators: Vec::new() })
    }

    /// Which strip.
    pub fn kind(&self) -> StripKind {
        self.kind
    }

    /// The levels.
    pub fn levels(&self) -> Levels {
        self.levels
    }

    /// Solves all levels of a family in one cone; levels that the memory recalls are not solved again.
    /// `report` is called for each level of each member.
    ///
    /// # Errors
    /// Those of scenes, operators, solvers and the memory.
    pub fn study(
        &mut self,
        family: &SceneFamily<'_>,
        cone: Cone,
        memory: &mut dyn LevelMemory,
        report: &mut dyn FnMut(),
    ) -> Result<RateStudy> {
        let mut members = Vec::with_capacity(family.count);
        let mut norm = None;
        for i in 0..family.count {
            let mut scene = None;
            members.push(self.member(family, i, &mut scene, cone, memory, report)?);
            if i == 0 && family.tau > 1.5 && family.tau < 2.0 {
                let scene = match scene {
                    Some(scene) => scene,
                    None => (family.member)(0, self.reference_cells)?,
                };
                norm = Some(edge_norms(&scene, family.tau)?.norm);
            }
        }
        let planned = self.levels.cells().count();
        let levels = RateLevel::means(&members)?;
        let reference = RateReference::Resolved(1.0 / self.reference_cells as f64);
        let subject = Subject::Strip(self.kind, family.scene.clone());
        Ok(RateStudy { subject, tau: family.tau, cone, norm, reference, planned, levels })
    }

    /// The levels of member i.
    fn member(
        &mut self,
        family: &SceneFamily<'_>,
        i: usize,
        scene: &mut Option<EdgeData>,
        cone: Cone,
        memory: &mut dyn LevelMemory,
        report: &mut dyn FnMut(),
    ) -> Result<Vec<RateLevel>> {
        let key = |cells: usize| LevelKey {
            kind: self.kind,
            family: family.scene.clone(),
            tau: family.tau,
            cone,
            member: (i, family.count),
            levels: self.levels,
            reference_cells: self.reference_cells,
            cells,
        };
        let keys: Vec<LevelKey> = self.levels.cells().map(key).collect();
        let mut known: Vec<Option<RateLevel>> = keys.iter().map(|key| memory.recall(key)).collect();
        known.iter().flatten().for_each(|_| report());
        if known.iter().any(Option::is_none) {
            let built = scene.insert((family.member)(i, self.reference_cells)?);
            self.set_scene(built)?;
            let Some(problem) = &self.problem else { return Ok(Vec::new()) };
            let problem = StripLevels::with_operators(problem, self.levels, &self.operators);
            let terms = consistency_terms(built, cone);
            let is_known: Vec<bool> = known.iter().map(Option::is_some).collect();
            solve_levels(
                &problem,
                cone,
                |k| is_known[k],
                |k, level, _| {
                    let mut level = RateLevel::of(level, self.reference_cells, RESOLVED);
                    level.consistency = terms.iter().find(|term| term.0 == level.cells).map(|term| term.1);
                    memory.keep(&keys[k], &level)?;
                    known[k] = Some(level);
                    report();
                    Ok(())
                },
            )?;
        }
        Ok(known.into_iter().flatten().collect())
    }

    fn set_scene(&mut self, scene: &EdgeData) -> Result<()> {
        if let Some(problem) = &mut self.problem {
            return problem.set_data(scene);
        }
        let problem = StripProblem::new(self.kind, scene, Reference::Nested, self.levels.coarsest_cells())?;
        self.operators =
            self.levels.cells().map(|cells| problem.operator(cells)).collect::<Result<Vec<_>>>()?;
        self.problem = Some(problem);
        Ok(())
    }
}
