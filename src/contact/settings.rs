//! Settings of a contact solver: solver, initial guess, accuracy, coarser meshes, progress.

use super::multigrid::{Accuracy, Progress};
use super::solution::ContactSolution;
use super::solver::Solver;
use crate::cone::ContactSet;
use crate::error::Result;
use crate::mesh::Hierarchy;

/// The settings of [`ContactProblem::solve`](super::ContactProblem::solve); a [`Solver`] converts to settings with
/// default values of all other fields.
///
/// ```
/// use signorini::cone::Cone;
/// use signorini::contact::{Settings, Solver, Start};
/// use signorini::problems::TestProblem;
/// let coarse = TestProblem::Block.problem(8)?.solve(Cone::Nodal, Solver::ActiveSet)?;
/// let nested = Settings { start: Start::Coarse(&coarse), ..Settings::default() };
/// let fine = TestProblem::Block.problem(16)?.solve(Cone::Nodal, nested)?;
/// assert!(fine.work.iterations <= 4);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Default)]
pub struct Settings<'a> {
    /// The solver; the active set method by default.
    pub solver: Solver,
    /// The initial guess of the contact set, for the active set method; no contact by default.
    pub start: Start<'a>,
    /// The requested bound on the algebraic error, for multigrid; by default a relative error of 1e-12 in the energy
    /// norm.
    pub accuracy: Accuracy,
    /// The coarser meshes, for multigrid; the finest mesh of the hierarchy is that of the problem. By default
    /// every other line of a structured grid is omitted from each level to the next coarser one.
    pub hierarchy: Option<&'a Hierarchy>,
    /// A callback invoked after every step of multigrid; an error that it returns ends the iteration.
    #[allow(clippy::type_complexity)] // a callback, spelled out
    pub progress: Option<&'a mut (dyn FnMut(&Progress) -> Result<()> + Send)>,
}

impl From<Solver> for Settings<'_> {
    fn from(solver: Solver) -> Self {
        Self { solver, ..Self::default() }
    }
}

/// The initial contact set of the active set method.
///
/// The discrete solution is unique, so the initial set affects only the number of steps.
///
/// ```
/// use signorini::{cone::Cone, contact::{Settings, Solver, Start}, problems::TestProblem};
/// let problem = TestProblem::Block.problem(8)?;
/// let cold = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
/// let start = Start::Set(cold.contact_set.clone());
/// let warm = problem.solve(Cone::Nodal, Settings { start, ..Settings::default() })?;
/// // a set that reproduces itself is that of the solution
/// assert_eq!((warm.steps.len(), &warm.contact_set), (1, &cold.contact_set));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub enum Start<'a> {
    /// The empty contact set.
    #[default]
    Open,
    /// The contact set of the given solution on the next coarser mesh, in the same cone, with every segment bisected.
    Coarse(&'a ContactSolution),
    /// The given contact set.
    Set(ContactSet),
}
