//! The balance of Section 3: both bounds as functions of theta, the printed choice, and the true worst case of an element.
//!
//! `cargo run --release --example theta_balance -- --tau 2`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::Result;
use signorini::proof::ElementBalance;
use signorini::report::Headline;
use signorini::strip::Levels;
use std::process::ExitCode;

/// Compare the bounds of both cases with an optimisation over complementary pairs (u_N, sigma_N) on one element
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Regularity, in (3/2, 2]
    #[arg(long, default_value_t = 1.75)]
    pub tau: f64,
    /// Exponent q of the embedding at tau = 2
    #[arg(long, default_value_t = 2.0)]
    pub q: f64,
    /// Element lengths h = 2^-COARSEST ... 2^-FINEST
    #[arg(long, default_value = "3-12")]
    pub levels: Levels,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["theta_balance"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Finds the worst pairs of every contact interval and sets them beside the bounds.
pub fn run(options: &Options) -> Result<Headline> {
    let balance = ElementBalance::new(options.tau, options.q)?;
    let lengths: Vec<f64> = options.levels.cells().map(|n| 1.0 / n as f64).collect();
    let rows = balance.rows(&lengths)?;
    let mut headline = balance.headline(&rows)?;
    if let (Some(directory), Some(row)) = (options.output.directory()?, rows.last()) {
        headline.figures.push(balance.chart(row).save(directory, "theta_balance")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
