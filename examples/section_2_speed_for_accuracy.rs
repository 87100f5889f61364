//! Section 2: true error against seconds, for both solvers, cold and nested starts, on a scene with known solution.
//!
//! `cargo run --release --example section_2_speed_for_accuracy -- --levels 6`

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use signorini::contact::{Cone, ContactSolution, Solver};
use signorini::fem::{Cubature, Field, error_norms};
use signorini::figures::{Axis, Chart, Series};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::scenes::{JUDGED, MeshScene, manufactured};
use signorini::{Error, Result};
use std::process::ExitCode;
use std::time::Instant;

/// Seconds against true error on the scene `manufactured`, u = -Re (z - 2/5)^{3/2}
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Squares along each side of the coarsest mesh
    #[arg(long, default_value_t = 8)]
    pub n: usize,
    /// Number of meshes n, 2n, 4n, ...
    #[arg(long, default_value_t = 5)]
    pub levels: usize,
    /// Discrete cone
    #[arg(long, default_value_t = Cone::Nodal)]
    pub cone: Cone,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self { n: 8, levels: 5, cone: Cone::Nodal, output: Output::default() }
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Ways to the same discrete solution.
const ROADS: [&str; 3] = ["active set, cold", "active set, nested", "interior point"];

/// Solves on every level by every road and measures the error in the H¹ seminorm.
pub fn run(options: &Options) -> Result<Headline> {
    if !(2..=8).contains(&options.levels) {
        return Err(Error::CountOutOfRange { name: "levels", value: options.levels, range: "[2, 8]" });
    }
    let rule = Cubature::new(4)?.singular_at(&[[manufactured::TRANSITION, 0.0]]);
    let exact = Field::Scalar(&manufactured::exact);
    let gradient = |point| [manufactured::gradient(point), [0.0; 2]];
    let mut table = Table::new(vec![
        Column::new("n", "n", Format::Significant(3), ""),
        Column::new("road", "road", Format::Significant(3), ""),
        Column::new(
            "error",
            "error",
            Format::Scientific(3),
            "|u - u_h| in the H1 seminorm, against the known solution",
        ),
        Column::new("seconds", "seconds", Format::Scientific(1), "mesh, assembly, solution and judgement"),
        Column::new("iterations", "steps", Format::Significant(3), ""),
        Column::new("kkt", "KKT", Format::Scientific(1), "worst scaled KKT figure"),
    ]);
    let mut points = vec![Vec::new(); ROADS.len()];
    let (mut worst, mut coarse): (f64, Option<ContactSolution>) = (0.0, None);
    let bar = progress(options.levels as u64);
    for level in 0..options.levels {
        let n = options.n.saturating_mul(1 << level);
        for (road, name) in ROADS.iter().enumerate() {
            let start = Instant::now();
            let problem = MeshScene::Manufactured.problem(n)?;
            let solution = match (road, &coarse) {
                (1, Some(coarse)) => problem.solve_after(coarse)?,
                (2, _) => problem.solve(options.cone, Solver::InteriorPoint)?,
                _ => problem.solve(options.cone, Solver::ActiveSet)?,
            };
            let seconds = start.elapsed().as_secs_f64();
            let values = &solution.displacement;
            let error = error_norms(problem.mesh(), problem.form(), values, (&exact, &gradient), &rule)?.h1;
            let kkt = solution.judgement.worst();
            worst = worst.max(kkt);
            let steps = solution.work.iterations as usize;
            if road == 1 {
                coarse = Some(solution);
            }
            // On the coarsest mesh there is nothing to start from.
            if road == 1 && level == 0 {
                continue;
            }
            table.push(vec![
                n.into(),
                (*name).into(),
                error.into(),
                seconds.into(),
                steps.into(),
                kkt.into(),
            ]);
            points[road].push((seconds, error));
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let (first, last) = (points[0][0].1, points[0][options.levels - 1].1);
    let order = (first / last).log2() / (options.levels - 1) as f64;
    let verdict = if worst <= JUDGED && (0.9..=1.1).contains(&order) {
        Verdict::Holds
    } else {
        Verdict::NotConfirmed(format!("order {order:.3}, KKT {worst:.1e}"))
    };
    let claim = "order 1 in the energy norm for u in H^{5/2-eps}, whatever solves the discrete problem";
    let measured = format!("order {order:.3}, error {last:.2e} on the finest mesh");
    let mut headline = Headline::new("Section 2, speed for accuracy", claim, table, measured, verdict);
    headline.quote(format!("section.2.speed.{}.order", options.cone), order);
    if let Some(directory) = options.output.directory()? {
        let (x, y) = (Axis::logarithmic("seconds"), Axis::logarithmic("error in the H¹ seminorm"));
        let chart = ROADS
            .iter()
            .zip(points)
            .fold(Chart::new("Known solution: seconds for accuracy", x, y), |chart, (name, points)| {
                chart.with(Series::line_and_points(*name, points))
            });
        headline.figures.push(chart.save(directory, &format!("section_2_seconds_{}", options.cone))?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
