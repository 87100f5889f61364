//! Remark 3: one face of contact in three dimensions, a right isosceles triangle T with legs 1, open in small
//! gaps about its corners.
//!
//! σ = −1 in contact and 0 in the gaps; u = 0 in contact and −1 at the corners, linear in each gap, a
//! triangle cut off with legs r. Elementwise the consistency term of the nodal cone is ∫_T σ Iu, that of the
//! cone of means (1/|T|) ∫σ ∫u; both over |σ|_ν |∇u|_ν, seminorms on T, 0 < ν < 1/2. In scaling, |σ|_ν ~
//! r^{1−ν} and |∇u|_ν ~ r^{−ν}, while Iu = −1 on all of T: the nodal quotient grows like r^{2ν−1}, the other
//! falls like r^{1+2ν}.

use crate::EstimateExt;
use fractional_sobolev::{Estimate, Function, Given, Order, Tolerance, Triangles};
use signorini::Result;

/// Both quotients for one size of the gaps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceGaps {
    /// The legs of a gap.
    pub radius: f64,
    /// ∫ σ Iu over both seminorms.
    pub nodal: Estimate,
    /// (1/|T|) ∫σ ∫u over both seminorms.
    pub mean: Estimate,
}

impl FaceGaps {
    /// Gaps with legs 2^{-1-halvings}.
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`](signorini::ToolkitError::InfiniteNorm) for ν ≥ 1/2: σ jumps; [`ToolkitError::ToleranceNotMet`](signorini::ToolkitError::ToleranceNotMet).
    pub fn new(halvings: u32, order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        let face = Face::new(halvings)?;
        let areas = face.mesh.areas();
        let contact: f64 = face.pressure.iter().zip(areas).map(|(s, area)| s * area).sum();
        let thirds = |t: &[usize; 3]| t.iter().map(|&node| face.gap[node]).sum::<f64>() / 3.0;
        let opening: f64 = face.mesh.triangles().iter().zip(areas).map(|(t, area)| thirds(t) * area).sum();
        let pressure = Function::on_triangles(&face.mesh, 0, &face.pressure)?;
        let gap = Function::on_triangles(&face.mesh, 1, &face.gap)?;
        let slope = gap.seminorm(order.plus_one(), tolerance)?;
        let pressure = pressure.seminorm(order, tolerance)?;
        // Iu = −1.
        let [nodal, mean] = [-contact, contact * opening / areas.iter().sum::<f64>()];
        let over = |term: f64| pressure.recip()?.over(slope)?.times(term);
        Ok(Self { radius: 0.5f64.powi(halvings as i32 + 1), nodal: over(nodal)?, mean: over(mean)? })
    }
}

/// The triangulation, σ on triangles, u at nodes.
struct Face {
    mesh: Triangles,
    pressure: Vec<f64>,
    gap: Vec<f64>,
}

impl Face {
    /// The triangle between the middles of the sides, and towards each corner strips that are halved again
    /// and again.
    fn new(halvings: u32) -> Result<Self> {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let middle = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let mut nodes: Vec<[f64; 2]> = (0..3).map(|k| middle(corners[k], corners[(k + 1) % 3])).collect();
        let (mut triangles, mut pressure, mut gap) = (vec![[0, 1, 2]], vec![-1.0], vec![0.0; 3]);
        for (k, &corner) in corners.iter().enumerate() {
            let (mut p, mut q) = (k, (k + 2) % 3);
            for _ in 0..halvings {
                let a = nodes.len();
                nodes.extend([middle(corner, nodes[p]), middle(corner, nodes[q])]);
                gap.extend([0.0; 2]);
                triangles.extend([[p, q, a], [q, a + 1, a]]);
                pressure.extend([-1.0; 2]);
                (p, q) = (a, a + 1);
            }
            triangles.push([nodes.len(), p, q]);
            nodes.push(corner);
            pressure.push(0.0);
            gap.push(-1.0);
        }
        Ok(Self { mesh: Triangles::new(nodes, triangles)?, pressure, gap })
    }
}
