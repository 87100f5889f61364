//! Remark 4: the P0 projection gains nothing beyond H^1: the rate of ‖φ − π^h φ‖ is min(r, 1), in the dual
//! norm min(r, 1) + 1/2.
//!
//! φ = x^{r−1/2+0.005}, barely in H^r. Lagrange interpolation of the same functions goes on to rate 2. The
//! product of two projection errors loses an order; whether the method does is asked in `theorem_4_1_rates`.

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, within};
use experiments::ErrorExt;
use experiments::EstimateExt;
use experiments::interpolation::{
    DualRates, SampleSlope, power_lagrange_rate, sample_projection_rate, saturation_quotient,
};
use fractional_sobolev::{Error, Estimate};
use std::process::ExitCode;

/// Distance of a measured rate from the theoretical one that counts as agreement.
const RATE_TOLERANCE: f64 = 0.02;
/// Distance from 1 of the error over its limit on the finest mesh, which falls like 1/N.
const LIMIT_TOLERANCE: f64 = 1e-3;
/// Elements of the mesh for the limit, and of the coarsest of three meshes in the dual norm.
const FINEST: usize = 1 << 16;
const DUAL_COARSEST: usize = 64;

example_frame::options! {
    /// The rate of the P0 projection against the smoothness of the function
    pub struct Options {
        /// Orders r > 0, comma separated
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75", "1.25", "1.5", "2", "2.5", "4"], value_parser = within::<f64>("(0, 10]"))]
        pub r: Vec<f64>,
    }
}

/// Rates of the function barely in H^r.
pub struct Row {
    /// The order.
    pub r: f64,
    /// Of ‖φ − π^h φ‖₀.
    pub projection: Estimate,
    /// Of ‖φ − π^h φ‖_{1/2,*}.
    pub dual: Estimate,
    /// Of ‖φ − I^h φ‖₀, for φ ∈ H¹.
    pub lagrange: Option<Estimate>,
    /// ‖φ − π^h φ‖₀ / (h ‖φ'‖₀/√12) on the finest mesh, for φ ∈ H¹.
    pub limit: Option<Estimate>,
}

/// Rates for every r, and the limit of ‖φ − π^h φ‖/h.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let dual = DualRates::new(DUAL_COARSEST)?;
    let mut rows = Vec::new();
    for &r in &options.r {
        Error::require("r", r, "(0, 10]", r > 0.0 && r <= 10.0)?;
        let phi = SampleSlope::barely_in(r)?;
        // x^a is in H¹ for a > 1/2
        let a = r - 0.5 + SampleSlope::EDGE;
        rows.push(Row {
            r,
            projection: sample_projection_rate(phi)?,
            dual: dual.rate(phi)?,
            lagrange: (a > 0.5).then(|| power_lagrange_rate(a)).transpose()?,
            limit: (a > 0.5).then(|| saturation_quotient(a, FINEST)).transpose()?,
        });
    }
    Ok(rows)
}

/// σ_N and u_N of a solution in H^{7/4}: their orders on the edge, and the power that (4.9) has.
const PAIR: ([f64; 2], f64) = ([0.25, 1.25], 1.5);

