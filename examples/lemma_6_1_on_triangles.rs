//! Lemma 6.1 in the plane: best constants of linear interpolation on a triangle, for gradients of order s.
//!
//! `cargo run --release --example lemma_6_1_on_triangles -- --s 0.3,0.5,0.9 --tolerance 1e-7`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table};
use experiments::EstimateExt;
use fractional_sobolev::{
    BestConstant, Domain, ErrorNorm, Estimate, Order, Tolerance, interpolation_constant,
};
use std::f64::consts::FRAC_PI_2;
use std::process::ExitCode;

example_frame::options! {
    /// Best constants of linear interpolation on the right isosceles triangle
    pub struct Options {
        /// Orders s of the gradient in (0, 1), increasing; s = 1 is added
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.3", "0.35", "0.4", "0.5", "0.6", "0.7", "0.75", "0.8", "0.9", "0.95"])]
        pub s: Vec<Order>,
        /// Relative tolerance of the constants: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-6")]
        pub tolerance: Tolerance,
    }
}

/// One order with both constants.
#[derive(Clone)]
pub struct Row {
    /// s; 1 for the norm of second derivatives.
    pub s: f64,
    /// The constants of ‖∇(u − Iu)‖ and of ‖u − Iu‖, legs 1.
    pub constants: [BestConstant; 2],
}

impl Row {
    /// ((π/2)/(1−s))^{1/2}, which makes |∇u|_s a norm that tends to ‖D²u‖.
    fn unit(&self) -> f64 {
        if self.s < 1.0 { (FRAC_PI_2 / (1.0 - self.s)).sqrt() } else { 1.0 }
    }

    fn both(&self) -> impl Iterator<Item = &BestConstant> {
        self.constants.iter()
    }
}

/// The right isosceles triangle with legs 1.
const RIGHT: Domain = Domain::Triangle([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
/// Babuska and Aziz' bound for the right isosceles triangle (1976), the root of 1/x + tan(1/x) = 0.
const BABUSKA_AZIZ: f64 = 0.492_912_451_754_9;
/// Relative error asked of every constant.
const DIGITS: f64 = 1e-6;

/// Both constants for all orders and s = 1.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let row = |s: f64| -> Result<Row> {
        let gradient = interpolation_constant(RIGHT, ErrorNorm::Derivative, s, options.tolerance)?;
        let l2 = gradient.in_norm(ErrorNorm::L2)?;
        Ok(Row { s, constants: [gradient, l2] })
    };
    options.s.iter().map(|order| order.value()).chain([1.0]).map(row).collect()
}

/// What decides: the digits, the bounds from both sides, the order in s, and the limit s = 1.
pub fn findings(rows: &[Row]) -> Vec<Finding> {
    let constants = || rows.iter().flat_map(Row::both);
    let exact = |numbers: Vec<f64>| numbers.into_iter().reduce(f64::max).map(|number| (number, 0.0));
    let digits = constants().map(|c| c.constant.relative_error()).collect();
    let lower = constants().map(|c| c.lower.value / (c.constant.value + c.constant.error)).collect();
    let below = rows.iter().filter(|row| row.s < 1.0).flat_map(Row::both);
    let over = below.filter_map(|c| c.constant.times(c.upper?.value.recip()).ok());
    let falls = rows.windows(2).flat_map(|pair| {
        let normalised = |row: &Row, k: usize| row.constants[k].constant.times(row.unit()).ok();
        [0, 1].into_iter().filter_map(move |k| normalised(&pair[1], k)?.over(normalised(&pair[0], k)?).ok())
    });
    let at_one = rows.iter().find(|row| row.s == 1.0).map(|row| &row.constants[0]);
    let one = at_one.map(|found| found.constant);
    let bound = at_one.and_then(|found| found.upper).map_or(f64::NAN, |upper| upper.value);
    vec![
        Finding::claim("digits", "every constant is known to a relative error of {value}")
            .number_or(exact(digits), "no order")
            .at_most(DIGITS, "accuracy asked")
            .told(),
        Finding::claim("lower", "quotients of functions reach {value} of value plus error, never more")
            .number_or(exact(lower), "no order")
            .at_most(1.0, "such quotients are lower bounds"),
        Finding::claim("upper", "for s < 1 each constant is at most {value} times its computable bound")
            .largest(over)
            .at_most(1.0, "telescoping over halved triangles"),
        Finding::claim("monotone", "normalised, both fall with s, to {value} of the one before or less")
            .largest(falls)
            .at_most(1.0, "the constant of the order before")
            .told(),
        Finding::claim("kobayashi", "at s = 1 the constant of the gradient is {value}")
            .estimate_or(one, "s = 1 is missing")
            .at_most(bound, "Kobayashi's upper bound")
            .told(),
        Finding::claim("babuska.aziz", "that is below the classical bound")
            .estimate_or(one, "s = 1 is missing")
            .at_most(BABUSKA_AZIZ, "Babuska and Aziz"),
    ]
}

