//! The trace theorem of Section 1 with its constant: |w|_{s-1/2, edge} <= C(s) |w|_s on the half-plane.
//!
//! `cargo run --release --example section_1_trace_constants -- --s 0.51,0.999`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress, within};
use experiments::EstimateExt;
use experiments::square_trace::SquareTrace;
use fractional_sobolev::{Domain, Estimate, Order, trace_constant, trace_quotient};
use std::f64::consts::PI;
use std::process::ExitCode;

example_frame::options! {
    /// Best constants of the trace on one edge: half-plane, corner, square
    pub struct Options {
        /// Orders s in (1/2, 1), comma separated
        #[arg(long, value_delimiter = ',', default_values = ["0.55", "0.6", "0.65", "0.7", "0.75", "0.8", "0.85", "0.9", "0.95"], value_parser = within::<Order>("(0.5, 1)"))]
        pub s: Vec<Order>,
        /// Angle of the corner in degrees, in [10, 180]
        #[arg(long, default_value_t = 90.0, value_parser = within::<f64>("[10, 180]"))]
        pub angle: f64,
        /// Degree of the polynomials on the square
        #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u32).range(2..=16))]
        pub degree: u32,
    }
}

/// One order; all quotients are divided by C(s)^2.
#[derive(Clone)]
pub struct Row {
    /// s.
    pub order: Order,
    /// C(s) on the half-plane, the closed form.
    pub constant: Estimate,
    /// Modes of the half-plane, by finite elements.
    pub half_plane: Vec<Estimate>,
    /// Modes of the corner.
    pub corner: Vec<Estimate>,
    /// Trial functions on the square; `None` where they are not independent or s is outside [0.55, 0.95].
    pub square: Option<Estimate>,
}

/// All orders, and what belongs to both ends.
#[derive(Clone)]
pub struct Computed {
    /// One row for each order.
    pub rows: Vec<Row>,
    /// (2s-1) C(s) near 1/2, over its limit.
    pub growth: Estimate,
    /// s = 1 on the square: the largest quotient of cosines.
    pub one: Estimate,
}

/// Frequencies mu of the corner, the first three of the half-plane too; cosines for s = 1.
const CORNER: [f64; 5] = [0.0, 1.0, 4.0, 16.0, 64.0];
const COSINES: usize = 60;
/// Distance from 1/2 at which the limit is read off; accuracy asked.
const NEAR: f64 = 1e-7;
const DIGITS: f64 = 1e-5;
/// Accuracy asked of the closed form.
const ROUNDING: f64 = 1e-8;

/// Constants, second road, corner and square for every order.
pub fn compute(options: &Options) -> Result<Computed> {
    let (bar, angle) = (progress(options.s.len() as u64), options.angle.to_radians());
    let row = |&order: &Order| -> Result<Row> {
        let constant = trace_constant(Domain::HalfPlane, order, ROUNDING)?.constant;
        let over = |found: Estimate| found.times(constant.value.powi(-2));
        let all = |domain: Domain, modes: &[f64]| -> fractional_sobolev::Result<Vec<Estimate>> {
            let of = |&mu: &f64| Estimate::or_best(trace_quotient(domain.clone(), order, mu, DIGITS));
            modes.iter().map(|mu| over(of(mu)?)).collect()
        };
        let half_plane = all(Domain::HalfPlane, &CORNER[..3])?;
        let corner = all(Domain::Corner(angle), &CORNER)?;
        let trial = SquareTrace::new(order, options.degree as usize).ok();
        let square = trial.map(|found| over(found.largest())).transpose()?;
        bar.inc(1);
        Ok(Row { order, constant, half_plane, corner, square })
    };
    let rows = options.s.iter().map(row).collect::<Result<_>>()?;
    let near = trace_constant(Domain::HalfPlane, Order::half_plus(NEAR)?, ROUNDING)?.constant;
    let growth = near.times(2.0 * NEAR * PI / 3f64.sqrt())?;
    Ok(Computed { rows, growth, one: SquareTrace::at_one(COSINES)?.largest() })
}

