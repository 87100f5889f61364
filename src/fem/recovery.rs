//! Continuous gradients from piecewise constant ones.

use super::form::Element;
use super::stress::gradients;
use crate::error::Result;
use crate::mesh::{Point, Triangulation};

/// Nodal values of a continuous piecewise linear field: at each node the mean of ∇v over the triangles there,
/// weighted by area; for scalar nodal values. On uniform meshes of order h² inside and h at the boundary.
///
/// Reference: M. Zlámal, Some superconvergence results in the finite element method, LNM 606 (1977) 353-362.
///
/// # Errors
/// As [`gradients`].
pub fn recovered_gradients(mesh: &Triangulation, values: &[f64]) -> Result<Vec<Point>> {
    let mut sums = vec![([0.0; 2], 0.0); mesh.nodes().len()];
    for (t, gradient) in gradients(mesh, values)?.into_iter().enumerate() {
        let area = Element::new(mesh.corners(t)).area;
        for node in mesh.triangles()[t] {
            let (sum, weight) = &mut sums[node];
            (0..2).for_each(|d| sum[d] += area * gradient[d]);
            *weight += area;
        }
    }
    // A node of no triangle has no gradient.
    Ok(sums.into_iter().map(|(sum, w)| if w > 0.0 { sum.map(|s| s / w) } else { sum }).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Sides, unit_square};

    #[test]
    fn gradients_of_quadratic_functions_are_exact_inside() {
        let mesh = unit_square(8, Sides::HANGING).unwrap();
        let values: Vec<f64> = mesh.nodes().iter().map(|[x, y]| x * x - 3.0 * x * y + 0.5 * y).collect();
        for (found, [x, y]) in recovered_gradients(&mesh, &values).unwrap().iter().zip(mesh.nodes()) {
            let exact = [2.0 * x - 3.0 * y, 0.5 - 3.0 * x];
            let apart = (found[0] - exact[0]).hypot(found[1] - exact[1]);
            let is_inside = [x, y].iter().all(|c| **c > 0.0 && **c < 1.0);
            assert!(apart < if is_inside { 1e-13 } else { 0.4 }, "{x} {y}: {apart}");
        }
    }
}
