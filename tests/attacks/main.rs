//! Attacks, which `cargo test` leaves out: `cargo test --release --test attacks`.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/program.rs"]
mod program;

mod command_lines;
mod contact;
mod meshes;
mod text;
