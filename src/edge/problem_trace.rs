//! The trace of a solution on its contact edge, from a body, from a strip, or from manufactured data.
//!
//! | trace of | by |
//! | --- | --- |
//! | a discrete solution on a mesh | [`EdgeTrace::of_solution`] |
//! | a discrete solution on a strip with natural sides | [`EdgeTrace::of_strip`] |
//! | the manufactured pair (u_N, σ_N) of a strip | [`EdgeTrace::of_data`] |
//!
//! The midpoint cone admits positive values of u_h,N: positive values, and values on segments whose constraint is
//! active, are set to zero.

use super::trace::EdgeTrace;
use crate::cone::{Cone, ContactSet};
use crate::contact::{ContactProblem, ContactSolution};
use crate::error::{Error, Result};
use crate::strip::{EdgeData, EdgeSolution, LateralCondition};

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

    /// The trace of a discrete solution on the contact edge of its body, over the arc length.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, edge::EdgeTrace, problems::TestProblem};
    /// let problem = TestProblem::Block.problem(16)?;
    /// let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// let trace = EdgeTrace::of_solution(&problem, &u)?;
    /// // the forces are the multipliers, and contact is where u_N = 0
    /// assert_eq!(trace.force(), u.multiplier);
    /// assert!(trace.contact().iter().any(|interval| interval.length() > 0.0));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a closed contact edge,
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for one in several pieces; those of
    /// [`EdgeTrace::new`].
    pub fn of_solution(problem: &ContactProblem, solution: &ContactSolution) -> Result<Self> {
        let edge = problem.edge();
        if edge.is_closed() {
            let (with, expected) = ("a trace on a segment", "a contact edge with two ends");
            return Err(Error::incompatible("contact edge", "closed", with, expected));
        }
        problem.contact_mesh()?; // one piece
        let values = solution.normal_displacement.clone();
        discrete_trace(
            edge.arc(),
            values,
            &solution.multiplier,
            &solution.contact_set,
            solution.cone,
        )
    }

    /// The trace of a discrete solution on a strip with natural sides, on (0, 1).
    ///
    /// ```
    /// use signorini::{cone::Cone, edge::EdgeTrace, problems::StripData};
    /// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
    /// let data = StripData::Transition { position: 0.3 }.data(1.75, 256, LateralCondition::Natural)?;
    /// let strip = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 8)?;
    /// let trace = EdgeTrace::of_strip(&strip.solve(32, Cone::Nodal)?)?;
    /// assert!((trace.contact()[0].end - 0.3).abs() <= 1.0 / 32.0);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for periodic sides; those of
    /// [`EdgeTrace::new`].
    pub fn of_strip(solution: &EdgeSolution) -> Result<Self> {
        let cells = solution.cells;
        if solution.values.len() != cells + 1 {
            let (with, expected) = ("a trace on a segment", "natural sides");
            return Err(Error::incompatible("sides", "periodic", with, expected));
        }
        let nodes: Vec<f64> = (0..=cells).map(|i| i as f64 / cells as f64).collect();
        let values = solution.values.clone();
        discrete_trace(&nodes, values, &solution.multiplier, &solution.contact, solution.cone)
    }
}

/// Nodal values and multipliers of a discrete solution as a trace.
fn discrete_trace(
    nodes: &[f64],
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
    EdgeTrace::new(nodes, &values, &force, ZERO * largest)
}
