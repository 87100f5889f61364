//! Theorem 3.1: energy-norm errors of the nodal cone on nested meshes, beside the paper's bound and the optimal one.
//!
//! `cargo run --release --example theorem_3_1_rates -- --scene membrane --levels 5`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::Result;
use signorini::analysis::{Bound, RateStudy};
use signorini::contact::Cone;
use signorini::report::Headline;
use signorini::scenes::Scene;
use std::process::ExitCode;

/// Errors of the nodal cone on nested meshes against a solution four times finer
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// block (H^1.745, clamped/free corners) or membrane (H^2)
    #[arg(long, default_value_t = Scene::Block)]
    pub scene: Scene,
    /// Squares along each side of the coarsest mesh
    #[arg(long, default_value_t = 4)]
    pub n: usize,
    /// Number of nested meshes
    #[arg(long, default_value_t = 5)]
    pub levels: usize,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self { scene: Scene::Block, n: 4, levels: 5, output: Output::default() }
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Computes the errors and compares them with the bounds of (3.1), (3.2).
pub fn run(options: &Options) -> Result<Headline> {
    let study = RateStudy::nested(options.scene, Cone::Nodal, options.n, options.levels)?;
    let (paper, optimal) = (Bound::Paper.exponent(study.tau)?, Bound::Optimal.exponent(study.tau)?);
    let space = if study.tau == 2.0 { "H^2".to_owned() } else { format!("H^tau, tau < {:.4}", study.tau) };
    let bound =
        if study.tau == 2.0 { "C h |ln h|^(1/2)".to_owned() } else { format!("C h^p, p < {paper:.4}") };
    let claim =
        format!("{}, u in {space}: the H^1 error of the nodal cone is at most {bound}", options.scene);
    let measured = format!("{}; optimal {optimal:.3}", study.measured());
    let mut headline = Headline::new("Theorem 3.1", claim, study.table()?, measured, study.verdict()?);
    if let Some((low, high)) = study.order_range() {
        headline.quote(format!("theorem.3.1.{}.order.low", options.scene), low);
        headline.quote(format!("theorem.3.1.{}.order.high", options.scene), high);
    }
    headline.quote(format!("theorem.3.1.{}.exponent.paper", options.scene), paper);
    headline.quote(format!("theorem.3.1.{}.exponent.optimal", options.scene), optimal);
    if let Some(directory) = options.output.directory()? {
        let title = format!("Theorem 3.1: errors of the nodal cone, scene {}", options.scene);
        headline.figures.push(study.chart(title)?.save(directory, "theorem_3_1_errors")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
