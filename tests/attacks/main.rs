//! Attacks, which `cargo test` leaves out: `cargo test --release --test attacks`.

/// Sizes of random searches: the few that decide here, or as many as the target `attacks` takes.
pub const MANY: bool = true;

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/program.rs"]
mod program;

/// Searches of the sections, at their full sizes.
#[path = "../section_2/extremes.rs"]
mod extremes;
#[path = "../section_1/functions_in_the_plane.rs"]
mod functions_in_the_plane;
#[path = "../appendix_a/lemma_5_2.rs"]
mod lemma_5_2;
#[path = "../section_2/multigrid.rs"]
mod multigrid;
#[path = "../common/plane_polar.rs"]
mod plane_polar;
#[path = "../beyond/rearrangement.rs"]
mod rearrangement;
#[path = "../section_2/strip_errors.rs"]
mod strip_errors;
#[path = "../beyond/worst_contact_set.rs"]
mod worst_contact_set;
#[path = "../beyond/worst_pair.rs"]
mod worst_pair;

mod bounds;
mod command_lines;
mod contact;
mod meshes;
mod text;
