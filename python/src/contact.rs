//! Signorini's problem on a triangulation.

use std::sync::Arc;

use fractional_sobolev::Error;
use numpy::PyArray1;
use pyo3::prelude::*;
use signorini::bounds::{Enclosure, Refinement};
use signorini::cone::Cone;
use signorini::contact::{Body, ContactProblem, ContactSolution, Solver, Support};
use signorini::fem::{Form, Lame};
use signorini::mesh::{Part, Triangulation};

use crate::callback::{Callback, Shared};
use crate::operators::array;
use crate::wait::{Failure, wait};

/// The discrete solution, with its bounds if a tolerance was given.
#[pyclass(frozen, module = "fractional_sobolev")]
pub(crate) struct Solved {
    problem: ContactProblem,
    solution: ContactSolution,
    supports: Vec<Support>,
    bounds: Option<Bounds>,
}

struct Bounds {
    enclosure: Enclosure,
    forces: Vec<Option<(f64, f64)>>,
}

#[pymethods]
impl Solved {
    /// (name, force x, force y, moment about the origin) of every clamped and contact group.
    #[getter]
    fn supports(&self) -> Vec<(String, f64, f64, f64)> {
        let row = |one: &Support| (one.group.clone(), one.force[0], one.force[1], one.moment);
        self.supports.iter().map(row).collect()
    }

    /// Guaranteed error in the energy norm, absolute and relative.
    #[getter]
    fn error(&self) -> Option<(f64, f64)> {
        self.bounds.as_ref().map(|found| (found.enclosure.error, found.enclosure.relative_error()))
    }

    /// J(u) of the exact solution in an interval.
    #[getter]
    fn energy_bounds(&self) -> Option<(f64, f64)> {
        self.bounds
            .as_ref()
            .map(|found| (found.enclosure.energy.lower, found.enclosure.energy.upper))
    }

    /// The force of every contact edge in an interval.
    #[getter]
    fn force_bounds(&self) -> Option<Vec<Option<(f64, f64)>>> {
        self.bounds.as_ref().map(|found| found.forces.clone())
    }

    /// The share of every triangle in the square of the bound.
    #[getter]
    fn shares<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.bounds.as_ref().map(|found| array(py, &found.enclosure.shares))
    }

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
        let found = py.detach(|| match &self.bounds {
            Some(found) => found.enclosure.to_vtu(),
            None => self.problem.to_vtu(&self.solution),
        });
        found.map_err(|error| Failure::from(error).raise(py))
    }
}

/// Whether the name of a group says what happens there.
#[pyfunction]
pub(crate) fn states_a_part(name: &str) -> bool {
    Part::named(name).is_some()
}

/// The form with these constants of the regions: one without a name for all, or one for each by name.
fn form(
    mesh: &Triangulation,
    lame: Option<&[(String, f64, f64)]>,
) -> Result<Form, signorini::Error> {
    let Some(lame) = lame else { return Ok(Form::LAPLACE) };
    if let [(name, lambda, mu)] = lame
        && name.is_empty()
    {
        return Ok(Form::elastic(Lame::new(*lambda, *mu)?));
    }
    let names = mesh.region_names();
    let known = || names.join(", ");
    if let Some((other, ..)) = lame.iter().find(|(name, ..)| !names.contains(name)) {
        return Err(signorini::Error::NoGroup {
            what: "region",
            given: other.clone(),
            known: known(),
        });
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

/// What acts: `load`, `traction`, `displacement` or `gap`, the name of its group or region (empty: everywhere), and a
/// function or a constant.
type Given = (String, String, Option<Py<PyAny>>, [f64; 2]);

/// Adds one datum to the body.
fn with_datum(
    body: Body<'static>,
    (kind, place, function, constant): Given,
    shared: &Arc<Shared>,
) -> Body<'static> {
    let callback = function.map(|function| Callback::new(function, shared));
    let is_scalar = kind == "gap" || body.form().components() == 1;
    if is_scalar {
        let f = move |point| callback.as_ref().map_or(constant[0], |f| f.at_point(point));
        match (kind.as_str(), place.as_str()) {
            ("load", "") => body.load(f),
            ("load", region) => body.load_on(region, f),
            ("traction", "") => body.traction(f),
            ("traction", group) => body.traction_on(group, f),
            ("displacement", "") => body.displacement(f),
            ("displacement", group) => body.displacement_on(group, f),
            (_, "") => body.gap(f),
            (_, group) => body.gap_on(group, f),
        }
    } else {
        let f = move |point| callback.as_ref().map_or(constant, |f| f.vector_at(point));
        match (kind.as_str(), place.as_str()) {
            ("load", "") => body.load(f),
            ("load", region) => body.load_on(region, f),
            ("traction", "") => body.traction(f),
            ("traction", group) => body.traction_on(group, f),
            (_, "") => body.displacement(f),
            (_, group) => body.displacement_on(group, f),
        }
    }
}

/// The parts of groups on which something acts and whose names do not state it.
fn parts(given: &[Given]) -> Vec<(&str, Part)> {
    let of = |(kind, place, ..): &'_ Given| {
        match kind.as_str() {
            "traction" => Some(Part::Neumann),
            "displacement" => Some(Part::Dirichlet),
            "gap" => Some(Part::Contact),
            _ => None,
        }
        .filter(|_| !place.is_empty() && Part::named(place).is_none())
    };
    given.iter().filter_map(|one| of(one).map(|part| (one.1.as_str(), part))).collect()
}

