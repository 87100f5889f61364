//! The trace of a test problem on its contact edge, from a mesh or from a strip.
//!
//! | trace of | mesh | strip |
//! | --- | --- | --- |
//! | the fine reference | nodal solution on 8n × 8n squares | the manufactured (u_N, σ_N), 64n cells or more |
//! | u_h itself | discrete solution on n × n squares | discrete solution on n cells (scalar, height 1) |
//!
//! u_h is the nodal solution for Section 3 and the midpoint solution for Section 4. The midpoint cone admits positive
//! values of u_h,N: positive values, and values on segments whose constraint is active, are set to zero. Cost: that
//! of the solvers.

use super::trace::EdgeTrace;
use crate::cone::{Cone, ContactSet};
use crate::contact::Solver;
use crate::error::{Error, Result};
use crate::problems::{NamedProblem, StripData, TestProblem};
use crate::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};

/// Segments of a mesh reference per segment of the finest mesh: the transition is resolved to an eighth of a segment.
const MESH_FACTOR: usize = 8;
/// Relative residual of the contact solution on a strip.
const SOLVED: f64 = 1e-13;
/// Smallest number of cells of the manufactured edge: studies of up to 1024 segments use the same edge.
const STRIP_CELLS: usize = 1 << 16;
/// Smallest number of these cells per segment: lengths h_e θ are resolved to h_e/64.
const STRIP_FACTOR: usize = 64;
/// Displacements below this multiple of the largest one count as zero: far above rounding, far below the opening of
/// one cell.
const ZERO: f64 = 1e-12;

impl EdgeTrace {
    /// The trace of the manufactured pair of a strip on the fine grid of the data; a periodic edge is cut at 0, where
    /// the force is halved.
    ///
    /// The nodal values and forces of the data, without a solver; a node is in contact only if its value is exactly
    /// zero.
    ///
    /// ```
    /// use signorini::{edge::EdgeTrace, problems::StripData, strip::LateralCondition};
    /// let data = StripData::Transition { position: 0.3 }.data(1.75, 256, LateralCondition::Natural)?;
    /// let trace = EdgeTrace::of_data(&data)?;
    /// // Contact left of the transition, to within a cell.
    /// assert_eq!(trace.transitions(), 1);
    /// assert!((trace.contact()[0].end - 0.3).abs() <= 1.0 / 256.0);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`EdgeTrace::new`].
    pub fn of_data(edge_data: &EdgeData) -> Result<Self> {
        let cells = edge_data.cells();
        let (mut values, mut forces) = (edge_data.values().to_vec(), edge_data.forces().to_vec());
        if edge_data.sides() == LateralCondition::Periodic {
            forces[0] *= 0.5;
            values.push(values[0]);
            forces.push(forces[0]);
        }
        let nodes = (0..=cells).map(|i| i as f64 / cells as f64).collect::<Vec<_>>();
        EdgeTrace::new(&nodes, &values, &forces, 0.0)
    }

    /// The trace of u on a grid fine enough for comparison with meshes of up to n segments; `tau` is the regularity
    /// of a strip test problem.
    ///
    /// # Errors
    /// Those of the test problems; [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a closed contact edge.
    pub fn reference(source: &NamedProblem, n: usize, tau: f64) -> Result<Self> {
        match source {
            NamedProblem::Mesh(test_problem) => mesh_trace(*test_problem, MESH_FACTOR * n, Cone::Nodal),
            NamedProblem::Strip(source) => EdgeTrace::of_data(&strip_data(source, n, tau)?),
        }
    }

    /// The trace of the discrete solution on n segments.
    ///
    /// # Errors
    /// Those of the test problems and solvers; [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a closed contact edge.
    pub fn discrete(source: &NamedProblem, n: usize, tau: f64, cone: Cone) -> Result<Self> {
        match source {
            NamedProblem::Mesh(test_problem) => mesh_trace(*test_problem, n, cone),
            NamedProblem::Strip(source) => {
                let edge_data = strip_data(source, n, tau)?;
                let exact = StripProblem::new(StripKind::Scalar, &edge_data, Reference::Nested, n)?;
                let solution = exact.operator(n)?.0.solve_contact(&exact.load(n)?, cone, None, SOLVED)?;
                let nodes = (0..=n).map(|i| i as f64 / n as f64).collect();
                discrete_trace(nodes, solution.values, &solution.multiplier, &solution.contact, cone)
            }
        }
    }
}

/// The test problem on a grid whose cells divide every segment.
fn strip_data(source: &StripData, n: usize, tau: f64) -> Result<EdgeData> {
    source.data(tau, (STRIP_FACTOR * n).max(STRIP_CELLS), StripKind::Scalar.sides())
}

fn mesh_trace(test_problem: TestProblem, squares: usize, cone: Cone) -> Result<EdgeTrace> {
    let problem = test_problem.problem(squares)?;
    if problem.edge().is_closed() {
        let (with, expected) = ("a trace on a segment", "a test problem whose contact edge has two ends");
        return Err(Error::incompatible("test problem", test_problem, with, expected));
    }
    let solution = problem.solve(cone, Solver::ActiveSet)?;
    let arc = problem.edge().arc().to_vec();
    let values = solution.normal_displacement;
    discrete_trace(arc, values, &solution.multiplier, &solution.contact_set, cone)
}

/// Nodal values and multipliers of a discrete solution as a trace.
fn discrete_trace(
    nodes: Vec<f64>,
    mut values: Vec<f64>,
    multiplier: &[f64],
    active: &ContactSet,
    cone: Cone,
) -> Result<EdgeTrace> {
    let largest = values.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let mut force = multiplier.to_vec();
    if cone == Cone::Midpoint {
        force = vec![0.0; nodes.len()];
        values.iter_mut().for_each(|v| *v = v.min(0.0));
        for segment in active.indices() {
            for end in [segment, segment + 1] {
                values[end] = 0.0;
                force[end] += 0.5 * multiplier[segment];
            }
        }
    }
    EdgeTrace::new(&nodes, &values, &force, ZERO * largest)
}
