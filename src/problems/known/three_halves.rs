//! A scalar Signorini problem with known solution: u = −Re (z − a)^{3/2} on the unit square, z = x + iy,
//! a = 2/5.
//!
//! With z − a = r e^{iφ}: u = −r^{3/2} cos(3φ/2) is harmonic. On y = 0 it is −r^{3/2} < 0 with ∂u/∂n = 0 to the right
//! of a, and 0 with ∂u/∂n = −(3/2) r^{1/2} ≤ 0 to the left: contact on [0, a], and exactly the regularity H^{5/2−ε}
//! of a transition inside a straight edge. u is prescribed on top, ∂u/∂n on the
//! left and the right side, integrated by quadrature.

use crate::contact::ContactProblem;
use crate::error::Result;
use crate::fem::{Field, Form};
use crate::mesh::{Part, Point, Triangulation};

/// The end of contact: 2/5, not a node of a uniform dyadic mesh.
pub(super) const TRANSITION: f64 = 0.4;

fn polar([x, y]: Point) -> (f64, f64) {
    ((x - TRANSITION).hypot(y), y.atan2(x - TRANSITION))
}

/// u.
pub(super) fn displacement(point: Point) -> f64 {
    let (r, phi) = polar(point);
    -r * r.sqrt() * (1.5 * phi).cos()
}

/// ∇u.
pub(super) fn gradient(point: Point) -> Point {
    let (r, phi) = polar(point);
    [-1.5 * r.sqrt() * (0.5 * phi).cos(), 1.5 * r.sqrt() * (0.5 * phi).sin()]
}

/// σ_N = ∂u/∂n on the contact edge.
pub(super) fn normal_stress(x: f64) -> f64 {
    -1.5 * (TRANSITION - x).max(0.0).sqrt()
}

/// The problem with all data multiplied by `scale`.
///
/// # Errors
/// As for [`ContactProblem::new`].
pub(in super::super) fn problem(mesh: Triangulation, scale: f64) -> Result<ContactProblem> {
    let load = vec![0.0; mesh.nodes().len()];
    let mut problem = ContactProblem::new(mesh, Form::LAPLACE, &load)?;
    problem.set_dirichlet(&Field::Scalar(&|point| scale * displacement(point)))?;
    problem.add_boundary_load(Part::Neumann, &|point, normal| {
        let [x, y] = gradient(point);
        Ok([scale * (x * normal[0] + y * normal[1]), 0.0])
    })?;
    Ok(problem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solution_satisfies_what_is_claimed() {
        for i in 0..=20 {
            let x = f64::from(i) / 20.0;
            let (u, slope) = (displacement([x, 0.0]), -gradient([x, 0.0])[1]);
            assert!(u <= 1e-16 && slope <= 1e-16 && (u * slope).abs() < 1e-16, "{x}: {u} {slope}");
            assert!((slope - normal_stress(x)).abs() < 1e-15, "{x}");
        }
        // Differences: gradient and Laplacian at an inner point, steps where rounding and truncation balance.
        let (h, [x, y]) = (1e-4, [0.7, 0.3]);
        let sides = [[x + h, y], [x - h, y], [x, y + h], [x, y - h]].map(displacement);
        let slope = gradient([x, y]);
        assert!(((sides[0] - sides[1]) / (2.0 * h) - slope[0]).abs() < 1e-8);
        assert!(((sides[2] - sides[3]) / (2.0 * h) - slope[1]).abs() < 1e-8);
        assert!((sides.iter().sum::<f64>() - 4.0 * displacement([x, y])).abs() / (h * h) < 1e-6);
    }
}
