//! Lemma 5.2: the Poincaré constant γ_θ(ν) against the printed laws and the true ones.
//!
//! (5.1)-(5.3) bound γ_θ by C θ^{ν−1/2}, C ln(1/θ) and C. The first and the third are the true orders; at ν = 1/2 the true
//! growth is √(3/(2π²) ln(1/θ)).

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::poincare::{Condition, Zone, end_limit, gamma, gamma_at_point, half_law, printed_growth};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Result, Tolerance};
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

/// The law that holds as θ → 0.
fn true_law(order: FractionalOrder, theta: f64, tolerance: Tolerance) -> Result<f64> {
    if order.is_below_half() {
        Ok(end_limit(order)?.value * theta.powf(order.offset()))
    } else if order.offset() == 0.0 {
        half_law(theta)
    } else {
        Ok(gamma_at_point(order, 0.0, tolerance)?.value)
    }
}

/// Computes the table and compares both laws.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("nu", "nu", Format::Significant(3), ""),
        Column::new("theta", "theta", Format::Scientific(0), ""),
        Column::new("gamma", "gamma", Format::Significant(9), "computed constant"),
        Column::new("error", "error", Format::Scientific(0), "its estimated error"),
        Column::new(
            "printed",
            "/printed",
            Format::Significant(4),
            "gamma / (theta^(nu-1/2), ln(1/theta), 1)",
        ),
        Column::new(
            "law",
            "/true",
            Format::Significant(8),
            "gamma / (B theta^(nu-1/2), (A L + c + d/(A L + c))^(1/2), gamma_0)",
        ),
        Column::hidden("seconds"),
    ]);
    let mut decline = 1.0_f64;
    for &nu in &options.nu {
        let mut ratios = Vec::new();
        for &theta in &options.theta {
            let start = Instant::now();
            let estimate = gamma(nu, Zone::end(theta)?, options.condition, options.tolerance)?;
            let seconds = start.elapsed().as_secs_f64();
            let printed = estimate.value / printed_growth(nu, theta);
            ratios.push(printed);
            table.push(vec![
                nu.value().into(),
                theta.into(),
                estimate.value.into(),
                estimate.error.into(),
                printed.into(),
                (theta <= 0.5)
                    .then(|| true_law(nu, theta, options.tolerance))
                    .transpose()?
                    .map(|law| estimate.value / law)
                    .into(),
                seconds.into(),
            ]);
        }
        if nu.offset() == 0.0 {
            decline = ratios[ratios.len() - 1] / ratios[0];
        }
    }
    let measured =
        format!("at nu = 1/2 gamma/ln(1/theta) falls to {decline:.3} of its first value: sqrt(ln), not ln");
    let verdict = Verdict::HoldsLoose("sqrt(ln(1/theta)) at nu = 1/2".into());
    let claim = "gamma_theta(nu) <= C theta^(nu-1/2), C ln(1/theta), C for nu < 1/2, = 1/2, > 1/2";
    Ok(Headline::new("Lemma 5.2", claim, table, measured, verdict))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
