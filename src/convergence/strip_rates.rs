//! Rate studies on a strip: many scenes on the same levels.
//!
//! The operators of all levels and the exact error forms depend on the kind of strip and the grids alone; they are made once and serve
//! every scene, τ and cone. Each level starts from the coarser one. Below h_r, the mesh size of the reference grid, the data are smooth: a
//! singularity of order p lacks a share (h_r/h)^{2p} of e²; fits account for it where it is large, τ ≤ 3/2.

use super::level::RateLevel;
use super::store::LevelStore;
use super::study::RateStudy;
use crate::contact::Cone;
use crate::edge::{consistency_terms, edge_norm};
use crate::error::{Error, Result};
use crate::scenes::TransitionPowers;
use crate::strip::{
    EdgeOperator, EdgeScene, EdgeSolution, Levels, Reference, SceneKind, SceneSource, Settings, Sides,
    StripKind, StripProblem, solve_contact,
};
use std::time::Instant;

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

/// One family of scenes: a scene, or one at several positions whose errors are averaged.
pub struct SceneFamily<'a> {
    /// In words; part of the key of stored levels.
    pub name: String,
    /// The supremum of the τ with u ∈ H^τ.
    pub tau: f64,
    /// How many members.
    pub count: usize,
    /// Member i on an edge of so many cells.
    pub member: Box<dyn Fn(usize, usize) -> Result<EdgeScene> + 'a>,
}

impl SceneFamily<'_> {
    /// A named scene. One transition has a gap that is mirrored at natural sides ([`TransitionPowers`]) and is moved over `positions` places of a cell, spread over the cells of every level when odd.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for no position.
    pub fn named(
        source: &SceneSource,
        tau: f64,
        kind: StripKind,
        coarsest: usize,
        positions: usize,
    ) -> Result<Self> {
        if positions == 0 || positions > 1024 {
            return Err(Error::CountOutOfRange { name: "positions", value: positions, range: "[1, 1024]" });
        }
        let sides = kind.sides();
        let name = source.to_string();
        let source = source.clone();
        Ok(match source {
            SceneSource::Built(SceneKind::Transition { position }) => Self {
                name,
                tau,
                count: positions,
                member: Box::new(move |i, cells| {
                    let position = position + i as f64 / positions as f64 / coarsest as f64;
                    match sides {
                        Sides::Natural => TransitionPowers::of_regularity(tau).scene(position, cells),
                        Sides::Periodic => {
                            EdgeScene::build(SceneKind::Transition { position }, tau, cells, sides)
                        }
                    }
                }),
            },
            _ => Self {
                name,
                tau,
                count: 1,
                member: Box::new(move |_, cells| source.scene(tau, cells, sides)),
            },
        })
    }
}

