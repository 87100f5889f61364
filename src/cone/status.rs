//! Termination of a contact iteration; invalid input is an error.

use std::fmt;

/// The status with which an iteration terminated. It is [`Status::Stalled`] also if the stopping rule was met
/// but the largest KKT residual exceeds 1e-8 (for multigrid a limit derived from the error estimate; for the
/// interior point method also if the forces do not balance to 1e-3, beyond rounding).
///
/// ```
/// use signorini::{cone::{Cone, Status}, contact::Solver, problems::TestProblem};
/// let solution = TestProblem::Membrane.problem(4)?.solve(Cone::Nodal, Solver::ActiveSet)?;
/// assert_eq!(solution.status, Status::Converged);
/// // a stalled iteration reports its largest KKT residual
/// assert_eq!(Status::Stalled { residual: 2e-7 }.to_string(), "stalled at 2.0e-7");
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Status {
    /// The stopping rule of the solver was met.
    Converged,
    /// No further progress was possible, or the KKT residuals are too large; `residual` is the largest of
    /// them.
    Stalled {
        /// The largest of the residuals of balance, sign, gap and complementarity.
        residual: f64,
    },
    /// The contact set recurred after `period` steps and the iteration could not leave the cycle.
    Cycled {
        /// Number of steps between two visits of the same set.
        period: usize,
    },
    /// The maximum number of steps was reached.
    StepLimit {
        /// Number of steps.
        steps: usize,
    },
}

impl Status {
    /// True for [`Status::Converged`].
    ///
    /// ```
    /// use signorini::cone::Status;
    /// assert!(Status::Converged.is_converged() && !Status::Cycled { period: 2 }.is_converged());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn is_converged(self) -> bool {
        self == Status::Converged
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Status::Converged => write!(f, "converged"),
            Status::Stalled { residual } => write!(f, "stalled at {residual:.1e}"),
            Status::Cycled { period } => write!(f, "cycled with period {period}"),
            Status::StepLimit { steps } => write!(f, "stopped after {steps} steps"),
        }
    }
}
