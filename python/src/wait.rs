//! Computations beside the interpreter: it is released, Ctrl-C is seen, errors become exceptions.

use std::sync::atomic::Ordering;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, Once, PoisonError};
use std::time::Duration;

use fractional_sobolev::{Error, Estimate};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::callback::Shared;

/// Between two looks for Ctrl-C.
const PATIENCE: Duration = Duration::from_millis(50);

/// An error of either library.
pub(crate) enum Failure {
    Toolkit(Error),
    Contact(signorini::Error),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Toolkit(error)
    }
}

impl From<signorini::Error> for Failure {
    fn from(error: signorini::Error) -> Self {
        match error {
            signorini::Error::Toolkit(error) => Self::Toolkit(error),
            other => Self::Contact(other),
        }
    }
}

impl Failure {
    pub(crate) fn raise(self, py: Python<'_>) -> PyErr {
        let (kind, message, best) = match &self {
            Self::Toolkit(error) => {
                let kind = match error {
                    Error::ToleranceNotMet { .. } => "ToleranceNotMet",
                    Error::InfiniteNorm { .. } => "InfiniteNorm",
                    _ => "SobolevError",
                };
                (kind, error.to_string(), error.best())
            }
            Self::Contact(error) => ("SobolevError", error.to_string(), None),
        };
        let raised = || -> PyResult<PyErr> {
            let best = best.map(|best| estimate(py, best)).transpose()?;
            Ok(PyErr::from_value(types(py)?.getattr(kind)?.call1((message, best))?))
        };
        raised().unwrap_or_else(|error| error)
    }
}

fn types(py: Python<'_>) -> PyResult<Bound<'_, PyModule>> {
    py.import("fractional_sobolev._types")
}

/// The number with its error, as a Python `Estimate`.
pub(crate) fn estimate(py: Python<'_>, found: Estimate) -> PyResult<Py<PyAny>> {
    Ok(types(py)?
        .getattr("Estimate")?
        .call1((found.value, found.error, found.work.total()))?
        .unbind())
}

/// Attaches the threads that share the work to the interpreter, each once for its life: a thread state made for each
/// callback would cost many times the callback.
fn attach_workers(py: Python<'_>) {
    static ONCE: Once = Once::new();
    let run = |worker: rayon::ThreadBuilder| Python::attach(|py| py.detach(|| worker.run()));
    let spawned = |worker| std::thread::Builder::new().spawn(move || run(worker)).map(drop);
    // Released, as all of them attach before the pool is there. Without it Rayon makes its own, of slower callbacks.
    py.detach(|| {
        ONCE.call_once(|| {
            rayon::ThreadPoolBuilder::new().spawn_handler(spawned).build_global().ok();
        });
    });
}

/// What the computation returns. It runs on a thread of its own without the interpreter; Ctrl-C is answered at once,
/// and ends a computation that calls Python functions.
pub(crate) fn wait<T: Send + 'static>(
    py: Python<'_>,
    shared: &Arc<Shared>,
    job: impl FnOnce() -> Result<T, Failure> + Send + 'static,
) -> PyResult<T> {
    attach_workers(py);
    let (send, receive) = channel();
    // Attached once for the whole computation: a thread state made for each callback would cost 20 times the callback.
    std::thread::spawn(move || Python::attach(|py| py.detach(|| send.send(job()).ok())));
    let receive = Mutex::new(receive); // shared with the closure that waits
    loop {
        match py.detach(|| {
            receive.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(PATIENCE)
        }) {
            Ok(found) => {
                if let Some(error) = shared.take_failure() {
                    return Err(error);
                }
                return found.map_err(|failure| failure.raise(py));
            }
            Err(RecvTimeoutError::Timeout) => {
                if let Err(interrupt) = py.check_signals() {
                    shared.stop.store(true, Ordering::Relaxed);
                    return Err(interrupt);
                }
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the computation ended without a result"));
            }
        }
    }
}
