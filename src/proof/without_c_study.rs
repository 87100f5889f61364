//! The bound without C beside the error of a problem in closed form, mesh after mesh.

use super::without_c::{BoundWithoutC, MeshShape, unit_square_korn};
use crate::cone::Cone;
use crate::error::Result;
use crate::estimate::Estimate;
use crate::scenes::{ClosedForm, ClosedFormLevel};
use std::fmt;

/// One problem in one cone.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundStudy {
    /// The problem.
    pub scene: ClosedForm,
    /// The cone.
    pub cone: Cone,
    /// |u|₂.
    pub whole: Estimate,
    /// Errors, coarsest mesh first.
    pub levels: Vec<ClosedFormLevel>,
    /// Bounds, one for each constant of a segment.
    pub bounds: Vec<BoundWithoutC>,
}

impl BoundStudy {
    /// Meshes of 4 × 4 ... 2^finest × 2^finest squares, and the given constants of a segment; `report` is called after
    /// each mesh.
    ///
    /// # Errors
    /// As [`ClosedForm::levels`] and [`BoundWithoutC::new`].
    pub fn new(
        scene: ClosedForm,
        cone: Cone,
        segment: &[f64],
        finest: u32,
        report: impl FnMut(),
    ) -> Result<Self> {
        // B plays no part in scalar problems.
        let korn = scene.lame.map_or(Ok(1.0), unit_square_korn)?;
        let shape = MeshShape::right_isosceles();
        let bound = |&c: &f64| BoundWithoutC::new(&scene.form(), cone, shape, c, korn);
        let bounds = segment.iter().map(bound).collect::<Result<_>>()?;
        let whole = scene.second_seminorm(1)?;
        Ok(Self { scene, cone, whole, levels: scene.levels(cone, finest, report)?, bounds })
    }

    /// Bound over error on every mesh with constant `version`: from |u|₂ near the edge, or (not `local`) from |u|₂ on Ω
    /// alone.
    ///
    /// # Errors
    /// As [`BoundWithoutC::bound`].
    pub fn effectivities(&self, version: usize, local: bool) -> Result<Vec<f64>> {
        let whole = self.whole.value + self.whole.error;
        let quotient = |level: &ClosedFormLevel| {
            let near = (level.near.value + level.near.error).min(whole);
            let near = if local { near } else { whole };
            Ok(self.bounds[version].bound(1.0 / level.n as f64, whole, near)? / level.error)
        };
        self.levels.iter().map(quotient).collect()
    }
}

impl fmt::Display for BoundStudy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.scene, self.cone)
    }
}
