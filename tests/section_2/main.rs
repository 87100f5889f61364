//! Section 2: bodies, contact on meshes and on strips, singular exponents, multigrid; Remark 1.

/// Sizes of random searches: the few that decide here, or as many as the target `attacks` takes.
pub const MANY: bool = false;

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/reference_squares.rs"]
mod reference_squares;

mod bodies;
mod by_name;
mod contact;
mod contact_zone;
mod dirichlet_end;
mod exponents_on_arc;
mod extremes;
mod mesh_files;
mod multigrid;
mod remark_1;
mod singular_exponents;
mod strip;
mod strip_and_mesh;
mod strip_errors;
mod strip_extremes;
mod strip_iterations;
mod test_problems;
mod two_sided_energies;
