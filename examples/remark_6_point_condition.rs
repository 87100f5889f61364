//! Remark 6: for ν > 1/2 it is enough that u vanishes at one point.
//!
//! γ₀(ν) = sup ‖u‖₀/|u|_ν over u(a) = 0, the limit of γ_θ as the zone shrinks to the point. It blows up like
//! (2ν−1)^{−1/2} at ν = 1/2: the uniform formula gives (2ν−1) γ₀² → 3/(2π²) at an end, and the inside of the
//! interval is the better place.
//!
//! `cargo run --release --example remark_6_point_condition`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, within};
use experiments::EstimateExt;
use experiments::growth::END_SLOPE;
use fractional_sobolev::{Constraint, Estimate, Order, Tolerance, gamma};
use std::process::ExitCode;

example_frame::options! {
    /// The Poincare constant of functions that vanish at one point
    pub struct Options: Quick {
        /// Orders nu in (1/2, 1)
        #[arg(long, value_delimiter = ',', default_values = ["0.55", "0.6", "0.75", "0.9", "0.99"], value_parser = within::<Order>("(0.5, 1)"))]
        pub nu: Vec<Order>,
        /// The point inside, beside the end
        #[arg(long, default_value_t = 0.5)]
        pub point: f64,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value_t = Tolerance::balanced())]
        pub tolerance: Tolerance,
    }
}

/// Zone that stands for a point in the comparison.
const SHORT: f64 = 1e-12;

/// One order.
pub struct Row {
    /// The order.
    pub nu: Order,
    /// γ₀, the point at the end.
    pub end: Estimate,
    /// γ₀, the point inside.
    pub inside: Estimate,
    /// γ_θ, mean zero on (0, 1e-12).
    pub short: Estimate,
    /// The last two over the first.
    pub ratios: [Estimate; 2],
    /// γ₀ over (A / (2ν−1))^{1/2}.
    pub scaled: Estimate,
}

/// The constants of the point at the end, of the point given and of a short zone.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let row = |&nu: &Order| -> Result<Row> {
        let end = gamma(nu, Constraint::vanishing_at(0.0), options.tolerance)?.constant;
        let inside = gamma(nu, Constraint::vanishing_at(options.point), options.tolerance)?.constant;
        let short = gamma(nu, Constraint::mean_zero_on(0.0..SHORT), options.tolerance)?.constant;
        let ratios = [inside.over(end)?, short.over(end)?];
        let law = (END_SLOPE / (2.0 * nu.offset())).sqrt();
        let scaled = Estimate::new(end.value / law, end.error / law, end.work)?;
        Ok(Row { nu, end, inside, short, ratios, scaled })
    };
    options.nu.iter().map(row).collect()
}

/// What decides: short zones have smaller constants that tend to γ₀, the end is the worst point, and how γ₀
/// blows up.
pub fn findings(options: &Options, rows: &[Row]) -> Vec<Finding> {
    // Both constants are known to the tolerance, and near ν = 1 they agree to many digits.
    let allowed = 1.0 + 4.0 * options.tolerance.relative();
    let largest = |k: usize| Estimate::largest(rows.iter().map(|row| row.ratios[k]));
    let none = "no order";
    let inside = format!("the point {} has at most {{percent}} % of the constant of the end", options.point);
    let mut findings = vec![
        Finding::claim("short", "no zone (0, 1e-12) has a larger constant than the point: {value} times it")
            .estimate_or(largest(1), none)
            .at_most(allowed, "(5.3) with the constant of the point, to the tolerance")
            .otherwise("a short zone has {value} times the constant of the point"),
        Finding::claim("inside", inside)
            .estimate_or(largest(0), none)
            .at_most(allowed, "the constant of the end, to the tolerance")
            .otherwise("the point inside has {percent} % of the constant of the end"),
    ];
    for Row { nu, end, ratios, scaled, .. } in rows {
        let finite = Finding::claim(format!("finite.nu{nu}"), format!("gamma_0({nu}) = {{value}}"));
        let source = "(3/(2 pi^2) / (2 nu - 1))^(1/2), its law as nu -> 1/2";
        findings.push(finite.estimate(*end).at_most(end.value / scaled.value, source).told());
        let limit = format!("nu = {nu}: the zone (0, 1e-12) has {{value}} times the constant of the point");
        let correction = SHORT.powf(2.0 * nu.offset());
        findings.push(Finding::remark(format!("limit.nu{nu}"), limit).estimate(ratios[1]).within(
            correction.max(allowed - 1.0),
            1.0,
            "the point, up to theta^(2nu-1) or the tolerance",
        ));
    }
    let nearest = rows.iter().min_by(|a, b| a.nu.offset().total_cmp(&b.nu.offset()));
    if let Some(Row { nu, scaled, .. }) = nearest {
        let words = format!("(2 nu - 1)^(1/2) gamma_0 is {{percent}} % of its limit at nu = {nu}");
        let finding = Finding::remark("blow.up", words).estimate(*scaled);
        findings.push(finding.within(
            2.0 * nu.offset(),
            1.0,
            "(3/(2 pi^2))^(1/2) as nu -> 1/2, up to 2 nu - 1",
        ));
    }
    findings
}

/// Compares the constant of a point with that of short zones.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim =
        "for nu > 1/2 the inequality ||u||_0 <= C |u|_nu holds for functions that vanish at one point";
    let mut headline = Headline::new("Remark 6", claim, table(&rows), findings(options, &rows));
    for row in &rows {
        headline.quote(format!("remark.6.gamma.{}", row.nu.value()), row.end.value);
    }
    headline.draw(&options.output, "remark_6_point_condition", || Ok(draw(&rows, options.point)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let ten = Format::Significant(10);
    let scaled = "(2nu-1) gamma_0^2 / A";
    let columns = vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("gamma0", "gamma_0", ten, "u = 0 at the end of the interval"),
        Column::new("short", "gamma_theta", ten, "mean zero on (0, 1e-12)"),
        Column::new("scaled", scaled, Format::Significant(5), "A = 3/(2 pi^2); tends to 1 as nu -> 1/2"),
        Column::new("inside", "inside", Format::Significant(8), "u = 0 at the point given"),
        Column::new("ratio", "inside/end", Format::Significant(6), ""),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let (end, inside) = (row.end.value, row.inside.value);
        [row.nu.value(), end, row.short.value, row.scaled.value.powi(2), inside, row.ratios[0].value]
    }))
}

fn draw(rows: &[Row], point: f64) -> Chart {
    let axes = (Axis::linear("ν, order"), Axis::logarithmic("γ_0, Poincaré constant"));
    let points = |value: fn(&Row) -> f64| rows.iter().map(|row| (row.nu.value(), value(row))).collect();
    Chart::new("Functions vanishing at a point", axes.0, axes.1)
        .with(Series::line_and_points("point at the end", points(|row| row.end.value)))
        .with_asymptote(0.5)
        .with(Series::line_and_points(format!("point at {point}"), points(|row| row.inside.value)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
