//! Errors of the discrete solutions of a problem in closed form on the meshes with n × n squares, n = 4, 8,
//! ..., and what is known of u there.

use super::closed_form::ClosedForm;
use crate::cone::Cone;
use crate::contact::{ContactSolution, Solver};
use crate::error::{Error, Result, ToolkitError};
use fractional_sobolev::Estimate;

/// n = 2 to this power on the coarsest mesh.
const COARSEST: u32 = 2;

/// One mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosedFormLevel {
    /// n; h = 1/n.
    pub n: usize,
    /// |u − u_h|_a.
    pub error: f64,
    /// |u − I^h u|_a.
    pub interpolation: f64,
    /// |u|₂ on (0, 1) × (0, h).
    pub near: Estimate,
    /// Worst scaled Karush-Kuhn-Tucker figure.
    pub kkt: f64,
}

impl ClosedFormLevel {
    /// |u − u_h|_a / |u − I^h u|_a on the finest of at least two meshes, and what it changed by from the one
    /// before.
    pub fn limit(levels: &[Self]) -> Option<(f64, f64)> {
        let [.., before, last] = levels else { return None };
        let [before, last] = [before, last].map(|level| level.error / level.interpolation);
        Some((last, (last - before).abs()))
    }
}

impl ClosedForm {
    /// n = 4, 8, ..., 2^finest, each solved from the contact set of the mesh before; `report` is called after
    /// each.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 2 ≤ finest ≤ 11; [`ToolkitError::ToleranceNotMet`](crate::ToolkitError::ToleranceNotMet) for a solution that does
    /// not meet its conditions to 1e-8; whatever problems and solvers return.
    pub fn levels(&self, cone: Cone, finest: u32, mut report: impl FnMut()) -> Result<Vec<ClosedFormLevel>> {
        if !(COARSEST..=11).contains(&finest) {
            let (name, value) = ("finest level", finest as usize);
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range: "[2, 11]" }));
        }
        let mut coarse: Option<ContactSolution> = None;
        let mut levels = Vec::new();
        for n in (COARSEST..=finest).map(|level| 1usize << level) {
            let problem = self.problem(n)?;
            let solution = match &coarse {
                Some(coarse) => problem.solve_after(coarse)?,
                None => problem.solve(cone, Solver::ActiveSet)?,
            };
            let kkt = solution.kkt.worst();
            if !solution.status.is_converged() {
                let why = "the active-set iteration did not converge";
                return Err(Error::out_of_reach("contact conditions", 1e-8, kkt, why));
            }
            levels.push(ClosedFormLevel {
                n,
                error: self.error(&problem, &solution.displacement)?.energy,
                interpolation: self.error(&problem, &self.interpolant(&problem)?)?.energy,
                near: self.second_seminorm(n)?,
                kkt,
            });
            coarse = Some(solution);
            report();
        }
        Ok(levels)
    }
}