/// What decides: rates below and beyond H^1, and the limit they saturate at.
pub fn findings(_: &Options, rows: &[Row]) -> Vec<Finding> {
    let beyond = || rows.iter().filter(|row| row.r > 1.0);
    let l2 = |row: &Row| row.projection.off(row.r.min(1.0)).ok();
    let gap = |row: &Row| Estimate::new(row.r + 0.5 - row.dual.value, row.dual.error, row.dual.work).ok();
    let rate = |r: f64| rows.iter().find(|row| row.r == r).map(|row| row.projection);
    let product = PAIR.0.map(rate);
    let product = product[0].zip(product[1]).map(|(s, u)| (s.value + u.value, s.error + u.error));
    vec![
        Finding::claim("below", "up to H^1 the rates in L2 are within {value} of r")
            .largest(rows.iter().filter(|row| row.r <= 1.0).filter_map(l2))
            .at_most(RATE_TOLERANCE, "(4.6)")
            .told(),
        Finding::claim("beyond", "beyond H^1 the rates in L2 are within {value} of 1")
            .largest(beyond().filter_map(l2))
            .at_most(RATE_TOLERANCE, "saturation")
            .told(),
        Finding::claim(
            "limit",
            "of functions in H^1 the error is h |phi'|_0 / sqrt(12) up to a part {value}",
        )
        .largest(rows.iter().filter_map(|row| row.limit?.off(1.0).ok()))
        .at_most(LIMIT_TOLERANCE, "its limit"),
        Finding::remark("dual", "beyond H^1 the rates in the dual norm stay {value} or more below r + 1/2")
            .smallest(beyond().filter_map(gap))
            .at_least(0.0, "(4.7), if it went on beyond r = 1"),
        Finding::remark(
            "product",
            "at tau = 7/4 the product of both projection errors has the power {value}",
        )
        .number_or(product, "no row for sigma_N or u_N")
        .at_most(PAIR.1, "2 tau - 2, the power of the term; tau - 1/2 by (4.6), saturated")
        .otherwise("at tau = 7/4 the product of both projection errors has the power {value}, no loss"),
        Finding::remark("lagrange", "beyond H^1 piecewise linears have rates of at least {value}")
            .smallest(beyond().filter_map(|row| row.lagrange))
            .at_least(1.0, "the rate of piecewise constants"),
    ]
}

/// Measures the rates of projection and interpolation.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "the L2 projection on piecewise constants gains nothing beyond H^1";
    let mut headline = Headline::new("Remark 4", claim, table(&rows), findings(options, &rows));
    let worst = rows.iter().map(|row| (row.projection.value - row.r.min(1.0)).abs()).fold(0.0, f64::max);
    headline.quote("remark_4.worst_rate", worst);
    headline.draw(&options.output, "remark_4_saturation", || Ok(draw(&rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let (rate, error) = (Format::Fixed(4), Format::Scientific(0));
    let uncertainty = "3.5 times the change from the coarser pair of meshes, and the errors of the norms";
    Table::new(vec![
        Column::new("r", "r", Format::Significant(3), "phi = x^(r-1/2+0.005) is barely in H^r"),
        Column::new("projection", "P0", rate, "rate of |phi - pi^h phi|_0; theory min(r, 1)"),
        Column::new("projection_error", "+-", error, uncertainty),
        Column::new("dual", "P0, dual", Format::Fixed(3), "in the dual norm; theory min(r, 1) + 1/2"),
        Column::new("dual_error", "+- dual", error, "the same"),
        Column::new(
            "limit",
            "/limit",
            Format::Fixed(5),
            "|phi - pi^h phi|_0 / (h |phi'|_0 / sqrt(12)), finest mesh",
        ),
        Column::new("lagrange", "P1", rate, "rate of |phi - I^h phi|_0; theory min(r, 2)"),
    ])
    .with_rows(rows.iter().map(|row| {
        let both = |rate: Estimate| [Some(rate.value), Some(rate.error)];
        let last = [row.limit.map(|e| e.value), row.lagrange.map(|e| e.value)];
        [[Some(row.r)].as_slice(), &both(row.projection), &both(row.dual), &last].concat()
    }))
}

fn draw(rows: &[Row]) -> Chart {
    let points = |of: fn(&Row) -> Option<Estimate>| -> Vec<(f64, f64)> {
        rows.iter().filter_map(|row| Some((row.r, of(row)?.value))).collect()
    };
    let (x, y) = (Axis::linear("r, smoothness of the function"), Axis::linear("rate, exponent of h"));
    Chart::new("Remark 4: saturation of the P0 projection", x, y)
        .with(Series::line_and_points("P0, L2", points(|row| Some(row.projection))))
        .with(Series::line_and_points("P0, dual norm", points(|row| Some(row.dual))))
        .with(Series::line_and_points("P1, L2", points(|row| row.lagrange)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
