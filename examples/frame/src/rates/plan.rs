//! The scenes, regularities and meshes on which Theorems 3.1 and 4.1 are measured.

use super::row::RateRow;
use super::store::LevelStore;
use crate::{Error, Result, announce_memory, progress};
use experiments::ErrorExt;
use experiments::convergence::{LevelMemory, Levels, MeshRates, StripGroup, TransitionRates};
use signorini::cone::Cone;
use signorini::problems::{NamedProblem, Parameters, StripData, TestProblem};
use signorini::strip::StripKind;

/// What is solved: groups of scenes on strips, whose exact solution is known, and corners on meshes.
pub struct RatePlan {
    /// Scenes on strips.
    pub strips: Vec<StripGroup>,
    /// Scenes on meshes.
    pub meshes: Vec<MeshRates>,
}

/// Openings of the corners in degrees, τ = 1 + 90/ω: 120 is τ = 7/4.
const CORNERS: [f64; 4] = [100.0, 120.0, 135.0, 150.0];
/// Regularities of the short study below 2, and of the full one.
const FIVE: [f64; 5] = [1.55, 1.65, 1.75, 1.85, 1.95];
const NINE: [f64; 9] = [1.55, 1.6, 1.65, 1.7, 1.75, 1.8, 1.85, 1.9, 1.95];
/// Regularities from 2 on.
const SMOOTH: [f64; 4] = [2.0, 2.1, 2.25, 2.4];
/// Many transitions: 22 of them, none at a node of a dyadic mesh.
const MANY: StripData = StripData::Transitions { gaps: 11 };
/// Deeper than any grid resolves. These sets repeat themselves after a factor 2^{1/(4−2τ)} in h: only τ ≤ 1.8
/// shows several periods.
const FAT: StripData = StripData::FatCantor { depth: 30 };
/// Regularities are told apart by this when they are chosen.
const SAME: f64 = 1e-3;

impl RatePlan {
    /// Some seconds of work: one transition, 22 transitions, fat Cantor sets on strips, corners on meshes.
    ///
    /// # Errors
    /// None for these values.
    pub fn short() -> Result<Self> {
        let all = [&FIVE[..], &SMOOTH].concat();
        let group = |kind, from, to, reference: u32| {
            Ok::<_, Error>(StripGroup::new(kind, Levels::new(from, to)?, 1 << reference))
        };
        let strips = vec![
            group(StripKind::Scalar, 3, 12, 17)?.with(&StripData::transition(), &all, 7)?,
            group(StripKind::Elastic, 3, 12, 17)?.with(&StripData::transition(), &[1.55, 1.75, 1.95], 5)?,
            group(StripKind::Scalar, 6, 14, 18)?.with(&MANY, &FIVE, 1)?.with(&FAT, &FIVE[..3], 1)?,
        ];
        Ok(Self { strips, meshes: CORNERS.map(|angle| corner(angle, 3, 7)).to_vec() })
    }

    /// The long study: minutes, corners to h = 1/2048 with 9 GB for their references.
    ///
    /// # Errors
    /// None for these values.
    pub fn full() -> Result<Self> {
        let all = [&NINE[..], &SMOOTH].concat();
        let mut strips = Vec::new();
        for from in [3, 6] {
            for kind in [StripKind::Scalar, StripKind::Elastic] {
                let group = StripGroup::new(kind, Levels::new(from, 16)?, 1 << 20);
                strips.push(match from {
                    3 => group.with(&StripData::transition(), &all, 5)?,
                    _ => group.with(&MANY, &all, 1)?.with(&FAT, &NINE[..6], 1)?,
                });
            }
        }
        Ok(Self { strips, ..Self::corners(Levels::new(2, 11)?) })
    }

    /// The corners of the study alone.
    pub fn corners(levels: Levels) -> Self {
        let meshes = CORNERS.map(|angle| corner(angle, levels.coarsest_cells(), levels.cells().count()));
        Self { strips: Vec::new(), meshes: meshes.to_vec() }
    }

    /// One scene, with its own load on meshes.
    ///
    /// # Errors
    /// As [`StripGroup::with`].
    pub fn of_scene(
        scene: &NamedProblem,
        kind: StripKind,
        levels: Levels,
        tau: f64,
        positions: usize,
    ) -> Result<Self> {
        check(&[tau])?;
        let coarsest = levels.coarsest_cells();
        Ok(match scene {
            NamedProblem::Strip(scene) => {
                let group = StripGroup::new(kind, levels, (32 * levels.finest_cells()).min(1 << 22));
                Self { strips: vec![group.with(scene, &[tau], positions)?], meshes: Vec::new() }
            }
            NamedProblem::Mesh(scene) => {
                let (setting, levels) = (Parameters::default(), levels.cells().count());
                let mesh = MeshRates { scene: *scene, setting, constant_load: false, coarsest, levels };
                Self { strips: Vec::new(), meshes: vec![mesh] }
            }
        })
    }

