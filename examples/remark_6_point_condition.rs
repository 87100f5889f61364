//! Remark 6: for ν > 1/2 it is enough that u vanishes at one point.
//!
//! γ₀(ν) = sup ‖u‖₀/|u|_ν over u(a) = 0, the limit of γ_θ as the zone shrinks to the point. It blows up like (2ν−1)^{−1/2} at ν = 1/2: the
//! uniform formula gives (2ν−1) γ₀² → 3/(2π²) at an end, and the inside of the interval is the better place.
//!
//! `cargo run --release --example remark_6_point_condition`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::poincare::{Condition, END_SLOPE, Zone, gamma, gamma_at_point};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Result, Tolerance};
use std::process::ExitCode;

/// The Poincare constant of functions that vanish at one point
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (1/2, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.55", "0.6", "0.75", "0.9", "0.99"])]
    pub nu: Vec<FractionalOrder>,
    /// The point inside, beside the end
    #[arg(long, default_value_t = 0.5)]
    pub point: f64,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value_t = Tolerance::balanced())]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["remark_6_point_condition"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Zone that stands for a point in the comparison.
const SHORT: f64 = 1e-12;

/// Compares the constant of a point with that of short zones.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("gamma0", "gamma_0", Format::Significant(10), "u = 0 at the end of the interval"),
        Column::new("short", "gamma_theta", Format::Significant(10), "mean zero on (0, 1e-12)"),
        Column::new(
            "scaled",
            "(2nu-1) gamma_0^2 / A",
            Format::Significant(5),
            "A = 3/(2 pi^2); tends to 1 as nu -> 1/2",
        ),
        Column::new("inside", "inside", Format::Significant(8), "u = 0 at the point given"),
        Column::new("ratio", "inside/end", Format::Significant(6), ""),
    ]);
    let (mut ends, mut insides, mut holds) = (Vec::new(), Vec::new(), true);
    for &nu in &options.nu {
        let end = gamma_at_point(nu, 0.0, options.tolerance)?;
        let inside = gamma_at_point(nu, options.point, options.tolerance)?;
        let short = gamma(nu, Zone::end(SHORT)?, Condition::MeanZero, options.tolerance)?;
        // (5.3): the constants of all zones stay below that of the point
        holds &= short.value <= end.value + end.error + short.error
            && inside.value <= end.value + end.error + inside.error;
        let scaled = 2.0 * nu.offset() * end.value * end.value / END_SLOPE;
        ends.push((nu.value(), end.value));
        insides.push((nu.value(), inside.value));
        let ratio = inside.value / end.value;
        table.push([nu.value(), end.value, short.value, scaled, inside.value, ratio].map(Into::into).into());
    }
    let measured =
        ends.iter().map(|(nu, g)| format!("gamma_0({nu}) = {g:.8}")).collect::<Vec<_>>().join(", ");
    let verdict = if holds {
        Verdict::Holds
    } else {
        Verdict::NotConfirmed("a short zone or a point inside has a larger constant than the end".into())
    };
    let claim =
        "for nu > 1/2 the inequality ||u||_0 <= C |u|_nu holds for functions that vanish at one point";
    let mut headline = Headline::new("Remark 6", claim, table, measured, verdict);
    for &(nu, value) in &ends {
        headline.quote(format!("remark.6.gamma.{nu}"), value);
    }
    let chart = Chart::new(
        "Functions vanishing at a point",
        Axis::linear("ν, order"),
        Axis::logarithmic("γ_0, Poincaré constant"),
    )
    .with(Series::line_and_points("point at the end", ends))
    .with(Series::line_and_points(format!("point at {}", options.point), insides));
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "remark_6_point_condition")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
