//! How a contact problem is solved: solver, start, accuracy, coarser meshes, progress.

use super::multigrid::{Accuracy, Progress};
use super::solution::ContactSolution;
use super::solver::Solver;
use crate::cone::ContactSet;
use crate::error::Result;
use crate::mesh::Hierarchy;

/// How [`ContactProblem::solve`](super::ContactProblem::solve) works; a [`Solver`] alone stands for the settings with
/// defaults for the rest.
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
    /// The solver; the active set by default.
    pub solver: Solver,
    /// The first guess of the contact set, for the active set; no contact by default.
    pub start: Start<'a>,
    /// The algebraic error admitted, for multigrid; twelve digits in the energy norm by default.
    pub accuracy: Accuracy,
    /// The coarser meshes, for multigrid: the finest of them is that of the problem. By default every other line of a
    /// grid is left out.
    pub hierarchy: Option<&'a Hierarchy>,
    /// Called after every step of multigrid; its error ends the iteration.
    #[allow(clippy::type_complexity)] // a callback, spelled out
    pub progress: Option<&'a mut (dyn FnMut(&Progress) -> Result<()> + Send)>,
    /// Relative sizes expected of the displacement at the nodes of the contact edge, all positive, for
    /// [`Solver::EdgeInteriorPoint`] in the nodal cone: each node has its own barrier weight.
    ///
    /// Near a singular point this resolves every decade of the mesh; one weight for all nodes resolves half as many in
    /// `section_1_clamped_end`.
    pub sizes: Option<&'a [f64]>,
}

impl From<Solver> for Settings<'_> {
    fn from(solver: Solver) -> Self {
        Self { solver, ..Self::default() }
    }
}

/// Where the search of the active set for the contact set begins.
///
/// The discrete solution is unique, so that the start changes the number of steps only.
///
/// ```
/// use signorini::{cone::Cone, contact::{Settings, Solver, Start}, problems::TestProblem};
/// let problem = TestProblem::Block.problem(8)?;
/// let cold = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
/// let start = Start::Set(cold.contact_set.clone());
/// let warm = problem.solve(Cone::Nodal, Settings { start, ..Settings::default() })?;
/// // a set that reproduces itself is that of the solution
/// assert_eq!((warm.history.len(), &warm.contact_set), (1, &cold.contact_set));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub enum Start<'a> {
    /// Without contact.
    #[default]
    Open,
    /// With the contact set of this solution on the next coarser mesh, in the same cone, every segment halved.
    Coarse(&'a ContactSolution),
    /// With this contact set.
    Set(ContactSet),
}