    /// Only these regularities; all of them when there are none.
    ///
    /// # Errors
    /// [`Error::Option`] when nothing is left.
    pub fn with_taus(mut self, taus: &[f64]) -> Result<Self> {
        check(taus)?;
        let wanted = |tau: f64| taus.is_empty() || taus.iter().any(|t| (t - tau).abs() < SAME);
        for group in &mut self.strips {
            group.families.retain(|family| wanted(family.tau));
        }
        self.strips.retain(|group| !group.families.is_empty());
        self.meshes.retain(|mesh| wanted(1.0 + 90.0 / mesh.setting.angle));
        if self.steps() == 0 {
            let all = "1.55, 1.65, ..., 1.95, 2, 2.1, 2.25 or 2.4; with --scene any in (3/2, 5/2]";
            return Err(Error::Option(format!("unknown tau {taus:?}: expected {all}")));
        }
        Ok(self)
    }

    /// Steps of a progress bar: levels of strips at all positions, and corners.
    pub fn steps(&self) -> usize {
        self.strips.iter().map(StripGroup::steps).sum::<usize>() + self.meshes.len()
    }

    /// About what the largest study takes, in bytes: 200 for each cell of the reference of a strip; for each
    /// square of the finest mesh, whose reference is twice as fine, 2200 for a scalar and 3700 for a body.
    fn bytes(&self) -> f64 {
        let strips = self.strips.iter().map(|group| 200.0 * group.reference_cells as f64);
        let squares = |mesh: &MeshRates| (mesh.coarsest as f64 * (mesh.levels as f64 - 1.0).exp2()).powi(2);
        let bytes = |mesh: &MeshRates| if mesh.scene.is_elastic() { 3700.0 } else { 2200.0 } * squares(mesh);
        strips.chain(self.meshes.iter().map(bytes)).fold(0.0, f64::max)
    }

    /// All studies in one cone with their fits; finished levels of strips are taken from the memory.
    ///
    /// # Errors
    /// [`Error::Option`] for more than the memory of the machine; those of [`StripGroup::studies`] and
    /// [`MeshRates::study`].
    pub fn rows(&self, cone: Cone, memory: &mut dyn LevelMemory) -> Result<Vec<RateRow>> {
        announce_memory(self.bytes())?;
        let bar = progress(self.steps() as u64);
        let mut rows = Vec::new();
        for group in &self.strips {
            let studies = group.studies(&[cone], memory, &mut || bar.inc(1))?;
            rows.extend(studies.into_iter().flatten().map(RateRow::new));
        }
        for mesh in &self.meshes {
            rows.extend(mesh.study(&[cone])?.into_iter().map(RateRow::new));
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(rows)
    }
}

fn check(taus: &[f64]) -> Result<()> {
    for &tau in taus {
        fractional_sobolev::Error::require("tau", tau, "(3/2, 5/2]", tau > 1.5 && tau <= 2.5)?;
    }
    Ok(())
}

/// The families of a group in both cones, nodal first, with their fits; a family that comes twice is solved
/// once.
///
/// # Errors
/// Those of [`StripGroup::studies`].
pub fn both_cones(group: &StripGroup) -> Result<Vec<[RateRow; 2]>> {
    let bar = progress(2 * group.steps() as u64);
    let mut memory = LevelStore::in_memory();
    let mut pairs = Vec::new();
    for cones in group.studies(&[Cone::Nodal, Cone::Midpoint], &mut memory, &mut || bar.inc(1))? {
        let mut rows = cones.into_iter().map(RateRow::new);
        pairs.extend(rows.next().zip(rows.next()).map(|(nodal, midpoint)| [nodal, midpoint]));
    }
    bar.finish_and_clear();
    Ok(pairs)
}

/// One transition on meshes in both cones, nodal first, with its fits.
///
/// # Errors
/// Those of [`TransitionRates::study`].
pub fn on_meshes(transition: &TransitionRates) -> Result<[RateRow; 2]> {
    let bar = progress(2 * transition.steps() as u64);
    let studies = transition.study(&[Cone::Nodal, Cone::Midpoint], || bar.inc(1))?;
    bar.finish_and_clear();
    let rows: Vec<RateRow> = studies.into_iter().map(RateRow::new).collect();
    rows.try_into().map_err(|_| Error::Option("a study is missing: expected one per cone".to_owned()))
}

/// With f = −1: u < 0 by the maximum principle, the contact edge is free and the corner is all there is.
fn corner(angle: f64, coarsest: usize, levels: usize) -> MeshRates {
    let setting = Parameters { angle, ..Parameters::default() };
    MeshRates { scene: TestProblem::Corner, setting, constant_load: true, coarsest, levels }
}
