//! Section 2, Remark 1: scalar Signorini problems. The argument is that of `section_2_elastic_contact`, with
//! scalar scenes.
//!
//! `cargo run --release --example section_2_scalar_contact -- --scene corner --angle 135 --n 8 --levels 5`

#[path = "section_2_elastic_contact.rs"]
#[allow(dead_code, reason = "the elastic problem has its own launcher")]
mod contact;

pub use contact::{Computed, Options};

use contact::Problem;
use example_frame::{Finding, Headline, Result};
use std::process::ExitCode;

/// Solves the scalar scene.
pub fn compute(options: &Options) -> Result<Computed> {
    contact::compute(Problem::Scalar, options)
}

/// What decides.
pub fn findings(options: &Options, computed: &Computed) -> Vec<Finding> {
    contact::findings(options, computed)
}

/// Solves a scalar scene and says how well the discrete conditions are met.
pub fn run(options: &Options) -> Result<Headline> {
    contact::show(Problem::Scalar, options)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
