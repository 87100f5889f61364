//! Functions of one variable as Python gives them: a callable with breakpoints, or an array on a mesh.

use std::sync::Arc;

use fractional_sobolev::{Error, Function, Mesh, Result};
use pyo3::prelude::*;

use crate::callback::{Callback, Shared};

/// How a callable is called, or what an array holds.
pub(crate) enum Source {
    /// f(x) between breakpoints.
    Formula(Callback),
    /// f(x, distances to the breakpoints).
    Distances(Callback),
    /// One value per node: piecewise linear; one per element: piecewise constant.
    Values(Vec<f64>),
    /// Values of a functional on the hat functions.
    Functional(Vec<f64>),
}

impl Source {
    pub(crate) fn of(
        u: &Bound<'_, PyAny>,
        distances: bool,
        functional: bool,
        shared: &Arc<Shared>,
    ) -> PyResult<Self> {
        if u.is_callable() {
            let callback = Callback::new(u.clone().unbind(), shared);
            return Ok(if distances { Self::Distances(callback) } else { Self::Formula(callback) });
        }
        let values = u.extract()?;
        Ok(if functional { Self::Functional(values) } else { Self::Values(values) })
    }

    /// The function on the interval with these breakpoints or nodes.
    pub(crate) fn on(&self, places: &[f64]) -> Result<Function<'_>> {
        match self {
            Self::Formula(f) => Function::from_fn(places, |x| f.at(x)),
            Self::Distances(f) => {
                let count = places.len();
                Function::from_positions(places, move |at| {
                    f.at_distances(at.x(), (0..count).map(|k| at.distance_to(k)))
                })
            }
            Self::Functional(values) => Function::load(&Mesh::from_nodes(places)?, values),
            Self::Values(values) => {
                let mesh = Mesh::from_nodes(places)?;
                match values.len() {
                    n if n == places.len() => Function::linears(&mesh, values),
                    n if n + 1 == places.len() => Function::piecewise(&mesh, 0, values),
                    given => Err(Error::LengthMismatch {
                        name: "array of nodal values (or of element values, one fewer)",
                        given,
                        expected: places.len(),
                    }),
                }
            }
        }
    }
}