/// Solves the problem.
#[pyfunction]
#[pyo3(signature = (nodes, triangles, edges, names, regions, given, values, lame, cone, tolerance))]
#[allow(clippy::too_many_arguments)] // called by one Python function with all of them
pub(crate) fn contact(
    py: Python<'_>,
    nodes: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
    edges: Vec<[usize; 2]>,
    names: Vec<String>,
    regions: Vec<String>,
    given: Vec<Given>,
    values: Vec<f64>,
    lame: Option<Vec<(String, f64, f64)>>,
    cone: &str,
    tolerance: Option<f64>,
) -> PyResult<Solved> {
    let shared = Arc::new(Shared::default());
    let of_callbacks = shared.clone();
    let cone = cone.to_owned();
    wait(py, &shared, move || {
        let cone = match cone.as_str() {
            "nodal" => Cone::Nodal,
            "midpoint" => Cone::Midpoint,
            _ => {
                let expected = "nodal or midpoint";
                return Err(Failure::from(Error::UnknownName {
                    what: "cone",
                    given: cone,
                    expected,
                }));
            }
        };
        let edges: Vec<([usize; 2], &str)> =
            edges.iter().zip(&names).map(|(&edge, name)| (edge, name.as_str())).collect();
        let regions: Vec<&str> = regions.iter().map(String::as_str).collect();
        let mesh =
            Triangulation::from_groups(&nodes, &triangles, &regions, &edges, &parts(&given))?;
        let form = form(&mesh, lame.as_deref())?;
        let body = Body::new(mesh, form);
        let body = given.into_iter().fold(body, |body, one| with_datum(body, one, &of_callbacks));
        if let Some(tolerance) = tolerance {
            let enclosure = Refinement { cone, tolerance, ..Refinement::default() }.solve(&body)?;
            let edges = 0..enclosure.problem.edge().pieces().len();
            let force = |edge| body.contact_force(&enclosure, edge);
            let forces = edges
                .map(|edge| Ok(force(edge)?.map(|force| (force.lower, force.upper))))
                .collect::<Result<_, signorini::Error>>()?;
            let (problem, solution) = (enclosure.problem.clone(), enclosure.solution.clone());
            let supports = problem.supports(&solution)?;
            return Ok(Solved {
                problem,
                solution,
                supports,
                bounds: Some(Bounds { enclosure, forces }),
            });
        }
        let mut problem = body.problem()?;
        if !values.is_empty() {
            problem.add_nodal_load(&values)?;
        }
        let solution = problem.solve(cone, Solver::ActiveSet)?;
        let supports = problem.supports(&solution)?;
        Ok(Solved { problem, solution, supports, bounds: None })
    })
}
