//! The discrete Signorini problem (2.9) on a triangulation: form, load, prescribed values, contact edge, initial gap.
//!
//! Unknowns are node-major. Internally those of an elastic body are (u_T, u_N), with respect to its straight contact
//! edge (with several straight contact edges, each on its own nodes); all input and output is Cartesian. In the
//! scalar problem u replaces u_N.

use super::operator::Operator;
use crate::cone::{Cone, EdgeCone, Ends};
use crate::error::{Error, Result};
use crate::fem::{Form, Frame, Frames, consistent_load};
use crate::mesh::{ContactEdge, Hierarchy, Part, Point, Triangulation};
use crate::numeric::check::require_values;
use crate::numeric::scale::careful_dot;
use fractional_sobolev::Mesh;
use rayon::prelude::*;
use std::time::Instant;

/// Sine of the angle below which two floors count as parallel.
const PARALLEL: f64 = 1e-8;

/// A discrete Signorini problem; the stiffness matrix is assembled when it is first used.
///
/// Find u_h in the cone, with the prescribed values on the Dirichlet part, such that
/// a(u_h, v − u_h) ≥ F(v − u_h) for all such v: u_h is the minimiser of J(v) = ½ a(v, v) − F(v). All nodal
/// vectors are node-major and Cartesian: (v_x, v_y) of node i at 2i, 2i + 1.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// let problem = TestProblem::Membrane.problem(8)?;
/// let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?.normal_displacement;
/// // u_N ≤ 0 at all n + 1 contact nodes
/// assert!(u.len() == problem.edge().nodes().len() && u.iter().all(|u| *u <= 1e-15));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct ContactProblem {
    pub(super) mesh: Triangulation,
    pub(super) form: Form,
    pub(super) edge: ContactEdge,
    pub(super) frames: Frames,
    pub(super) operator: Operator,
    /// Load on all unknowns of the frame.
    pub(super) load: Vec<f64>,
    pub(super) prescribed: Vec<bool>,
    /// Prescribed values of the frame; zero elsewhere.
    pub(super) values: Vec<f64>,
    /// Initial gap at the nodes of the contact edge.
    pub(crate) gap: Vec<f64>,
    /// Whether some body has no Dirichlet edge, so that only its floors keep it in place.
    pub(crate) floats: bool,
    /// Time in seconds for the edge, the load, and the part of the operator that is set up immediately.
    pub(super) preparation_seconds: f64,
}

impl ContactProblem {
    /// The problem whose volume load is the P1 function with the given nodal values (node-major, one number per node
    /// for a scalar form, two for elasticity), with zero surface load, zero Dirichlet data and zero initial gap.
    ///
    /// The contact edge may consist of several pieces without a common node, each with its own normal; only the nodal
    /// cone is then available.
    ///
    /// ```
    /// use signorini::cone::Cone;
    /// use signorini::contact::{ContactProblem, Solver};
    /// use signorini::fem::{Field, Form, Lame};
    /// use signorini::mesh::{SideParts, unit_square};
    /// let mesh = unit_square(8, SideParts::HANGING)?;
    /// let load = Field::Vector(&|[x, _]| [0.0, 1.0 - 3.0 * x]).sample(mesh.nodes())?;
    /// let problem = ContactProblem::new(mesh, Form::elastic(Lame::new(1.0, 1.0)?), &load)?;
    /// let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// assert!(solution.contact_force > 0.0 && solution.kkt.worst() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// Invalid data: no contact edge, a contact edge of an elastic body that is not straight, for a
    /// form without reaction term no Dirichlet boundary, or a part of the body without one
    /// ([`Error::NotHeld`]), a load that is not finite or has the wrong length, an inadmissible form.
    pub fn new(mesh: Triangulation, form: Form, volume: &[f64]) -> Result<Self> {
        let start = Instant::now();
        form.check()?;
        let edge = ContactEdge::in_pieces(&mesh)?;
        let c = form.components();
        let held = mesh.nodes_on(Part::Dirichlet);
        let reaction = matches!(form, Form::Scalar { reaction } if reaction > 0.0);
        let floats = if reaction { false } else { require_held(&mesh, &held, &edge, c)? };
        require_values("volume load", volume, mesh.nodes().len() * c)?;
        let frames = if c == 2 { frames_of(&edge)? } else { Frames::all(Frame::cartesian()) };
        let operator = Operator::of(&mesh, &form, &frames);
        let mut problem = Self {
            prescribed: held.iter().flat_map(|&held| std::iter::repeat_n(held, c)).collect(),
            values: vec![0.0; mesh.nodes().len() * c],
            gap: vec![0.0; edge.nodes().len()],
            load: Vec::new(),
            preparation_seconds: 0.0,
            mesh,
            form,
            edge,
            frames,
            operator,
            floats,
        };
        problem.load = problem.to_frame(&consistent_load(&problem.mesh, c, volume));
        problem.preparation_seconds = start.elapsed().as_secs_f64();
        Ok(problem)
    }

