//! The introduction: (E1)-(E4), (N1), (N2), each with what a scene of its regularity shows.
//!
//! `cargo run --release --example introduction_rates -- --levels 3-16 --out out`

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use example_frame::{introduction_chart, introduction_headline, introduction_rows, introduction_studies};
use signorini::Result;
use signorini::report::Headline;
use signorini::strip::Levels;
use std::process::ExitCode;

/// Printed rates and measured orders
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 16 times finer
    #[arg(long, default_value = "4-14")]
    pub levels: Levels,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["introduction_rates"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Solves a scene for each row in both cones.
pub fn run(options: &Options) -> Result<Headline> {
    let finest = options.levels.cells().max().unwrap_or(2);
    let bar = progress(introduction_rows() as u64);
    let studies = introduction_studies(options.levels, (16 * finest).min(1 << 22), &mut || bar.inc(1))?;
    bar.finish_and_clear();
    let mut headline = introduction_headline(&studies)?;
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(introduction_chart(&studies).save(directory, "introduction_rates")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
