//! Section 2 and (4.1): discrete Signorini problems, two cones, independent solvers, and KKT residuals with the same
//! definition for all solvers.
//!
//! Sign convention of the paper: u_N ≤ g and σ_N ≤ 0 on the contact edge, n outward; multipliers λ ≥ 0 are
//! generalised forces with K u − F + B'λ = 0 and B u ≤ g. The cones are in [`crate::cone`]. The solvers are
//! called by [`ContactProblem::solve`] with [`Settings`].

mod active_set;
mod body;
mod by_radius;
mod cascade;
mod condensed;
mod data;
mod dual_active_set;
pub(crate) mod edge {
    pub(crate) use super::active_set::solve_on_edge;
    pub(crate) use super::edge_problem::EdgeProblem;
}
mod edge_problem;
mod interior_point;
mod multigrid;
mod npy;
mod operator;
mod problem;
mod settings;
mod solution;
mod solve;
mod solver;
mod supports;
mod units;
mod vtk;

pub use active_set::Step;
pub use body::{Body, Value};
pub use multigrid::{Accuracy, Fallback, MultigridLevel, MultigridReport, Progress};
pub use npy::npy;
pub use problem::ContactProblem;
pub use settings::{Settings, Start};
pub use solution::{ContactSolution, Seconds};
pub use solver::Solver;
pub use supports::Support;
