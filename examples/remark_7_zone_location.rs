//! Remark 7: the constants hold wherever the zone lies.
//!
//! The statement: γ for (a, a+θ) is never above γ for (0, θ) in any case computed, hence of the same order. The printed proof cuts
//! the interval inside the zone and uses Lemma 5.2 on both pieces, as if the mean over each half of the zone were zero. Take the zone in the
//! middle, v on (0,1/2) vanishing on the last ε ≪ θ and extremal for that, and u = v on the left, −v reflected on the right: u has mean zero
//! over the zone, and on the left piece ‖u‖₀/(|I₁|^ν |u|_ν) is the constant of ε, not of θ. Repair: with m the mean of u over (0,1),
//! ‖u‖₀² = ‖u − m‖₀² + m² ≤ (γ₁² + N²)|u|_ν², N the dual norm of 1_E/|E| − 1, of order θ^{ν−1/2}, √ln(1/θ), 1 by Hölder and Sobolev for any set E.
//!
//! `cargo run --release --example remark_7_zone_location`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::poincare::{Condition, Zone, gamma, two_sided};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Result, Tolerance};
use std::process::ExitCode;

/// Poincare constants of zones at several places, the printed step and its repair
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (0, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
    pub nu: Vec<FractionalOrder>,
    /// Length theta of the zone
    #[arg(long, default_value_t = 1e-3)]
    pub theta: f64,
    /// Places a, as fractions of 1 - theta
    #[arg(long, value_delimiter = ',', default_values = ["0", "1e-4", "1e-2", "0.1", "0.25", "0.5"])]
    pub at: Vec<f64>,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value_t = Tolerance::balanced())]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["remark_7_zone_location"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// ε/θ: where the odd function of the counterexample starts to differ from zero.
const SHARE: f64 = 1e-3;

/// Compares places, then the printed step with its repair.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("a", "a", Format::Significant(3), "start of the zone"),
        Column::new("gamma", "gamma", Format::Significant(9), "its constant"),
        Column::new("ratio", "/end", Format::Significant(6), "over the constant of (0, theta), at most 1"),
        Column::new("repair", "repair", Format::Significant(6), "(gamma_1^2 + N^2)^(1/2), at least gamma"),
        Column::new(
            "step",
            "printed step",
            Format::Significant(4),
            "||u|| / (gamma |I_1|^nu |u|) on (0,1/2) for the odd function; the proof needs at most 1",
        ),
    ]);
    let mut chart = Chart::new(
        "Where the zone lies",
        Axis::linear("a, start of the zone (interval = 1)"),
        Axis::linear("constant over that at the end"),
    );
    let (mut holds, mut least_step) = (true, f64::INFINITY);
    for &nu in &options.nu {
        let end = gamma(nu, Zone::end(options.theta)?, Condition::MeanZero, options.tolerance)?;
        // Scaled to (0,1), the left piece (0,1/2) has its zone, of relative length 2ε, at an end.
        let short = Zone::end(2.0 * SHARE * options.theta)?;
        let odd = gamma(nu, short, Condition::Vanishing, options.tolerance)?;
        let step = odd.value / end.value;
        least_step = least_step.min(step);
        let mut curve = Vec::new();
        for &fraction in &options.at {
            let zone = Zone::at(fraction * (1.0 - options.theta), options.theta)?;
            let found = two_sided(nu, zone, Condition::MeanZero, options.tolerance)?;
            let repair = found.whole.value.hypot(found.dual_norm.value);
            let ratio = found.gamma.value / end.value;
            holds &=
                ratio <= 1.0 + options.tolerance.relative() && found.gamma.value <= repair * (1.0 + 1e-9);
            curve.push((zone.start(), ratio));
            let row = [nu.value(), zone.start(), found.gamma.value, ratio, repair, step];
            table.push(row.map(Into::into).into());
        }
        chart = chart.with(Series::line_and_points(format!("ν = {nu}"), curve));
    }
    let measured =
        format!("the end is the worst place; the printed step fails by a factor of at least {least_step:.3}");
    let verdict = match (holds, least_step > 1.0) {
        (true, true) => Verdict::PrintedFormFails(
            "the step that splits the zone, for functions of mean zero; the statement holds".into(),
        ),
        (true, false) => Verdict::Holds,
        _ => Verdict::NotConfirmed("a zone inside has a larger constant than at the end".into()),
    };
    let claim = "the constants of Lemma 5.2 are valid wherever the zone of length theta lies";
    let mut headline = Headline::new("Remark 7", claim, table, measured, verdict);
    headline.quote("remark.7.printed.step", least_step);
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "remark_7_zone_location")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
