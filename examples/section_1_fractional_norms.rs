//! Section 1, (1.1): Slobodeckij norms of a gallery of functions against ν, and where each becomes infinite.

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::sobolev::{FractionalOrder, GalleryFunction};
use signorini::{Error, Result, Tolerance};
use std::process::ExitCode;
use std::time::Instant;

/// Norms of fractional order of functions of one variable
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Functions: power:A, step:X, hat, log:ALPHA, samples:FILE (rows of x, value, read as piecewise linear)
    #[arg(long, value_delimiter = ',', default_values = ["power:0.6", "power:-0.2", "step:0.4", "hat", "log:0.25"], allow_hyphen_values = true)]
    pub function: Vec<GalleryFunction>,
    /// Orders nu in (0, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.1", "0.25", "0.45", "0.5", "0.75", "0.95"])]
    pub nu: Vec<FractionalOrder>,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value = "1e-9")]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["section_1_fractional_norms"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

fn columns() -> Vec<Column> {
    vec![
        Column::new("function", "function", Format::Significant(6), ""),
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("seminorm", "|u|_nu", Format::Significant(13), "seminorm (1.1) of order nu on (0,1)"),
        Column::new("norm", "||u||_nu", Format::Significant(13), ""),
        Column::new("error", "error", Format::Scientific(1), "estimated absolute error of the seminorm"),
        Column::new(
            "true_error",
            "true error",
            Format::Scientific(1),
            "relative, against the closed form where one is known",
        ),
        Column::new("seconds", "seconds", Format::Scientific(1), "for the seminorm"),
    ]
}

/// Computes every norm and compares with closed forms.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(columns());
    let (mut worst, mut compared, mut recognised, mut wrong) = (0.0f64, 0, 0, Vec::new());
    let mut repeated = 0.0f64;
    let mut chart =
        Chart::new("Seminorms of order nu", Axis::linear("nu, order"), Axis::logarithmic("|u|_nu, seminorm"));
    for function in &options.function {
        let mut curve = Vec::new();
        for &order in &options.nu {
            let start = Instant::now();
            let outcome = function.seminorm(order, options.tolerance);
            let seconds = start.elapsed().as_secs_f64();
            let head = [Cell::from(function.to_string()), order.value().into()];
            let rest = match (outcome, function.closed_form(order)) {
                (Ok(seminorm), Ok(exact)) => {
                    let norm = function.norm(order, options.tolerance)?;
                    let error = exact.map(|exact| (seminorm.value / exact.value - 1.0).abs());
                    match error {
                        Some(error) => (worst, compared) = (worst.max(error), compared + 1),
                        None => {
                            repeated = repeated.max(repetition(function, order, options, seminorm.value)?)
                        }
                    }
                    curve.push((order.value(), seminorm.value));
                    [
                        seminorm.value.into(),
                        norm.value.into(),
                        seminorm.error.into(),
                        error.into(),
                        seconds.into(),
                    ]
                }
                // An infinite norm that no closed form contradicts.
                (Err(Error::InfiniteNorm { .. }), Err(Error::InfiniteNorm { .. }) | Ok(None)) => {
                    recognised += 1;
                    ["infinite".into(), "infinite".into(), Cell::Missing, Cell::Missing, seconds.into()]
                }
                (Err(error @ Error::InfiniteNorm { .. }), _) | (Ok(_), Err(error)) => {
                    wrong.push(format!("{function} at {order}: {error}"));
                    [Cell::Missing, Cell::Missing, Cell::Missing, Cell::Missing, seconds.into()]
                }
                (Err(error), _) => return Err(error),
            };
            table.push(head.into_iter().chain(rest).collect());
        }
        chart = chart.with(Series::line_and_points(function.to_string(), curve));
    }
    let verdict = match wrong.first() {
        None if worst.max(repeated / 11.0) <= options.tolerance.relative() => Verdict::Holds,
        None => Verdict::NotConfirmed(format!(
            "true error {worst:.1e}, change {repeated:.1e} against a coarser run: above the tolerance"
        )),
        Some(first) => Verdict::NotConfirmed(first.clone()),
    };
    let claim = "the norms (1.1) are computed to the tolerance asked, and an infinite one is recognised";
    let measured = match (compared, recognised) {
        (0, 0) => format!("no closed form; at ten times the tolerance the norms change by {repeated:.1e}"),
        (0, _) => format!("infinite norms recognised: {recognised}; nothing finite to compare"),
        _ => {
            format!(
                "true error at most {worst:.1e} over {compared} closed forms, {} asked; {recognised} infinite",
                options.tolerance
            )
        }
    };
    let mut headline = Headline::new("Section 1, (1.1)", claim, table, measured, verdict);
    headline.quote("section_1.true_error", worst);
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "section_1_fractional_norms")?);
    }
    Ok(headline)
}

/// Without a closed form: the relative change of the seminorm against a run at ten times the tolerance.
fn repetition(
    function: &GalleryFunction,
    order: FractionalOrder,
    options: &Options,
    value: f64,
) -> Result<f64> {
    let coarser = Tolerance::new((10.0 * options.tolerance.relative()).min(0.1))?;
    let again = function.seminorm(order, coarser)?.value;
    Ok(if again == value { 0.0 } else { (again / value - 1.0).abs() })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
