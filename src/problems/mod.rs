//! The registry of test problems, on meshes and on the edge of a strip: names, data, regularity, and the solution if
//! it is known.
//!
//! | | content | module |
//! | --- | --- | --- |
//! | [`NamedProblem`] | a test problem of either kind, by name | `named` |
//! | [`TestProblem`] | bodies, loads, boundary parts | `test_problem` |
//! | [`TestProblem::regularity`], [`solution_regularity`] | sup τ from corners and contact set | `regularity`, `corners` |
//! | [`StripData`] | pairs (u_N, λ) on a fine edge that determine the load | `strip_data`, `contact_sets`, `gap_data` |
//! | [`TransitionPowers`] | one transition with given powers and logarithms | `transition_powers` |
//! | [`DirichletEnd`] | a body whose Dirichlet and contact boundary meet, on polar rings | `dirichlet_end` |
//! | [`KnownSolution`] | problems on the square with known solution of given regularity, and errors | `known` |
//!
//! A new test problem is a variant in `strip_data` or `test_problem`, with its name, its parameters and its data.

mod contact_sets;
mod corners;
mod dirichlet_end;
mod gap_data;
mod known;
mod named;
mod regularity;
mod strip_data;
mod test_problem;
mod transition_powers;

pub use corners::{CornerSingularity, SolutionRegularity, solution_regularity};
pub use dirichlet_end::DirichletEnd;
pub use known::{EdgeDatum, KnownSolution};
pub use named::NamedProblem;
pub use strip_data::StripData;
pub use test_problem::{Parameters, TestProblem};
pub use transition_powers::TransitionPowers;
