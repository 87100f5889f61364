//! Stresses and gradients of P1 functions, constant on each triangle.

use super::form::{Element, Form};
use crate::error::{Error, Result};
use crate::mesh::{Point, Triangulation};
use crate::numeric::check::require_length;

/// The in-plane stress tensor.
///
/// In the units of λ and μ; tension is positive.
///
/// ```
/// use signorini::fem::Stress;
/// let stress = Stress { xx: 3.0, yy: -1.0, xy: 1.5 };
/// assert_eq!(stress.max_shear(), 2.5);
/// // On the floor, n = (0, −1): σ_N = σ_yy and σ_T along t = (1, 0) is −σ_xy.
/// assert_eq!(stress.traction([0.0, -1.0]), [-1.0, -1.5]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stress {
    /// σ_xx.
    pub xx: f64,
    /// σ_yy.
    pub yy: f64,
    /// σ_xy.
    pub xy: f64,
}

impl Stress {
    /// The maximum in-plane shear stress: the radius of Mohr's circle.
    pub fn max_shear(&self) -> f64 {
        (0.5 * (self.xx - self.yy)).hypot(self.xy)
    }

    /// The normal and tangential traction (σ_N, σ_T) on a line with unit normal n; σ_T along t = (−n_y, n_x).
    pub fn traction(&self, [nx, ny]: Point) -> Point {
        let force = [self.xx * nx + self.xy * ny, self.xy * nx + self.yy * ny];
        [force[0] * nx + force[1] * ny, force[1] * nx - force[0] * ny]
    }
}

/// The gradient ∇v on every triangle, for scalar nodal values.
///
/// Exact for affine v. The result has one vector per triangle, in the order of the triangles.
///
/// ```
/// use signorini::fem::gradients;
/// use signorini::mesh::{SideParts, unit_square};
/// let mesh = unit_square(2, SideParts::HANGING)?;
/// let values: Vec<f64> = mesh.nodes().iter().map(|[x, y]| 3.0 * x - 2.0 * y).collect();
/// assert!(gradients(&mesh, &values)?.iter().all(|&g| g == [3.0, -2.0]));
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless there is one value per node.
pub fn gradients(mesh: &Triangulation, values: &[f64]) -> Result<Vec<Point>> {
    require_length("nodal values", values.len(), mesh.nodes().len())?;
    Ok((0..mesh.triangles().len())
        .map(|t| {
            let at = mesh.triangles()[t].map(|node| values[node]);
            Element::new(mesh.corners(t)).gradient(at)
        })
        .collect())
}

/// The stress σ = λ (div u) I + 2 μ ε(u) on every triangle, for Cartesian nodal displacements (node-major).
///
/// Nodal displacements are (u_x, u_y), node after node. Uniform stretching u = (x, 0) gives σ_xx = λ + 2μ, σ_yy = λ.
///
/// ```
/// use signorini::fem::{Form, Lame, Stress, stresses};
/// use signorini::mesh::{SideParts, unit_square};
/// let mesh = unit_square(2, SideParts::HANGING)?;
/// let affine: Vec<f64> = mesh.nodes().iter().flat_map(|&[x, y]| [0.5 * x + y, 3.0 * x - y]).collect();
/// let all = stresses(&mesh, &Form::elastic(Lame::new(2.0, 3.0)?), &affine)?;
/// // div u = −1/2, ε = ((1/2, 2), (2, −1))
/// assert_eq!(all[0], Stress { xx: 2.0, yy: -7.0, xy: 12.0 });
/// assert!(stresses(&mesh, &Form::LAPLACE, &affine).is_err());
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless there are two values per node;
/// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a scalar form.
pub fn stresses(mesh: &Triangulation, form: &Form, displacement: &[f64]) -> Result<Vec<Stress>> {
    require_length("nodal values", displacement.len(), 2 * mesh.nodes().len())?;
    (0..mesh.triangles().len())
        .map(|t| {
            let scalar = || {
                Error::incompatible(
                    "form",
                    "scalar",
                    "the computation of stresses",
                    "an elastic form",
                )
            };
            let material = form.material(mesh.region(t)).ok_or_else(scalar)?;
            let element = Element::new(mesh.corners(t));
            let along = |axis: usize| {
                let at = mesh.triangles()[t].map(|node| displacement[2 * node + axis]);
                element.gradient(at)
            };
            let ([xx, xy], [yx, yy]) = (along(0), along(1));
            let pressure = material.lambda() * (xx + yy);
            Ok(Stress {
                xx: pressure + 2.0 * material.mu() * xx,
                yy: pressure + 2.0 * material.mu() * yy,
                xy: material.mu() * (xy + yx),
            })
        })
        .collect()
}
