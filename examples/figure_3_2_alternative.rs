//! Figure 3.2, the alternative of Section 3 on a computed contact set: zeros of u_N near both vertices, or no pressure near one.
//!
//! `cargo run --release --example figure_3_2_alternative -- --n 64 --theta 0.1`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::Result;
use signorini::analysis::{AlternativeStudy, Section, ThetaRule};
use signorini::report::Headline;
use signorini::scenes::Scene;
use std::process::ExitCode;

/// Classify every contact segment of meshes n/4, n/2, n on the contact set of the solution on 8n x 8n squares
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// block or membrane
    #[arg(long, default_value_t = Scene::Block)]
    pub scene: Scene,
    /// Contact segments of the finest mesh classified, a multiple of 4
    #[arg(long, default_value_t = 32)]
    pub n: usize,
    /// Sobolev regularity in theta = h^(2 tau - 3), h^2 at tau = 2
    #[arg(long, default_value_t = 1.75)]
    pub tau: f64,
    /// A fixed theta in (0, 1) instead
    #[arg(long)]
    pub theta: Option<f64>,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self { scene: Scene::Block, n: 32, tau: 1.75, theta: None, output: Output::default() }
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Classifies the segments and adds up the consistency term int sigma_N (I^h u)_N by case.
pub fn run(options: &Options) -> Result<Headline> {
    let rule = options.theta.map_or(ThetaRule::Printed { tau: options.tau }, ThetaRule::Fixed);
    let study = AlternativeStudy::new(Section::Three, options.scene, options.n, rule)?;
    let claim = "on every contact segment u_N has a zero near both vertices or sigma_N = 0 near one";
    let mut headline = Headline::new("Figure 3.2", claim, study.table()?, study.measured(), study.verdict());
    if let Some(finest) = study.rows().last() {
        for case in ["first", "second", "both"] {
            headline.quote(format!("figure.3.2.{case}.count"), finest.classification.count(case) as f64);
            headline.quote(format!("figure.3.2.{case}.term"), finest.classification.term(case));
        }
        headline.quote("figure.3.2.theta", finest.theta);
    }
    if let (Some(directory), Some(chart)) = (options.output.directory()?, study.chart()) {
        headline.figures.push(chart.save(directory, "figure_3_2_alternative")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