    /// The triangulation.
    ///
    /// ```
    /// let problem = signorini::problems::TestProblem::Block.problem(4)?;
    /// // Euler's formula for a disc: nodes − edges + triangles = 1, edges = (3 triangles + boundary)/2
    /// let mesh = problem.mesh();
    /// let edges = (3 * mesh.triangles().len() + mesh.boundary().len()) / 2;
    /// assert_eq!(mesh.nodes().len() + mesh.triangles().len(), edges + 1);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn mesh(&self) -> &Triangulation {
        &self.mesh
    }

    /// The bilinear form.
    ///
    /// Scalar: a(u, v) = ∫ ∇u·∇v + c u v, c the reaction coefficient; elastic: a(u, v) = ∫ 2μ ε(u):ε(v) +
    /// λ div u div v, plane strain.
    ///
    /// ```
    /// use signorini::{fem::Form, problems::TestProblem};
    /// assert_eq!(TestProblem::Membrane.problem(2)?.form(), &Form::LAPLACE);
    /// assert_eq!(TestProblem::Block.problem(2)?.form().components(), 2);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn form(&self) -> &Form {
        &self.form
    }

    /// The contact edge.
    ///
    /// Its nodes are ordered with the domain on the left (on a floor from left to right); this is the order
    /// of all vectors along the contact edge.
    ///
    /// ```
    /// let problem = signorini::problems::TestProblem::Block.problem(4)?;
    /// let edge = problem.edge();
    /// // the integrals of the hat functions sum to the length of the edge
    /// assert!((edge.nodal_lengths().iter().sum::<f64>() - 1.0).abs() < 1e-15);
    /// assert!(edge.points().windows(2).all(|pair| pair[0][0] < pair[1][0]));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn edge(&self) -> &ContactEdge {
        &self.edge
    }

    /// The initial gap g in u_N ≤ g at the nodes of the contact edge, in order.
    ///
    /// ```
    /// let mut problem = signorini::problems::TestProblem::Block.problem(2)?;
    /// problem.set_gap(|[x, _]| 0.1 * x)?;
    /// assert_eq!(problem.gap(), [0.0, 0.05, 0.1]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn gap(&self) -> &[f64] {
        &self.gap
    }

    /// The contact edge as a mesh of (0, length), with its segments as elements.
    ///
    /// ```
    /// let mesh = signorini::problems::TestProblem::Block.problem(4)?.contact_mesh()?;
    /// assert!(mesh.len() == 4 && (mesh.nodes()[4] - 1.0).abs() < 1e-15);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Mesh::from_lengths`]; [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for an
    /// edge in several pieces.
    pub fn contact_mesh(&self) -> Result<Mesh> {
        self.edge.require_one_piece()?;
        Ok(Mesh::from_lengths(&self.edge.segment_lengths())?)
    }

    /// Checks that the cone is defined on the contact edge.
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for the midpoint cone on a contact edge in several pieces.
    pub(super) fn require_cone(&self, cone: Cone) -> Result<()> {
        if cone == Cone::Nodal || self.edge.pieces().len() == 1 {
            return Ok(());
        }
        Err(Error::incompatible("cone", cone, "a contact edge in several pieces", "the nodal cone"))
    }

    pub(super) fn edge_cone(&self, cone: Cone) -> EdgeCone {
        let ends = if self.edge.is_closed() { Ends::Joined } else { Ends::Open };
        cone.on(self.edge.nodes().len(), ends)
    }

    /// The number of unknowns that are not prescribed.
    ///
    /// The dimension of the trial space: the number of nodes not on the Dirichlet part times the number of
    /// components.
    ///
    /// ```
    /// // (n + 1) n nodes below the clamped top, two components
    /// assert_eq!(signorini::problems::TestProblem::Block.problem(4)?.free_unknowns(), 2 * 5 * 4);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn free_unknowns(&self) -> usize {
        self.prescribed.iter().filter(|&&prescribed| !prescribed).count()
    }

    /// The smallest of all μ, λ + μ; 1 for a scalar form.
    pub(super) fn smallest_modulus(&self) -> f64 {
        match &self.form {
            Form::Scalar { .. } => 1.0,
            Form::Elastic { materials } => materials
                .iter()
                .map(|m| m.mu().min(m.lambda() + m.mu()))
                .fold(f64::INFINITY, f64::min),
        }
    }

    /// Numbers of the unknowns u_N along the contact edge.
    pub(super) fn normal_unknowns(&self) -> Vec<usize> {
        let c = self.form.components();
        self.edge.nodes().iter().map(|&node| node * c + c - 1).collect()
    }

    /// The normal displacement u_N (scalar: u) at the nodes of the contact edge, from Cartesian nodal values.
    ///
    /// It is u·n with the outward normal n, one value per contact node in the order of the edge.
    ///
    /// ```
    /// let problem = signorini::problems::TestProblem::Block.problem(2)?;
    /// // n = (0, −1) on the bottom: u_N = −1 for an upward translation by 1
    /// let lift: Vec<f64> = [0.0, 1.0].repeat(9);
    /// assert_eq!(problem.normal_displacement(&lift)?, [-1.0; 3]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) or
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite).
    pub fn normal_displacement(&self, displacement: &[f64]) -> Result<Vec<f64>> {
        require_values("displacement", displacement, self.unknowns())?;
        let framed = self.to_frame(displacement);
        Ok(self.normal_unknowns().into_iter().map(|unknown| framed[unknown]).collect())
    }

    /// The energy norm a(v, v)^{1/2} of Cartesian nodal values.
    ///
    /// ```
    /// use signorini::problems::TestProblem;
    /// let problem = TestProblem::Membrane.problem(4)?;
    /// // the energy norm of y is the square root of the area
    /// let y: Vec<f64> = problem.mesh().nodes().iter().map(|p| p[1]).collect();
    /// assert!((problem.energy_norm(&y)? - 1.0).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) or
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite).
    pub fn energy_norm(&self, displacement: &[f64]) -> Result<f64> {
        require_values("displacement", displacement, self.unknowns())?;
        // Scaled, so that squares neither overflow nor underflow.
        let scale = displacement.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        if scale == 0.0 {
            return Ok(0.0);
        }
        let unit: Vec<f64> = displacement.iter().map(|v| v / scale).collect();
        let framed = self.to_frame(&unit);
        Ok(scale * careful_dot(&framed, &self.multiply(&framed)).max(0.0).sqrt())
    }

    /// The norm |u − P u_h|_a for nested levels: u is a function on the mesh of this problem, which is level `to` of
    /// the hierarchy, and u_h on level `from` is prolonged by P.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, mesh::Hierarchy, problems::TestProblem};
    /// let hierarchy = Hierarchy::refined(TestProblem::Membrane.mesh(4)?, 1)?;
    /// let problems = [0, 1].map(|k| TestProblem::Membrane.on(hierarchy.levels()[k].clone()));
    /// let [coarse, fine] = problems;
    /// let (coarse, fine) = (coarse?, fine?);
    /// let u = coarse.solve(Cone::Nodal, Solver::ActiveSet)?.displacement;
    /// let v = fine.solve(Cone::Nodal, Solver::ActiveSet)?.displacement;
    /// let error = fine.nested_energy_error(&hierarchy, (0, &u), (1, &v))?;
    /// assert!(error > 0.0 && error < fine.energy_norm(&v)?);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for levels that do not exist
    /// or are in the wrong order, [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch),
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite).
    pub fn nested_energy_error(
        &self,
        hierarchy: &Hierarchy,
        (from, coarse): (usize, &[f64]),
        (to, fine): (usize, &[f64]),
    ) -> Result<f64> {
        require_values("fine displacement", fine, self.unknowns())?;
        let prolonged = hierarchy.prolong(from, to, self.form.components(), coarse)?;
        require_values("prolonged displacement", &prolonged, fine.len())?;
        let difference: Vec<f64> = fine.iter().zip(prolonged).map(|(u, v)| u - v).collect();
        self.energy_norm(&difference)
    }

    /// Cartesian nodal values in the unknowns of the frame.
    pub(super) fn to_frame(&self, values: &[f64]) -> Vec<f64> {
        self.turn(values, Frame::to_frame)
    }

    /// Unknowns of the frame as Cartesian nodal values.
    pub(super) fn to_cartesian(&self, values: &[f64]) -> Vec<f64> {
        self.turn(values, Frame::to_cartesian)
    }

    fn turn(&self, values: &[f64], turn: fn(Frame, Point) -> Point) -> Vec<f64> {
        let mut turned = values.to_vec();
        if self.form.components() == 2 {
            turned.par_chunks_mut(2).enumerate().for_each(|(node, pair)| {
                let [a, b] = turn(*self.frames.at(node), [pair[0], pair[1]]);
                pair[0] = a;
                pair[1] = b;
            });
        }
        turned
    }
}

