//! `theorem_3_1_with_numbers` and `_elastic`: the theorems with explicit constants beside the error of a problem whose
//! solution is known.

use crate::known_levels::{KnownLevel, known_levels};
use fractional_sobolev::{Estimate, Tolerance};
use signorini::Result;
use signorini::cone::Cone;
use signorini::problems::{EdgeDatum, KnownSolution};
use signorini::proof::TheoremConstants;

/// Relative accuracy of the norms; all are rounded up by their errors.
const ACCURACY: f64 = 1e-5;
/// More than the rounding of a few dozen operations.
const ROUND_UP: f64 = 1.0 + 1e-13;

/// The bound on one mesh, and what it bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumberedRow {
    /// n; h = 1/n.
    pub n: usize,
    /// |u − u_h|_a.
    pub error: f64,
    /// |u − I^h u|_a.
    pub interpolation: f64,
    /// The bound with the norms of all of Ω and of the edge.
    pub bound: f64,
    /// The same with |u − I^h u|_a itself and the seminorms of the segment of the transition.
    pub near: f64,
}

/// One scene in one cone.
#[derive(Debug, Clone, PartialEq)]
pub struct NumberedStudy {
    /// Constants.
    pub numbers: TheoremConstants,
    /// The scene.
    pub scene: KnownSolution,
    /// The cone.
    pub cone: Cone,
    /// |∇u|_{τ−1} on the half disc.
    pub norm: f64,
    /// |σ_N|_ν and |u_N'|_ν on the edge.
    pub edge: [f64; 2],
    /// Coarsest mesh first.
    pub rows: Vec<NumberedRow>,
}

/// The segment with the transition inside, of n equal ones.
fn segment(transition: f64, n: usize) -> [f64; 2] {
    let first = (transition * n as f64).floor();
    [first, first + 1.0].map(|i| i / n as f64)
}

fn up(estimate: Estimate) -> f64 {
    ROUND_UP * (estimate.value + estimate.error)
}

impl NumberedStudy {
    /// The bound and the error on meshes of 4 × 4 ... 2^finest × 2^finest squares; `numbers` are those of the
    /// Laplacian.
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`](signorini::ToolkitError::InfiniteNorm) where u is not in H^τ, p ≤ τ − 1; as [`known_levels`].
    pub fn new(numbers: TheoremConstants, scene: KnownSolution, cone: Cone, finest: u32) -> Result<Self> {
        let numbers = scene.lame().map_or(numbers, |lame| numbers.elastic(lame));
        let (tau, asked) = (numbers.tau, Tolerance::new(ACCURACY)?);
        let norm = up(scene.body_seminorm(tau, asked)?);
        let both = |part: [f64; 2]| -> Result<[f64; 2]> {
            let one =
                |datum| -> Result<f64> { Ok(up(scene.edge_seminorm(datum, part, numbers.order, asked)?)) };
            Ok([one(EdgeDatum::Pressure)?, one(EdgeDatum::Slope)?])
        };
        let edge = both([0.0, 1.0])?;
        let row = |level: KnownLevel| -> Result<NumberedRow> {
            let KnownLevel { n, error, interpolation } = level;
            let h = 1.0 / n as f64;
            let [pressure, slope] = both(segment(scene.transitions()[0], n))?;
            let smooth = numbers.interpolation * h.powf(tau - 1.0) * norm;
            Ok(NumberedRow {
                n,
                error,
                interpolation,
                bound: numbers.bound(cone, h, smooth, edge[0] * edge[1], edge[0]),
                near: numbers.bound(cone, h, interpolation, pressure * slope, edge[0]),
            })
        };
        let rows = known_levels(&scene, cone, finest, || ())?.into_iter().map(row).collect::<Result<_>>()?;
        Ok(Self { numbers, scene, cone, norm, edge, rows })
    }
}
