//! Several families on one strip: operators and exact error forms are made once.

use super::family::SceneFamily;
use super::levels::Levels;
use super::memory::LevelMemory;
use super::strip_rates::RateStrip;
use super::study::RateStudy;
use signorini::Result;
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::strip::StripKind;

/// Families of scenes on one strip, with its levels and its reference grid.
pub struct StripGroup {
    /// Which strip.
    pub kind: StripKind,
    /// The levels.
    pub levels: Levels,
    /// Cells of the reference grid.
    pub reference_cells: usize,
    /// The families.
    pub families: Vec<SceneFamily<'static>>,
}

impl StripGroup {
    /// A strip without scenes.
    pub fn new(kind: StripKind, levels: Levels, reference_cells: usize) -> Self {
        Self { kind, levels, reference_cells, families: Vec::new() }
    }

    /// Adds a named scene at each of these regularities, a single transition at so many positions.
    ///
    /// # Errors
    /// As [`SceneFamily::named`].
    pub fn with(mut self, scene: &StripData, taus: &[f64], positions: usize) -> Result<Self> {
        for &tau in taus {
            let coarsest = self.levels.coarsest_cells();
            self.families.push(SceneFamily::named(scene, tau, self.kind, coarsest, positions)?);
        }
        Ok(self)
    }

    /// How many levels are solved in one cone, all members of all families together.
    pub fn steps(&self) -> usize {
        self.levels.cells().count() * self.families.iter().map(|family| family.count).sum::<usize>()
    }

    /// The studies of each family, one per cone.
    ///
    /// # Errors
    /// Those of [`RateStrip::study`].
    pub fn studies(
        &self,
        cones: &[Cone],
        memory: &mut dyn LevelMemory,
        report: &mut dyn FnMut(),
    ) -> Result<Vec<Vec<RateStudy>>> {
        let mut strip = RateStrip::new(self.kind, self.levels, self.reference_cells)?;
        let mut studies = Vec::with_capacity(self.families.len());
        for family in &self.families {
            let of_cone = |&cone: &Cone| strip.study(family, cone, memory, report);
            studies.push(cones.iter().map(of_cone).collect::<Result<_>>()?);
        }
        Ok(studies)
    }
}
