//! Theorem 4.1: the argument of `theorem_3_1_rates` for the midpoint cone, (4.2)-(4.4).
//!
//! `cargo run --release --example theorem_4_1_rates`
//! `cargo run --release --example theorem_4_1_rates -- --scene fat-cantor --tau 1.65 --levels 4-14`

use signorini::cone::Cone;
use std::process::ExitCode;

#[allow(dead_code)]
#[path = "theorem_3_1_rates.rs"]
pub mod rates;

pub use rates::Options;

/// Theorem 4.1.
pub fn run(options: &Options) -> example_frame::Result<example_frame::Headline> {
    rates::outcome(Cone::Midpoint, options)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
