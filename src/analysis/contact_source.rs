//! Where the trace on the contact edge comes from: a scene of the mesh solver, or one of the strip.
//!
//! | against | mesh | strip |
//! | --- | --- | --- |
//! | the fine reference | nodal solution on 8n × 8n squares | (u_N, σ_N) as manufactured, at least 64 cells per segment |
//! | u_h itself | the discrete solution on n × n squares | the discrete solution on n cells (scalar, height 1) |
//!
//! u_h is the nodal solution for Section 3, the midpoint solution for Section 4. The midpoint cone lets u_h,N be positive: there,
//! and on segments whose constraint is active, the gap counts as closed.

use crate::contact::{Cone, ContactSet, Solver};
use crate::edge::EdgeTrace;
use crate::error::{Error, Result};
use crate::scenes::{MeshScene, Scene, StripScene};
use crate::strip::{
    EdgeData, EdgeOperator, ExactEdge, Reference, Settings, Sides, StripKind, StripProblem, solve_contact,
};
use std::fmt;
use std::str::FromStr;

/// Segments of a mesh reference per segment of the finest mesh classified.
const MESH_FACTOR: usize = 8;
/// Largest n on a mesh: a reference with 2048 squares along each side.
const MESH_LARGEST: usize = 256;
/// The manufactured edge: at least this many cells, and this many per segment.
const STRIP_CELLS: usize = 1 << 16;
const STRIP_FACTOR: usize = 64;
const STRIP_LARGEST: usize = 1 << 14;
/// u_N counts as zero below this, relative to its largest value: far above rounding, far below one cell's opening.
const ZERO: f64 = 1e-12;

/// On whose contact set the cases are decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Against {
    /// The fine reference: the paper's u.
    Reference,
    /// The discrete solution of each mesh.
    Itself,
}

/// The largest n that can be asked for.
pub fn largest_classified(scene: &Scene) -> usize {
    match scene {
        Scene::Mesh(_) => MESH_LARGEST,
        Scene::Strip(_) => STRIP_LARGEST,
    }
}

/// The fine trace that stands for u on meshes of up to n segments; `tau` is the regularity of a strip scene.
///
/// # Errors
/// Those of the scenes.
pub fn reference_trace(scene: &Scene, n: usize, tau: f64) -> Result<EdgeTrace> {
    match scene {
        Scene::Mesh(scene) => mesh_trace(*scene, MESH_FACTOR * n, Cone::Nodal),
        Scene::Strip(scene) => EdgeTrace::of_scene(&strip_data(scene, n, tau)?),
    }
}

/// The trace of the discrete solution on n segments.
///
/// # Errors
/// Those of the scenes and solvers.
pub fn solution_trace(scene: &Scene, n: usize, tau: f64, cone: Cone) -> Result<EdgeTrace> {
    match scene {
        Scene::Mesh(scene) => mesh_trace(*scene, n, cone),
        Scene::Strip(scene) => {
            let data = strip_data(scene, n, tau)?;
            let exact = StripProblem::Scalar(ExactEdge::scalar(&data, (1, 1), Reference::Nested)?);
            let (operator, _): (EdgeOperator, f64) = exact.operator(n)?;
            let solution = solve_contact(&operator, &exact.load(n)?, cone, None, &Settings::default())?;
            let nodes = (0..=n).map(|i| i as f64 / n as f64).collect();
            discrete_trace(nodes, solution.values, &solution.multiplier, &solution.contact, cone)
        }
    }
}

/// The scene on a grid whose cells divide every segment.
fn strip_data(scene: &StripScene, n: usize, tau: f64) -> Result<EdgeData> {
    scene.data(tau, (STRIP_FACTOR * n).max(STRIP_CELLS), StripKind::Scalar.sides())
}

fn mesh_trace(scene: MeshScene, squares: usize, cone: Cone) -> Result<EdgeTrace> {
    let problem = scene.problem(squares)?;
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
    EdgeTrace::new(nodes, values, force, ZERO * largest)
}

impl EdgeTrace {
    /// The manufactured pair of a strip on its fine edge; a ring is opened at 0, where the force is halved.
    ///
    /// # Errors
    /// As [`EdgeTrace::new`].
    pub fn of_scene(scene: &EdgeData) -> Result<Self> {
        let cells = scene.cells();
        let (mut values, mut forces) = (scene.values().to_vec(), scene.forces().to_vec());
        if scene.sides() == Sides::Periodic {
            forces[0] *= 0.5;
            values.push(values[0]);
            forces.push(forces[0]);
        }
        let nodes = (0..=cells).map(|i| i as f64 / cells as f64).collect();
        EdgeTrace::new(nodes, values, forces, 0.0)
    }
}

impl fmt::Display for Against {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Against::Reference => "reference",
            Against::Itself => "itself",
        })
    }
}

impl FromStr for Against {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "reference" => Ok(Against::Reference),
            "itself" => Ok(Against::Itself),
            _ => Err(Error::UnknownName {
                what: "solution to classify on",
                given: text.to_owned(),
                expected: "reference or itself",
            }),
        }
    }
}
