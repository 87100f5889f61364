//! (3.2), (4.3): at τ = 2, does the error need a power of |ln h|?
//!
//! `cargo run --release --example equation_3_2_logarithm -- --levels 3-18`

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use example_frame::{logarithm_chart, logarithm_headline, logarithm_studies};
use signorini::Result;
use signorini::report::Headline;
use signorini::strip::Levels;
use std::process::ExitCode;

/// Which of h, h |ln h|^1/4, h |ln h|^1/2 is the error at tau = 2?
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 16 times finer
    #[arg(long, default_value = "3-16")]
    pub levels: Levels,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["equation_3_2_logarithm"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Measures three scenes in both cones.
pub fn run(options: &Options) -> Result<Headline> {
    let finest = options.levels.cells().max().unwrap_or(2);
    let bar = progress(12 * options.levels.cells().count() as u64);
    let studies = logarithm_studies(options.levels, (16 * finest).min(1 << 22), &mut || bar.inc(1))?;
    bar.finish_and_clear();
    let mut headline = logarithm_headline(&studies)?;
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(logarithm_chart(&studies).save(directory, "equation_3_2_logarithm")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
