//! The error type of the library. Variants for invalid input carry the offending value;
//! [`Error::ToleranceNotMet`] carries the best estimate, if there is one.

mod given;

pub use given::Given;

use crate::value::Estimate;

/// Result with the library's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// The error type of this library: invalid input, insufficient memory, an infinite result, a tolerance that
/// is not met, or a factorization or solver that failed.
///
/// How an iteration ended (converged, stalled, cycled) is a status in its result, not an error.
///
/// ```
/// use fractional_sobolev::{Constraint, Error, Order, gamma};
/// let refused = gamma(0.25, Constraint::mean_zero_on(0.0..0.5), 1e-15).unwrap_err();
/// assert!(matches!(refused, Error::ToleranceNotMet { .. }));
/// assert!(refused.best().is_some_and(|best| best.relative_error() < 1e-11)); // the error carries the best estimate
/// assert!(matches!(Order::new(f64::NAN), Err(Error::OutOfRange { name: "nu", .. })));
///
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A parameter lies outside the range in which the formula holds.
    #[error("{name} = {value:?} is outside {range}")]
    OutOfRange {
        /// Name of the parameter.
        name: &'static str,
        /// The value that was given.
        value: f64,
        /// The admissible set, as text.
        range: &'static str,
    },
    /// An entry of a list lies outside the range in which the formula holds.
    #[error("{name} at index {index} = {value:?} is outside {range}")]
    EntryOutOfRange {
        /// Name of the entry.
        name: &'static str,
        /// Its position, from 0.
        index: usize,
        /// The value that was given.
        value: f64,
        /// The admissible set, as text.
        range: &'static str,
    },
    /// A count (cells, nodes, levels, ...) is not admissible.
    #[error("{name} = {value} is outside {range}")]
    CountOutOfRange {
        /// Name of the count.
        name: &'static str,
        /// The count that was given.
        value: usize,
        /// The admissible set, as text.
        range: &'static str,
    },
    /// A count for which the machine does not have enough memory.
    #[error(
        "{name} = {count} requires {needed:.3e} GB of memory: this machine has {available:.1} GB"
    )]
    TooLarge {
        /// Name of the count.
        name: &'static str,
        /// The count that was given.
        count: usize,
        /// The required memory, in units of 10^9 bytes.
        needed: f64,
        /// The physical memory, in units of 10^9 bytes.
        available: f64,
    },
    /// A name that is not one of the known names.
    #[error("unknown {what} '{given}': expected {expected}")]
    UnknownName {
        /// Kind of the name.
        what: &'static str,
        /// The name that was given.
        given: String,
        /// The known names, as text.
        expected: &'static str,
    },
    /// Two choices that cannot be combined.
    #[error("{what} {given} is not available for {with}: expected {expected}")]
    Incompatible {
        /// Name of the choice.
        what: &'static str,
        /// The choice.
        given: String,
        /// The other choice, as text.
        with: &'static str,
        /// The admissible choices, as text.
        expected: &'static str,
    },
    /// A value (data, load, function value) is NaN or infinite.
    #[error("{name} is not finite: {value} at index {index}")]
    NotFinite {
        /// Name of the value.
        name: &'static str,
        /// Its position.
        index: usize,
        /// The value.
        value: f64,
    },
    /// A function on the plane is NaN or infinite at an evaluation point.
    #[error("{name} is not finite: {value} at ({:?}, {:?})", point[0], point[1])]
    NotFiniteAt {
        /// Name of the function.
        name: &'static str,
        /// The point.
        point: [f64; 2],
        /// The value.
        value: f64,
    },
    /// An array does not have the required length.
    #[error("{name}: length {given}, expected {expected}")]
    LengthMismatch {
        /// Name of the array.
        name: &'static str,
        /// Its length.
        given: usize,
        /// The length it should have.
        expected: usize,
    },
    /// The requested norm is infinite.
    #[error("the norm is infinite: {why} (order {order})")]
    InfiniteNorm {
        /// Order of the Sobolev norm.
        order: f64,
        /// The reason, as text.
        why: &'static str,
    },
    /// The tolerance was not met; the best estimate and the limiting factor are given.
    #[error("{what}: relative error {reached:.1e}, requested {asked:e}{}: {why}", value_of(best))]
    ToleranceNotMet {
        /// The quantity.
        what: &'static str,
        /// The requested relative tolerance.
        asked: f64,
        /// The estimated relative error that was reached.
        reached: f64,
        /// The best estimate of the quantity; `None` if no value was obtained.
        best: Option<Estimate>,
        /// The limiting factor, as text.
        why: &'static str,
    },
    /// A matrix that should be positive definite is not, to working accuracy.
    #[error("{what} is not positive definite: pivot {pivot}")]
    NotPositiveDefinite {
        /// Name of the matrix.
        what: &'static str,
        /// Index of the pivot at which the factorization broke down.
        pivot: usize,
    },
    /// A solver of another library failed.
    #[error("solver: {reason}")]
    Solver {
        /// Its message.
        reason: String,
    },
    /// Two triangles of a mesh overlap: their interiors intersect.
    #[error("triangles {} and {} overlap", triangles[0], triangles[1])]
    Overlap {
        /// Their indices, from 0.
        triangles: [usize; 2],
    },
    /// A triangle of a mesh is invalid.
    #[error("triangle {triangle} {reason} {}", plain(*value))]
    Triangle {
        /// Its index, from 0.
        triangle: usize,
        /// Description of the error.
        reason: &'static str,
        /// The offending value.
        value: f64,
    },
    /// An edge of a mesh is invalid.
    #[error("edge {}-{} {reason}", nodes[0], nodes[1])]
    Edge {
        /// Its end nodes.
        nodes: [usize; 2],
        /// Description of the error.
        reason: &'static str,
    },
    /// A node of a mesh is invalid.
    #[error("node {node} {reason}")]
    Node {
        /// Its index, from 0.
        node: usize,
        /// Description of the error.
        reason: &'static str,
    },
}

