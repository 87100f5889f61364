//! Lemma 5.2: the Poincaré constant γ_θ(ν) against the printed laws and the true ones.
//!
//! (5.1)-(5.3) bound γ_θ by C θ^{ν−1/2}, C ln(1/θ) and C. The first and the third are the true orders; at ν = 1/2 the true
//! growth is √(3/(2π²) ln(1/θ)).

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, PALETTE, Series};
use signorini::poincare::{Condition, Zone, end_limit, gamma, gamma_at_point, half_law, printed_growth};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Result, Tolerance};
use std::f64::consts::PI;
use std::process::ExitCode;
use std::time::Instant;

/// The Poincare constant of a zone (0, theta) for three regimes of nu
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (0, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
    pub nu: Vec<FractionalOrder>,
    /// Lengths theta of the zone
    #[arg(long, value_delimiter = ',', default_values = ["1e-1", "1e-2", "1e-3", "1e-4", "1e-5", "1e-6"])]
    pub theta: Vec<f64>,
    /// What holds on the zone: mean-zero or vanishing
    #[arg(long, default_value = "mean-zero")]
    pub condition: Condition,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value = "balanced")]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["lemma_5_2_poincare_scaling"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// The law that holds as θ → 0; known for a mean-zero zone, and for both conditions when ν > 1/2.
fn true_law(order: FractionalOrder, theta: f64, options: &Options) -> Result<Option<f64>> {
    let is_known = options.condition == Condition::MeanZero || order.offset() > 0.0;
    if theta > 0.5 || !is_known {
        return Ok(None);
    }
    Ok(Some(if order.is_below_half() {
        end_limit(order)?.value * theta.powf(order.offset())
    } else if order.offset() == 0.0 {
        half_law(theta)?
    } else {
        gamma_at_point(order, 0.0, options.tolerance)?.value
    }))
}

/// One order: computed constants with their printed and true laws.
struct Curve {
    order: FractionalOrder,
    computed: Vec<(f64, f64)>,
    law: Vec<(f64, f64)>,
}

impl Curve {
    /// Growth from the last two zones computed, beside the law that holds.
    fn growth(&self) -> Option<String> {
        let &[.., (theta0, gamma0), (theta1, gamma1)] = self.computed.as_slice() else { return None };
        let (nu, logarithm) = (self.order, (theta0 / theta1).ln());
        Some(if nu.is_below_half() {
            let power = (gamma1 / gamma0).ln() / -logarithm;
            format!("nu = {nu}: theta^{power:.4}, law theta^{:.4}", nu.offset())
        } else if nu.offset() == 0.0 {
            let slope = (gamma1 * gamma1 - gamma0 * gamma0) / logarithm;
            format!("nu = 1/2: gamma^2 gains {slope:.6} per ln(1/theta), law {:.6}", 1.5 / (PI * PI))
        } else {
            let limit = self.law.last().map_or(String::new(), |(_, law)| format!(", limit {law:.6}"));
            format!("nu = {nu}: {gamma1:.6}{limit}")
        })
    }
}

/// Computes the table and compares both laws.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(columns());
    let mut curves = Vec::new();
    for &order in &options.nu {
        let mut curve = Curve { order, computed: Vec::new(), law: Vec::new() };
        for &theta in &options.theta {
            let start = Instant::now();
            let estimate = gamma(order, Zone::end(theta)?, options.condition, options.tolerance)?;
            let seconds = start.elapsed().as_secs_f64();
            let printed = estimate.value / printed_growth(order, theta);
            let law = true_law(order, theta, options)?;
            curve.computed.push((theta, estimate.value));
            curve.law.extend(law.map(|law| (theta, law)));
            table.push(vec![
                order.value().into(),
                theta.into(),
                estimate.value.into(),
                estimate.error.into(),
                printed.is_finite().then_some(printed).into(),
                law.map(|law| estimate.value / law).into(),
                seconds.into(),
            ]);
        }
        curves.push(curve);
    }
    let measured: Vec<String> = curves.iter().filter_map(Curve::growth).collect();
    let has_half = curves.iter().any(|curve| curve.order.offset() == 0.0);
    let loose = || Verdict::HoldsLoose("sqrt(ln(1/theta)) at nu = 1/2".into());
    let verdict = if has_half { loose() } else { Verdict::Holds };
    let claim = "gamma_theta(nu) <= C theta^(nu-1/2), C ln(1/theta), C for nu < 1/2, = 1/2, > 1/2";
    let mut headline = Headline::new("Lemma 5.2", claim, table, measured.join("; "), verdict);
    for curve in &curves {
        for &(theta, gamma) in &curve.computed {
            headline.quote(format!("lemma.5.2.gamma.nu{}.theta{theta:e}", curve.order), gamma);
        }
    }
    headline.quote("lemma.5.2.slope.end", 1.5 / (PI * PI));
    if let Some(directory) = options.output.directory()? {
        let names: Vec<String> =
            options.nu.iter().map(|nu| format!("_{nu}").replace(['/', '.'], "_")).collect();
        let name = if names.len() == 1 { names.concat() } else { String::new() };
        headline.figures.push(chart(curves).save(directory, &format!("lemma_5_2_gamma{name}"))?);
    }
    Ok(headline)
}

fn columns() -> Vec<Column> {
    let printed = "gamma / (theta^(nu-1/2), ln(1/theta), 1)";
    let law = "gamma / (B theta^(nu-1/2), (A L + c + d/(A L + c))^(1/2), gamma_0)";
    vec![
        Column::new("nu", "nu", Format::Significant(3), ""),
        Column::new("theta", "theta", Format::Scientific(0), ""),
        Column::new("gamma", "gamma", Format::Significant(9), "computed constant"),
        Column::new("error", "error", Format::Scientific(0), "its estimated error"),
        Column::new("printed", "/printed", Format::Significant(4), printed),
        Column::new("law", "/true", Format::Significant(8), law),
        Column::hidden("seconds"),
    ]
}

/// γ_θ(ν) against θ: points computed, dashed the law that holds as θ → 0.
fn chart(curves: Vec<Curve>) -> Chart {
    let x = Axis::logarithmic("θ, length of the zone (interval = 1)");
    let mut chart =
        Chart::new("Poincaré constants of Lemma 5.2", x, Axis::logarithmic("γ, Poincaré constant"));
    for (k, Curve { order, computed, law }) in curves.into_iter().enumerate() {
        let colour = PALETTE[k % PALETTE.len()];
        chart = chart.with(Series::points(format!("ν = {order}, computed"), computed).colour(colour));
        if !law.is_empty() {
            chart = chart.with(Series::dashed(format!("ν = {order}, law as θ → 0"), law).colour(colour));
        }
    }
    chart
}

fn main() -> ExitCode {
    example_frame::main(run)
}
