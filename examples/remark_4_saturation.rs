//! Remark 4: the P0 projection gains nothing beyond H^1: the rate of ‖φ − π^h φ‖ is min(r, 1), in the dual norm min(r, 1) + 1/2.
//!
//! φ = x^{r−1/2+0.005}, barely in H^r. Lagrange interpolation of the same functions goes on to rate 2.

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::interpolation::{
    DualNorm, InterpolationError, SampleSlope, sample_projection_dual_error, sample_projection_error,
};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::{FractionalOrder, Partition};
use signorini::{Error, Result};
use std::process::ExitCode;

/// Distance of a measured rate from the theoretical one that counts as agreement
const RATE_TOLERANCE: f64 = 0.02;
/// x^(r - 1/2 + EDGE) is barely in H^r
const EDGE: f64 = 0.005;
/// Elements of the two meshes in L2 and in the dual norm, where an element has 4 cells (with 2 the sawtooth of a smooth function is not seen)
const MESHES: [usize; 2] = [1 << 12, 1 << 16];
const DUAL_MESHES: [usize; 2] = [128, 256];

/// The rate of the P0 projection against the smoothness of the function
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders r > 0
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75", "1.25", "1.5", "2", "2.5", "4"])]
    pub r: Vec<f64>,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["remark_4_saturation"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// The observed exponent between two meshes.
fn rate(meshes: [usize; 2], error: impl Fn(usize) -> Result<f64>) -> Result<f64> {
    Ok((error(meshes[0])? / error(meshes[1])?).log2() / (meshes[1] as f64 / meshes[0] as f64).log2())
}

/// Rates for every r, and the limit of ‖φ − π^h φ‖/h.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("r", "r", Format::Significant(3), "phi = x^(r-1/2+0.005) is barely in H^r"),
        Column::new("projection", "P0", Format::Fixed(4), "rate of |phi - pi^h phi|_0; theory min(r, 1)"),
        Column::new(
            "dual",
            "P0, dual",
            Format::Fixed(3),
            "the same in the dual norm of H^(1/2); theory min(r, 1) + 1/2, neared from above like 1/N",
        ),
        Column::new(
            "limit",
            "/limit",
            Format::Fixed(5),
            "|phi - pi^h phi|_0 / (h |phi'|_0 / sqrt(12)) on the finest mesh",
        ),
        Column::new("lagrange", "P1", Format::Fixed(4), "rate of |phi - I^h phi|_0; theory min(r, 2)"),
    ]);
    let dual_norm = |n: usize| DualNorm::new(&Partition::uniform(4 * n, 1.0)?);
    let norms = [dual_norm(DUAL_MESHES[0])?, dual_norm(DUAL_MESHES[1])?];
    let (mut worst, mut rows) = (0.0f64, Vec::new());
    for &r in &options.r {
        Error::require("r", r, "(0, 10]", r > 0.0 && r <= 10.0)?;
        let a = r - 0.5 + EDGE;
        let phi = SampleSlope::Power(a);
        let l2 = |n: usize| sample_projection_error(phi, &Partition::uniform(n, 1.0)?).map(|e| e.value);
        let dual = |n: usize| {
            sample_projection_dual_error(phi, &norms[usize::from(n == DUAL_MESHES[1])], 4).map(|e| e.value)
        };
        let (projection, in_dual) = (rate(MESHES, l2)?, rate(DUAL_MESHES, dual)?);
        worst = worst.max((projection - r.min(1.0)).abs());
        // ‖φ'‖₀ = a/√(2a − 1) and the interpolation error of φ by its slope, for φ ∈ H¹.
        let smooth = a > 0.5;
        let finest = MESHES[1];
        let limit =
            |n: usize| -> Result<f64> { Ok(l2(n)? * n as f64 * 12f64.sqrt() * (2.0 * a - 1.0).sqrt() / a) };
        let order = FractionalOrder::new((0.5 * (a - 0.5)).clamp(1e-3, 0.5))?;
        let p1 = |n: usize| -> Result<f64> {
            Ok(InterpolationError::of_sample(
                SampleSlope::Power(a - 1.0),
                &Partition::uniform(n, 1.0)?,
                order,
            )?
            .l2
            .value)
        };
        let lagrange = smooth.then(|| rate(MESHES, p1)).transpose()?;
        table.push(vec![
            r.into(),
            projection.into(),
            in_dual.into(),
            smooth.then(|| limit(finest)).transpose()?.into(),
            lagrange.into(),
        ]);
        rows.push((r, [Some(projection), Some(in_dual), lagrange]));
    }
    let measured = format!("L2 rates within {worst:.3} of min(r, 1)");
    let verdict = if worst <= RATE_TOLERANCE {
        Verdict::Holds
    } else {
        Verdict::NotConfirmed(format!("a rate is off by {worst:.3}"))
    };
    let claim = "the L2 projection on piecewise constants gains nothing beyond H^1";
    let mut headline = Headline::new("Remark 4", claim, table, measured, verdict);
    headline.quote("remark_4.worst_rate", worst);
    if let Some(directory) = options.output.directory()? {
        let series =
            |k: usize| rows.iter().filter_map(|(r, rates)| Some((*r, rates[k]?))).collect::<Vec<_>>();
        let chart = Chart::new(
            "Remark 4: saturation of the P0 projection",
            Axis::linear("r, smoothness of the function"),
            Axis::linear("rate, exponent of h"),
        )
        .with(Series::line_and_points("P0, L2", series(0)))
        .with(Series::line_and_points("P0, dual norm", series(1)))
        .with(Series::line_and_points("P1, L2", series(2)));
        headline.figures.push(chart.save(directory, "remark_4_saturation")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
