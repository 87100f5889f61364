//! The problem of a rough transition on the meshes with n × n squares, n = 4, 8, ..., and the errors of its
//! discrete solutions.

use super::rough_transition::{RoughTransition, TRANSITION};
use crate::cone::Cone;
use crate::contact::{ContactProblem, ContactSolution, Solver};
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Cubature, ErrorNorms, Field, error_norms};
use crate::mesh::{Part, Sides, unit_square};

/// Points along each side of a triangle's rule for errors, graded towards the transition.
const POINTS: usize = 4;

/// One mesh with n × n squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughLevel {
    /// n; h = 1/n.
    pub n: usize,
    /// |u − u_h|_a.
    pub error: f64,
    /// |u − I^h u|_a.
    pub interpolation: f64,
}

impl RoughTransition {
    /// The problem on the structured mesh with n × n squares; the load of the edge is integrated exactly.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 1 ≤ n ≤ 16384.
    pub fn problem(&self, n: usize) -> Result<ContactProblem> {
        let given = Part::Dirichlet;
        let mesh = unit_square(n, Sides { bottom: Part::Contact, right: given, top: given, left: given })?;
        let form = self.form();
        let (c, mut load) = (form.components(), vec![0.0; mesh.nodes().len() * form.components()]);
        // In the direction of n: u_N is u, or −u_y.
        let normal = if c == 2 { -1.0 } else { 1.0 };
        let (h, q) = (1.0 / n as f64, self.power() - 1.0);
        // ∫ r^q over the part and ∫ r^{q+1}, with r from `near` to `far`.
        let moment = |k: f64, near: f64, far: f64| (far.powf(q + k) - near.powf(q + k)) / (q + k);
        for i in 0..n {
            let (left, right) = (i as f64 * h, (i + 1) as f64 * h);
            for (size, side) in self.loads().into_iter().zip([-1.0, 1.0]) {
                let (low, high) =
                    if side < 0.0 { (left, right.min(TRANSITION)) } else { (left.max(TRANSITION), right) };
                if low >= high {
                    continue;
                }
                let distances = [low, high].map(|x| side * (x - TRANSITION));
                let (near, far) = (distances[0].min(distances[1]).max(0.0), distances[0].max(distances[1]));
                let (whole, first) = (moment(1.0, near, far), moment(2.0, near, far));
                // The hat of the right node is (x − left)/h, x = a ± r.
                let right_part = ((TRANSITION - left) * whole + side * first) / h;
                load[(i + 2) * c - 1] += normal * size * right_part;
                load[(i + 1) * c - 1] += normal * size * (whole - right_part);
            }
        }
        let nothing = vec![0.0; load.len()];
        let mut problem = ContactProblem::new(mesh, form, &nothing)?;
        problem.add_load(&load)?;
        self.with_field(|field| problem.set_dirichlet(field))?;
        Ok(problem)
    }

    /// Norms of u − v for nodal values v on the mesh of a problem.
    ///
    /// # Errors
    /// As [`error_norms`].
    pub fn error(&self, problem: &ContactProblem, values: &[f64]) -> Result<ErrorNorms> {
        let rule = Cubature::new(POINTS)?.singular_at(&[[TRANSITION, 0.0]]);
        let gradient = |point| self.gradient(point);
        self.with_field(|field| {
            error_norms(problem.mesh(), problem.form(), values, (field, &gradient), &rule)
        })
    }

    fn with_field<T>(&self, then: impl FnOnce(&Field<'_>) -> T) -> T {
        if self.lame().is_some() {
            then(&Field::Vector(&|point| self.displacement(point)))
        } else {
            then(&Field::Scalar(&|point| self.displacement(point)[0]))
        }
    }

    /// n = 4, 8, ..., 2^finest, each solved from the contact set of the mesh before.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 2 ≤ finest ≤ 11; [`ToolkitError::ToleranceNotMet`](crate::ToolkitError::ToleranceNotMet) for a solution that does
    /// not meet its conditions; whatever problems and solvers return.
    pub fn levels(&self, cone: Cone, finest: u32) -> Result<Vec<RoughLevel>> {
        if !(2..=11).contains(&finest) {
            let (name, value) = ("finest level", finest as usize);
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range: "[2, 11]" }));
        }
        let mut coarse: Option<ContactSolution> = None;
        let mut levels = Vec::new();
        for n in (2..=finest).map(|level| 1usize << level) {
            let problem = self.problem(n)?;
            let solution = match &coarse {
                Some(coarse) => problem.solve_after(coarse)?,
                None => problem.solve(cone, Solver::ActiveSet)?,
            };
            if !solution.status.is_converged() {
                let reached = solution.kkt.worst();
                let why = "the active-set iteration did not converge";
                return Err(Error::out_of_reach("contact conditions", 1e-8, reached, why));
            }
            let sampled = self.with_field(|field| field.sample(problem.mesh().nodes()))?;
            levels.push(RoughLevel {
                n,
                error: self.error(&problem, &solution.displacement)?.energy,
                interpolation: self.error(&problem, &sampled)?.energy,
            });
            coarse = Some(solution);
        }
        Ok(levels)
    }
}
