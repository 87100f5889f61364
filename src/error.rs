//! The error type of the contact library, which includes the errors of the toolkit.

use fractional_sobolev::Estimate;
use std::any::Any;
use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

pub use fractional_sobolev::Error as ToolkitError;

/// A result whose error type is [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// The error type of this library: invalid input, an unusable file, an iteration that did not converge, or an error of
/// the toolkit.
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
    /// An iteration ended before its stopping rule was met; the best solution is [`Error::unfinished`].
    #[error("not converged: {status}; the best solution has J = {energy:e}")]
    NotConverged {
        /// The termination of the iteration.
        status: String,
        /// The energy J of the best solution.
        energy: f64,
        /// The best solution.
        solution: Unfinished,
    },
    /// A solver of another library reported an error.
    #[error("solver: {reason}")]
    Solver {
        /// The message of the solver.
        reason: String,
    },
    /// The contact force and the displacement u_N are both nonzero at a node.
    #[error(
        "node {node}: u_N = {value:?} and lambda = {force:?} are both nonzero: one of them must be zero"
    )]
    NotComplementary {
        /// The node, from 0.
        node: usize,
        /// u_N at the node.
        value: f64,
        /// λ at the node.
        force: f64,
    },
    /// A body without Dirichlet boundary, whose displacement is not unique.
    #[error(
        "the body of {triangles} triangles with node {node} at ({}, {}) has no edge on the Dirichlet boundary: \
         prescribe the displacement on at least one edge, otherwise the solution is not unique",
        place[0], place[1]
    )]
    NotHeld {
        /// Number of triangles of the body.
        triangles: usize,
        /// First node of the body, in the numbering of the mesh file.
        node: usize,
        /// Coordinates of that node.
        place: [f64; 2],
    },
    /// A clamp whose prescribed displacement is beyond the floor, so that no displacement is admissible.
    #[error(
        "the clamp at ({}, {}) is beyond the floor: u_N = {displacement:e} is prescribed and the gap is {gap:e}, \
         expected u_N <= gap where a clamp ends on a contact edge",
        place[0], place[1]
    )]
    BeyondFloor {
        /// Coordinates of the clamped node of the contact edge.
        place: [f64; 2],
        /// The prescribed normal displacement u_N of that node.
        displacement: f64,
        /// The gap at that node.
        gap: f64,
    },
    /// Contact data without a node in contact.
    #[error(
        "the contact set is empty: u_N < 0 at all {nodes} nodes, expected u_N = 0 at one or more nodes"
    )]
    EmptyContact {
        /// Number of nodes of the contact edge.
        nodes: usize,
    },
    /// A text file that does not follow its format.
    #[error("{format}, line {line}: {reason}")]
    Syntax {
        /// Name of the format.
        format: &'static str,
        /// Line number, from 1.
        line: usize,
        /// Description of the error.
        reason: String,
    },
    /// A text file that follows its format, with invalid data in a line.
    #[error("{format}, line {line}: {cause}")]
    AtLine {
        /// Name of the format.
        format: &'static str,
        /// Line number, from 1.
        line: usize,
        /// The error in the data of that line.
        cause: Box<Error>,
    },
    /// A binary file that does not follow its format, or holds invalid data.
    #[error("{format}, byte {byte}: {reason}")]
    AtByte {
        /// Name of the format.
        format: &'static str,
        /// Number of the byte, from 0.
        byte: usize,
        /// Description of the error.
        reason: String,
    },
    /// The name of a boundary group or a region that the mesh does not have.
    #[error("the mesh has no {what} '{given}': it has {known}")]
    NoGroup {
        /// Kind of the name.
        what: &'static str,
        /// The given name.
        given: String,
        /// The names of the mesh, with commas between.
        known: String,
    },
    /// A file that could not be read or written.
    #[error("{}: {reason}", path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// The message of the operating system.
        reason: String,
    },
}

/// The best solution of an iteration that did not converge: a
/// [`ContactSolution`](crate::contact::ContactSolution) or an [`EdgeSolution`](crate::strip::EdgeSolution).
///
/// Two of them are equal if they are clones of one another.
#[derive(Clone)]
pub struct Unfinished(Arc<dyn Any + Send + Sync>);

