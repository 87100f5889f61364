//! KKT residuals on annuli around a point, scaled on each annulus.
//!
//! Near a singular point displacements and forces decay like a power of r: over forty decades they become negligible
//! relative to the largest force. The residuals of each annulus are those of [`KktTerms`], scaled by the largest
//! force size (abs(K) abs(u) + abs(F))_i and the largest displacement of that annulus.

use super::problem::ContactProblem;
use super::solution::{ContactSolution, gap_of, sizes};
use crate::cone::{KktResiduals, KktTerms};
use crate::error::{Error, Result, ToolkitError};
use crate::mesh::{Point, distance};
use crate::numeric::check::require_values;
use crate::numeric::scale::largest;

impl ContactProblem {
    /// The four KKT residuals on every annulus `bounds[k]` ≤ r < `bounds[k + 1]` around `centre`; they are zero on an
    /// annulus without free unknowns. Cost: O(unknowns) per annulus.
    ///
    /// An unknown belongs to the annulus of its node, a constraint to that of its farthest node.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let problem = TestProblem::Block.problem(8)?;
    /// let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// let rings = problem.kkt_by_radius(&solution, [0.0, 0.0], &[0.0, 0.5, 2.0])?;
    /// assert!(rings.len() == 2 && rings.iter().all(|ring| ring.worst() < 1e-12));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless the bounds increase;
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch),
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) if the solution belongs to another
    /// problem.
    pub fn kkt_by_radius(
        &self,
        solution: &ContactSolution,
        centre: Point,
        bounds: &[f64],
    ) -> Result<Vec<KktResiduals>> {
        require_values("displacement", &solution.displacement, self.unknowns())?;
        if let Some(pair) = bounds.windows(2).find(|pair| pair[0] >= pair[1] || pair[1].is_nan()) {
            return Err(Error::Toolkit(ToolkitError::OutOfRange {
                name: "radius",
                value: pair[1],
                range: "(previous radius, inf)",
            }));
        }
        let u = self.to_frame(&solution.displacement);
        let cone = self.edge_cone(solution.cone);
        let force = cone.apply_transposed(&solution.multiplier)?;
        let normals = self.normal_unknowns();
        let mut residual = self.multiply(&u);
        residual.iter_mut().zip(&self.load).for_each(|(r, f)| *r -= f);
        normals.iter().zip(force).for_each(|(&unknown, f)| residual[unknown] += f);
        let sizes = sizes(self, &u);
        let normal: Vec<f64> = normals.iter().map(|&unknown| u[unknown]).collect();
        let gap = gap_of(self, cone, &normal);
        let c = self.form.components();
        let radius: Vec<f64> =
            self.mesh.nodes().iter().map(|&node| distance(centre, node)).collect();
        let place: Vec<f64> = (0..gap.len())
            .map(|i| cone.support(i).map(|k| radius[normals[k] / c]).fold(0.0, f64::max))
            .collect();
        let ring = |pair: &[f64]| {
            let inside = |r: f64| pair[0] <= r && r < pair[1];
            let unknowns: Vec<usize> =
                (0..u.len()).filter(|&i| !self.prescribed[i] && inside(radius[i / c])).collect();
            let constraints: Vec<usize> = (0..gap.len()).filter(|&i| inside(place[i])).collect();
            let pick = |values: &[f64], from: &[usize]| {
                from.iter().map(|&i| values[i]).collect::<Vec<f64>>()
            };
            KktTerms {
                residual: &pick(&residual, &unknowns),
                multiplier: &pick(&solution.multiplier, &constraints),
                gap: &pick(&gap, &constraints),
                force: largest(&pick(&sizes, &unknowns)),
                displacement: largest(&pick(&u, &unknowns)),
            }
            .residuals()
        };
        bounds.windows(2).map(ring).collect()
    }
}