/// What decides: two roads to the constant, corner and square below it, s = 1, both limits.
pub fn findings(computed: &Computed) -> Vec<Finding> {
    let Computed { rows, growth, one } = computed;
    let apart = rows.iter().flat_map(|row| &row.half_plane).filter_map(|q| q.off(1.0).ok());
    vec![
        Finding::claim("roads", "finite elements and the closed form are {value} apart at most")
            .largest(apart)
            .at_most(DIGITS, "accuracy asked"),
        Finding::claim("corner", "the modes of the corner reach {percent} % of the half-plane")
            .largest(rows.iter().flat_map(|row| row.corner.iter().copied()))
            .at_most(1.0, "C(s)^2 of the half-plane")
            .told(),
        Finding::claim("square", "trial functions on the square reach {percent} % of the half-plane")
            .largest(rows.iter().filter_map(|row| row.square))
            .at_most(1.0, "C(s)^2 of the half-plane")
            .told(),
        Finding::claim("one", "at s = 1 cosines on the square reach {value}")
            .estimate(*one)
            .at_most(2.0 * PI, "2 pi")
            .by_proof("section_1_trace_constants"),
        Finding::claim("growth", "at s = 1/2 + 1e-7 the product (2s-1) C is {value} of its limit")
            .estimate(*growth)
            .within(DIGITS, 1.0, "sqrt(3)/pi"),
    ]
}

/// The constants over s.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "|w|_{s-1/2, edge} <= C(s) |w|_s, C(s)^2 = 4s^2/((2s-1) D(s)) on the half-plane";
    let mut headline = Headline::new("Section 1, traces", claim, table(&computed), findings(&computed));
    headline.draw(&options.output, "trace_shares", || Ok(draw_shares(&computed)))?;
    headline.draw(&options.output, "trace_profiles", draw_profiles)?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
    let (digits, share) = (Format::Significant(7), Format::Fixed(4));
    let columns = vec![
        Column::new("s", "s", Format::Plain, ""),
        Column::new("constant", "C(s)", digits, "half-plane"),
        Column::new("growth", "(2s-1) C", digits, "tends to sqrt(3)/pi as s -> 1/2"),
        Column::new("normalised", "normalised", digits, "C sqrt(pi/(2(1-s))), tends to sqrt(2 pi)"),
        Column::new("corner", "corner", share, "largest quotient of its modes up to mu = 16, over C^2"),
        Column::new("square", "square", share, "largest quotient of trial functions, over C^2"),
    ];
    Table::new(columns).with_rows(computed.rows.iter().map(|row| {
        let (s, c) = (row.order, row.constant.value);
        let corner = row.corner.iter().take(4).map(|q| q.value).fold(0.0, f64::max);
        let (growth, normalised) = (2.0 * s.offset() * c, c * (0.5 * PI / (1.0 - s.value())).sqrt());
        [s.value(), c, growth, normalised, corner, row.square.map_or(f64::NAN, |q| q.value)]
    }))
}

fn draw_shares(computed: &Computed) -> Chart {
    let chart = Chart::new("Corner and square", Axis::linear("s"), Axis::linear("quotient over half-plane"));
    let chart = CORNER.iter().enumerate().fold(chart, |chart, (k, mu)| {
        let points = computed.rows.iter().map(|row| (row.order.value(), row.corner[k].value)).collect();
        chart.with(Series::line_and_points(format!("corner, mu = {mu}"), points))
    });
    let point = |row: &Row| Some((row.order.value(), row.square?.value));
    chart.with(Series::line_and_points("square", computed.rows.iter().filter_map(point).collect()))
}

fn draw_profiles() -> Result<Chart> {
    let (x, y) = (Axis::logarithmic("distance from the edge times frequency"), Axis::linear("extension"));
    let mut chart = Chart::new("Extremal functions: the profile beside cos(x)", x, y);
    let places: Vec<f64> = (0..61).map(|k| 10f64.powf(-5.0 + 0.1 * f64::from(k))).collect();
    for s in [0.55, 0.65, 0.8, 0.95] {
        let found = trace_constant(Domain::HalfPlane, s, ROUNDING)?;
        let profile = |y: f64| found.extremal().map_or(f64::NAN, |w| w.value(&[0.0, y]));
        let points = places.iter().map(|&y| (y, profile(y))).collect();
        chart = chart.with(Series::line(format!("s = {s}"), points));
    }
    Ok(chart.with(Series::dashed("s = 1", places.iter().map(|&y| (y, (-y).exp())).collect())))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
