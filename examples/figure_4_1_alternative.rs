//! Figure 4.1: the contact set of every segment against h_e theta. The argument is that of Figure 3.2, its
//! twin.
//!
//! `cargo run --release --example figure_4_1_alternative -- --scene fat-cantor --tau 1.7 --n 256
//! --over-theta`

#[allow(dead_code)]
#[path = "figure_3_2_alternative.rs"]
pub mod figure_3_2_alternative;

use example_frame::{Headline, Result};
pub use figure_3_2_alternative::{Options, outcome};
use signorini::proof::Section;
use std::process::ExitCode;

/// The outcome for Section 4.
pub fn run(options: &Options) -> Result<Headline> {
    outcome(Section::Four, options)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
