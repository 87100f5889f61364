//! The rooms of the libraries, the table of labels, every example at its default size, options, files.

#[path = "../common/program.rs"]
mod program;

mod bad_input;
mod commands;
mod every_label;
mod exports;
mod files;
mod large_runs;
mod outcomes;
mod public_items;
mod rooms;
