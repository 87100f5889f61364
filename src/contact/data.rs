//! Further data of a contact problem: loads by quadrature, surface loads, prescribed displacements, initial gap.

use super::problem::ContactProblem;
use crate::error::Result;
use crate::fem::{Cubature, Field, consistent_load, load_by_edges, volume_load};
use crate::mesh::{Part, Point};
use crate::numeric::check::require_values;
use fractional_sobolev::gauss_legendre;

/// Gauss points per boundary edge for surface loads.
const EDGE_POINTS: usize = 5;

impl ContactProblem {
    /// Adds the volume load ∫ f·v, computed by the given rule, in which singular points of f are declared.
    ///
    /// ```
    /// use signorini::contact::ContactProblem;
    /// use signorini::fem::{Cubature, Field, Form};
    /// use signorini::mesh::{SideParts, unit_square};
    /// let mesh = unit_square(4, SideParts::HANGING)?;
    /// let mut problem = ContactProblem::new(mesh, Form::LAPLACE, &[0.0; 25])?;
    /// problem.add_volume_load(&Field::Scalar(&|[x, y]| (x * y).exp()), &Cubature::new(4)?)?;
    /// assert!(problem.add_volume_load(&Field::Scalar(&|[x, _]| x.ln() / 0.0), &Cubature::new(4)?).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if f has the wrong number of components,
    /// [`ToolkitError::NotFiniteAt`](crate::ToolkitError::NotFiniteAt) if f is not finite at a quadrature point.
    pub fn add_volume_load(&mut self, density: &Field<'_>, rule: &Cubature) -> Result<()> {
        density.require(self.form.components())?;
        let load = volume_load(&self.mesh, density, rule)?;
        self.add_load(&load)
    }

