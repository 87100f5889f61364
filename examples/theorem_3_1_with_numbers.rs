//! Theorems 3.1 and 4.1 for 3/2 < tau <= 2 with numbers for all constants: a bound above the error, on every
//! mesh.
//!
//! `cargo run --release --example theorem_3_1_with_numbers -- --tau 1.55,1.8 --finest 8`

use example_frame::figures::{Axis, Chart, Series};
pub use example_frame::shown::numbers::numbered_findings as findings;
use example_frame::shown::numbers::numbered_table;
use example_frame::{Headline, Result, progress, within};
use experiments::ErrorExt;
use experiments::proof::{NumberedRow, NumberedStudy};
use signorini::cone::Cone;
use signorini::problems::KnownSolution;
use signorini::proof::TheoremConstants;
use std::process::ExitCode;

example_frame::options! {
    /// Compare the bound with numbers with the error of problems of known solution
    pub struct Options {
        /// tau in (3/2, 2], comma separated
        #[arg(long, value_delimiter = ',', default_values = ["1.6", "1.75", "1.9", "2"], value_parser = within::<f64>("(1.5, 2]"))]
        pub tau: Vec<f64>,
        /// The solution is r^p with p = tau - 1 + this: just in H^tau
        #[arg(long, default_value_t = 0.06, value_parser = within::<f64>("[1e-12, 0.4]"))]
        pub above: f64,
        /// Meshes of 4 x 4 ... n x n squares, n = 2 to this power
        #[arg(long, default_value_t = 6, value_parser = clap::value_parser!(u32).range(3..=10))]
        pub finest: u32,
    }
    memory(options) {
        1250.0 * f64::from(2 * options.finest).exp2()
    }
}

/// What C(s) belongs to.
const CONSTANT: &str = "interpolation, right isosceles triangles with legs h";

/// Both cones for every tau.
pub fn compute(options: &Options) -> Result<Vec<NumberedStudy>> {
    fractional_sobolev::Error::require(
        "above",
        options.above,
        "(0, 0.4]",
        options.above > 0.0 && options.above <= 0.4,
    )?;
    let bar = progress(2 * options.tau.len() as u64);
    let mut studies = Vec::new();
    for &tau in &options.tau {
        let numbers = TheoremConstants::new(tau)?;
        let scene = KnownSolution::power(tau - 1.0 + options.above, None)?;
        for cone in [Cone::Nodal, Cone::Midpoint] {
            studies.push(NumberedStudy::new(numbers, scene, cone, options.finest)?);
            bar.inc(1);
        }
    }
    Ok(studies)
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let studies = compute(options)?;
    let claim = "|u - u_h| <= C h^(tau-1), 3/2 < tau <= 2, any contact set, every constant a number";
    let mut headline = Headline::new(
        "Theorems 3.1, 4.1, numbers",
        claim,
        numbered_table(&studies, CONSTANT, ""),
        findings(&studies),
    );
    headline.draw(&options.output, "theorem_3_1_with_numbers", || Ok(draw(&studies)))?;
    Ok(headline)
}

fn draw(studies: &[NumberedStudy]) -> Chart {
    let (x, y) = (Axis::logarithmic("h"), Axis::logarithmic("nodal cone: bound, and error (dashed)"));
    let nodal = studies.iter().filter(|study| study.cone == Cone::Nodal);
    nodal.fold(Chart::new("The bound with numbers and the error", x, y), |chart, study| {
        let points = |of: fn(&NumberedRow) -> f64| {
            study.rows.iter().map(|row| (1.0 / row.n as f64, of(row))).collect::<Vec<_>>()
        };
        chart
            .with(Series::line_and_points(format!("bound, tau = {}", study.numbers.tau), points(|r| r.bound)))
            .with(Series::dashed(format!("error, tau = {}", study.numbers.tau), points(|r| r.error)))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
