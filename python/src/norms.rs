//! Norms of functions on intervals, triangulations and polygons.

use std::sync::Arc;

use fractional_sobolev::{Curve, DualOf, Error, Function, Mesh, Triangles};
use pyo3::prelude::*;

use crate::callback::{Callback, Shared};
use crate::source::Source;
use crate::wait::{Failure, estimate, wait};

/// Which norm.
#[derive(Clone, Copy)]
enum Which {
    Seminorm,
    Norm,
}

fn of(
    which: Which,
    u: &Function<'_>,
    s: f64,
    tolerance: f64,
) -> Result<fractional_sobolev::Estimate, Failure> {
    Ok(match which {
        Which::Seminorm => u.seminorm(s, tolerance)?,
        Which::Norm => u.norm(s, tolerance)?,
    })
}

/// The seminorm or the norm of a function on an interval.
#[pyfunction]
#[pyo3(signature = (u, s, on, tol, distances, derivative, seminorm))]
#[allow(clippy::too_many_arguments)] // called by one Python function with all of them
pub(crate) fn norm(
    py: Python<'_>,
    u: &Bound<'_, PyAny>,
    s: f64,
    on: Vec<f64>,
    tol: f64,
    distances: bool,
    derivative: Option<Bound<'_, PyAny>>,
    seminorm: bool,
) -> PyResult<Py<PyAny>> {
    let shared = Arc::new(Shared::default());
    let source = Source::of(u, distances, false, &shared)?;
    let slope =
        derivative.map(|slope| Source::of(&slope, distances, false, &shared)).transpose()?;
    let which = if seminorm { Which::Seminorm } else { Which::Norm };
    let found = wait(py, &shared, move || {
        let mut u = source.on(&on)?;
        if let Some(slope) = &slope {
            u = u.with_gradient(vec![slope.on(&on)?]);
        }
        of(which, &u, s, tol)
    })?;
    estimate(py, found)
}

/// The dual norm of order −s of a function or a functional.
#[pyfunction]
#[pyo3(signature = (f, s, on, tol, distances, functional, dual_of))]
#[allow(clippy::too_many_arguments)] // called by one Python function with all of them
pub(crate) fn dual_norm(
    py: Python<'_>,
    f: &Bound<'_, PyAny>,
    s: f64,
    on: Vec<f64>,
    tol: f64,
    distances: bool,
    functional: bool,
    dual_of: String,
) -> PyResult<Py<PyAny>> {
    let shared = Arc::new(Shared::default());
    let source = Source::of(f, distances, functional, &shared)?;
    let found = wait(py, &shared, move || {
        let of = match dual_of.as_str() {
            "slobodeckij" => DualOf::Slobodeckij,
            "cosines" => DualOf::Interpolation,
            "sines" => DualOf::InterpolationZero,
            _ => {
                let expected = "slobodeckij, cosines or sines";
                return Err(Error::UnknownName { what: "norm", given: dual_of, expected }.into());
            }
        };
        Ok(source.dual_norm(&on, of, s, tol)?)
    })?;
    estimate(py, found)
}

/// The norm of u less the piecewise linear function with the given values at the nodes.
#[pyfunction]
#[pyo3(signature = (u, nodes, s, values, breaks, tol, distances, seminorm))]
#[allow(clippy::too_many_arguments)] // called by one Python function with all of them
pub(crate) fn error_norm(
    py: Python<'_>,
    u: &Bound<'_, PyAny>,
    nodes: Vec<f64>,
    s: f64,
    values: Vec<f64>,
    breaks: Vec<f64>,
    tol: f64,
    distances: bool,
    seminorm: bool,
) -> PyResult<Py<PyAny>> {
    let shared = Arc::new(Shared::default());
    let source = Source::of(u, distances, false, &shared)?;
    let which = if seminorm { Which::Seminorm } else { Which::Norm };
    let found = wait(py, &shared, move || {
        let u = source.on(&breaks)?;
        let discrete = Function::linears(&Mesh::from_nodes(&nodes)?, &values)?;
        of(which, &u.minus(&discrete)?, s, tol)
    })?;
    estimate(py, found)
}

/// The norm on the boundary of a polygon of a callable f(x, y) (s < 0: of its piecewise linear interpolant), or of values
/// at the nodes.
#[pyfunction]
#[pyo3(signature = (vertices, u, s, tol, elements, exponent, seminorm))]
#[allow(clippy::too_many_arguments)] // called by one Python function with all of them
pub(crate) fn boundary_norm(
    py: Python<'_>,
    vertices: Vec<[f64; 2]>,
    u: &Bound<'_, PyAny>,
    s: f64,
    tol: f64,
    elements: usize,
    exponent: f64,
    seminorm: bool,
) -> PyResult<Py<PyAny>> {
    let shared = Arc::new(Shared::default());
    let callback = u.is_callable().then(|| Callback::new(u.clone().unbind(), &shared));
    let values: Vec<f64> = if callback.is_some() { Vec::new() } else { u.extract()? };
    let which = if seminorm { Which::Seminorm } else { Which::Norm };
    let found = wait(py, &shared, move || {
        let curve = Curve::algebraic(&vertices, elements, exponent)?;
        let values = match callback {
            Some(f) if s >= 0.0 => {
                return of(
                    which,
                    &Function::on_polygon(&vertices, |point| f.at_point(point))?,
                    s,
                    tol,
                );
            }
            Some(f) => curve.nodes().into_iter().map(|point| f.at_point(point)).collect(),
            None => values,
        };
        of(which, &Function::on_curve(&curve, 1, &values)?, s, tol)
    })?;
    estimate(py, found)
}

/// The norm of a function on a triangulation, with a value per node or per triangle.
#[pyfunction]
#[pyo3(signature = (nodes, triangles, values, s, tol, seminorm))]
pub(crate) fn plane_norm(
    py: Python<'_>,
    nodes: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
    values: Vec<f64>,
    s: f64,
    tol: f64,
    seminorm: bool,
) -> PyResult<Py<PyAny>> {
    let shared = Arc::new(Shared::default());
    let which = if seminorm { Which::Seminorm } else { Which::Norm };
    let found = wait(py, &shared, move || {
        let degree = usize::from(values.len() == nodes.len());
        let mesh = Triangles::new(&nodes, &triangles)?;
        of(which, &Function::on_triangles(&mesh, degree, &values)?, s, tol)
    })?;
    estimate(py, found)
}
