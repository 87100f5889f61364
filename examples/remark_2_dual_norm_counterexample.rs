//! Remark 2: ‖u − I^h u‖ in the dual norm of H^{1/2} is no better than h^{3/2} for u ∈ H^{3/2}: Falk's route ends at h^{3/4}.
//!
//! A wave per element is aliased to a constant. For comparison a smooth function, where the dual norm is of order h².

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::figures::{Axis, Chart, Series};
use signorini::interpolation::{AliasedWave, DualNorm, ErrorNorm, all_waves_mean, element_constant};
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::sobolev::{FractionalOrder, Partition};
use signorini::{Error, Estimate, Result, Tolerance};
use std::process::ExitCode;

/// Distance of a measured exponent from the theoretical one that counts as agreement
const EXPONENT_TOLERANCE: f64 = 0.02;

/// Cells per element in the dual norm of the smooth function
const CELLS: usize = 4;

/// The interpolation error in the dual norm of H^(1/2): a family at h^(3/2), a smooth function at h^2
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Elements of the coarsest mesh
    #[arg(long, default_value_t = 16)]
    pub elements: usize,
    /// Meshes, each with twice the elements of the one before
    #[arg(long, default_value_t = 5)]
    pub meshes: usize,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["remark_2_dual_norm_counterexample"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// ‖u − I^h u‖_{1/2,*} for the smooth function u = −e^x on N equal elements.
fn smooth_error(elements: usize) -> Result<Estimate> {
    let cells = Partition::uniform(elements * CELLS, 1.0)?;
    let h = 1.0 / elements as f64;
    DualNorm::new(&cells)?.of(|cell, t| {
        let (element, s) = (cell / CELLS, ((cell % CELLS) as f64 + t) / CELLS as f64);
        // e^{x₀} ((1−s) + s e^h − e^{sh}), with differences from 1
        (h * element as f64).exp() * (s * h.exp_m1() - (s * h).exp_m1())
    })
}

/// Measures both exponents.
pub fn run(options: &Options) -> Result<Headline> {
    let count = options.meshes;
    if !(2..=20).contains(&count) {
        return Err(Error::CountOutOfRange { name: "meshes", value: count, range: "2..=20" });
    }
    let levels: Vec<usize> = (0..count).map(|k| options.elements.saturating_mul(1 << k)).collect();
    if options.elements == 0 || levels[count - 1] > 1024 {
        let range = "at least 1 on the first and at most 1024 on the last mesh";
        return Err(Error::CountOutOfRange { name: "elements", value: levels[count - 1], range });
    }
    let mut table = Table::new(vec![
        Column::new("elements", "elements", Format::Significant(6), ""),
        Column::new(
            "wave",
            "wave",
            Format::Scientific(4),
            "|u - Iu|_(1/2,*) / |u|_(3/2), u = cos(2 pi x/h) - 1",
        ),
        Column::new("wave_rate", "rate", Format::Fixed(4), "its observed exponent"),
        Column::new("falk", "Falk", Format::Fixed(4), "half of it: the rate left for |u - u^h|_1"),
        Column::new("bound", "bound", Format::Scientific(4), "C_L2(1/2) h^(3/2), which no u can exceed"),
        Column::new("smooth", "smooth", Format::Scientific(4), "|u - Iu|_(1/2,*), u = -exp(x)"),
        Column::new("smooth_rate", "rate", Format::Fixed(4), "its observed exponent"),
    ]);
    let best = element_constant(ErrorNorm::L2, FractionalOrder::HALF, Tolerance::balanced())?.value;
    let mut points: Vec<[f64; 4]> = Vec::new();
    let mut rates = [f64::NAN; 2];
    for &elements in &levels {
        let h = 1.0 / elements as f64;
        let row = [
            h,
            AliasedWave::new(elements)?.quotient()?.value,
            smooth_error(elements)?.value,
            best * h.powf(1.5),
        ];
        let rate = |k: usize| points.last().map(|last| (last[k] / row[k]).log2());
        let observed = [rate(1), rate(2)];
        rates = observed.map(|r| r.unwrap_or(f64::NAN));
        table.push(vec![
            Cell::from(elements),
            row[1].into(),
            observed[0].into(),
            observed[0].map(|r| 0.5 * r).into(),
            row[3].into(),
            row[2].into(),
            observed[1].into(),
        ]);
        points.push(row);
    }
    // One function for every h: the exponent between 2^-170 and 2^-340, from below.
    let one = (all_waves_mean(170, 0.6)?.value / all_waves_mean(340, 0.6)?.value).log2() / 170.0;
    let confirmed = (rates[0] - 1.5).abs() <= EXPONENT_TOLERANCE
        && (rates[1] - 2.0).abs() <= EXPONENT_TOLERANCE
        && (one - 1.5).abs() <= EXPONENT_TOLERANCE
        && points.iter().all(|row| row[1] <= row[3]);
    let measured = format!(
        "h^{:.3} for the wave of each mesh (h^{:.3} after the square root), at best h^{one:.3} for one function on all meshes, h^{:.3} for a smooth one",
        rates[0],
        0.5 * rates[0],
        rates[1]
    );
    let verdict = if confirmed { Verdict::Holds } else { Verdict::NotConfirmed("an exponent is off".into()) };
    let claim = "|u_N - I^h u_N| in the dual norm of H^(1/2) is no better than h^(3/2) for u_N in H^(3/2)";
    let mut headline = Headline::new("Remark 2", claim, table, measured, verdict);
    headline.quote("remark_2.wave_rate", rates[0]);
    headline.quote("remark_2.smooth_rate", rates[1]);
    headline.quote("remark_2.one_function_rate", one);
    if let Some(directory) = options.output.directory()? {
        let series = |k: usize| points.iter().map(|row| (row[0], row[k])).collect::<Vec<_>>();
        let y = Axis::logarithmic("|u - Iu| in the dual norm of H^(1/2)");
        let chart = Chart::new(
            "Remark 2: aliasing in a dual norm",
            Axis::logarithmic("h, length of an element (interval = 1)"),
            y,
        )
        .with(Series::dashed("bound C h^(3/2)", series(3)))
        .with(Series::line_and_points("one wave per element, over |u|_(3/2)", series(1)))
        .with(Series::line_and_points("u = -exp(x)", series(2)));
        headline.figures.push(chart.save(directory, "remark_2_dual_norm_counterexample")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
