//! Lemma 6.1: ‖u − I u‖₀ ≤ h^{1+ν} |u|_{1+ν} and ‖u − I u‖₁ ≤ h^ν |u|_{1+ν} on an interval of length h, with constant 1.
//!
//! Rough functions drawn at random, powers at the edge of H^ν, and the best constants beside them.

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use signorini::figures::{Axis, Chart, Series};
use signorini::interpolation::{
    ErrorNorm, InterpolationError, RoughFamily, RoughSlopes, element_constant, longest_element, power_slope,
};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Estimate, Result, Tolerance};
use std::process::ExitCode;

/// Exponents of the powers tried, above the critical nu - 1/2
const GAPS: [f64; 7] = [1e-6, 1e-2, 0.1, 0.4, 0.8, 1.3, 2.0];

/// Local interpolation estimate: ratios of rough functions and the best constants
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (0, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.01", "0.1", "0.25", "0.5", "0.75", "0.9", "0.99"])]
    pub nu: Vec<FractionalOrder>,
    /// Random functions per family and order
    #[arg(long, default_value_t = 60)]
    pub functions: usize,
    /// Seed of the random functions
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Relative tolerance of the best constants: fast, balanced, reference or a number
    #[arg(long, default_value = "1e-10")]
    pub tolerance: Tolerance,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["lemma_6_1_local_estimate"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Largest (L2, derivative) ratio over random functions and powers.
fn worst_ratios(options: &Options, order: FractionalOrder) -> Result<(f64, f64)> {
    let mut worst = (0.0f64, 0.0f64);
    let mut try_on = |error: InterpolationError| -> Result<()> {
        worst = (worst.0.max(error.l2_ratio()?.value), worst.1.max(error.derivative_ratio()?.value));
        Ok(())
    };
    for family in RoughFamily::admissible(order) {
        let mut slopes = RoughSlopes::new(family, order, options.seed);
        for _ in 0..options.functions {
            try_on(InterpolationError::of_slope(&slopes.draw()?, order, Tolerance::balanced())?)?;
        }
    }
    for exponent in GAPS.map(|gap| order.offset() + gap).into_iter().filter(|a| *a != 0.0) {
        try_on(power_slope(exponent, order)?)?;
    }
    Ok(worst)
}

/// Tries the lemma on rough functions and compares with its best constants.
pub fn run(options: &Options) -> Result<Headline> {
    let number = |key, title: &str, format, meaning: &str| Column::new(key, title, format, meaning);
    let mut table = Table::new(vec![
        number("nu", "nu", Format::Plain, ""),
        number(
            "worst_l2",
            "found L2",
            Format::Fixed(4),
            "largest |u - Iu|_0 / (h^(1+nu) |u'|_nu) among the functions",
        ),
        number("best_l2", "best L2", Format::Fixed(10), "best constant in place of 1"),
        number("error_l2", "error", Format::Scientific(0), ""),
        number("worst_h1", "found H1", Format::Fixed(4), "largest |(u - Iu)'|_0 / (h^nu |u'|_nu)"),
        number("best_h1", "best H1", Format::Fixed(10), "best constant, gamma_1(nu)"),
        number("error_h1", "error", Format::Scientific(0), ""),
        number("longest", "h*", Format::Fixed(3), "with the full H1 norm the constant 1 holds for h <= h*"),
    ]);
    let bar = progress(options.nu.len() as u64);
    let (mut exceeded, mut constants) = (false, Vec::new());
    let mut shortest = f64::INFINITY;
    for &order in &options.nu {
        let best = |norm| element_constant(norm, order, options.tolerance);
        let (l2, h1): (Estimate, Estimate) = (best(ErrorNorm::L2)?, best(ErrorNorm::Derivative)?);
        let (found_l2, found_h1) = worst_ratios(options, order)?;
        let longest = longest_element(order, Tolerance::fast())?.value;
        exceeded |=
            found_l2 > l2.value * (1.0 + 1e-9) + l2.error || found_h1 > h1.value * (1.0 + 1e-9) + h1.error;
        shortest = shortest.min(longest);
        constants.push((order.value(), [found_l2, l2.value, found_h1, h1.value]));
        let cells = [order.value(), found_l2, l2.value, l2.error, found_h1, h1.value, h1.error, longest];
        table.push(cells.map(Into::into).to_vec());
        bar.inc(1);
    }
    let largest = |k: usize| constants.iter().map(|(_, row)| row[k]).fold(0.0, f64::max);
    let loose = format!(
        "{:.2} in L2 and {:.2} in the derivative at least; the full H1 norm needs h <= {shortest:.2}",
        1.0 / largest(1),
        1.0 / largest(3)
    );
    let verdict = if exceeded {
        Verdict::NotConfirmed("a function exceeds the best constant".into())
    } else {
        Verdict::HoldsLoose(loose)
    };
    let measured =
        format!("best constants at most {:.4} (L2) and {:.4} (derivative)", largest(1), largest(3));
    let claim =
        "|u - Iu|_0 <= h^(1+nu) |u|_(1+nu) and |u - Iu|_1 <= h^nu |u|_(1+nu) on an interval of length h";
    let mut headline = Headline::new("Lemma 6.1", claim, table, measured, verdict);
    for (nu, row) in &constants {
        headline.quote(format!("lemma_6_1.best_l2.nu_{nu}"), row[1]);
        headline.quote(format!("lemma_6_1.best_h1.nu_{nu}"), row[3]);
    }
    headline.quote("lemma_6_1.longest_element", shortest);
    if let Some(directory) = options.output.directory()? {
        let points = |k: usize| constants.iter().map(|(nu, row)| (*nu, row[k])).collect::<Vec<_>>();
        let chart = Chart::new(
            "Lemma 6.1: the constant 1 and the best ones",
            Axis::linear("nu"),
            Axis::linear("ratio"),
        )
        .with(Series::dashed("printed: 1", constants.iter().map(|(nu, _)| (*nu, 1.0)).collect()))
        .with(Series::line("best, derivative", points(3)))
        .with(Series::points("rough functions, derivative", points(2)))
        .with(Series::line("best, L2", points(1)))
        .with(Series::points("rough functions, L2", points(0)));
        headline.figures.push(chart.save(directory, "lemma_6_1_local_estimate")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
