//! Lemma 5.2: the Poincaré constant γ_θ(ν) against the printed laws and the true ones.
//!
//! (5.1)-(5.3) bound γ_θ by C θ^{ν−1/2}, C ln(1/θ) and C. The first and the third are the true orders; at ν = 1/2 the true
//! growth is √(3/(2π²) ln(1/θ)).
//!
//! `cargo run --release --example lemma_5_2_poincare_scaling -- --nu 0.3,1/2 --theta 1e-300 --zone centre`

use clap::Parser;
use example_frame::poincare::{extremal_chart, growth_chart};
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, PALETTE, Series};
use signorini::poincare::{
    Condition, END_SLOPE, ExplicitBound, LimitLaw, Place, Zone, gamma, growth, printed_growth, two_sided,
};
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use signorini::{Estimate, Result, Tolerance};
use std::f64::consts::LN_2;
use std::path::{Path, PathBuf};
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

/// One order: pairs (θ, γ), and (θ, law of the limit θ → 0) where one is known.
struct Curve {
    order: FractionalOrder,
    computed: Vec<(f64, Estimate)>,
    law: Vec<(f64, f64)>,
}

fn columns() -> Vec<Column> {
    vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("theta", "theta", Format::Plain, ""),
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
        Column::new("law", "/limit law", Format::Significant(7), "gamma / (law of the limit theta -> 0)"),
        Column::hidden("seconds"),
    ]
}

/// Growth between the last two zones, beside the law.
fn words(curve: &Curve) -> Result<String> {
    let nu = curve.order;
    let growth = growth(nu, &curve.computed)?.map_or(f64::NAN, |growth| growth.value);
    Ok(if nu.is_below_half() {
        format!("nu = {nu}: theta^{growth:.4}, law theta^{:.4}", nu.offset())
    } else if nu.offset() == 0.0 {
        format!("nu = 1/2: gamma^2 gains {growth:.6} per ln(1/theta); law {END_SLOPE:.6} at an end")
    } else {
        let last = curve.computed.last().map_or(f64::NAN, |(_, gamma)| gamma.value);
        let limit = curve.law.last().map_or(String::new(), |(_, law)| format!(", limit {law:.6}"));
        format!("nu = {nu}: {last:.6}{limit}")
    })
}

/// The explicit bounds, and by which factor (5.2) is loose or where it fails.
fn verdict_on(curve: &Curve, options: &Options) -> Result<Verdict> {
    let (nu, tolerance) = (curve.order, options.tolerance);
    if let Some(bound) = ExplicitBound::new(nu, options.condition, tolerance)? {
        for &(theta, gamma) in &curve.computed {
            let allowed = bound.at(theta)?.value;
            if gamma.value > allowed * (1.0 + 4.0 * tolerance.relative()) {
                let words = format!("{} > {allowed} at nu = {nu}, theta = {theta:e}", gamma.value);
                return Ok(Verdict::NotConfirmed(words));
            }
        }
    }
    if nu.offset() != 0.0 {
        return Ok(Verdict::Holds);
    }
    if let Some((theta, gamma)) = curve.computed.iter().find(|(theta, _)| *theta > 0.5) {
        let words = "but ln(1/theta) -> 0 as theta -> 1; it holds for theta <= 1/2";
        return Ok(Verdict::PrintedFormFails(format!(
            "gamma = {:.4} at theta = {theta}, {words}",
            gamma.value
        )));
    }
    let at_half = gamma(nu, Zone::end(0.5)?, Condition::MeanZero, tolerance)?.value / LN_2;
    Ok(curve.computed.last().map_or(Verdict::Holds, |(theta, gamma)| {
        let factor = at_half * -theta.ln() / gamma.value;
        Verdict::HoldsLoose(format!("a factor {factor:.3} at theta = {theta:e} (C from theta = 1/2)"))
    }))
}