    /// Adds the surface load ∫ F·v over the Neumann part.
    ///
    /// ```
    /// use signorini::contact::ContactProblem;
    /// use signorini::fem::{Field, Form, Lame};
    /// use signorini::mesh::{SideParts, unit_square};
    /// let mesh = unit_square(4, SideParts::HANGING)?;
    /// let mut problem = ContactProblem::new(mesh, Form::elastic(Lame::new(1.0, 1.0)?), &[0.0; 50])?;
    /// // the Neumann part consists of the lateral sides: a horizontal load that increases with height
    /// problem.add_surface_load(&Field::Vector(&|[_, y]| [0.1 * y, 0.0]))?;
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`ContactProblem::add_volume_load`].
    pub fn add_surface_load(&mut self, density: &Field<'_>) -> Result<()> {
        density.require(self.form.components())?;
        self.add_boundary_load(Part::Neumann, &|point, _| density.at(point))
    }

    /// Adds ∫ F(x, n)·v over the edges with the given label, n the outward normal. On the contact part this
    /// load acts in addition to the contact force.
    ///
    /// Five Gauss points per edge are used. F receives the point and the outward unit normal.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, mesh::Part, problems::TestProblem};
    /// let mut problem = TestProblem::Closed.problem(4)?;
    /// let before = problem.solve(Cone::Nodal, Solver::ActiveSet)?.contact_force;
    /// // an upward load of density 1/4 on the contact edge (direction −n): the contact force decreases by 1/4
    /// problem.add_boundary_load(Part::Contact, &|_, [x, y]| Ok([-0.25 * x, -0.25 * y]))?;
    /// let after = problem.solve(Cone::Nodal, Solver::ActiveSet)?.contact_force;
    /// assert!((before - after - 0.25).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) for a load that is not finite, or the error
    /// returned by F.
    pub fn add_boundary_load(
        &mut self,
        part: Part,
        density: &dyn Fn(Point, Point) -> Result<Point>,
    ) -> Result<()> {
        self.add_load_of_edges(part, &|_, point, normal| density(point, normal))
    }

    /// Adds ∫ F·v over the edges with the given label; F receives the number of the boundary edge, the point and the
    /// outward unit normal.
    pub(super) fn add_load_of_edges(
        &mut self,
        part: Part,
        density: &dyn Fn(usize, Point, Point) -> Result<Point>,
    ) -> Result<()> {
        let rule = gauss_legendre(EDGE_POINTS)?;
        let load = load_by_edges(&self.mesh, part, self.form.components(), density, &rule)?;
        self.add_load(&load)
    }

    /// Adds the volume load ∫ f·v of the P1 function f with the given nodal values (node-major, one number per node for
    /// a scalar form, two for elasticity).
    ///
    /// ```
    /// use signorini::{contact::Body, fem::Form, mesh::{SideParts, unit_square}};
    /// let mut problem = Body::new(unit_square(4, SideParts::HANGING)?, Form::LAPLACE).problem()?;
    /// problem.add_nodal_load(&[1.0; 25])?;
    /// assert!(problem.add_nodal_load(&[1.0; 24]).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch),
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite).
    pub fn add_nodal_load(&mut self, values: &[f64]) -> Result<()> {
        let components = self.form.components();
        require_values("volume load", values, components * self.mesh.nodes().len())?;
        let load = consistent_load(&self.mesh, components, values);
        self.add_load(&load)
    }

    /// Adds a vector of nodal forces (Cartesian, node-major).
    ///
    /// F ← F + f: the entries are forces ∫ f·φ_i, not densities. The solution is Lipschitz continuous in F
    /// with constant 1, in the energy norm for u and its dual norm for F.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let mut problem = TestProblem::Closed.problem(4)?;
    /// let before = problem.solve(Cone::Nodal, Solver::ActiveSet)?.contact_force;
    /// // a force of 1 downwards on the second node of the bottom, in full contact: the contact carries all of it
    /// let mut force = vec![0.0; 50];
    /// force[2 * problem.edge().nodes()[1] + 1] = -1.0;
    /// problem.add_load(&force)?;
    /// let after = problem.solve(Cone::Nodal, Solver::ActiveSet)?.contact_force;
    /// assert!((after - before - 1.0).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch),
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite).
    pub fn add_load(&mut self, load: &[f64]) -> Result<()> {
        require_values("load", load, self.load.len())?;
        let framed = self.to_frame(load);
        self.load.iter_mut().zip(framed).for_each(|(sum, f)| *sum += f);
        Ok(())
    }

    /// Prescribes u = data on the Dirichlet part.
    ///
    /// The data are interpolated at the Dirichlet nodes by P1 functions; they replace earlier data.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::{ContactProblem, Solver}, fem::{Field, Form}};
    /// use signorini::mesh::{SideParts, unit_square};
    /// let mut problem = ContactProblem::new(unit_square(4, SideParts::HANGING)?, Form::LAPLACE, &[0.0; 25])?;
    /// problem.set_dirichlet(&Field::Scalar(&|_| 1.0))?;
    /// // u = 1 on top and u ≤ 0 at the bottom: u = y, the contact force is ∫ ∂u/∂y = 1, J = 1/2
    /// let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// assert!((u.contact_force - 1.0).abs() < 1e-14 && (u.energy - 0.5).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`ContactProblem::add_volume_load`].
    pub fn set_dirichlet(&mut self, data: &Field<'_>) -> Result<()> {
        let c = self.form.components();
        data.require(c)?;
        let mut values = vec![0.0; self.values.len()];
        for node in 0..self.mesh.nodes().len() {
            if self.prescribed[node * c] {
                values[node * c..(node + 1) * c]
                    .copy_from_slice(&data.at(self.mesh.nodes()[node])?[..c]);
            }
        }
        self.set_dirichlet_values(&values)
    }

    /// Prescribes the values at the Dirichlet nodes (Cartesian, node-major, 0 elsewhere).
    pub(super) fn set_dirichlet_values(&mut self, values: &[f64]) -> Result<()> {
        require_values("prescribed displacement", values, self.values.len())?;
        self.values = self.to_frame(values);
        Ok(())
    }

    /// Sets the initial gap g in u_N ≤ g by its values at the nodes of the contact edge.
    ///
    /// ```
    /// use signorini::cone::Cone;
    /// use signorini::contact::Solver;
    /// use signorini::problems::TestProblem;
    /// let mut problem = TestProblem::Closed.problem(8)?;
    /// problem.set_gap(|[x, _]| 0.1 * x)?;
    /// let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// assert!(solution.normal_displacement.last().is_some_and(|u| *u <= 0.1));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) for a gap that is not finite at a node.
    pub fn set_gap(&mut self, gap: impl FnMut(Point) -> f64) -> Result<()> {
        self.set_gap_values(self.edge.points().iter().copied().map(gap).collect())
    }

    /// Sets the gap at the nodes of the contact edge, in order.
    pub(super) fn set_gap_values(&mut self, values: Vec<f64>) -> Result<()> {
        require_values("gap", &values, self.gap.len())?;
        self.gap = values;
        Ok(())
    }
}
