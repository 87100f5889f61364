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
    let mut decline = None;
    let mut curves = Vec::new();
    for &nu in &options.nu {
        let (mut ratios, mut computed, mut theory) = (Vec::new(), Vec::new(), Vec::new());
        for &theta in &options.theta {
            let start = Instant::now();
            let estimate = gamma(nu, Zone::end(theta)?, options.condition, options.tolerance)?;
            let seconds = start.elapsed().as_secs_f64();
            let printed = estimate.value / printed_growth(nu, theta);
            let law = (theta <= 0.5).then(|| true_law(nu, theta, options.tolerance)).transpose()?;
            ratios.extend((theta <= 0.5).then_some(printed));
            computed.push((theta, estimate.value));
            theory.extend(law.map(|law| (theta, law)));
            table.push(vec![
                nu.value().into(),
                theta.into(),
                estimate.value.into(),
                estimate.error.into(),
                printed.is_finite().then_some(printed).into(),
                law.map(|law| estimate.value / law).into(),
                seconds.into(),
            ]);
        }
        if nu.offset() == 0.0 && ratios.len() > 1 {
            decline = Some(ratios[ratios.len() - 1] / ratios[0]);
        }
        curves.push((nu, computed, theory));
    }
    let (measured, verdict) = match decline {
        Some(decline) => (
            format!(
                "at nu = 1/2 gamma/ln(1/theta) falls to {decline:.3} of its first value: sqrt(ln), not ln"
            ),
            Verdict::HoldsLoose("sqrt(ln(1/theta)) at nu = 1/2".into()),
        ),
        None => ("gamma against both laws, row by row".to_owned(), Verdict::Holds),
    };
    let claim = "gamma_theta(nu) <= C theta^(nu-1/2), C ln(1/theta), C for nu < 1/2, = 1/2, > 1/2";
    let mut headline = Headline::new("Lemma 5.2", claim, table, measured, verdict);
    for (nu, computed, _) in &curves {
        for &(theta, gamma) in computed {
            headline.quote(format!("lemma.5.2.gamma.nu{nu}.theta{theta:e}"), gamma);
        }
    }
    headline.quote("lemma.5.2.slope.end", 3.0 / (2.0 * PI * PI));
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart(curves).save(directory, "lemma_5_2_gamma")?);
    }
    Ok(headline)
}

/// Order, computed constants, law that holds.
type Curve = (FractionalOrder, Vec<(f64, f64)>, Vec<(f64, f64)>);

/// γ_θ(ν) against θ: points computed, dashed the law that holds as θ → 0.
fn chart(curves: Vec<Curve>) -> Chart {
    let x = Axis::logarithmic("θ, length of the zone (interval = 1)");
    let mut chart =
        Chart::new("Poincaré constants of Lemma 5.2", x, Axis::logarithmic("γ, Poincaré constant"));
    for (k, (nu, computed, law)) in curves.into_iter().enumerate() {
        let colour = PALETTE[k % PALETTE.len()];
        chart = chart
            .with(Series::points(format!("ν = {nu}, computed"), computed).colour(colour))
            .with(Series::dashed(format!("ν = {nu}, law as θ → 0"), law).colour(colour));
    }
    chart
}

fn main() -> ExitCode {
    example_frame::main(run)
}
