//! The paper in one run: its main arguments computed, one row each with claim, measured, verdict and seconds.
//!
//! `cargo run --release --example tour -- --out out`

use clap::Parser;
use example_frame::{HasOutput, Output, Result, progress};
use signorini::contact::Cone;
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::sobolev::FractionalOrder;
use std::process::ExitCode;
use std::time::Instant;

/// The main arguments of the paper: claim, measured, verdict, seconds
#[derive(Debug, Clone, Default, Parser)]
pub struct Options {
    /// Smaller meshes and fewer values: a few seconds instead of up to a minute
    #[arg(long)]
    pub quick: bool,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Options {
    /// Squares along each side of the contact scenes.
    fn size(&self) -> usize {
        if self.quick { 16 } else { 32 }
    }

    /// Regularities τ of the rate studies.
    fn regularities(&self) -> Vec<f64> {
        if self.quick { vec![1.75] } else { vec![1.55, 1.75, 1.95] }
    }

    /// Rough functions of each family tried on Lemma 6.1.
    fn functions(&self) -> usize {
        if self.quick { 4 } else { lemma_6_1_local_estimate::Options::default().functions }
    }

    /// Lengths θ of the zones of Lemma 5.2.
    fn zones(&self) -> Vec<f64> {
        (1..=if self.quick { 3 } else { 6 }).map(|k| 10f64.powi(-k)).collect()
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// The examples are the rows: each file is loaded here, so that tour, example, test and book cannot disagree.
macro_rules! example {
    ($name:ident, $file:literal) => {
        #[path = $file]
        #[allow(dead_code, reason = "only `run` is used here")]
        mod $name;
    };
}
example!(section_2_elastic_contact, "section_2_elastic_contact.rs");
example!(section_2_scalar_contact, "section_2_scalar_contact.rs");
example!(figure_3_2_alternative, "figure_3_2_alternative.rs");
example!(figure_4_1_alternative, "figure_4_1_alternative.rs");
example!(lemma_5_2_poincare_scaling, "lemma_5_2_poincare_scaling.rs");
example!(lemma_6_1_local_estimate, "lemma_6_1_local_estimate.rs");
example!(theorem_3_1_rates, "theorem_3_1_rates.rs");
example!(theorem_4_1_rates, "theorem_4_1_rates.rs");

/// What an example says, as far as a row needs it.
struct Told {
    words: [String; 4],
    confirmed: bool,
    misprinted: bool,
    figures: Vec<std::path::PathBuf>,
    values: Vec<(String, f64)>,
}

impl From<Headline> for Told {
    fn from(headline: Headline) -> Self {
        let confirmed = headline.verdict.is_confirmed();
        let misprinted = matches!(headline.verdict, Verdict::PrintedFormFails(_));
        let words = [headline.label, headline.claim, headline.measured, headline.verdict.to_string()];
        Self { words, confirmed, misprinted, figures: headline.figures, values: headline.values }
    }
}

impl From<example_frame::Headline> for Told {
    fn from(headline: example_frame::Headline) -> Self {
        let (verdict, measured) = (headline.verdict(), headline.measured());
        let misprinted = matches!(verdict, example_frame::Verdict::PrintedFormFails(_));
        let words = [headline.label, headline.claim, measured, verdict.to_string()];
        let confirmed = verdict.is_confirmed();
        Self { words, confirmed, misprinted, figures: headline.figures, values: headline.values }
    }
}

/// One row: how to compute it.
type Row = Box<dyn Fn(&Options) -> Result<Told>>;

/// A row that runs an example with some of its options set from those of the tour.
macro_rules! row {
    ($tour:ident: $example:ident $(, $field:ident = $value:expr)*) => {
        Box::new(|$tour: &Options| {
            let output = Output { values: None, ..$tour.output.clone() };
            #[allow(clippy::needless_update, reason = "some examples have no other option")]
            let options = $example::Options { $($field: $value,)* output, ..Default::default() };
            Ok(Told::from($example::run(&options)?))
        })
    };
}

fn rows() -> Vec<Row> {
    vec![
        row!(tour: section_2_elastic_contact, n = tour.size()),
        row!(tour: section_2_scalar_contact, n = tour.size()),
        row!(tour: section_2_elastic_contact, n = tour.size(), cone = Cone::Midpoint),
        row!(tour: section_2_scalar_contact, n = tour.size(), cone = Cone::Midpoint),
        row!(tour: figure_3_2_alternative, n = tour.size()),
        row!(tour: figure_4_1_alternative, n = tour.size()),
        row!(tour: lemma_5_2_poincare_scaling, nu = vec![FractionalOrder::new(0.25)?], theta = tour.zones()),
        row!(tour: lemma_5_2_poincare_scaling, nu = vec![FractionalOrder::HALF], theta = tour.zones()),
        row!(tour: lemma_5_2_poincare_scaling, nu = vec![FractionalOrder::new(0.75)?], theta = tour.zones()),
        row!(tour: lemma_6_1_local_estimate, functions = tour.functions()),
        row!(tour: theorem_3_1_rates, tau = tour.regularities()),
        row!(tour: theorem_4_1_rates, tau = tour.regularities()),
    ]
}

/// Runs every row and gathers their headlines.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::words("label", "label", 12),
        Column::words("claim", "claim", 26),
        Column::words("measured", "measured", 27),
        Column::words("verdict", "verdict", 17),
        Column::new("seconds", "s", Format::Significant(2), ""),
    ]);
    let (mut figures, mut values) = (Vec::new(), Vec::new());
    let (mut unconfirmed, mut misprinted) = (Vec::new(), Vec::new());
    let rows = rows();
    let (bar, started) = (progress(rows.len() as u64), Instant::now());
    for row in &rows {
        let row_started = Instant::now();
        let told = row(options)?;
        let seconds = row_started.elapsed().as_secs_f64();
        let label = told.words[0].clone();
        bar.set_message(label.clone());
        bar.inc(1);
        if !told.confirmed {
            unconfirmed.push(label.clone());
        }
        if told.misprinted {
            misprinted.push(label);
        }
        let words = told.words.map(Cell::Text);
        table.push(words.into_iter().chain([Cell::Number(seconds)]).collect());
        figures.extend(told.figures);
        values.extend(told.values);
    }
    bar.finish_and_clear();
    let mut measured = format!("{} arguments in {:.0} s", rows.len(), started.elapsed().as_secs_f64());
    if !misprinted.is_empty() {
        measured += &format!(", the printed form fails in {}", misprinted.join(", "));
    }
    let verdict =
        if unconfirmed.is_empty() { Verdict::Holds } else { Verdict::NotConfirmed(unconfirmed.join(", ")) };
    let claim = "an a priori error analysis for Signorini's problem, argument by argument";
    let mut headline = Headline::new("Hild & Renard 2012", claim, table, measured, verdict);
    headline.figures = figures;
    headline.values = values;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
