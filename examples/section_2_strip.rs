//! Section 2 on a strip reduced to its contact edge: levels up to 2^20 cells, 10^12 nodes, with exact errors.
//!
//! `cargo run --release --example section_2_strip -- --scene fat-cantor --tau 1.55 --levels 3-20`

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use signorini::contact::Cone;
use signorini::figures::{Axis, Chart, Series};
use signorini::report::{Headline, Verdict};
use signorini::strip::{
    Level, Levels, Reference, SceneKind, SceneSource, StripKind, StripProblem, level_table, mean_errors,
    mean_order, study,
};
use signorini::{Error, Estimate, Result};
use std::process::ExitCode;

/// Solve a contact scene on nested strips and print exact energy errors and orders
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// scalar (Laplace, natural sides) or elastic (periodic sides)
    #[arg(long, default_value_t = StripKind::Scalar)]
    pub kind: StripKind,
    /// Levels COARSEST-FINEST: n = 2^level cells along the edge
    #[arg(long, default_value = "3-14")]
    pub levels: Levels,
    /// transition[:POSITION], transitions:COUNT, cantor[:RATIO[:DEPTH]], fat-cantor[:DEPTH] or samples:FILE
    #[arg(long, default_value_t = SceneSource::transition())]
    pub scene: SceneSource,
    /// Regularity of the solution, 3/2 < tau <= 2 (not used by samples)
    #[arg(long, default_value_t = 1.75)]
    pub tau: f64,
    /// Discrete cone: nodal (2.9) or midpoint (4.1)
    #[arg(long, default_value_t = Cone::Nodal)]
    pub cone: Cone,
    /// Compare with the solution on the grid of the scene (nested) or with the continuous one (harmonic; scalar only)
    #[arg(long, default_value_t = Reference::Nested)]
    pub reference: Reference,
    /// Average the squared error over this many positions of the transition in the coarsest cell (odd: evenly spread on all levels)
    #[arg(long, default_value_t = 1)]
    pub positions: usize,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["section_2_strip"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Every scaled KKT figure must be below this.
const JUDGED: f64 = 1e-10;

/// Solves all levels and compares the mean order with the exponent of Theorems 3.1 and 4.1.
pub fn run(options: &Options) -> Result<Headline> {
    let sources = positions(options)?;
    let bar = progress((options.levels.cells().count() * sources.len()) as u64);
    let build = |source: &SceneSource| {
        source.scene(options.tau, options.levels.reference_cells(), options.kind.sides())
    };
    let first = build(&sources[0])?;
    let (tau, gaps) = (first.regularity(), first.gaps());
    let coarsest = options.levels.cells().next().unwrap_or(2);
    let mut problem = StripProblem::new(options.kind, &first, options.reference, coarsest)?;
    let mut studies = Vec::new();
    for source in &sources {
        if !studies.is_empty() {
            problem.set_scene(&build(source)?)?;
        }
        studies.push(study(&problem, options.levels, options.cone, |_| bar.inc(1))?);
    }
    bar.finish_and_clear();
    let errors = mean_errors(&studies)?;
    let levels = &studies[0];
    let all = || studies.iter().flatten();
    let kkt = all().fold(0.0, |w: f64, level| w.max(level.kkt));
    let converged = all().all(|level| level.status.is_converged());
    let order = mean_order(levels, &errors).unwrap_or(0.0);
    let last = &levels[levels.len() - 1];
    let measured = format!(
        "error {:.4e} at n = {} ({:.1e} unknowns), mean order {order:.3}, KKT {kkt:.0e}",
        errors[errors.len() - 1].value,
        last.cells,
        last.virtual_unknowns
    );
    let paper = tau.map(paper_exponent);
    let verdict = match paper {
        _ if !converged || kkt > JUDGED => {
            Verdict::NotConfirmed(format!("KKT {kkt:.1e}, converged: {converged}"))
        }
        Some(rate) if levels.len() > 4 && order < rate - 0.05 => {
            Verdict::NotConfirmed(format!("mean order {order:.3} below {rate:.3}"))
        }
        Some(rate) => Verdict::HoldsLoose(format!("order {order:.3} against {rate:.3}")),
        None => Verdict::Holds,
    };
    let tau_text = tau.map_or("unknown".to_owned(), |tau| format!("{tau}"));
    let claim = format!(
        "the {} strip in the {} cone, scene {} ({gaps} gaps), u of regularity tau = {tau_text}: order at least the paper's",
        options.kind, options.cone, options.scene
    );
    let mut headline =
        Headline::new("Section 2, strip", claim, level_table(levels, &errors), measured, verdict);
    headline.quote("section.2.strip.unknowns", last.virtual_unknowns);
    headline.quote("section.2.strip.error", errors[errors.len() - 1].value);
    headline.quote("section.2.strip.order", order);
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(figure(options, levels, &errors, tau).save(directory, "section_2_strip")?);
    }
    Ok(headline)
}

/// The scene, or the transition at several places of one coarsest cell. Doubling permutes the multiples of 1/count for an
/// odd count, so that the places are evenly spread over the cells of every level.
fn positions(options: &Options) -> Result<Vec<SceneSource>> {
    match (&options.scene, options.positions) {
        (_, 0) => Err(Error::CountOutOfRange { name: "positions", value: 0, range: "[1, inf)" }),
        (SceneSource::Built(SceneKind::Transition { position }), count) => {
            let cell = 1.0 / options.levels.cells().next().unwrap_or(2) as f64;
            let place = |i: usize| i as f64 / count as f64 * cell;
            let shifted = |i| SceneKind::Transition { position: position + place(i) };
            Ok((0..count).map(|i| SceneSource::Built(shifted(i))).collect())
        }
        (scene, _) => Ok(vec![scene.clone()]),
    }
}

/// The exponent of Theorems 3.1 and 4.1.
fn paper_exponent(tau: f64) -> f64 {
    tau / 2.0 - 0.25 + (tau - 1.5).powi(2)
}

fn figure(options: &Options, levels: &[Level], errors: &[Estimate], tau: Option<f64>) -> Chart {
    let points: Vec<(f64, f64)> =
        levels.iter().zip(errors).map(|(level, e)| (1.0 / level.cells as f64, e.value)).collect();
    let last = points[points.len() - 1];
    let slope = |rate: f64| points.iter().map(|p| (p.0, 1.5 * last.1 * (p.0 / last.0).powf(rate))).collect();
    let chart = Chart::new(
        format!("{} strip, {} cone, {}", options.kind, options.cone, options.scene),
        Axis::logarithmic("h (nondimensional)"),
        Axis::logarithmic("energy error (nondimensional)"),
    )
    .with(Series::line_and_points("error", points.clone()));
    tau.into_iter().fold(chart, |chart, tau| {
        chart
            .with(Series::dashed("h^(tau - 1)", slope(tau - 1.0)))
            .with(Series::dashed("Theorems 3.1, 4.1", slope(paper_exponent(tau))))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
