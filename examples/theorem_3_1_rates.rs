//! Theorem 3.1: errors and consistency terms of the nodal cone against h, beside the paper's bounds (3.1), (3.2) and the optimal one.
//!
//! `cargo run --release --example theorem_3_1_rates`
//! `cargo run --release --example theorem_3_1_rates -- --scene fat-cantor --tau 1.65 --levels 4-14`
//! `cargo run --release --example theorem_3_1_rates -- --full --out out`

pub use example_frame::RateOptions as Options;
use signorini::Result;
use signorini::contact::Cone;
use signorini::report::Headline;
use std::process::ExitCode;

/// All scenes and regularities, or one scene level by level.
pub fn run(options: &Options) -> Result<Headline> {
    example_frame::rates(Cone::Nodal, options)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