/// The constants of the right isosceles triangle.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "|grad(u - Iu)| <= C(s) |grad u|_s and |u - Iu| <= C'(s) |grad u|_s on a triangle";
    let mut headline = Headline::new("Lemma 6.1, triangles", claim, table(&rows), findings(&rows));
    headline.draw(&options.output, "lemma_6_1_on_triangles", || Ok(draw(&rows)))?;
    headline.draw(&options.output, "lemma_6_1_on_triangles_extremal", || Ok(draw_extremal(&rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let (digits, error, bound) = (Format::Significant(9), Format::Scientific(0), Format::Significant(4));
    let columns = vec![
        Column::new("s", "s", Format::Plain, ""),
        Column::new("derivative", "gradient", digits, "sup |grad(u - Iu)| / |grad u|_s, legs 1"),
        Column::new("derivative_error", "+-", error, "error of it"),
        Column::new("derivative_lower", "lower", digits, "quotient of a function"),
        Column::new("derivative_upper", "upper", bound, "computable upper bound; at s = 1 Kobayashi's"),
        Column::new("l2", "L2", digits, "sup |u - Iu| / |grad u|_s"),
        Column::new("l2_error", "+- L2", error, "error of it"),
        Column::new("normalised", "normalised", digits, "gradient, times (pi/2 / (1-s))^(1/2)"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let [first, second] = &row.constants;
        let upper = first.upper.map_or("".into(), |upper| Cell::from(upper.value));
        let (gradient, error): (Estimate, Estimate) = (first.constant, second.constant);
        let value = [gradient.value, gradient.error, first.lower.value].map(Cell::from);
        let l2 = [error.value, error.error, gradient.value * row.unit()].map(Cell::from);
        [[row.s.into()].as_slice(), &value, &[upper], &l2].concat()
    }))
}

fn draw(rows: &[Row]) -> Chart {
    let of =
        |k: usize| rows.iter().map(|row| (row.s, row.constants[k].constant.value * row.unit())).collect();
    let y = Axis::logarithmic("constant, seminorm normalised");
    Chart::new(
        "Linear interpolation on the right isosceles triangle",
        Axis::linear("s, order of the gradient"),
        y,
    )
    .with(Series::line_and_points("gradient of the error", of(0)))
    .with(Series::line_and_points("error in L2", of(1)))
}

/// The extremal functions less their interpolants along a leg, largest value 1.
fn draw_extremal(rows: &[Row]) -> Chart {
    let (x, y) =
        (Axis::linear("place on a leg, from the right angle"), Axis::linear("u - Iu, largest value 1"));
    let chart = Chart::new("Functions that take the constant of the gradient", x, y);
    rows.iter().step_by((rows.len() / 3).max(1)).fold(chart, |chart, row| {
        let extremal = row.constants[0].extremal();
        let value = |t: f64| extremal.map_or(f64::NAN, |error| error.value(&[t, 0.0]));
        let leg: Vec<(f64, f64)> = (0..=100).map(|k| 0.01 * f64::from(k)).map(|t| (t, value(t))).collect();
        let top = leg.iter().fold(0f64, |top, p| if p.1.abs() > top.abs() { p.1 } else { top });
        let scaled = leg.into_iter().map(|(t, v)| (t, v / top)).collect();
        chart.with(Series::line(format!("s = {}", row.s), scaled))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
