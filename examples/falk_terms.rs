//! Falk's lemma, (4.5) and (4.8): every term on computed solutions of the strip, and the measured constant.
//!
//! `cargo run --release --example falk_terms -- --cone nodal --scene fat-cantor`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::Result;
use signorini::analysis::{falk_chart, falk_headline};
use signorini::contact::Cone;
use signorini::proof::falk_terms;
use signorini::report::Headline;
use signorini::scenes::{StripCase, StripScene};
use signorini::strip::{Levels, Reference, StripKind};
use std::process::ExitCode;

/// Terms of Falk's lemma for the nodal or the midpoint cone on a scene with known solution
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// scalar or elastic
    #[arg(long, default_value_t = StripKind::Scalar)]
    pub kind: StripKind,
    /// transition[:POSITION], transitions:COUNT, cantor[:RATIO[:DEPTH]], fat-cantor[:DEPTH] or samples:FILE
    #[arg(long, default_value_t = StripScene::transition())]
    pub scene: StripScene,
    /// Regularity of the scene, in (3/2, 2]
    #[arg(long, default_value_t = 1.75)]
    pub tau: f64,
    /// nodal or midpoint
    #[arg(long, default_value_t = Cone::Midpoint)]
    pub cone: Cone,
    /// Mesh sizes h = 2^-COARSEST ... 2^-FINEST
    #[arg(long, default_value = "3-10")]
    pub levels: Levels,
    /// Over how many positions in its cell a single transition is moved (odd)
    #[arg(long, default_value_t = 5)]
    pub positions: usize,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["falk_terms"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Solves the scene on all meshes and integrates the terms.
pub fn run(options: &Options) -> Result<Headline> {
    let case = StripCase {
        kind: options.kind,
        levels: options.levels,
        source: options.scene.clone(),
        tau: options.tau,
        cone: options.cone,
        reference: Reference::Nested,
        positions: options.positions,
    };
    let rows = falk_terms(&case, |_| ())?;
    let mut headline = falk_headline(&case, &rows)?;
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(falk_chart(&case, &rows).save(directory, "falk_terms")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
