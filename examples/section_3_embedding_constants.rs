//! (3.6), (3.10), (4.12), (E3): the constants C(q) of H^ν(0,1) ⊂ L^q(0,1) and C(α) of H^{3/2}(0,1) ⊂ C^{0,α}.
//!
//! Lower bounds by functions found by an ascent, upper bounds by an inequality on the circle; growth like √q and (1−α)^{-1/2}.

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use signorini::figures::{Axis, Chart, Series};
use signorini::interpolation::{EmbeddingSpace, EndIncrements, critical_exponent, embedding_upper_bound};
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::sobolev::{FractionalOrder, Partition};
use signorini::{Error, Result};
use std::process::ExitCode;

/// C(q)/√q lies between these for q = 2 ... 200: below its limit (3/(4 pi² e))^(1/2) = 0.16721..., above 1/√2 at q = 2
const GROWTH: [f64; 2] = [0.167, 0.708];
/// Grading towards the end of the interval
const RATIO: f64 = 0.6;

/// Embedding constants: C(q) at nu = 1/2 and at critical exponents, C(alpha)
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Exponents q for nu = 1/2, comma separated; alpha = 1 - 1/q beside them
    #[arg(long, value_delimiter = ',', default_values = ["2", "3", "4", "6", "8", "12", "16", "24", "36", "50", "75", "100", "150", "200"])]
    pub q: Vec<f64>,
    /// Orders nu < 1/2, comma separated, taken at the critical exponent q = 2/(1 - 2 nu)
    #[arg(long, value_delimiter = ',', default_values = ["0.1", "0.3", "0.4", "0.45", "0.49"])]
    pub nu: Vec<FractionalOrder>,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["section_3_embedding_constants"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Layers that reach e^{-0.6 q}, beyond ln(1/θ) = q/2 where the extremal function is cut off.
fn layers(q: f64) -> usize {
    (30.0 + 0.6 * q / -RATIO.ln()) as usize
}

/// Both bounds for every q and nu.
pub fn run(options: &Options) -> Result<Headline> {
    let largest = options.q.iter().copied().fold(2.0, f64::max);
    Error::require("q", largest, "[2, 1000]", largest <= 1000.0)?;
    let mut table = Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("q", "q", Format::Significant(5), "for nu < 1/2 the critical exponent 2/(1-2 nu)"),
        Column::new("lower", "C(q) >=", Format::Fixed(6), "quotient of a function"),
        Column::new("upper", "C(q) <=", Format::Fixed(6), "for all functions"),
        Column::new("growth", ">= /sqrt(q)", Format::Fixed(4), "the lower bound over sqrt(q)"),
        Column::new("upper_growth", "<= /sqrt(q)", Format::Fixed(4), "the upper bound over sqrt(q)"),
        Column::new("alpha", "alpha", Format::Significant(5), "1 - 1/q"),
        Column::new(
            "hoelder",
            "C(alpha) >=",
            Format::Fixed(5),
            "from H^(3/2), pairs (0, theta); C(alpha) <= C(q)",
        ),
        Column::new(
            "hoelder_growth",
            "*(1-alpha)^(1/2)",
            Format::Fixed(4),
            "C(alpha) times (1-alpha)^(1/2) = q^(-1/2)",
        ),
    ]);
    let bar = progress((options.q.len() + options.nu.len()) as u64);
    let half = EmbeddingSpace::new(FractionalOrder::HALF, layers(largest), RATIO)?;
    let increments = EndIncrements::new(&Partition::geometric(layers(largest), RATIO, 1.0)?)?;
    let (mut bounded, mut ordered) = (true, true);
    let mut rows = Vec::new();
    for &q in &options.q {
        let lower = half.climb(q)?.quotient.value;
        let upper = embedding_upper_bound(FractionalOrder::HALF, q)?.value;
        let alpha = 1.0 - 1.0 / q;
        let hoelder = increments.constant(alpha)?.0.value;
        bounded &= lower >= GROWTH[0] * q.sqrt() && upper <= GROWTH[1] * q.sqrt();
        ordered &= lower <= upper * (1.0 + 1e-12) && hoelder <= upper;
        let row =
            [0.5, q, lower, upper, lower / q.sqrt(), upper / q.sqrt(), alpha, hoelder, hoelder / q.sqrt()];
        table.push(row.map(Cell::from).to_vec());
        rows.push(row);
        bar.inc(1);
    }
    for &order in &options.nu {
        let q = critical_exponent(order)?;
        Error::require("nu", order.value(), "(0, 1/2) for the critical exponent", q.is_finite())?;
        let lower = EmbeddingSpace::new(order, layers((4.0 * q).min(800.0)), RATIO)?.climb(q)?.quotient.value;
        let upper = embedding_upper_bound(order, q)?.value;
        ordered &= lower <= upper * (1.0 + 1e-12);
        table.push(
            [order.value(), q, lower, upper, lower / q.sqrt(), upper / q.sqrt()].map(Cell::from).to_vec(),
        );
        bar.inc(1);
    }
    let last = rows.last().map_or([f64::NAN; 9], |row| *row);
    let measured = format!(
        "C(q)/sqrt(q) between {} and {} for q = 2 ... {largest}; {:.4} <= C({})/sqrt({}) <= {:.4}",
        GROWTH[0], GROWTH[1], last[4], last[1], last[1], last[5]
    );
    let verdict = match (bounded, ordered) {
        (true, true) => Verdict::Holds,
        (false, true) => Verdict::NotConfirmed("C(q)/sqrt(q) leaves the printed constants".into()),
        _ => Verdict::NotConfirmed("a lower bound exceeds its upper bound".into()),
    };
    let claim = "H^nu(0,1) embeds in L^q(0,1), q <= 2/(1-2 nu); C(q) grows like sqrt(q) at nu = 1/2";
    let mut headline = Headline::new("Sec. 3, C(q)", claim, table, measured, verdict);
    for row in &rows {
        headline.quote(format!("section_3_embedding.lower.q_{}", row[1]), row[2]);
        headline.quote(format!("section_3_embedding.upper.q_{}", row[1]), row[3]);
    }
    if let Some(directory) = options.output.directory()? {
        let series = |k: usize| rows.iter().map(|row| (row[1], row[k])).collect::<Vec<_>>();
        let limit = (3.0 / (4.0 * std::f64::consts::PI.powi(2) * 1f64.exp())).sqrt();
        let chart = Chart::new(
            "C(q) of H^(1/2)(0,1) in L^q(0,1)",
            Axis::logarithmic("q, exponent"),
            Axis::logarithmic("C(q), embedding constant"),
        )
        .with(Series::line_and_points("upper bound", series(3)))
        .with(Series::line_and_points("lower bound", series(2)))
        .with(Series::line_and_points("C(alpha), alpha = 1 - 1/q, lower bound", series(7)))
        .with(Series::dashed("0.1672 sqrt(q)", rows.iter().map(|r| (r[1], limit * r[1].sqrt())).collect()));
        headline.figures.push(chart.save(directory, "section_3_embedding_constants")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
