//! The forces by which clamps and floors hold a body: resultant and moment by group of the boundary.

use super::problem::ContactProblem;
use super::solution::ContactSolution;
use crate::error::Result;
use crate::mesh::{Part, Point};
use crate::numeric::check::require_length;

/// What one clamped or contact group of the boundary exerts on the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    /// Name of the group.
    pub group: String,
    /// Γ_D or Γ_C.
    pub part: Part,
    /// The resultant, a force per thickness (scalar: second entry 0).
    pub force: Point,
    /// Its moment about the origin, counterclockwise; 0 for a scalar problem.
    pub moment: f64,
}

impl ContactProblem {
    /// The forces of all clamps and floors on the body, by group, in the order in which the boundary lists them.
    ///
    /// They are K u − F at the nodes of a group. A node of two groups counts for a clamp before a floor, and otherwise for
    /// the first one. Loads and all supports have the sum 0, up to rounding, and so have their moments.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let problem = TestProblem::Block.problem(8)?;
    /// let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// let supports = problem.supports(&u)?;
    /// let [floor, top] = &supports[..] else { panic!() };
    /// assert_eq!((&*floor.group, &*top.group), ("contact", "clamped"));
    /// // the floor pushes upwards
    /// assert!((floor.force[1] - u.contact_force).abs() < 1e-14);
    /// assert!((top.force[1] - u.reaction[1]).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a solution of another problem.
    pub fn supports(&self, solution: &ContactSolution) -> Result<Vec<Support>> {
        let (mesh, c) = (self.mesh(), self.form().components());
        require_length("displacement", solution.displacement.len(), c * mesh.nodes().len())?;
        let inner = self.multiply(&self.to_frame(&solution.displacement));
        let residual: Vec<f64> = inner.iter().zip(&self.load).map(|(k, f)| k - f).collect();
        let forces = self.to_cartesian(&residual);
        let mut owner: Vec<Option<usize>> = vec![None; mesh.nodes().len()];
        let mut found: Vec<Support> = Vec::new();
        for (number, edge) in mesh.boundary().iter().enumerate() {
            let group = mesh.group(number);
            if edge.part != Part::Neumann && !found.iter().any(|one| one.group == group) {
                let (group, part) = (group.to_owned(), edge.part);
                found.push(Support { group, part, force: [0.0; 2], moment: 0.0 });
            }
        }
        for part in [Part::Dirichlet, Part::Contact] {
            for (number, edge) in
                mesh.boundary().iter().enumerate().filter(|(_, edge)| edge.part == part)
            {
                let support = found.iter().position(|one| one.group == mesh.group(number));
                edge.nodes.into_iter().for_each(|node| owner[node] = owner[node].or(support));
            }
        }
        for (node, support) in owner.into_iter().enumerate() {
            let Some(support) = support.map(|number| &mut found[number]) else { continue };
            let [x, y] = mesh.nodes()[node];
            let own = &forces[c * node..c * (node + 1)];
            own.iter().zip(&mut support.force).for_each(|(force, sum)| *sum += force);
            if let [along, up] = own {
                support.moment += x * up - y * along;
            }
        }
        Ok(found)
    }
}
