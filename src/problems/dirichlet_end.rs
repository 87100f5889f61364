//! A body whose bottom is the Dirichlet boundary for x < 0 and the contact boundary for x > 0, on rings that resolve
//! the origin.
//!
//! Ring k of the mesh is the outline scaled by e^{−k `step`}; the form is plane strain with μ = 1, or the Laplacian. The
//! load is a constant traction (cos α, sin α) on the outline: tension for α = 90°, compression for −90°, shear for 0°
//! and 180°. In the scalar problem u replaces u_N = −u_y, and the load is −sin α. There is no volume load: near the
//! origin the solution is determined by the far field.

use crate::contact::ContactProblem;
use crate::error::{Error, Result};
use crate::fem::{Field, Form, Lame};
use crate::mesh::{Outline, polar_rings};

/// The data of a test problem in which the Dirichlet and the contact boundary meet.
///
/// The two parts meet at the origin at an angle of π. The number of nodes is about
/// `angles` · ln(1/`smallest`)/`step`.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, mesh::Outline, problems::DirichletEnd};
/// let (outline, poisson) = (Outline::HalfDisc, Some(0.0));
/// let pressed = DirichletEnd { outline, angles: 8, step: 0.4, smallest: 1e-4, poisson, direction: -90.0 };
/// let found = pressed.problem()?.solve(Cone::Nodal, Solver::ActiveSet)?;
/// // λ ≥ 0 and equilibrium of all forces, over four decades of r
/// assert!(found.multiplier.iter().all(|l| *l >= -1e-12) && found.balance < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirichletEnd {
    /// The outline of the body.
    pub outline: Outline,
    /// Number of sectors of a ring, a multiple of 4.
    pub angles: usize,
    /// Logarithm of the ratio of the radii of consecutive rings.
    pub step: f64,
    /// Rings are added until their radius is at most this value.
    pub smallest: f64,
    /// Poisson's ratio in (−1, 1/2); `None` for the scalar problem.
    pub poisson: Option<f64>,
    /// The direction α of the traction, in degrees.
    pub direction: f64,
}

impl DirichletEnd {
    /// The assembled contact problem.
    ///
    /// ```
    /// use signorini::{fem::Form, mesh::Outline, problems::DirichletEnd};
    /// let (outline, poisson) = (Outline::HalfDisc, None);
    /// let body = DirichletEnd { outline, angles: 8, step: 0.4, smallest: 1e-3, poisson, direction: 90.0 };
    /// let problem = body.problem()?;
    /// // the contact edge extends from the origin to (1, 0)
    /// assert!((problem.contact_mesh()?.nodes().last().unwrap_or(&0.0) - 1.0).abs() < 1e-12);
    /// assert_eq!(problem.form(), &Form::LAPLACE);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless `angles` is a multiple of 4 in [4,
    /// 512] and there are at most four million nodes; [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange)
    /// unless 1e−3 ≤ `step` ≤ 2, 1e−140 ≤ `smallest` ≤ 1/2 (areas of smaller rings underflow), Poisson's ratio lies in
    /// (−1, 1/2) and the direction is finite.
    pub fn problem(&self) -> Result<ContactProblem> {
        let Self { outline, angles, step, smallest, poisson, direction } = *self;
        Error::require("direction of the load", direction, "(-inf, inf)", direction.is_finite())?;
        let form = match poisson {
            None => Form::LAPLACE,
            Some(nu) => {
                // λ = 2μν/(1 − 2ν) with μ = 1: E = 2 (1 + ν).
                Form::elastic(Lame::plane_strain(2.0 * (1.0 + nu), nu)?)
            }
        };
        let mesh = polar_rings(outline, angles, step, smallest)?;
        let zeros = vec![0.0; mesh.nodes().len() * form.components()];
        let mut problem = ContactProblem::new(mesh, form, &zeros)?;
        let (sin, cos) = direction.to_radians().sin_cos();
        match poisson {
            None => problem.add_surface_load(&Field::Scalar(&|_| -sin))?,
            Some(_) => problem.add_surface_load(&Field::Vector(&|_| [cos, sin]))?,
        }
        Ok(problem)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::Cone;
    use crate::contact::Solver;
    use crate::edge::radial_intervals;

    const END: DirichletEnd = DirichletEnd {
        outline: Outline::HalfDisc,
        angles: 8,
        step: 0.4,
        smallest: 1e-40,
        poisson: Some(0.0),
        direction: 90.0,
    };

    #[test]
    fn every_ring_is_solved_and_a_pulled_body_keeps_one_zone() {
        for cone in Cone::ALL {
            let problem = END.problem().unwrap();
            let solution = problem.solve(cone, Solver::ActiveSet).unwrap();
            assert!(solution.status.is_converged(), "{cone}");
            let found = radial_intervals(&solution.positions, &solution.contact_set).unwrap();
            // The midpoint cone touches with every other segment.
            let is_one = found.len() == 2 || cone == Cone::Midpoint;
            assert!(is_one && found[0].in_contact, "{cone}: {} stretches", found.len());
            let bounds: Vec<f64> = (0..41).rev().map(|k| 10f64.powi(-k)).collect();
            let judged = problem.kkt_by_radius(&solution, [0.0; 2], &bounds).unwrap();
            assert!(judged.iter().all(|ring| ring.worst() < 1e-10), "{cone}: {judged:?}");
        }
    }
}