/// Computes the table and compares both laws.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(columns());
    let (mut curves, mut ordered) = (Vec::new(), true);
    for &order in &options.nu {
        let law = LimitLaw::new(order, options.zone, options.condition, options.tolerance)?;
        let mut curve = Curve { order, computed: Vec::new(), law: Vec::new() };
        for &theta in &options.theta {
            let start = Instant::now();
            let zone = options.zone.zone(theta)?;
            let found = two_sided(order, zone, options.condition, options.tolerance)?;
            let seconds = start.elapsed().as_secs_f64();
            let gamma = found.gamma.value;
            ordered &= found.lower <= gamma && gamma <= found.upper;
            let printed = (theta < 1.0).then(|| gamma / printed_growth(order, theta));
            let law_here = law.as_ref().and_then(|law| Some(law.gamma(theta).ok()?.value));
            curve.computed.push((theta, found.gamma));
            curve.law.extend(law_here.map(|value| (theta, value)));
            let mut row: Vec<Cell> = vec![order.value().into(), theta.into(), zone.to_string().into()];
            row.extend([gamma, found.gamma.error, found.lower, found.upper].map(Cell::from));
            row.extend([printed.into(), law_here.map(|value| gamma / value).into(), seconds.into()]);
            table.push(row);
        }
        curves.push(curve);
    }
    let measured = curves.iter().map(words).collect::<Result<Vec<String>>>()?;
    let mut verdict = Verdict::Holds;
    for curve in &curves {
        verdict = verdict.graver(verdict_on(curve, options)?);
    }
    if !ordered {
        verdict = Verdict::NotConfirmed("a value lies outside its bounds".into());
    }
    let claim = "gamma_theta(nu) <= C theta^(nu-1/2), C ln(1/theta), C for nu < 1/2, = 1/2, > 1/2";
    let mut headline = Headline::new("Lemma 5.2", claim, table, measured.join("; "), verdict);
    for curve in &curves {
        for &(theta, gamma) in &curve.computed {
            headline.quote(format!("lemma.5.2.gamma.nu{}.theta{theta:e}", curve.order), gamma.value);
        }
    }
    headline.quote("lemma.5.2.slope.end", END_SLOPE);
    if let Some(directory) = options.output.directory()? {
        let name: String = options.nu.iter().map(|nu| format!("_{nu}").replace(['/', '.'], "_")).collect();
        let name = if options.nu.len() == 1 { name } else { String::new() };
        headline.figures.push(chart(curves).save(directory, &format!("lemma_5_2_gamma{name}"))?);
        if options.nu.len() > 1 {
            headline.figures.extend(frames(options, directory)?);
        }
    }
    Ok(headline)
}

/// Orders of the frames of the growth: both regimes and the border between them.
const FRAMES: [f64; 9] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];

/// Extremal functions, one frame per θ; growth of the constant of a zone at an end, one frame per ν.
fn frames(options: &Options, directory: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for &theta in options.theta.iter().filter(|&&theta| theta < 1.0) {
        let chart = extremal_chart(&options.nu, theta, Tolerance::fast())?;
        files.push(chart.save(directory, &format!("lemma_5_2_extremal_{theta:e}"))?);
    }
    for nu in FRAMES {
        let chart = growth_chart(FractionalOrder::new(nu)?, &options.theta, Tolerance::fast())?;
        files.push(chart.save(directory, &format!("lemma_5_2_growth_{nu}"))?);
    }
    Ok(files)
}

/// γ_θ(ν) against θ: points computed, dashed the law that holds as θ → 0.
fn chart(curves: Vec<Curve>) -> Chart {
    let x = Axis::logarithmic("θ, length of the zone (interval = 1)");
    let mut chart =
        Chart::new("Poincaré constants of Lemma 5.2", x, Axis::logarithmic("γ, Poincaré constant"));
    for (k, Curve { order, computed, law }) in curves.into_iter().enumerate() {
        let computed = computed.into_iter().map(|(theta, gamma)| (theta, gamma.value)).collect();
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
