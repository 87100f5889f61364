//! A Python function of numbers as a Rust one: its first exception ends the computation and is raised afterwards.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// What a computation shares with the call that waits for it.
#[derive(Default)]
pub(crate) struct Shared {
    /// Set when the caller no longer waits: every callback then returns NaN, which ends the computation.
    pub(crate) stop: AtomicBool,
    failed: Mutex<Option<PyErr>>,
}

impl Shared {
    /// The first exception of a callback.
    pub(crate) fn take_failure(&self) -> Option<PyErr> {
        self.failed.lock().ok().and_then(|mut failed| failed.take())
    }

    fn fail(&self, error: PyErr) {
        if let Ok(mut failed) = self.failed.lock() {
            failed.get_or_insert(error);
        }
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// A Python callable that returns a number.
pub(crate) struct Callback {
    function: Py<PyAny>,
    shared: Arc<Shared>,
}

impl Callback {
    pub(crate) fn new(function: Py<PyAny>, shared: &Arc<Shared>) -> Self {
        Self { function, shared: shared.clone() }
    }

    /// f(x).
    pub(crate) fn at(&self, x: f64) -> f64 {
        self.number(|py| (x,).into_pyobject(py))
    }

    /// f(x, y).
    pub(crate) fn at_point(&self, [x, y]: [f64; 2]) -> f64 {
        self.number(|py| (x, y).into_pyobject(py))
    }

    /// f(x, d), d the distances to the breakpoints.
    pub(crate) fn at_distances(&self, x: f64, distances: impl Iterator<Item = f64>) -> f64 {
        let distances: Vec<f64> = distances.collect();
        self.number(|py| (x, PyTuple::new(py, distances)?).into_pyobject(py))
    }

    /// (f_x, f_y) at a point.
    pub(crate) fn vector_at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let found = self.call(
            |py| (x, y).into_pyobject(py),
            |value| {
                let parts: Vec<f64> =
                    value.try_iter()?.map(|part| part?.extract()).collect::<PyResult<_>>()?;
                parts.try_into().map_err(|parts: Vec<f64>| {
                    PyValueError::new_err(format!(
                        "the load has {} components, expected 2",
                        parts.len()
                    ))
                })
            },
        );
        found.unwrap_or([f64::NAN; 2])
    }

    fn number(&self, arguments: impl FnOnce(Python<'_>) -> PyResult<Bound<'_, PyTuple>>) -> f64 {
        self.call(arguments, |value| value.extract()).unwrap_or(f64::NAN)
    }

    fn call<T>(
        &self,
        arguments: impl FnOnce(Python<'_>) -> PyResult<Bound<'_, PyTuple>>,
        read: impl FnOnce(Bound<'_, PyAny>) -> PyResult<T>,
    ) -> Option<T> {
        if self.shared.stop.load(Ordering::Relaxed) {
            return None;
        }
        Python::attach(|py| {
            let found =
                arguments(py).and_then(|arguments| read(self.function.bind(py).call1(arguments)?));
            found.map_err(|error| self.shared.fail(error)).ok()
        })
    }
}
