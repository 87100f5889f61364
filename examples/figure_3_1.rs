//! Figure 3.1: the three printed curves over τ, and on them the orders that errors and consistency terms of both cones show.
//!
//! `cargo run --release --example figure_3_1 -- --kind elastic --out out`

use clap::Parser;
use example_frame::{FigureRates, figure_chart, figure_headline};
use example_frame::{HasOutput, Output, progress};
use signorini::report::Headline;
use signorini::scenes::StripScene;
use signorini::strip::{Levels, StripKind};
use signorini::{Error, Result};
use std::process::ExitCode;

/// Exponents over the regularity: printed, and measured with their uncertainty
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Regularities tau in (3/2, 2)
    #[arg(long, value_delimiter = ',', default_value = "1.55,1.6,1.65,1.7,1.75,1.8,1.85,1.9,1.95")]
    pub tau: Vec<f64>,
    /// scalar or elastic
    #[arg(long, default_value_t = StripKind::Scalar)]
    pub kind: StripKind,
    /// transition[:POSITION], transitions:COUNT, cantor[:RATIO[:DEPTH]] or fat-cantor[:DEPTH]
    #[arg(long, default_value_t = StripScene::transition())]
    pub scene: StripScene,
    /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 32 times finer
    #[arg(long, default_value = "3-12")]
    pub levels: Levels,
    /// Positions of a single transition in its cell (odd: evenly spread on all levels)
    #[arg(long, default_value_t = 5)]
    pub positions: usize,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["figure_3_1"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Measures the orders and sets them beside the curves.
pub fn run(options: &Options) -> Result<Headline> {
    for &tau in &options.tau {
        Error::require("tau", tau, "(3/2, 2)", tau > 1.5 && tau < 2.0)?;
    }
    let finest = options.levels.cells().max().unwrap_or(2).ilog2();
    let figure = FigureRates {
        taus: options.tau.clone(),
        kind: options.kind,
        source: options.scene.clone(),
        levels: options.levels,
        reference: (finest + 5).min(22),
        positions: options.positions,
    };
    let bar = progress(figure.steps());
    let studies = figure.run(&mut || bar.inc(1))?;
    bar.finish_and_clear();
    let mut headline = figure_headline(&studies)?;
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(figure_chart(&studies)?.save(directory, "figure_3_1")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