impl RateStrip {
    /// A strip with the given levels and reference grid.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless the reference grid is a power of two that is finer than every level and has at most 2^22 cells.
    pub fn new(kind: StripKind, levels: Levels, reference_cells: usize) -> Result<Self> {
        let finest = levels.cells().max().unwrap_or(0);
        if !reference_cells.is_power_of_two() || reference_cells <= finest || reference_cells > 1 << 22 {
            let range = "the powers of two above the finest level, at most 2^22";
            return Err(Error::CountOutOfRange { name: "reference cells", value: reference_cells, range });
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

    /// Solves all levels of a family in one cone; levels found in the store are not solved again. `report` is called for each level
    /// of each member.
    ///
    /// # Errors
    /// Those of scenes, operators, solvers and the store.
    pub fn study(
        &mut self,
        family: &SceneFamily<'_>,
        cone: Cone,
        store: &mut LevelStore,
        report: &mut dyn FnMut(),
    ) -> Result<RateStudy> {
        let mut members = Vec::with_capacity(family.count);
        let mut norm = None;
        for i in 0..family.count {
            let mut scene = None;
            members.push(self.member(family, i, &mut scene, cone, store, report)?);
            if i == 0 && family.tau > 1.5 && family.tau < 2.0 {
                let scene = match scene {
                    Some(scene) => scene,
                    None => (family.member)(0, self.reference_cells)?,
                };
                norm = Some(edge_norm(&scene, family.tau)?);
            }
        }
        let levels = (0..members.first().map_or(0, Vec::len))
            .map(|k| {
                let same: Vec<RateLevel> = members.iter().map(|levels| levels[k].clone()).collect();
                RateLevel::mean(&same)
            })
            .collect::<Result<_>>()?;
        // Up to τ = 3/2 what the reference grid does not resolve is a large share of the error.
        let reference = (family.tau <= 1.5).then_some(1.0 / self.reference_cells as f64);
        let scene = format!("{} {}", self.kind, family.name);
        Ok(RateStudy { scene, tau: family.tau, cone, norm, reference, levels })
    }

    /// The levels of member i.
    fn member(
        &mut self,
        family: &SceneFamily<'_>,
        i: usize,
        scene: &mut Option<EdgeScene>,
        cone: Cone,
        store: &mut LevelStore,
        report: &mut dyn FnMut(),
    ) -> Result<Vec<RateLevel>> {
        let key = |cells: usize| {
            format!(
                "strip {} {} tau {} {cone} member {i}/{} from {} on {} n {cells}",
                self.kind, family.name, family.tau, family.count, self.levels, self.reference_cells,
            )
        };
        let keys: Vec<(usize, String)> = self.levels.cells().map(|cells| (cells, key(cells))).collect();
        let stored: Option<Vec<RateLevel>> = keys.iter().map(|(_, key)| store.get(key).cloned()).collect();
        if let Some(levels) = stored {
            levels.iter().for_each(|_| report());
            return Ok(levels);
        }
        let built = scene.insert((family.member)(i, self.reference_cells)?);
        self.set_scene(built)?;
        let terms = consistency_terms(built, cone);
        let mut previous: Option<EdgeSolution> = None;
        let mut levels = Vec::with_capacity(keys.len());
        for (k, (cells, key)) in keys.into_iter().enumerate() {
            if let Some(level) = store.get(&key) {
                // The next level then starts cold.
                levels.push(level.clone());
                previous = None;
            } else {
                let (mut level, solution) = self.solve(k, cells, cone, previous.as_ref())?;
                level.consistency = terms.iter().find(|term| term.0 == cells).map(|term| term.1);
                store.insert(key, level.clone())?;
                levels.push(level);
                previous = Some(solution);
            }
            report();
        }
        Ok(levels)
    }

    fn set_scene(&mut self, scene: &EdgeScene) -> Result<()> {
        if let Some(problem) = &mut self.problem {
            return problem.set_scene(scene);
        }
        let problem = StripProblem::new(self.kind, scene, Reference::Nested, self.levels.coarsest_cells())?;
        self.operators =
            self.levels.cells().map(|cells| problem.operator(cells)).collect::<Result<Vec<_>>>()?;
        self.problem = Some(problem);
        Ok(())
    }

    fn solve(
        &self,
        k: usize,
        cells: usize,
        cone: Cone,
        previous: Option<&EdgeSolution>,
    ) -> Result<(RateLevel, EdgeSolution)> {
        let (Some(problem), Some((operator, unknowns))) = (&self.problem, self.operators.get(k)) else {
            return Err(Error::CountOutOfRange { name: "level", value: k, range: "the levels of the strip" });
        };
        let start = Instant::now();
        let load = problem.load(cells)?;
        let solution = solve_contact(operator, &load, cone, previous, &Settings::default())?;
        let seconds = start.elapsed().as_secs_f64();
        let error = problem.error(cells, &solution.values)?;
        let level = RateLevel {
            cells,
            unknowns: *unknowns,
            error: error.value,
            error_bound: error.error,
            consistency: None,
            contact_runs: solution.contact.runs().len(),
            kkt: solution.judgement.worst(),
            seconds,
            flag: None,
        };
        let converged = solution.status.is_converged();
        Ok((level.judged(converged, self.reference_cells, RESOLVED), solution))
    }
}
