//! Signorini's problem on a triangulation.

use std::sync::Arc;

use fractional_sobolev::Error;
use numpy::PyArray1;
use pyo3::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::fem::{Cubature, Field, Form, Lame};
use signorini::mesh::{Part, Triangulation};

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

    /// Coordinates of the nodes in use.
    #[getter]
    fn nodes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        array(py, self.problem.mesh().nodes().as_flattened())
    }

    #[getter]
    fn triangles(&self) -> Vec<usize> {
        self.problem.mesh().triangles().as_flattened().to_vec()
    }

    /// Names of the boundary groups.
    #[getter]
    fn groups(&self) -> Vec<String> {
        self.problem.mesh().groups().into_iter().map(str::to_owned).collect()
    }

    #[getter]
    fn regions(&self) -> Vec<String> {
        self.problem.mesh().region_names()
    }

    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.problem.mesh().remarks().to_vec()
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

/// Whether the name of a group says what happens there.
#[pyfunction]
pub(crate) fn states_a_part(name: &str) -> bool {
    Part::named(name).is_some()
}

/// The form with these constants of the regions: one without a name for all, or one for each by name.
fn form(mesh: &Triangulation, lame: Option<&[(String, f64, f64)]>) -> Result<Form, signorini::Error> {
    let Some(lame) = lame else { return Ok(Form::LAPLACE) };
    if let [(name, lambda, mu)] = lame
        && name.is_empty()
    {
        return Ok(Form::elastic(Lame::new(*lambda, *mu)?));
    }
    let names = mesh.region_names();
    let known = || names.join(", ");
    if let Some((other, ..)) = lame.iter().find(|(name, ..)| !names.contains(name)) {
        return Err(signorini::Error::NoGroup { what: "region", given: other.clone(), known: known() });
    }
    let of = |name: &String| {
        let found = lame.iter().find(|(other, ..)| other == name);
        let (_, lambda, mu) = found.ok_or_else(|| signorini::Error::NoGroup {
            what: "constants for the region",
            given: name.clone(),
            known: lame.iter().map(|(name, ..)| &**name).collect::<Vec<_>>().join(", "),
        })?;
        Ok(Lame::new(*lambda, *mu)?)
    };
    Ok(Form::Elastic { materials: names.iter().map(of).collect::<Result<_, signorini::Error>>()? })
}

/// Solves the problem.
#[pyfunction]
#[pyo3(signature = (nodes, triangles, edges, names, regions, load, values, lame, cone))]
#[allow(clippy::too_many_arguments)] // called by one Python function with all of them
pub(crate) fn contact(
    py: Python<'_>,
    nodes: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
    edges: Vec<[usize; 2]>,
    names: Vec<String>,
    regions: Vec<String>,
    load: Option<Py<PyAny>>,
    values: Vec<f64>,
    lame: Option<Vec<(String, f64, f64)>>,
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
        let edges: Vec<([usize; 2], &str)> =
            edges.iter().zip(&names).map(|(&edge, name)| (edge, name.as_str())).collect();
        let regions: Vec<&str> = regions.iter().map(String::as_str).collect();
        let mesh = Triangulation::from_groups(&nodes, &triangles, &regions, &edges, &[])?;
        let form = form(&mesh, lame.as_deref())?;
        let count = form.components() * mesh.nodes().len();
        let values = if values.is_empty() { vec![0.0; count] } else { values };
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
