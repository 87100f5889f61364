//! Best constants with a function that attains them.

use std::sync::Arc;

use fractional_sobolev::{
    BestConstant, Constraint, Domain, Error, ErrorNorm, Estimate, Extremal, Zones, gamma,
    interpolation_constant,
};
use pyo3::prelude::*;

use crate::callback::Shared;
use crate::wait::{estimate, wait};

/// A function for which a best constant is attained.
#[pyclass(frozen, module = "fractional_sobolev")]
pub(crate) struct ExtremalFunction(Extremal);

#[pymethods]
impl ExtremalFunction {
    /// The values at points, each given by its coordinates; NaN outside the domain.
    fn values(&self, points: Vec<Vec<f64>>) -> Vec<f64> {
        points.iter().map(|point| self.0.value(point)).collect()
    }
}

/// The constant, a lower and an upper bound, and a function that attains it.
type Found = (Py<PyAny>, Option<Py<PyAny>>, Option<Py<PyAny>>, Option<ExtremalFunction>);

/// What of an interval a Poincaré constant is about.
enum Condition {
    MeanZero,
    MeanZeroOn(Zones),
    VanishingOn(Zones),
    VanishingAt(f64),
}

/// γ of the unit interval.
#[pyfunction]
#[pyo3(signature = (s, zones, start_and_length, condition, point, tol))]
pub(crate) fn poincare(
    py: Python<'_>,
    s: f64,
    zones: Vec<(f64, f64)>,
    start_and_length: bool,
    condition: &str,
    point: Option<f64>,
    tol: f64,
) -> PyResult<Found> {
    let shared = Arc::new(Shared::default());
    let condition = condition.to_owned();
    let (found, bounded) = wait(py, &shared, move || {
        let zones_given = || match zones.as_slice() {
            [(start, length)] if start_and_length => Zones::from_start_and_length(*start, *length),
            _ => Zones::union(&zones.iter().map(|&(a, b)| a..b).collect::<Vec<_>>()),
        };
        let condition = match (condition.as_str(), point) {
            ("point", Some(x)) => Condition::VanishingAt(x),
            ("vanishing", _) => Condition::VanishingOn(zones_given()?),
            _ if zones.is_empty() => Condition::MeanZero,
            _ => Condition::MeanZeroOn(zones_given()?),
        };
        let constraint = match condition {
            Condition::MeanZero => Constraint::mean_zero(),
            Condition::MeanZeroOn(zones) => Constraint::mean_zero_on(zones)?,
            Condition::VanishingOn(zones) => Constraint::vanishing_on(zones)?,
            Condition::VanishingAt(x) => Constraint::vanishing_at(x)?,
        };
        let found = gamma(s, constraint, tol)?;
        let bounded = found.bounded().ok();
        Ok((found, bounded))
    })?;
    shown(py, &found, bounded.as_ref())
}

/// The best constant of linear interpolation on an interval, a mesh or a triangle.
#[pyfunction]
#[pyo3(signature = (s, length, mesh, triangle, norm, tol))]
pub(crate) fn interpolation(
    py: Python<'_>,
    s: f64,
    length: f64,
    mesh: Option<Vec<f64>>,
    triangle: Option<[[f64; 2]; 3]>,
    norm: &str,
    tol: f64,
) -> PyResult<Found> {
    let shared = Arc::new(Shared::default());
    let norm = norm.to_owned();
    let found = wait(py, &shared, move || {
        let norm = match norm.as_str() {
            "L2" => ErrorNorm::L2,
            "derivative" => ErrorNorm::Derivative,
            "H1" => ErrorNorm::H1,
            _ => {
                let expected = "L2, derivative or H1";
                return Err(Error::UnknownName { what: "norm", given: norm, expected }.into());
            }
        };
        let domain = match (mesh, triangle) {
            (_, Some(corners)) => Domain::Triangle(corners),
            (Some(nodes), None) => Domain::Mesh(fractional_sobolev::Mesh::from_nodes(&nodes)?),
            (None, None) => Domain::Interval(length),
        };
        Ok(interpolation_constant(domain, norm, s, tol)?)
    })?;
    shown(py, &found, Some(&found))
}

/// The constant with its bounds, if any, and its function.
fn shown(py: Python<'_>, found: &BestConstant, bounded: Option<&BestConstant>) -> PyResult<Found> {
    let bound = |of: Option<Estimate>| of.map(|bound| estimate(py, bound)).transpose();
    let lower = bound(bounded.map(|found| found.lower))?;
    let upper = bound(bounded.and_then(|found| found.upper))?;
    let extremal = found.extremal().ok().map(ExtremalFunction);
    Ok((estimate(py, found.constant)?, lower, upper, extremal))
}
