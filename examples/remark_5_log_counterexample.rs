//! Remark 5: (5.3) fails at ν = 1/2. Truncations of |ln x|^α, 0 < α < 1/2.
//!
//! w = 1 − min(|ln x|^α, n)/n vanishes on (0, θ), θ = exp(−n^{1/α}), ‖w‖₀ ≥ 1 − O(1/n) and |w|_{1/2} ≤ C/n. With L = ln(1/θ) the quotient grows
//! like L^α: for α → 1/2 the remark's own family reaches the true order √L of (5.2), not the printed L.
//!
//! `cargo run --release --example remark_5_log_counterexample`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::poincare::{Condition, Zone, gamma};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::{FractionalOrder, Partition, PiecewisePolynomial, closed_forms};
use signorini::{Error, Result, Tolerance};
use std::process::ExitCode;

/// Quotients of the truncated logarithms of Remark 5 beside the Poincare constants of their zones
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Exponents alpha in (0, 1/2)
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.4", "0.45"])]
    pub alpha: Vec<f64>,
    /// L = ln(1/theta)
    #[arg(long, value_delimiter = ',', default_values = ["4", "16", "64", "256"])]
    pub log: Vec<f64>,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value_t = Tolerance::balanced())]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["remark_5_log_counterexample"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// The truncated function on layers of ratio 0.7 towards 0 and 1, piecewise quadratic: a function of H^{1/2} in its own right,
/// so that its quotient is a true lower bound of the constant of its zone.
fn truncated(alpha: f64, log: f64) -> Result<PiecewisePolynomial> {
    let layers = (log / 0.35).ceil().max(8.0);
    let mut nodes = vec![0.0];
    nodes.extend((0..=layers as usize).map(|k| (-log * (1.0 - k as f64 / layers)).exp()));
    nodes.pop();
    let last = nodes[nodes.len() - 1];
    nodes.extend((1..40).map(|k| 1.0 - (1.0 - last) * 0.5f64.powi(k)));
    nodes.push(1.0);
    let value =
        |x: f64| if x <= 0.0 { 0.0 } else { 1.0 - (-x.ln()).min(log).max(0.0).powf(alpha) / log.powf(alpha) };
    PiecewisePolynomial::interpolate(Partition::from_nodes(&nodes)?, 2, value)
}

/// Follows the family down to very short zones.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("alpha", "alpha", Format::Significant(3), ""),
        Column::new("log", "L", Format::Significant(3), "ln(1/theta)"),
        Column::new("quotient", "||w||/|w|", Format::Significant(6), "of the truncated function"),
        Column::new(
            "gamma",
            "gamma",
            Format::Significant(8),
            "constant for functions that vanish on (0, theta)",
        ),
        Column::new("used", "share", Format::Significant(4), "quotient / gamma, at most 1"),
        Column::new("growth", "/L^alpha", Format::Significant(4), "quotient / L^alpha"),
        Column::new(
            "bound",
            "seminorm",
            Format::Significant(5),
            "n |w| / | |ln x|^alpha |, at most 1 (truncation)",
        ),
    ]);
    let mut chart = Chart::new(
        "Remark 5: quotients of truncated logarithms",
        Axis::logarithmic("L = ln(1/θ), logarithm of the zone"),
        Axis::logarithmic("‖w‖ / |w|, quotient of the function"),
    );
    let nu = FractionalOrder::HALF;
    let (mut holds, mut unbounded, mut resolved) = (true, true, true);
    let mut constants = Vec::new();
    for &log in &options.log {
        Error::require("L", log, "[1, 690]", (1.0..=690.0).contains(&log))?;
        constants.push(gamma(nu, Zone::end((-log).exp())?, Condition::Vanishing, options.tolerance)?.value);
    }
    for &alpha in &options.alpha {
        let full = closed_forms::log_power(alpha)?.value.sqrt();
        let mut curve: Vec<(f64, f64)> = Vec::new();
        for (&log, &gamma) in options.log.iter().zip(&constants) {
            let w = truncated(alpha, log)?;
            let seminorm = w.seminorm(nu, Tolerance::balanced())?.value;
            let quotient = w.l2_norm(Tolerance::reference())?.value / seminorm;
            let bound = seminorm * log.powf(alpha) / full;
            holds &= quotient <= gamma * (1.0 + 1e-7);
            // Truncation lowers the seminorm; an interpolant that raises it has too coarse a mesh.
            resolved &= bound <= 1.0 + 1e-3;
            unbounded &= curve.last().is_none_or(|&(_, before)| quotient > before);
            curve.push((log, quotient));
            let growth = quotient / log.powf(alpha);
            table.push([alpha, log, quotient, gamma, quotient / gamma, growth, bound].map(Into::into).into());
        }
        chart = chart.with(Series::line_and_points(format!("α = {alpha}"), curve));
    }
    let curve = options.log.iter().copied().zip(constants.iter().copied()).collect();
    chart = chart.with(Series::dashed("γ of the zone", curve));
    let measured =
        "the quotients grow without bound, like L^alpha, below the constant, like L^(1/2)".to_owned();
    let verdict = if !resolved {
        Verdict::NotConfirmed("the mesh near x = 1 does not resolve so small an alpha".into())
    } else if holds && unbounded {
        Verdict::Holds
    } else {
        Verdict::NotConfirmed("a quotient exceeds the constant of its zone or does not grow".into())
    };
    let claim = "no C bounds ||w||_0 / |w|_{1/2} for functions that vanish on an interval of length theta";
    let mut headline = Headline::new("Remark 5", claim, table, measured, verdict);
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "remark_5_log_counterexample")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
