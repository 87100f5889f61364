//! Lemma 5.2: the Poincaré constant γ_θ(ν) against the printed laws and the true ones.
//!
//! (5.1)-(5.3) bound γ_θ by C θ^{ν−1/2}, C ln(1/θ) and C. The first and the third are the true orders; at ν = 1/2 the true
//! growth is √(3/(2π²) ln(1/θ)).
//!
//! `cargo run --release --example lemma_5_2_poincare_scaling -- --nu 0.3,1/2 --theta 1e-300 --zone centre`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::poincare::{
    Condition, Place, UniformLaw, end_limit, gamma_at_point, interior_limit, printed_growth, two_sided,
};
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Result, Tolerance};
use std::process::ExitCode;
use std::time::Instant;

/// The Poincare constant of a zone of length theta in three regimes of nu, printed law and true law side by side
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (0, 1)
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
    pub nu: Vec<FractionalOrder>,
    /// Lengths theta of the zone
    #[arg(long, value_delimiter = ',', default_values = ["1e-1", "1e-2", "1e-3", "1e-4", "1e-5", "1e-6"])]
    pub theta: Vec<f64>,
    /// Where the zone is: end, centre, or its start a
    #[arg(long, default_value_t = Place::End)]
    pub zone: Place,
    /// What holds on the zone: mean-zero or vanishing
    #[arg(long, default_value_t = Condition::MeanZero)]
    pub condition: Condition,
    /// Relative tolerance: fast, balanced, reference or a number
    #[arg(long, default_value_t = Tolerance::balanced())]
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

/// A law in θ → 0, where one is known.
type Law = Box<dyn Fn(f64) -> Option<f64>>;

fn true_law(nu: FractionalOrder, options: &Options) -> Result<Law> {
    let power = |limit: f64| -> Law { Box::new(move |theta: f64| Some(limit * theta.powf(nu.offset()))) };
    let constant = |limit: f64| -> Law { Box::new(move |_| Some(limit)) };
    Ok(match (options.zone, options.condition) {
        (place, _) if nu.offset() > 0.0 => {
            let point = match place {
                Place::End => 0.0,
                Place::Centre => 0.5,
                Place::At(a) => a,
            };
            constant(gamma_at_point(nu, point, options.tolerance)?.value)
        }
        (Place::End, Condition::MeanZero) if nu.is_below_half() => power(end_limit(nu)?.value),
        (Place::End, Condition::MeanZero) => {
            let law = UniformLaw::new(nu, options.tolerance)?;
            Box::new(move |theta| law.gamma(theta).ok())
        }
        (_, Condition::MeanZero) if nu.is_below_half() => power(interior_limit(nu)?),
        _ => Box::new(|_| None),
    })
}

fn columns() -> Vec<Column> {
    vec![
        Column::new("nu", "nu", Format::Significant(3), ""),
        Column::new("theta", "theta", Format::Scientific(0), ""),
        Column::hidden("zone"),
        Column::new("gamma", "gamma", Format::Significant(11), "computed constant"),
        Column::new("error", "error", Format::Scientific(0), "its estimated error"),
        Column::new("lower", "lower", Format::Significant(7), "quotient of a function"),
        Column::new(
            "upper",
            "upper",
            Format::Significant(7),
            "from gamma_1 and a dual norm, no eigenproblem",
        ),
        Column::new(
            "printed",
            "/printed",
            Format::Significant(4),
            "gamma / (theta^(nu-1/2), ln(1/theta), 1)",
        ),
        Column::new("law", "/true", Format::Significant(7), "gamma / (true law as theta -> 0)"),
        Column::hidden("seconds"),
    ]
}

/// Computes the table and compares both laws.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(columns());
    let axes = (Axis::logarithmic("θ"), Axis::logarithmic("γ, its bounds and (dashed) the true law"));
    let mut chart = Chart::new("Poincaré constants of Lemma 5.2", axes.0, axes.1);
    let (mut decline, mut ordered) = (None, true);
    for &nu in &options.nu {
        let law = true_law(nu, options)?;
        let (mut curve, mut dashes, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
        for &theta in &options.theta {
            let start = Instant::now();
            let zone = options.zone.zone(theta)?;
            let found = two_sided(nu, zone, options.condition, options.tolerance)?;
            let seconds = start.elapsed().as_secs_f64();
            let gamma = found.gamma.value;
            ordered &= found.lower <= gamma && gamma <= found.upper;
            let printed = (theta < 1.0).then(|| gamma / printed_growth(nu, theta));
            ratios.extend(printed);
            curve.push((theta, gamma));
            dashes.extend(law(theta).map(|value| (theta, value)));
            let mut row: Vec<Cell> = vec![nu.value().into(), theta.into(), zone.to_string().into()];
            row.extend([gamma, found.gamma.error, found.lower, found.upper].map(Cell::from));
            row.extend([printed.into(), law(theta).map(|value| gamma / value).into(), seconds.into()]);
            table.push(row);
        }
        chart = chart.with(Series::line_and_points(format!("ν = {nu}"), curve));
        chart = chart.with(Series::dashed(format!("true law, ν = {nu}"), dashes));
        if let (0.0, [first, .., last]) = (nu.offset(), ratios.as_slice()) {
            decline = Some(last / first);
        }
    }
    let measured = decline.map_or("no row at nu = 1/2".to_owned(), |ratio| {
        format!("at nu = 1/2 gamma/ln(1/theta) falls to {ratio:.3} of its first value")
    });
    let verdict = if ordered {
        Verdict::HoldsLoose("sqrt(ln(1/theta)) at nu = 1/2, where gamma grows like sqrt(ln(1/theta))".into())
    } else {
        Verdict::NotConfirmed("a value lies outside its bounds".into())
    };
    let claim = "gamma_theta(nu) <= C theta^(nu-1/2), C ln(1/theta), C for nu < 1/2, = 1/2, > 1/2";
    let mut headline = Headline::new("Lemma 5.2", claim, table, measured, verdict);
    if let Some(ratio) = decline {
        headline.quote("lemma.5.2.decline", ratio);
    }
    if let Some(directory) = options.output.directory()? {
        headline.figures.push(chart.save(directory, "lemma_5_2_poincare_scaling")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
