//! Section 2 and (4.1): discrete Signorini problems, two cones, two unrelated solvers, one judge.
//!
//! Sign convention of the paper: u_N ≤ g and σ_N ≤ 0 on the contact edge, n outward; multipliers λ ≥ 0 are
//! generalised forces with K u − F + B'λ = 0 and B u ≤ g. [`Cone`], [`ContactSet`], [`Status`], [`EdgeProblem`] and
//! the judge ([`Evidence`]) know no mesh: they act on a chain of contact unknowns, whatever stands behind it.

mod active_set;
mod condensed;
mod cone;
mod contact_set;
mod data;
mod edge_problem;
mod history;
mod interior_point;
mod judge;
mod listing;
mod picture;
mod problem;
mod projection;
mod solution;
mod solver;
mod status;

pub use active_set::{EdgeOutcome, solve_on_edge};
pub use cone::Cone;
pub use contact_set::ContactSet;
pub use edge_problem::{EdgeProblem, EdgeState};
pub use judge::{Evidence, Judgement, Margins, NOISE};
pub use problem::ContactProblem;
pub use solution::{ContactSolution, Seconds};
pub use solver::Solver;
pub use status::Status;
