//! Theorem 4.1: errors and consistency terms of the midpoint cone against h, beside the paper's bounds (4.2)-(4.4) and the optimal one.
//!
//! `cargo run --release --example theorem_4_1_rates`
//! `cargo run --release --example theorem_4_1_rates -- --scene fat-cantor --tau 1.65 --levels 4-14`
//! `cargo run --release --example theorem_4_1_rates -- --full --out out`

pub use example_frame::RateOptions as Options;
use signorini::Result;
use signorini::contact::Cone;
use signorini::report::Headline;
use std::process::ExitCode;

/// All scenes and regularities, or one scene level by level.
pub fn run(options: &Options) -> Result<Headline> {
    example_frame::rates(Cone::Midpoint, options)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