impl fmt::Debug for Unfinished {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Unfinished")
    }
}

impl PartialEq for Unfinished {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Error {
    /// The best solution of an iteration that did not converge; `None` for all other errors, and for a solution of
    /// another type than S.
    ///
    /// ```
    /// use signorini::{cone::Cone, strip::{EdgeSolution, Strip}};
    /// let b: Vec<f64> = (0..65).map(|i| (i as f64).cos()).collect();
    /// let solve = |tolerance| Strip::scalar(64, 64)?.operator().solve_contact(&b, Cone::Nodal, None, tolerance);
    /// // a residual of 2e-15 is near rounding: the iteration may stall close to the solution
    /// let energy = match solve(2e-15) {
    ///     Ok(found) => found.energy,
    ///     Err(error) => error.unfinished::<EdgeSolution>().unwrap().energy,
    /// };
    /// assert!((energy - solve(1e-12)?.energy).abs() < 1e-9);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn unfinished<S: 'static>(&self) -> Option<&S> {
        match self {
            Error::NotConverged { solution, .. } => solution.0.downcast_ref(),
            _ => None,
        }
    }

    /// [`Error::NotConverged`] with the best solution and its energy.
    pub(crate) fn not_converged<S: Any + Send + Sync>(
        status: impl fmt::Display,
        energy: f64,
        solution: S,
    ) -> Self {
        Error::NotConverged {
            status: status.to_string(),
            energy,
            solution: Unfinished(Arc::new(solution)),
        }
    }

    /// The best estimate reached if a tolerance was not met; `None` for all other errors.
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

    /// The value of the parameter `name`, if `admissible` is true. NaN is never admissible.
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

    /// Fails unless `admissible` is true for a count.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`] otherwise.
    pub(crate) fn require_count(
        name: &'static str,
        value: usize,
        range: &'static str,
        admissible: bool,
    ) -> Result<()> {
        if admissible { Ok(()) } else { Err(Error::count(name, value, range)) }
    }

    /// [`ToolkitError::CountOutOfRange`]: the count `value` of `name` outside its range.
    pub(crate) fn count(name: &'static str, value: usize, range: &'static str) -> Self {
        Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range })
    }

    /// [`ToolkitError::Incompatible`]: `what` is `given` together with `with`, where `expected` is required.
    pub(crate) fn incompatible(
        what: &'static str,
        given: impl std::fmt::Display,
        with: &'static str,
        expected: &'static str,
    ) -> Self {
        Error::Toolkit(ToolkitError::Incompatible {
            what,
            given: given.to_string(),
            with,
            expected,
        })
    }

    /// [`ToolkitError::NotPositiveDefinite`]: the pivot with this number vanishes.
    pub(crate) fn not_positive_definite(what: &'static str, pivot: usize) -> Self {
        Error::Toolkit(ToolkitError::NotPositiveDefinite { what, pivot })
    }

    /// [`ToolkitError::ToleranceNotMet`] with the best estimate of `what`.
    pub(crate) fn not_met(
        what: &'static str,
        asked: f64,
        best: Estimate,
        why: &'static str,
    ) -> Self {
        let reached = best.relative_error();
        Error::Toolkit(ToolkitError::ToleranceNotMet {
            what,
            asked,
            reached,
            best: Some(best),
            why,
        })
    }

    /// [`ToolkitError::ToleranceNotMet`] without an estimate of `what`, with its relative uncertainty.
    pub(crate) fn out_of_reach(
        what: &'static str,
        asked: f64,
        reached: f64,
        why: &'static str,
    ) -> Self {
        Error::Toolkit(ToolkitError::ToleranceNotMet { what, asked, reached, best: None, why })
    }

    /// The error for the file `path`, with the reason given by the operating system.
    pub fn file(path: impl Into<PathBuf>, reason: impl std::fmt::Display) -> Self {
        Error::File { path: path.into(), reason: reason.to_string() }
    }
}
