//! Theorems 3.1 and 4.1: is there a contact set whose consistency term comes near the paper's exponent?
//!
//! `cargo run --release --example worst_contact_set -- --tau 1.6 --out out`

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use signorini::analysis::{search_chart, search_headline, search_sets, search_size};
use signorini::report::Headline;
use signorini::{Error, Result};
use std::process::ExitCode;

/// Search families of contact sets for the consistency term that decays slowest
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Regularity, 3/2 < tau < 2
    #[arg(long, default_value_t = 1.75)]
    pub tau: f64,
    /// The data live on 2 to this power cells
    #[arg(long, default_value_t = 17)]
    pub depth: u32,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["worst_contact_set"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Sets on the whole edge, then all sets on one segment.
pub fn run(options: &Options) -> Result<Headline> {
    if !(13..=24).contains(&options.depth) {
        return Err(Error::CountOutOfRange {
            name: "depth",
            value: options.depth as usize,
            range: "[13, 24]",
        });
    }
    let bar = progress(search_size() as u64);
    let rows = search_sets(options.tau, 1 << options.depth, &mut || bar.inc(1))?;
    bar.finish_and_clear();
    let mut headline = search_headline(options.tau, &rows)?;
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(search_chart()?.save(directory, "worst_contact_set")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
