//! Lemma 5.1 (Peetre-Tartar): the constant α in α ‖u‖_ν ≤ |u|_ν for the spaces of Lemma 5.2.
//!
//! With X = V_θ, A u the difference quotient and T the embedding into L², ‖u‖_ν² = ‖u‖₀² + |u|_ν², so the
//! best constant is α = (1 + γ_θ²)^{−1/2}. γ² is an eigenvalue on a slope space; beside it, quotients
//! |u|_ν / ‖u‖_ν of piecewise polynomials, from other matrices: of the extremal function, which should attain
//! α, and of others with mean zero on the zone, which should not go below it.
//!
//! `cargo run --release --example lemma_5_1_peetre_tartar`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, within};
use experiments::EstimateExt;
use experiments::trial::{mean_free_quotient, peetre_tartar};
use fractional_sobolev::{Constraint, Estimate, Order, Tolerance, gamma};
use std::process::ExitCode;

example_frame::options! {
    /// The constant alpha of the Peetre-Tartar lemma for functions of mean zero on (0, theta)
    pub struct Options: Quick {
        /// Orders nu in (0, 1)
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
        pub nu: Vec<Order>,
        /// Lengths theta of the zone
        #[arg(long, value_delimiter = ',', default_values = ["1", "1e-1", "1e-2", "1e-4", "1e-8"], value_parser = within::<f64>("[1e-299, 1]"))]
        pub theta: Vec<f64>,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value_t = Tolerance::balanced())]
        pub tolerance: Tolerance,
    }
}

/// One order and one zone.
pub struct Row {
    /// The order and the length of the zone.
    pub at: (f64, f64),
    /// γ, the root of an eigenvalue.
    pub gamma: Estimate,
    /// α by γ.
    pub alpha: Estimate,
    /// |u| / ‖u‖_ν of the interpolated extremal function.
    pub quotient: Estimate,
    /// The same over α.
    pub attained: Estimate,
    /// The least of the same quotients of the other functions, over α.
    pub others: Option<Estimate>,
}

/// γ, its extremal function, and the other functions: those of the other orders, and that of ν = 0.9.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let other = Order::new(0.9)?;
    let mut rows = Vec::new();
    for &theta in &options.theta {
        let mut functions = Vec::new();
        for &nu in options.nu.iter().chain([&other]) {
            let (gamma, u) = gamma(nu, Constraint::mean_zero_on(0.0..theta), options.tolerance)
                .map(|found| (found.constant, found.extremal()))?;
            functions.push((gamma, u.interpolate(2, 6, &[theta])?));
        }
        for (k, &nu) in options.nu.iter().enumerate() {
            let of = |u| -> Result<Estimate> {
                Ok(peetre_tartar(mean_free_quotient(u, theta, nu, Tolerance::fast())?)?)
            };
            let quotients = functions.iter().map(|(_, u)| of(u)).collect::<Result<Vec<Estimate>>>()?;
            let alpha = peetre_tartar(functions[k].0)?;
            let over = quotients.iter().map(|quotient| quotient.over(alpha));
            let mut over = over.collect::<fractional_sobolev::Result<Vec<Estimate>>>()?;
            let (attained, others) = (over.remove(k), Estimate::smallest(over));
            let (at, gamma) = ((nu.value(), theta), functions[k].0);
            rows.push(Row { at, gamma, alpha, quotient: quotients[k], attained, others });
        }
    }
    rows.sort_by(|a, b| a.at.0.total_cmp(&b.at.0));
    Ok(rows)
}

/// Interpolation by quadratic pieces, six to a cell of the slope space, changes a quotient by less than this.
const INTERPOLATION: f64 = 1e-3;
/// α is said to fall where the last zone has less than this part of that of the first.
const FALLS: f64 = 0.9;

/// What decides: the extremal function attains α on the second road, no other function goes below, α > 0.
pub fn findings(rows: &[Row]) -> Vec<Finding> {
    let (largest, none) = (Estimate::largest(rows.iter().map(|row| row.attained)), "no order or no zone");
    let mut findings = vec![
        Finding::claim("positive", "alpha > 0 for every zone, at least {value}")
            .estimate_or(Estimate::smallest(rows.iter().map(|row| row.alpha)), none)
            .at_least(0.0, "Lemma 5.1")
            .told(),
        Finding::claim(
            "attained",
            "the extremal functions attain alpha on a second road: {value} times alpha",
        )
        .estimate_or(largest, none)
        .within(INTERPOLATION, 1.0, "equality, up to the interpolation of the function")
        .otherwise("an extremal function has {value} times alpha on a second road")
        .told(),
        Finding::claim(
            "least",
            "no other function tried goes below alpha, the nearest has {value} times alpha",
        )
        .estimate_or(Estimate::smallest(rows.iter().filter_map(|row| row.others)), none)
        .at_least(1.0 - INTERPOLATION, "alpha is the infimum, up to interpolation")
        .otherwise("a function has only {value} times alpha"),
    ];
    let series = rows.chunk_by(|a, b| a.at.0 == b.at.0);
    for (first, last) in series.filter_map(|same| same.first().zip(same.last())) {
        let (nu, theta) = last.at;
        let falls = format!("nu = {nu}: alpha falls to {{value}} at theta = {theta:e}");
        findings.push(
            Finding::remark(format!("falls.nu{nu}"), falls)
                .estimate(last.alpha)
                .at_most(FALLS * first.alpha.value, "nine tenths of alpha of the first zone")
                .otherwise(format!("nu = {nu}: alpha stays, {{value}} at theta = {theta:e}")),
        );
    }
    findings
}

/// Computes α from γ and compares it with quotients of functions.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "alpha ||u||_X <= ||A u||_Y with alpha > 0 on functions of mean zero over (0, theta)";
    let mut headline = Headline::new("Lemma 5.1", claim, table(&rows), findings(&rows));
    headline.quote("lemma.5.1.smallest.alpha", rows.iter().map(|row| row.alpha.value).fold(1.0, f64::min));
    headline.draw(&options.output, "lemma_5_1_peetre_tartar", || Ok(draw(&rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let (long, short) = (Format::Significant(9), Format::Significant(6));
    let columns = vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("theta", "theta", Format::Plain, ""),
        Column::new("gamma", "gamma", long, "root of an eigenvalue"),
        Column::new("alpha", "alpha", long, "(1 + gamma^2)^(-1/2)"),
        Column::new(
            "quotient",
            "|u|/||u||",
            short,
            "of the extremal function, interpolated, by another road",
        ),
        Column::new("others", "others", short, "least quotient of the other functions, over alpha"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let others = row.others.map_or(f64::NAN, |others| others.value);
        [row.at.0, row.at.1, row.gamma.value, row.alpha.value, row.quotient.value, others]
    }))
}

fn draw(rows: &[Row]) -> Chart {
    let (x, y) = ("θ, length of the zone (interval = 1)", "α, constant of the lemma");
    let chart = Chart::new("Peetre-Tartar constants", Axis::logarithmic(x), Axis::logarithmic(y));
    rows.chunk_by(|a, b| a.at.0 == b.at.0).fold(chart, |chart, same| {
        let points = same.iter().map(|row| (row.at.1, row.alpha.value)).collect();
        chart.with(Series::line_and_points(format!("ν = {}", same[0].at.0), points))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
