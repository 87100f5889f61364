//! Lemma 5.1 (Peetre-Tartar): the constant α in α ‖u‖_ν ≤ |u|_ν for the spaces of Lemma 5.2.
//!
//! With X = V_θ, A u the difference quotient and T the embedding into L², ‖u‖_ν² = ‖u‖₀² + |u|_ν², so the best constant is
//! α = (1 + γ_θ²)^{−1/2}. It stays positive for every θ > 0, as the lemma says, and goes to zero with θ unless ν > 1/2.
//!
//! `cargo run --release --example lemma_5_1_peetre_tartar`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::poincare::{Condition, Zone, extremal};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Result, Tolerance};
use std::process::ExitCode;

/// The constant alpha of the Peetre-Tartar lemma for functions of mean zero on (0, theta)
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (0, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
    pub nu: Vec<FractionalOrder>,
    /// Lengths theta of the zone
    #[arg(long, value_delimiter = ',', default_values = ["1", "1e-1", "1e-2", "1e-4", "1e-8"])]
    pub theta: Vec<f64>,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value_t = Tolerance::balanced())]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["lemma_5_1_peetre_tartar"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Second road: |u|/‖u‖_ν of the interpolated extremal function, seminorm and norm of the Sobolev room; agreement to this.
const AGREEMENT: f64 = 1e-3;

/// Computes α from γ and checks it on the extremal function.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("theta", "theta", Format::Plain, ""),
        Column::new("gamma", "gamma", Format::Significant(9), ""),
        Column::new("alpha", "alpha", Format::Significant(9), "(1 + gamma^2)^(-1/2)"),
        Column::new(
            "quotient",
            "|u|/||u||",
            Format::Significant(6),
            "of the extremal function, interpolated, by another road",
        ),
    ]);
    let mut chart = Chart::new(
        "Peetre-Tartar constants",
        Axis::logarithmic("θ, length of the zone (interval = 1)"),
        Axis::logarithmic("α, constant of the lemma"),
    );
    let (mut smallest, mut apart) = (1.0_f64, 0.0_f64);
    for &nu in &options.nu {
        let mut curve = Vec::new();
        for &theta in &options.theta {
            let (gamma, function) = extremal(nu, Zone::end(theta)?, Condition::MeanZero, options.tolerance)?;
            let alpha = 1.0 / gamma.value.hypot(1.0);
            let trial = function.interpolate(2, 6, &[])?;
            let seminorm = trial.seminorm(nu, Tolerance::fast())?.value;
            let quotient = seminorm / seminorm.hypot(trial.l2_norm(Tolerance::reference())?.value);
            smallest = smallest.min(alpha);
            apart = apart.max((quotient / alpha - 1.0).abs());
            curve.push((theta, alpha));
            table.push(vec![
                nu.value().into(),
                theta.into(),
                gamma.value.into(),
                alpha.into(),
                quotient.into(),
            ]);
        }
        chart = chart.with(Series::line_and_points(format!("ν = {nu}"), curve));
    }
    let measured = format!("smallest alpha {smallest:.6e}; second road within {apart:.0e}");
    let verdict = if smallest > 0.0 && apart < AGREEMENT {
        Verdict::Holds
    } else {
        Verdict::NotConfirmed(format!("the two roads differ by {apart:e}"))
    };
    let claim = "alpha ||u||_X <= ||A u||_Y with alpha > 0 on the functions of mean zero over (0, theta)";
    let mut headline = Headline::new("Lemma 5.1", claim, table, measured, verdict);
    headline.quote("lemma.5.1.smallest.alpha", smallest);
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "lemma_5_1_peetre_tartar")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
