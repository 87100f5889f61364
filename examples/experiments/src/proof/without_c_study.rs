//! The bound without C beside the error of a problem whose solution is known, mesh after mesh.

use super::bound_row::BoundRow;
use super::without_c_strip::strip_bounds;
use crate::convergence::Levels;
use crate::known_levels::{KnownLevel, known_levels};
use fractional_sobolev::{Order, Tolerance};
use signorini::Result;
use signorini::cone::Cone;
use signorini::problems::KnownSolution;
use signorini::proof::{ExplicitBound, MeshShape, half_plane_korn};
use signorini::proof::{SegmentConstant, consistency_constant, product_bound, product_constant};
use std::fmt;

/// Relative accuracy of |u|₂, rounded up by its error.
const SMOOTHNESS: f64 = 1e-2;

/// The three constants c, K, κ of a segment at ν = 1/2 for the bounds of the nodal and of the midpoint cone; K
/// and κ are rounded up by their errors. The midpoint cone has half of a product of two L¹ norms, whatever the
/// contact set, so that κ is of no use to it: c/2, K/2, K/2.
///
/// # Errors
/// Those of [`product_constant`].
pub fn segment_versions(tolerance: Tolerance) -> Result<[[f64; 3]; 2]> {
    let (order, up) = (Order::HALF, |found: SegmentConstant| found.value.value + found.value.error);
    let product = up(product_constant(order, tolerance)?);
    let nodal = [product_bound(order), product, up(consistency_constant(order, tolerance)?)];
    Ok([nodal, [0.5 * nodal[0], 0.5 * product, 0.5 * product]])
}

/// Where the solution is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BoundProblem {
    /// The unit square.
    Square(KnownSolution),
    /// The scalar strip with this many gaps between natural transitions.
    Strip(usize),
}

impl fmt::Display for BoundProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Square(scene) => scene.fmt(f),
            Self::Strip(gaps) => write!(f, "strip, {gaps} gaps"),
        }
    }
}

/// One problem in one cone.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundStudy {
    /// The problem.
    pub problem: BoundProblem,
    /// The cone.
    pub cone: Cone,
    /// Coarsest mesh first.
    pub rows: Vec<BoundRow>,
    /// On the square, one for each constant of a segment.
    pub bounds: Vec<ExplicitBound>,
}

impl BoundStudy {
    /// Meshes of 4 × 4 ... 2^finest × 2^finest squares, and the given constants of a segment; `report` is
    /// called after each mesh.
    ///
    /// # Errors
    /// As [`known_levels`] and [`ExplicitBound::new`].
    pub fn square(
        scene: KnownSolution,
        cone: Cone,
        segment: &[f64],
        finest: u32,
        report: impl FnMut(),
    ) -> Result<Self> {
        // B plays no part in scalar problems.
        let korn = scene.lame().map_or(1.0, half_plane_korn);
        let shape = MeshShape::right_isosceles();
        let bound = |&c: &f64| ExplicitBound::new(&scene.form(), cone, shape, c, korn);
        let bounds: Vec<ExplicitBound> = segment.iter().map(bound).collect::<Result<_>>()?;
        let whole = scene.second_seminorm(1, SMOOTHNESS)?;
        let whole = whole.value + whole.error;
        let row = |level: KnownLevel| {
            let KnownLevel { n, error, interpolation } = level;
            let near = scene.second_seminorm(n, SMOOTHNESS)?;
            let (h, near) = (1.0 / n as f64, (near.value + near.error).min(whole));
            let of =
                |near| bounds.iter().map(|bound| bound.bound(h, whole, near)).collect::<Result<Vec<f64>>>();
            let share = Some(near / whole);
            Ok(BoundRow { n, error, interpolation, share, near: of(near)?, whole: Some(of(whole)?) })
        };
        let rows = known_levels(&scene, cone, finest, report)?.into_iter().map(row).collect::<Result<_>>()?;
        Ok(Self { problem: BoundProblem::Square(scene), cone, rows, bounds })
    }

    /// The scalar strip with equal gaps; `report` is called after each mesh.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) where a segment of the coarsest mesh would be longer than half of a
    /// gap; those of the scenes and of the contact iteration.
    pub fn strip(
        gaps: usize,
        cone: Cone,
        segment: &[f64],
        levels: Levels,
        report: impl FnMut(),
    ) -> Result<Self> {
        let rows = strip_bounds(gaps, cone, segment, levels, report)?;
        Ok(Self { problem: BoundProblem::Strip(gaps), cone, rows, bounds: Vec::new() })
    }

    /// All quotients of bound and error with constant `version`, coarsest mesh first; none where the bound is
    /// not known.
    pub fn effectivities(&self, version: usize, local: bool) -> Vec<f64> {
        self.rows.iter().filter_map(|row| row.effectivity(version, local)).collect()
    }
}

impl fmt::Display for BoundStudy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.problem, self.cone)
    }
}
