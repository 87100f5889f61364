//! The Gram matrix of a seminorm as an operator.

use std::sync::Arc;

use fractional_sobolev::{Gram, Mesh};
use numpy::{PyArray1, PyArray2, PyReadonlyArray1, ToPyArray};
use pyo3::prelude::*;

use crate::callback::Shared;
use crate::wait::{Failure, wait};

/// The Gram matrix of |·|_s on the hat functions of a mesh.
#[pyclass(frozen, module = "fractional_sobolev")]
pub(crate) struct GramMatrix(Arc<Gram>);

fn product<'py>(
    py: Python<'py>,
    of: impl FnOnce() -> fractional_sobolev::Result<Vec<f64>> + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let found = py.detach(of).map_err(|error| Failure::from(error).raise(py))?;
    Ok(PyArray1::from_vec(py, found))
}

#[pymethods]
impl GramMatrix {
    #[new]
    fn new(py: Python<'_>, nodes: Vec<f64>, s: f64, tol: f64) -> PyResult<Self> {
        let shared = Arc::new(Shared::default());
        let found = wait(py, &shared, move || Ok(Gram::new(&Mesh::from_nodes(&nodes)?, s, tol)?))?;
        Ok(Self(Arc::new(found)))
    }

    fn size(&self) -> usize {
        self.0.len()
    }

    fn apply<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let x = x.as_slice()?;
        product(py, || self.0.apply(x))
    }

    fn mass<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let x = x.as_slice()?;
        product(py, || self.0.mass(x))
    }

    fn diagonal<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        product(py, || self.0.diagonal())
    }

    fn dense<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let found = py.detach(|| self.0.to_dense()).map_err(|error| Failure::from(error).raise(py))?;
        let rows: Vec<Vec<f64>> = found.row_iter().map(|row| row.iter().copied().collect()).collect();
        Ok(PyArray2::from_vec2(py, &rows)?)
    }
}

/// An array of the values.
pub(crate) fn array<'py>(py: Python<'py>, values: &[f64]) -> Bound<'py, PyArray1<f64>> {
    values.to_pyarray(py)
}
