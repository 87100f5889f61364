//! The scenes at τ = 2 on which the power of |ln h| is measured.

use super::plan::both_cones;
use crate::Result;
use experiments::convergence::{Levels, LogarithmFit, Quantity, RateStudy, SceneFamily, StripGroup};
use signorini::problems::{StripData, TransitionPowers};
use signorini::rates::Bound;
use signorini::strip::StripKind;

/// Powers α of one transition: a kink outside H², and three in it; then those of 22, and of a Cantor set.
const ALPHAS: [f64; 4] = [0.0, 0.75, 1.0, 1.5];
const OF_MANY: [f64; 3] = [0.0, 0.75, 1.0];
const OF_CANTOR: [f64; 3] = [0.0, 1.0, 1.5];
const MANY: StripData = StripData::Transitions { gaps: 11 };
const CANTOR: StripData = StripData::Cantor { ratio: 0.25, depth: 20 };
/// So many halvings until twenty-two transitions are resolved: levels that say nothing of a power.
const UNRESOLVED: usize = 3;

/// A scene in one cone.
pub struct LogarithmRow {
    /// "" for one transition, else "transitions" or "cantor".
    pub set: &'static str,
    /// α: slopes like |ln r|^{−α}.
    pub alpha: f64,
    /// The levels.
    pub study: RateStudy,
    /// The power q of ln(1/h) in (e/h)²; `None` for too few levels or an error that is not a positive number.
    pub fit: Option<LogarithmFit>,
}

impl LogarithmRow {
    /// All scenes in both cones, one transition before many, nodal cone first.
    ///
    /// # Errors
    /// Those of [`both_cones`].
    pub fn all(levels: Levels) -> Result<Vec<Self>> {
        let mut group = StripGroup::new(StripKind::Scalar, levels, (16 * levels.finest_cells()).min(1 << 22));
        let mut scenes: Vec<(&'static str, f64)> = Vec::new();
        for logarithm in ALPHAS {
            let powers = TransitionPowers { opening: 1.0, pressure: 0.0, logarithm };
            group.families.push(SceneFamily::at_thirds(powers, 2.0, levels.coarsest_cells()));
            scenes.push(("", logarithm));
        }
        for (set, scene, alphas) in [("transitions", &MANY, OF_MANY), ("cantor", &CANTOR, OF_CANTOR)] {
            for alpha in alphas {
                let coarsest = levels.coarsest_cells();
                group.families.push(SceneFamily::damped(scene, alpha, StripKind::Scalar, coarsest, 1)?);
                scenes.push((set, alpha));
            }
        }
        let pairs = scenes.into_iter().zip(both_cones(&group)?);
        let row = |(set, alpha): (&'static str, f64), study: RateStudy| {
            let points = study.points(Quantity::Error);
            let first = if set == "transitions" { UNRESOLVED.min(points.len()) } else { 0 };
            Self { set, alpha, fit: LogarithmFit::of(&points[first..]), study }
        };
        Ok(pairs.flat_map(|(scene, pair)| pair.map(|of_cone| row(scene, of_cone.study))).collect())
    }

    /// Whether it is one transition.
    pub fn is_single(&self) -> bool {
        self.set.is_empty()
    }

    /// For a table: a jump of the slopes, or what they behave like.
    pub fn name(&self) -> String {
        let slopes = if self.alpha == 0.0 { "kink".to_owned() } else { format!("|ln r|^-{}", self.alpha) };
        if self.is_single() { slopes } else { format!("{}, {slopes}", self.set) }
    }

    /// "none.cantor.nodal.75".
    pub fn key(&self, what: &str) -> String {
        let dot = if self.is_single() { "" } else { "." };
        format!("{what}{dot}{}.{}.{:.0}", self.set, self.study.cone, 100.0 * self.alpha)
    }

    /// error/bound on the finest level over the one in the middle, and what rounding leaves of it.
    pub fn growth(&self, bound: Bound) -> Option<(f64, f64)> {
        let ratios = self.study.ratios(Quantity::Error, bound).ok()?;
        let growth = ratios.last()? / ratios.get(ratios.len() / 2)?;
        Some((growth, 2.0 * self.study.precision() * growth))
    }
}
