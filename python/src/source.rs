//! Functions of one variable as Python gives them: a callable with breakpoints, or an array on a mesh.

use std::sync::Arc;

use fractional_sobolev::{DualOf, Error, Estimate, Function, Load, Mesh, Result};
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

    /// The dual norm of order −s on the interval with these breakpoints or nodes.
    pub(crate) fn dual_norm(
        &self,
        places: &[f64],
        of: DualOf,
        s: f64,
        tolerance: f64,
    ) -> Result<Estimate> {
        match self {
            Self::Functional(values) if of == DualOf::Slobodeckij => {
                Load::new(&Mesh::from_nodes(places)?, values)?.dual_norm(s, tolerance)
            }
            Self::Functional(_) => Err(Error::Incompatible {
                what: "the dual norm",
                given: format!("of {of:?}"),
                with: "a functional on hat functions",
                expected: "slobodeckij",
            }),
            _ => self.on(places)?.dual_norm(of, s, tolerance),
        }
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
            Self::Functional(_) => Err(Error::Incompatible {
                what: "the",
                given: "norm of positive order".to_owned(),
                with: "a functional on hat functions",
                expected: "the dual norm",
            }),
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
