//! The induction (5.5)-(5.9) in the proof of Lemma 5.2, every factor beside its bound.
//!
//! From θ to θ²: γ_{θ²} ≤ γ_θ (1 + θ^{ν−1/2}), hence γ at θ₀^{2ⁿ} is at most γ_{θ₀} times a product. (5.7) is followed on the extremal
//! function u of V_{θ²}: |c| ≤ ‖u‖_{0,(0,1)} ≤ γ_θ |u|_{ν,(0,1)} in the scaled variable, c its mean over (0,θ).
//!
//! `cargo run --release --example lemma_5_2_induction`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::poincare::{Condition, ExtremalFunction, Zone, extremal};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Error, Result, Tolerance};
use std::process::ExitCode;

/// Every step of the induction (5.5)-(5.9) beside its bound
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (0, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
    pub nu: Vec<FractionalOrder>,
    /// Where the induction starts
    #[arg(long, default_value_t = 0.5)]
    pub theta: f64,
    /// How often theta is squared
    #[arg(long, default_value_t = 5)]
    pub steps: u32,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value_t = Tolerance::balanced())]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["lemma_5_2_induction"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

fn columns() -> Vec<Column> {
    vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("theta", "theta^2", Format::Scientific(1), "length after the step"),
        Column::new("gamma", "gamma", Format::Significant(8), "its constant"),
        Column::new("factor", "factor", Format::Significant(5), "gamma at theta^2 over gamma at theta"),
        Column::new("bound", "(5.8)", Format::Significant(5), "1 + theta^(nu-1/2)"),
        Column::new("mean", "(5.7) a", Format::Significant(4), "|c| / ||u||_{0,(0,1)}, at most 1"),
        Column::new(
            "poincare",
            "(5.7) b",
            Format::Significant(4),
            "||u||_{0,(0,1)} / (gamma_theta |u|_{nu,(0,1)}), at most 1",
        ),
        Column::new(
            "restriction",
            "(5.7) c",
            Format::Significant(4),
            "|u|_{nu,(0,1)} / |u|_{nu,I}, at most 1",
        ),
        Column::new("product", "(5.9)", Format::Significant(5), "gamma over its bound by the product"),
    ]
}

/// The three quotients of (5.7) for the extremal function of V_{θ²}, in the variable x/θ.
fn restricted(nu: FractionalOrder, theta: f64, gamma: f64, u: &ExtremalFunction) -> Result<[f64; 3]> {
    let whole = u.interpolate(2, 6, &[theta])?;
    let inside = whole.partition().nodes().iter().filter(|&&x| x <= theta * (1.0 + 1e-12)).count() - 1;
    let part = whole.restrict(0..inside)?;
    // (5.5): |u|_I = θ^{ν−1/2} |ũ|, ‖u‖ = θ^{−1/2} ‖ũ‖
    let scale = theta.powf(nu.offset());
    let seminorm = part.seminorm(nu, Tolerance::fast())?.value * scale;
    let everywhere = whole.seminorm(nu, Tolerance::fast())?.value * scale;
    let norm = part.l2_norm(Tolerance::reference())?.value / theta.sqrt();
    Ok([
        part.mean(Tolerance::reference())?.value.abs() / norm,
        norm / (gamma * seminorm),
        seminorm / everywhere,
    ])
}

/// Squares θ step by step.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(columns());
    let mut chart = Chart::new(
        "γ over the bound (5.9)",
        Axis::logarithmic("θ, length of the zone (interval = 1)"),
        Axis::logarithmic("constant over its bound"),
    );
    let mut worst = 0.0_f64;
    Error::require("steps", f64::from(options.steps), "[1, 9]", (1..=9).contains(&options.steps))?;
    Error::require("theta", options.theta, "(0, 1), its powers above 1e-300", admissible(options))?;
    for &nu in &options.nu {
        let solve = |theta: f64| extremal(nu, Zone::end(theta)?, Condition::MeanZero, options.tolerance);
        let mut theta = options.theta;
        let mut gamma = solve(theta)?.0.value;
        let mut bound = gamma;
        let mut curve = Vec::new();
        for _ in 0..options.steps {
            let (next, function) = solve(theta * theta)?;
            let step = 1.0 + theta.powf(nu.offset());
            bound *= step;
            let [a, b, c] = restricted(nu, theta, gamma, &function)?;
            let (factor, product) = (next.value / gamma, next.value / bound);
            worst = [factor / step, product, a, b, c].into_iter().fold(worst, f64::max);
            theta *= theta;
            gamma = next.value;
            curve.push((theta, product));
            let mut row = vec![nu.value().into()];
            row.extend([theta, gamma, factor, step, a, b, c, product].map(Into::into));
            table.push(row);
        }
        chart = chart.with(Series::line_and_points(format!("ν = {nu}"), curve));
    }
    let measured = format!("largest quotient of a quantity by its bound: {worst:.4}");
    let verdict = if worst <= 1.0 {
        Verdict::HoldsLoose("one power of 2 per step at nu = 1/2, where gamma grows by sqrt(2)".into())
    } else {
        Verdict::NotConfirmed(format!("a bound is exceeded by the factor {worst}"))
    };
    let claim =
        "gamma at theta^2 <= gamma at theta times (1 + theta^(nu-1/2)), and the product of these factors";
    let mut headline = Headline::new("(5.5)-(5.9)", claim, table, measured, verdict);
    headline.quote("lemma.5.2.induction.worst", worst);
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "lemma_5_2_induction")?);
    }
    Ok(headline)
}

/// θ^(2^steps) is the shortest zone; on the whole interval no function is restricted.
fn admissible(options: &Options) -> bool {
    let last = options.theta.powf(2f64.powi(options.steps as i32));
    options.theta < 1.0 && last >= 1e-300
}

fn main() -> ExitCode {
    example_frame::main(run)
}
