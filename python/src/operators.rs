//! The Gram matrix of a seminorm as an operator.

use std::sync::Arc;

use fractional_sobolev::{Gram, Mesh};
use numpy::{PyArray1, PyArray2, PyReadonlyArray1, ToPyArray};
use pyo3::prelude::*;

use crate::callback::Shared;
use crate::wait::{Failure, estimate, wait};

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
    fn new(
        py: Python<'_>,
        nodes: Vec<f64>,
        s: f64,
        tol: f64,
        zero_outside: bool,
    ) -> PyResult<Self> {
        let shared = Arc::new(Shared::default());
        let found = wait(py, &shared, move || {
            let mesh = Mesh::from_nodes(&nodes)?;
            Ok(if zero_outside {
                Gram::zero_outside(&mesh, s, tol)?
            } else {
                Gram::new(&mesh, s, tol)?
            })
        })?;
        Ok(Self(Arc::new(found)))
    }

    /// The solution of A x = b and the energy xᵀA x.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        b: Vec<f64>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Py<PyAny>)> {
        let (shared, gram) = (Arc::new(Shared::default()), self.0.clone());
        let (x, energy) = wait(py, &shared, move || Ok(gram.solve(&b)?))?;
        Ok((PyArray1::from_vec(py, x), estimate(py, energy)?))
    }

    fn precondition<'py>(
        &self,
        py: Python<'py>,
        r: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let r = r.as_slice()?;
        product(py, || self.0.precondition(r))
    }

    /// The smallest positive and the largest eigenvalue of A x = λ M x.
    fn extreme_eigenvalues(&self, py: Python<'_>) -> PyResult<(Py<PyAny>, Py<PyAny>)> {
        let (shared, gram) = (Arc::new(Shared::default()), self.0.clone());
        let [low, high] = wait(py, &shared, move || Ok(gram.extreme_eigenvalues()?))?;
        Ok((estimate(py, low)?, estimate(py, high)?))
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

    fn dense<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let found =
            py.detach(|| self.0.to_dense()).map_err(|error| Failure::from(error).raise(py))?;
        let rows: Vec<Vec<f64>> =
            found.row_iter().map(|row| row.iter().copied().collect()).collect();
        Ok(PyArray2::from_vec2(py, &rows)?)
    }
}

/// An array of the values.
pub(crate) fn array<'py>(py: Python<'py>, values: &[f64]) -> Bound<'py, PyArray1<f64>> {
    values.to_pyarray(py)
}
