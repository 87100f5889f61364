//! What accuracy costs: seconds against true error for every numerical function of the library.
//!
//! [`CASES`] is the one list; each entry is a function that returns rows of (asked, seconds, true error). A later room adds
//! one line to the list and one function.

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use signorini::figures::{Axis, Chart, Series};
use signorini::interpolation::{ErrorNorm, dual_projection_constant, element_constant};
use signorini::poincare::{Condition, Zone, gamma};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::{
    DualOf, FractionalOrder, GramOperator, Partition, PiecewisePolynomial, SingularFunction, closed_forms,
    gram_linears,
};
use signorini::{Result, Tolerance};
use std::process::ExitCode;
use std::time::Instant;

/// Seconds against true error
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Only cases whose name contains this
    #[arg(long, default_value = "")]
    pub case: String,
    /// Repetitions; the fastest counts
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    pub repeat: u32,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["speed_for_accuracy"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// One tolerance of one case.
pub struct Row {
    /// Relative tolerance.
    pub asked: f64,
    /// Seconds of the fastest run.
    pub seconds: f64,
    /// Relative error against a value computed another way.
    pub true_error: f64,
}

/// A case: its name and its rows, each timed as the fastest of some repetitions.
pub type Case = (&'static str, fn(u32) -> Result<Vec<Row>>);

/// Everything that is measured.
pub const CASES: [Case; 14] = [
    ("closure x^0.6, nu 0.25", |repeat| power(0.6, 0.25, repeat)),
    ("closure x^0.001, nu 1/2", |repeat| power(0.001, 0.5, repeat)),
    ("closure x^0.51, nu 0.99", |repeat| power(0.51, 0.99, repeat)),
    ("closure |ln x|^0.25, nu 1/2", logarithm),
    ("fast product, geometric 1e-30, N 2000", fast_product),
    ("hat on 1000 elements, nu 1/2", hat),
    ("dual norm of a constant", dual),
    ("interpolation C_L2, nu 1/2", |repeat| {
        interpolation(ErrorNorm::L2, 0.5, 0.092_742_524_652_174_63, repeat)
    }),
    ("interpolation C_H1, nu 0.99", |repeat| {
        interpolation(ErrorNorm::Derivative, 0.99, 0.032_024_593_023_715_79, repeat)
    }),
    ("projection C*, r 1/2", dual_projection),
    ("gamma, nu 0.25, theta 0.01", |repeat| poincare(0.25, Zone::end(1e-2)?, 1.656_712_117_564_16, repeat)),
    ("gamma, nu 0.49, theta 1e-300", |repeat| {
        poincare(0.49, Zone::end(1e-300)?, 2_758.865_095_337_738_5, repeat)
    }),
    ("gamma, nu 1/2, theta 1e-40", |repeat| poincare(0.5, Zone::end(1e-40)?, 3.738_285_316_256_439, repeat)),
    ("gamma, nu 0.99, theta 1e-4", |repeat| {
        poincare(0.99, Zone::end(1e-4)?, 0.064_321_434_320_780_88, repeat)
    }),
];

const TOLERANCES: [f64; 5] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11];

/// The value and the seconds of the fastest of `repeat` runs.
fn fastest<T>(repeat: u32, mut run: impl FnMut() -> Result<T>) -> Result<(T, f64)> {
    let mut seconds = f64::INFINITY;
    let mut timed = || -> Result<T> {
        let start = Instant::now();
        let value = run()?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
        Ok(value)
    };
    let mut value = timed()?;
    for _ in 1..repeat {
        value = timed()?;
    }
    Ok((value, seconds))
}

/// Rows of a function of the tolerance whose exact value is known.
fn rows(repeat: u32, exact: f64, value: impl Fn(Tolerance) -> Result<f64>) -> Result<Vec<Row>> {
    TOLERANCES
        .iter()
        .map(|&asked| {
            let tolerance = Tolerance::new(asked)?;
            let (value, seconds) = fastest(repeat, || value(tolerance))?;
            Ok(Row { asked, seconds, true_error: (value / exact - 1.0).abs() })
        })
        .collect()
}

fn power(a: f64, nu: f64, repeat: u32) -> Result<Vec<Row>> {
    let order = FractionalOrder::new(nu)?;
    let exact = closed_forms::power(a, order)?.value.sqrt();
    let u = SingularFunction::new(&[0.0, 1.0], |x: f64| x.powf(a))?;
    rows(repeat, exact, |tolerance| Ok(u.seminorm(order, tolerance)?.value))
}

fn logarithm(repeat: u32) -> Result<Vec<Row>> {
    let exact = closed_forms::log_power(0.25)?.value.sqrt();
    let u = SingularFunction::from_positions(&[0.0, 1.0], |at| match at.anchor() {
        0 => (-at.offset().ln()).powf(0.25),
        _ => (-at.offset().ln_1p()).powf(0.25),
    })?;
    rows(repeat, exact, |tolerance| Ok(u.seminorm(FractionalOrder::HALF, tolerance)?.value))
}

fn fast_product(repeat: u32) -> Result<Vec<Row>> {
    let n = 2000;
    let partition = Partition::geometric(n - 1, 1e-30f64.powf(1.0 / (n - 1) as f64), 1.0)?;
    let x: Vec<f64> = (0..=n).map(|i| ((i * 7919) % 1000) as f64 / 1000.0).collect();
    let matrix = gram_linears(&partition, FractionalOrder::HALF);
    let exact: Vec<f64> = (0..=n).map(|i| (0..=n).map(|j| matrix[(i, j)] * x[j]).sum()).collect();
    let largest = exact.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let row = |&asked: &f64| {
        let operator = GramOperator::linears(&partition, FractionalOrder::HALF, Tolerance::new(asked)?)?;
        let (y, seconds) = fastest(repeat, || operator.apply(&x))?;
        let worst = y.iter().zip(&exact).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        Ok(Row { asked, seconds, true_error: worst / largest })
    };
    TOLERANCES.iter().map(row).collect()
}

fn hat(repeat: u32) -> Result<Vec<Row>> {
    let values: Vec<f64> = (0..=1000).map(|i| f64::from(500 - (i - 500i32).abs()) / 500.0).collect();
    let u = PiecewisePolynomial::linears(Partition::uniform(1000, 1.0)?, &values)?;
    let exact = closed_forms::hat(0.0, 0.5, 0.5, 0.0, FractionalOrder::HALF)?.value.sqrt();
    rows(repeat, exact, |tolerance| Ok(u.seminorm(FractionalOrder::HALF, tolerance)?.value))
}

fn dual(repeat: u32) -> Result<Vec<Row>> {
    let u = PiecewisePolynomial::constants(Partition::uniform(8, 1.0)?, &[1.0; 8])?;
    rows(repeat, 1.0, |tolerance| {
        Ok(u.dual_norm(DualOf::Slobodeckij, FractionalOrder::HALF, tolerance)?.value)
    })
}

/// Best constants of Lemma 6.1 against values from hp functions in ball arithmetic.
fn interpolation(norm: ErrorNorm, nu: f64, exact: f64, repeat: u32) -> Result<Vec<Row>> {
    let order = FractionalOrder::new(nu)?;
    rows(repeat, exact, |tolerance| Ok(element_constant(norm, order, tolerance)?.value))
}

/// (4.7) at r = 1/2, where the best constant is γ₁(1/2)².
fn dual_projection(repeat: u32) -> Result<Vec<Row>> {
    let whole: f64 = 0.291_564_029_207_657_16;
    rows(repeat, whole * whole, |tolerance| Ok(dual_projection_constant(0.5, tolerance)?.value))
}

/// Lemma 5.2: γ_θ(ν) against values of Galerkin methods in ball arithmetic.
fn poincare(nu: f64, zone: Zone, exact: f64, repeat: u32) -> Result<Vec<Row>> {
    let order = FractionalOrder::new(nu)?;
    rows(repeat, exact, |tolerance| Ok(gamma(order, zone, Condition::MeanZero, tolerance)?.value))
}

/// Measures every case.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("case", "case", Format::Significant(6), ""),
        Column::new("asked", "asked", Format::Scientific(0), "relative tolerance"),
        Column::new("seconds", "seconds", Format::Scientific(2), "fastest run"),
        Column::new(
            "true_error",
            "true error",
            Format::Scientific(1),
            "relative, against a value computed another way",
        ),
    ]);
    let chosen: Vec<&Case> = CASES.iter().filter(|(name, _)| name.contains(&options.case)).collect();
    let mut chart = Chart::new(
        "What accuracy costs",
        Axis::logarithmic("seconds"),
        Axis::logarithmic("true relative error"),
    );
    let bar = progress(chosen.len() as u64);
    let (mut met, mut count) = (0, 0);
    for (name, measure) in chosen {
        let rows = measure(options.repeat)?;
        for row in &rows {
            (met, count) = (met + usize::from(row.true_error <= row.asked), count + 1);
            table.push(vec![(*name).into(), row.asked.into(), row.seconds.into(), row.true_error.into()]);
        }
        // An error of zero is drawn where binary64 ends.
        let points = rows.iter().map(|row| (row.seconds, row.true_error.max(f64::EPSILON))).collect();
        chart = chart.with(Series::line_and_points(*name, points));
        bar.inc(1);
    }
    let verdict = if count == 0 {
        Verdict::NotConfirmed("no case has a name like that".into())
    } else if met == count {
        Verdict::Holds
    } else {
        Verdict::NotConfirmed(format!("{} of {count} rows miss their tolerance", count - met))
    };
    let claim = "a looser tolerance costs less, and every tolerance is met";
    let mut headline = Headline::new(
        "Speed for accuracy",
        claim,
        table,
        format!("{met} of {count} rows meet their tolerance"),
        verdict,
    );
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "speed_for_accuracy_seconds")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
