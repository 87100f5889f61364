//! Signorini's problem on a triangulation.

use std::collections::HashMap;
use std::sync::Arc;

use fractional_sobolev::Error;
use numpy::PyArray1;
use pyo3::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::fem::{Cubature, Field, Form, Lame};
use signorini::mesh::{BoundaryEdge, Part, Triangulation};

use crate::callback::{Callback, Shared};
use crate::operators::array;
use crate::wait::{Failure, wait};

/// The discrete solution.
#[pyclass(frozen, module = "fractional_sobolev")]
pub(crate) struct Solved {
    problem: ContactProblem,
    solution: ContactSolution,
}

#[pymethods]
impl Solved {
    #[getter]
    fn displacement<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        array(py, &self.solution.displacement)
    }

    #[getter]
    fn contact_nodes(&self) -> Vec<usize> {
        self.problem.edge().nodes().to_vec()
    }

    #[getter]
    fn normal_displacement<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        array(py, &self.solution.normal_displacement)
    }

    #[getter]
    fn pressure<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        array(py, &self.solution.pressure)
    }

    #[getter]
    fn active(&self) -> Vec<bool> {
        self.solution.contact_set.as_slice().to_vec()
    }

    #[getter]
    fn energy(&self) -> f64 {
        self.solution.energy
    }

    #[getter]
    fn contact_force(&self) -> f64 {
        self.solution.contact_force
    }

    /// The largest scaled residual of the Karush-Kuhn-Tucker conditions.
    #[getter]
    fn residual(&self) -> f64 {
        self.solution.kkt.worst()
    }

    /// The text of a `.vtu` file.
    fn to_vtu(&self, py: Python<'_>) -> PyResult<String> {
        let found = py.detach(|| self.problem.to_vtu(&self.solution));
        found.map_err(|error| Failure::from(error).raise(py))
    }
}

/// Boundary edges, the domain on their left, with what happens on them.
fn boundary(
    triangles: &[[usize; 3]],
    contact: &[[usize; 2]],
    held: &[[usize; 2]],
) -> Result<Vec<BoundaryEdge>, Error> {
    let key = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
    let mut seen: HashMap<[usize; 2], (usize, [usize; 2])> = HashMap::new();
    for &[a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            seen.entry(key(edge)).or_insert((0, edge)).0 += 1;
        }
    }
    let mut parts = HashMap::new();
    for (edges, part) in [(contact, Part::Contact), (held, Part::Dirichlet)] {
        for &edge in edges {
            if seen.get(&key(edge)).is_none_or(|(count, _)| *count != 1) {
                return Err(Error::Edge {
                    nodes: edge,
                    reason: "is not on the boundary of the triangulation",
                });
            }
            if parts.insert(key(edge), part).is_some_and(|before| before != part) {
                return Err(Error::Edge { nodes: edge, reason: "is given both as a contact edge and as a Dirichlet edge" });
            }
        }
    }
    let mut outer: Vec<_> = seen.into_iter().filter(|(_, (count, _))| *count == 1).collect();
    outer.sort_unstable();
    Ok(outer
        .into_iter()
        .map(|(name, (_, nodes))| BoundaryEdge {
            nodes,
            part: parts.get(&name).copied().unwrap_or(Part::Neumann),
        })
        .collect())
}

/// Solves the problem.
#[pyfunction]
#[pyo3(signature = (nodes, triangles, contact, dirichlet, load, values, lame, cone))]
#[allow(clippy::too_many_arguments)] // called by one Python function with all of them
pub(crate) fn contact(
    py: Python<'_>,
    nodes: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
    contact: Vec<[usize; 2]>,
    dirichlet: Vec<[usize; 2]>,
    load: Option<Py<PyAny>>,
    values: Vec<f64>,
    lame: Option<[f64; 2]>,
    cone: &str,
) -> PyResult<Solved> {
    let shared = Arc::new(Shared::default());
    let callback = load.map(|load| Callback::new(load, &shared));
    let cone = cone.to_owned();
    wait(py, &shared, move || {
        let cone = match cone.as_str() {
            "nodal" => Cone::Nodal,
            "midpoint" => Cone::Midpoint,
            _ => {
                let expected = "nodal or midpoint";
                return Err(Failure::from(Error::UnknownName { what: "cone", given: cone, expected }));
            }
        };
        let edges = boundary(&triangles, &contact, &dirichlet)?;
        let form = match lame {
            Some([lambda, mu]) => Form::elastic(Lame::new(lambda, mu)?),
            None => Form::LAPLACE,
        };
        let mesh = Triangulation::new(&nodes, &triangles, &edges)?;
        let values =
            if values.is_empty() { vec![0.0; form.components() * mesh.nodes().len()] } else { values };
        let mut problem = ContactProblem::new(mesh, form, &values)?;
        if let Some(f) = &callback {
            let rule = Cubature::new(4)?;
            match lame {
                Some(_) => problem.add_volume_load(&Field::Vector(&|point| f.vector_at(point)), &rule)?,
                None => problem.add_volume_load(&Field::Scalar(&|point| f.at_point(point)), &rule)?,
            }
        }
        let solution = problem.solve(cone, Solver::ActiveSet)?;
        Ok(Solved { problem, solution })
    })
}