/// A number as it appears in the message: node numbers and counts as integers.
fn plain(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < 1e15 {
        format!("{value:.0}")
    } else {
        format!("{value:?}")
    }
}

/// The best value as it appears in the message; empty if there is none.
fn value_of(best: &Option<Estimate>) -> String {
    best.map_or_else(String::new, |best| format!(" (best value {best})"))
}

impl Error {
    /// [`Error::ToleranceNotMet`] with the best estimate of `what`, for the reason given.
    pub(crate) fn not_met(
        what: &'static str,
        asked: f64,
        best: Estimate,
        why: &'static str,
    ) -> Self {
        Error::ToleranceNotMet {
            what,
            asked,
            reached: best.relative_error(),
            best: Some(best),
            why,
        }
    }

    /// [`Error::ToleranceNotMet`] without a value of `what`: the relative uncertainty and the reason.
    pub(crate) fn out_of_reach(
        what: &'static str,
        asked: f64,
        reached: f64,
        why: &'static str,
    ) -> Self {
        Error::ToleranceNotMet { what, asked, reached, best: None, why }
    }

    /// [`Error::not_met`] with the best of several attempts; without a value if there is none.
    pub(crate) fn best_of(
        what: &'static str,
        asked: f64,
        best: Option<Estimate>,
        why: &'static str,
    ) -> Self {
        best.map_or(Self::out_of_reach(what, asked, f64::INFINITY, why), |best| {
            Self::not_met(what, asked, best, why)
        })
    }

    /// The best estimate carried by [`Error::ToleranceNotMet`]; `None` if it has none, and for all other
    /// errors.
    pub fn best(&self) -> Option<Estimate> {
        match self {
            Error::ToleranceNotMet { best, .. } => *best,
            _ => None,
        }
    }

    /// The same error for a quantity derived from the one whose tolerance was not met.
    pub(crate) fn carry(
        self,
        quantity: &'static str,
        of: impl FnOnce(Estimate) -> Result<Estimate>,
    ) -> Self {
        match self {
            Error::ToleranceNotMet { asked, best: Some(best), why, .. } => match of(best) {
                Ok(best) => Self::not_met(quantity, asked, best, why),
                Err(error) => error,
            },
            other => other,
        }
    }

    /// The value of the parameter `name` if it is admissible; NaN never is.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] otherwise.
    pub(crate) fn require(
        name: &'static str,
        value: f64,
        range: &'static str,
        admissible: bool,
    ) -> Result<f64> {
        if admissible && !value.is_nan() {
            Ok(value)
        } else {
            Err(Error::OutOfRange { name, value, range })
        }
    }
}
