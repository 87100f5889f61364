//! Theorems 3.1 and 4.1 for an elastic body and 3/2 < tau <= 2 with numbers for all constants: a bound above
//! the error, on every mesh.
//!
//! `cargo run --release --example theorem_3_1_with_numbers_elastic -- --lambda 20 --tau 1.75`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::shown::numbers::{decided_by, effectivity, numbered_findings, numbered_table};
use example_frame::{Finding, Headline, Result, progress, within};
use experiments::ErrorExt;
use experiments::proof::NumberedStudy;
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::problems::KnownSolution;
use signorini::proof::TheoremConstants;
use std::process::ExitCode;

example_frame::options! {
    /// Compare the bound with numbers with the error of elastic bodies of known displacement
    pub struct Options {
        /// tau in (3/2, 2], comma separated
        #[arg(long, value_delimiter = ',', default_values = ["1.6", "1.75", "1.9", "2"], value_parser = within::<f64>("(1.5, 2]"))]
        pub tau: Vec<f64>,
        /// The displacement is r^p with p = tau - 1 + this: just in H^tau
        #[arg(long, default_value_t = 0.06, value_parser = within::<f64>("[1e-12, 0.4]"))]
        pub above: f64,
        /// Lame's first constant
        #[arg(long, default_value_t = 1.0, value_parser = within::<f64>("[-1e12, 1e12]"))]
        pub lambda: f64,
        /// Lame's second constant
        #[arg(long, default_value_t = 1.0, value_parser = within::<f64>("[1e-12, 1e12]"))]
        pub mu: f64,
        /// Meshes of 4 x 4 ... n x n squares, n = 2 to this power
        #[arg(long, default_value_t = 6, value_parser = clap::value_parser!(u32).range(3..=9))]
        pub finest: u32,
    }
    memory(options) {
        4500.0 * f64::from(2 * options.finest).exp2()
    }
}

/// Both cones for every tau.
pub fn compute(options: &Options) -> Result<Vec<NumberedStudy>> {
    fractional_sobolev::Error::require(
        "above",
        options.above,
        "(0, 0.4]",
        options.above > 0.0 && options.above <= 0.4,
    )?;
    let lame = Lame::new(options.lambda, options.mu)?;
    let bar = progress(2 * options.tau.len() as u64);
    let mut studies = Vec::new();
    for &tau in &options.tau {
        let numbers = TheoremConstants::new(tau)?;
        let scene = KnownSolution::power(tau - 1.0 + options.above, Some(lame))?;
        for cone in [Cone::Nodal, Cone::Midpoint] {
            studies.push(NumberedStudy::new(numbers, scene, cone, options.finest)?);
            bar.inc(1);
        }
    }
    Ok(studies)
}

/// What decides: bound over error on every mesh, and the price of each cone.
pub fn findings(studies: &[NumberedStudy]) -> Vec<Finding> {
    let is_midpoint = |study: &NumberedStudy| study.cone == Cone::Midpoint;
    let korn = Finding::claim("korn", "for the midpoint cone, with Korn's constant, {value} times or more");
    let korn = decided_by(korn, studies, is_midpoint, effectivity, f64::min);
    let mut found = numbered_findings(studies);
    found.insert(1, korn.at_least(1.0, "the error itself"));
    found
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let studies = compute(options)?;
    let claim = "|u - u_h|_a <= C h^(tau-1), 3/2 < tau <= 2, elastic, every constant a number";
    let table = numbered_table(&studies, "interpolation, in the energy, times sqrt M", "_a");
    let found = findings(&studies);
    let mut headline = Headline::new("Theorems 3.1, 4.1, numbers, elastic", claim, table, found);
    headline.draw(&options.output, "theorem_3_1_with_numbers_elastic", || Ok(draw(&studies)))?;
    Ok(headline)
}

/// Bound over error, both cones.
fn draw(studies: &[NumberedStudy]) -> Chart {
    let (x, y) = (Axis::logarithmic("h"), Axis::linear("bound / error"));
    let title = "How far the bound with numbers is from the error of an elastic body";
    studies.iter().fold(Chart::new(title, x, y), |chart, study| {
        let points = study.rows.iter().map(|row| (1.0 / row.n as f64, effectivity(row))).collect();
        let name = format!("{}, tau = {}", study.cone, study.numbers.tau);
        chart.with(match study.cone {
            Cone::Nodal => Series::line_and_points(name, points),
            Cone::Midpoint => Series::dashed(name, points),
        })
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
