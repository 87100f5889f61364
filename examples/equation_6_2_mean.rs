//! (6.2): |v(x) − v̄| ≤ h^{1/2} ‖v'‖₀, its best constant κ(x/h) at every point, and functions that reach it.
//!
//! `cargo run --release --example equation_6_2_mean -- --cells 4096`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Error, Finding, Format, Headline, Result, Table};
use experiments::EstimateExt;
use experiments::interpolation::{extremal_slopes, largest_share, mean_deviation, pointwise};
use fractional_sobolev::Estimate;
use std::process::ExitCode;

example_frame::options! {
    /// How far a function can be from its mean, point by point
    pub struct Options: Quick {
        /// Cells with a constant slope each, a multiple of 16
        #[arg(long, default_value_t = 256)]
        pub cells: usize,
        /// Random functions tried
        #[arg(long, default_value_t = 2000)]
        pub functions: usize,
        /// Seed of the random functions
        #[arg(long, default_value_t = 1)]
        pub seed: u64,
    }
}

/// Points of the table: sixteenths of the interval.
const POINTS: usize = 16;

/// One point.
pub struct Row {
    /// x/h.
    pub point: f64,
    /// The best constant in place of 1.
    pub best: Estimate,
    /// What the best of functions with so many slopes reaches.
    pub reached: Estimate,
}

/// What is computed.
pub struct Computed {
    /// Points from end to end.
    pub rows: Vec<Row>,
    /// Largest share of κ among random functions.
    pub tried: Estimate,
}

/// κ in closed form, and the quotient of the nearest function, summed from its slopes.
pub fn compute(options: &Options) -> Result<Computed> {
    let Options { cells, functions, seed, .. } = *options;
    if cells == 0 || !cells.is_multiple_of(POINTS) {
        return Err(Error::Option(format!("cells {cells}: expected a multiple of {POINTS}")));
    }
    let row = |k: usize| {
        let (point, node) = (k as f64 / POINTS as f64, k * (cells / POINTS));
        let reached = mean_deviation(&extremal_slopes(cells, node)?, node)?;
        Ok(Row { point, best: pointwise(point)?, reached })
    };
    let rows = (0..=POINTS).map(row).collect::<Result<_>>()?;
    Ok(Computed { rows, tried: largest_share(cells, functions, seed)? })
}

/// (κ² − q²) · 12 N² for the functions of N slopes: one, up to rounding.
fn missing(row: &Row, cells: usize) -> (f64, f64) {
    let scale = 12.0 * (cells as f64).powi(2);
    let (best, reached) = (row.best, row.reached);
    let error = 2.0 * (best.value * best.error + reached.value * reached.error);
    (scale * (best.value - reached.value) * (best.value + reached.value), scale * error)
}

/// A second road agrees to this in units of what N slopes must miss.
const AGREED: f64 = 1e-3;

/// What decides: κ against the printed 1, functions against κ, and where it is worst.
pub fn findings(options: &Options, Computed { rows, tried }: &Computed) -> Vec<Finding> {
    let off = rows.iter().map(|row| missing(row, options.cells)).map(|(share, u)| ((share - 1.0).abs(), u));
    let off = off.reduce(|a, b| if a.0 + a.1 >= b.0 + b.1 { a } else { b });
    let at = |point: f64| rows.iter().find(|row| row.point == point).map(|row| row.best);
    let ratio = at(0.5).zip(at(0.0)).map(|(centre, end)| {
        let ratio = centre.value / end.value;
        (ratio, ratio * (centre.relative_error() + end.relative_error()))
    });
    vec![
        Finding::claim("holds", "the line holds at every point, with a constant of at most {value}")
            .largest(rows.iter().map(|row| row.best))
            .at_most(1.0, "printed constant")
            .otherwise("the line fails at a point, where the best constant is {value}"),
        Finding::claim("reached", "the best of all functions with N slopes misses its square by 1/(12 N^2)")
            .number_or(off, "no point")
            .at_most(AGREED, "means of k over the cells; in units of 1/(12 N^2)")
            .otherwise("the functions with N slopes miss it by another amount, off by {value}"),
        Finding::claim("tried", "no function tried takes more than {percent} % of the best constant")
            .estimate(*tried)
            .at_most(1.0, "best constant"),
        Finding::sharpness("loose", "by a factor {value} or more, at every point")
            .smallest(rows.iter().filter_map(|row| row.best.recip().ok()))
            .at_least(1.0, "printed constant")
            .told(),
        Finding::remark("centre", "in the centre the best constant is half that of the ends")
            .number_or(ratio, "centre or end is not among the points")
            .within(1e-12, 0.5, "kappa(1/2)/kappa(0), kappa(t)^2 = (t^3 + (1-t)^3)/3")
            .told(),
    ]
}

/// Computes κ by two roads and tries functions.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "|v(x) - mean of v| <= h^(1/2) |v'|_0 on an interval of length h, at every point x";
    let found = findings(options, &computed);
    let mut headline = Headline::new("(6.2)", claim, table(options, &computed.rows), found);
    if let Some(row) = computed.rows.first() {
        headline.quote("equation.6.2.end", row.best.value);
    }
    headline.draw(&options.output, "equation_6_2_mean", || Ok(draw(&computed.rows)))?;
    Ok(headline)
}

fn table(options: &Options, rows: &[Row]) -> Table {
    let digits = Format::Fixed(8);
    let reached = format!("by the best function with {} slopes, values and mean summed", options.cells);
    Table::new(vec![
        Column::new("point", "x/h", Format::Plain, "where"),
        Column::new("best", "best", digits, "best constant kappa in place of 1"),
        Column::new("reached", "reached", digits, reached),
        Column::new("missing", "missed", Format::Fixed(6), "12 N^2 (best^2 - reached^2); must be 1"),
    ])
    .with_rows(
        rows.iter().map(|row| [row.point, row.best.value, row.reached.value, missing(row, options.cells).0]),
    )
}

fn draw(rows: &[Row]) -> Chart {
    let points = |of: fn(&Row) -> f64| rows.iter().map(|row| (row.point, of(row))).collect::<Vec<_>>();
    let (x, y) =
        (Axis::linear("x/h, place in the interval"), Axis::linear("constant in (6.2)").range(0.0, 1.1));
    Chart::new("(6.2): how far a function is from its mean", x, y)
        .with(Series::dashed("printed: 1", points(|_| 1.0)))
        .with(Series::line("best", points(|row| row.best.value)))
        .with(Series::points("reached by functions", points(|row| row.reached.value)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
