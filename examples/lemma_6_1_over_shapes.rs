//! Lemma 6.1 over shapes: the constant of linear interpolation on isosceles triangles of all angles.
//!
//! `cargo run --release --example lemma_6_1_over_shapes -- --s 0.3,0.9 --angles 15,60,90,150`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress, within};
use fractional_sobolev::{Domain, Error, ErrorNorm, Estimate, Order, Tolerance, interpolation_constant};
use std::f64::consts::FRAC_PI_2;
use std::process::ExitCode;

example_frame::options! {
    /// Best constants of linear interpolation on isosceles triangles with longest edge 1
    pub struct Options {
        /// Orders s of the gradient in (0, 1), comma separated; s = 1 is added
        #[arg(long, value_delimiter = ',', default_values = ["0.5", "0.75"])]
        pub s: Vec<Order>,
        /// Angles at the top in degrees, in (6, 174), increasing; one should be 60
        #[arg(long, value_delimiter = ',', default_values = ["20", "30", "40", "50", "60", "75", "90", "105", "120", "135"], value_parser = within::<f64>("(6, 174)"))]
        pub angles: Vec<f64>,
        /// Relative tolerance of the constants: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-5")]
        pub tolerance: Tolerance,
    }
}

/// One angle.
#[derive(Clone)]
pub struct Row {
    /// Degrees.
    pub angle: f64,
    /// The constants of the gradient, seminorms normalised, for every order and for s = 1.
    pub constants: Vec<Estimate>,
    /// Kobayashi's bound at s = 1.
    pub bound: f64,
}

/// Relative error asked.
const DIGITS: f64 = 1e-3;
/// A flat triangle has at least this many times the constant of the equilateral one.
const FLAT: f64 = 2.0;

/// All constants for every angle.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let bar = progress(options.angles.len() as u64);
    let row = |&angle: &f64| -> Result<Row> {
        Error::require("angle", angle, "(6, 174)", angle > 6.0 && angle < 174.0)?;
        let (width, height) = (0.5 * angle).to_radians().sin_cos();
        let longest = (2.0 * width).max(1.0);
        let corners = [[0.0, height], [-width, 0.0], [width, 0.0]].map(|p| p.map(|x| x / longest));
        let constant = |s: f64| {
            interpolation_constant(Domain::Triangle(corners), ErrorNorm::Derivative, s, options.tolerance)
        };
        let mut constants = Vec::new();
        for order in &options.s {
            let found = constant(order.value())?.constant;
            constants.push(found.times((FRAC_PI_2 / order.complement()).sqrt())?);
        }
        let one = constant(1.0)?;
        constants.push(one.constant);
        bar.inc(1);
        Ok(Row { angle, constants, bound: one.upper.map_or(f64::NAN, |upper| upper.value) })
    };
    options.angles.iter().map(row).collect()
}

/// What decides: digits, the bound at s = 1, and both ends of the angles beside the equilateral triangle.
pub fn findings(rows: &[Row]) -> Vec<Finding> {
    let all = rows.iter().flat_map(|row| &row.constants);
    let digits = all.map(Estimate::relative_error).reduce(f64::max).map(|digits| (digits, 0.0));
    let below = rows.iter().filter_map(|row| row.constants.last()?.times(row.bound.recip()).ok());
    let equal = rows.iter().find(|row| row.angle == 60.0);
    let over = |row: Option<&Row>, below_one: bool| -> Vec<Estimate> {
        let (Some(row), Some(equal)) = (row, equal) else { return Vec::new() };
        let count = row.constants.len() - usize::from(below_one);
        let pairs = row.constants.iter().zip(&equal.constants).take(count);
        pairs.filter_map(|(a, b)| a.over(*b).ok()).collect()
    };
    vec![
        Finding::claim("digits", "every constant is known to a relative error of {value}")
            .number_or(digits, "no angle")
            .at_most(DIGITS, "accuracy asked"),
        Finding::claim("kobayashi", "at s = 1 every constant is at most {value} of Kobayashi's bound")
            .largest(below)
            .at_most(1.0, "an upper bound")
            .told(),
        Finding::claim(
            "flat",
            "the flattest triangle has {value} times the constant of the equilateral one, or more",
        )
        .smallest(over(rows.last(), false))
        .at_least(FLAT, "large angles do harm")
        .told(),
        Finding::claim(
            "needle",
            "below s = 1 the sharpest triangle has {value} times that constant, or more",
        )
        .smallest(over(rows.first(), true))
        .at_least(1.0, "for s < 1 small angles do harm too")
        .told(),
    ]
}

/// The constants over the angle at the top.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "|grad(u - Iu)| <= C |grad u|_s with a constant that depends on the angles";
    let mut headline = Headline::new("Lemma 6.1, shapes", claim, table(options, &rows), findings(&rows));
    headline.draw(&options.output, "lemma_6_1_over_shapes", || Ok(draw(options, &rows)))?;
    Ok(headline)
}

fn table(options: &Options, rows: &[Row]) -> Table {
    let digits = Format::Significant(6);
    let words = options.s.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let columns = vec![
        Column::new("angle", "angle", Format::Plain, "at the top of an isosceles triangle, degrees"),
        Column::new("first", "first s", digits, format!("gradient, normalised; orders s = {words} and 1")),
        Column::new("second", "last s", digits, "the last of these below 1"),
        Column::new("one", "s = 1", digits, ""),
        Column::new("bound", "Kobayashi", digits, "upper bound at s = 1"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let value = |k: usize| row.constants.get(k).map_or(f64::NAN, |c| c.value);
        let last = row.constants.len() - 1;
        [row.angle, value(0), value(last.saturating_sub(1)), value(last), row.bound]
    }))
}

fn draw(options: &Options, rows: &[Row]) -> Chart {
    let y = Axis::logarithmic("constant, longest edge 1, normalised");
    let chart = Chart::new("Isosceles triangles", Axis::linear("angle at the top, degrees"), y);
    let names = options.s.iter().map(|s| format!("s = {s}")).chain(["s = 1".to_string()]);
    let points = |of: &dyn Fn(&Row) -> f64| rows.iter().map(|row| (row.angle, of(row))).collect::<Vec<_>>();
    let chart = names.enumerate().fold(chart, |chart, (k, name)| {
        chart.with(Series::line_and_points(name, points(&|row| row.constants[k].value)))
    });
    chart.with(Series::dashed("Kobayashi's bound", points(&|row| row.bound)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
