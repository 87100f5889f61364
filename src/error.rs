//! The error type of the contact library: its own errors, and those of the toolkit.

use fractional_sobolev::Estimate;
use std::path::PathBuf;

pub use fractional_sobolev::Error as ToolkitError;

/// Result with [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// The error of this library: invalid input, a file that cannot be used, or an error of the toolkit.
///
/// The termination of an iteration (converged, stalled, cycled) is a status in its result, not an error.
///
/// ```
/// use signorini::{Error, ToolkitError};
/// let refused: Error = fractional_sobolev::Order::new(f64::NAN).unwrap_err().into();
/// assert!(matches!(refused, Error::Toolkit(ToolkitError::OutOfRange { name: "nu", .. })));
/// assert!(Error::file("body.msh", "no such file").to_string().contains("body.msh"));
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An error of the toolkit: a parameter, a count, an array, a matrix or a tolerance.
    #[error(transparent)]
    Toolkit(#[from] ToolkitError),
    /// A solver of another library failed.
    #[error("solver: {reason}")]
    Solver {
        /// Its message.
        reason: String,
    },
    /// Contact force and open gap at the same node.
    #[error("node {node}: u_N = {value:?} and lambda = {force:?} are both nonzero")]
    NotComplementary {
        /// The node.
        node: usize,
        /// u_N there.
        value: f64,
        /// λ there.
        force: f64,
    },
    /// A body without Dirichlet boundary: the solution is not unique.
    #[error(
        "the body of {triangles} triangles with node {node} at ({}, {}) has no edge on the Dirichlet boundary: the \
         solution is not unique",
        place[0], place[1]
    )]
    NotHeld {
        /// Its number of triangles.
        triangles: usize,
        /// Its first node, in the numbering of the mesh file.
        node: usize,
        /// Coordinates of that node.
        place: [f64; 2],
    },
    /// A contact problem without a node in contact.
    #[error("the contact set is empty: u_N < 0 at all {nodes} nodes")]
    EmptyContact {
        /// Number of nodes of the edge.
        nodes: usize,
    },
    /// A text does not follow its format.
    #[error("{format}, line {line}: {reason}")]
    Syntax {
        /// The format.
        format: &'static str,
        /// The line, from 1.
        line: usize,
        /// Description of the error.
        reason: String,
    },
    /// A text follows its format, but a line has invalid content.
    #[error("{format}, line {line}: {cause}")]
    AtLine {
        /// The format.
        format: &'static str,
        /// The line, from 1.
        line: usize,
        /// The cause.
        cause: Box<Error>,
    },
    /// A file could not be read or written.
    #[error("{}: {reason}", path.display())]
    File {
        /// The path.
        path: PathBuf,
        /// The message of the system.
        reason: String,
    },
}

impl Error {
    /// The best estimate that a missed tolerance carries; `None` for all other errors.
    ///
    /// ```
    /// assert!(signorini::Error::file("body.msh", "no such file").best().is_none());
    /// ```
    pub fn best(&self) -> Option<Estimate> {
        match self {
            Error::Toolkit(error) => error.best(),
            _ => None,
        }
    }

    /// The parameter `name` if it satisfies `admissible`. NaN is never admissible.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`] otherwise.
    pub(crate) fn require(
        name: &'static str,
        value: f64,
        range: &'static str,
        admissible: bool,
    ) -> Result<f64> {
        if admissible && !value.is_nan() {
            Ok(value)
        } else {
            Err(Error::Toolkit(ToolkitError::OutOfRange { name, value, range }))
        }
    }

    /// [`ToolkitError::ToleranceNotMet`] with the best estimate of `what`.
    pub(crate) fn not_met(what: &'static str, asked: f64, best: Estimate, why: &'static str) -> Self {
        let reached = best.relative_error();
        Error::Toolkit(ToolkitError::ToleranceNotMet { what, asked, reached, best: Some(best), why })
    }

    /// [`ToolkitError::ToleranceNotMet`] without a value of `what`, with the relative uncertainty.
    pub(crate) fn out_of_reach(what: &'static str, asked: f64, reached: f64, why: &'static str) -> Self {
        Error::Toolkit(ToolkitError::ToleranceNotMet { what, asked, reached, best: None, why })
    }

    /// The error for the file `path` with the reason given by the system.
    pub fn file(path: impl Into<PathBuf>, reason: impl std::fmt::Display) -> Self {
        Error::File { path: path.into(), reason: reason.to_string() }
    }
}