/// Whether some body (triangles connected by nodes) has no Dirichlet edge; [`Error::NotHeld`] if its floors cannot keep
/// it in place either: in the scalar problem one contact edge can, for an elastic body two that are not parallel can.
/// Checked before any matrix is assembled.
fn require_held(
    mesh: &Triangulation,
    held: &[bool],
    edge: &ContactEdge,
    components: usize,
) -> Result<bool> {
    let bodies = mesh.bodies();
    let mut is_held = vec![false; bodies.len()];
    bodies.iter().zip(held).for_each(|(&body, &held)| is_held[body] |= held);
    let floating = |&node: &usize| !is_held[bodies[node]];
    let Some(node) = (0..bodies.len()).find(floating) else { return Ok(false) };
    let normals =
        if components == 2 { edge.normals()? } else { vec![[0.0; 2]; edge.pieces().len()] };
    let floors_of = |body: usize| -> Vec<Point> {
        let pieces = edge.pieces().into_iter().zip(&normals);
        pieces
            .filter(|(piece, _)| bodies[edge.nodes()[piece.start]] == body)
            .map(|(_, n)| *n)
            .collect()
    };
    let is_kept = |body: usize| {
        let floors = floors_of(body);
        let turned = |n: &Point| (n[0] * floors[0][1] - n[1] * floors[0][0]).abs() > PARALLEL;
        if components == 1 { !floors.is_empty() } else { floors.iter().any(turned) }
    };
    match (0..bodies.len()).find(|node| floating(node) && !is_kept(bodies[*node])) {
        None => Ok(true),
        Some(_) if !held.contains(&true) && edge.pieces().len() == 1 => Err(Error::count(
            "Dirichlet edges",
            0,
            "[1, inf), the range for a form without reaction term",
        )),
        Some(_) => {
            let triangles =
                mesh.triangles().iter().filter(|t| bodies[t[0]] == bodies[node]).count();
            Err(Error::NotHeld { triangles, node: mesh.number(node), place: mesh.nodes()[node] })
        }
    }
}

/// The frames of the nodes: for one straight contact edge the same frame for all nodes, for several edges that of
/// each on its own nodes.
fn frames_of(edge: &ContactEdge) -> Result<Frames> {
    let normals = edge.normals()?;
    if let [normal] = normals[..] {
        return Ok(Frames::all(Frame::turned(normal)));
    }
    let own = edge.pieces().into_iter().zip(normals).flat_map(|(piece, normal)| {
        edge.nodes()[piece].iter().map(move |&node| (node, Frame::turned(normal)))
    });
    Ok(Frames::of_nodes(own.collect()))
}
