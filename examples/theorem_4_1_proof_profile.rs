//! Theorem 4.1, its proof: both sides of every inequality, and a ladder of bounds. The argument is that of
//! Theorem 3.1, its twin.
//!
//! `cargo run --release --example theorem_4_1_proof_profile -- --tau 2.25`

#[allow(dead_code)]
#[path = "theorem_3_1_proof_profile.rs"]
pub mod theorem_3_1_proof_profile;

use example_frame::{Headline, Result};
use signorini::proof::Section;
use std::process::ExitCode;
pub use theorem_3_1_proof_profile::{Options, outcome};

/// The outcome for Theorem 4.1.
pub fn run(options: &Options) -> Result<Headline> {
    outcome(Section::Four, "theorem_4_1_proof_profile", options)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
