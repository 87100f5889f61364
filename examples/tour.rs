//! The paper in one run: its main arguments computed, one row each with claim, measured, verdict and seconds.
//!
//! `cargo run --release --example tour -- --out out`

#![allow(clippy::duplicate_mod, reason = "twins share a file, and every row loads its own")]

use example_frame::{
    Cell, Column, Finding, Format, Headline, Outcome, Output, Result, Role, Table, progress,
};
use fractional_sobolev::Order;
use signorini::cone::Cone;
use std::process::ExitCode;
use std::time::Instant;

example_frame::options! {
    /// The main arguments of the paper: claim, measured, verdict, how many findings hold, seconds
    pub struct Options: Long {
        /// Smaller meshes and fewer values: a few seconds instead of up to a minute
        #[arg(long)]
        pub quick: bool,
    }
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

/// One row: its name and how to compute it.
type Row = (&'static str, Box<dyn Fn(&Options) -> Result<Headline>>);

/// A row that runs an example with some of its options set from those of the tour.
macro_rules! row {
    ($name:literal, $tour:ident: $example:ident $(, $field:ident = $value:expr)*) => {
        ($name, Box::new(|$tour: &Options| {
            let output = Output { values: None, ..$tour.output.clone() };
            #[allow(clippy::needless_update, reason = "some examples have no other option")]
            let options = $example::Options { $($field: $value,)* output, ..Default::default() };
            $example::run(&options)
        }))
    };
}

fn rows() -> Vec<Row> {
    vec![
        row!("elastic.nodal", tour: section_2_elastic_contact, n = tour.size()),
        row!("scalar.nodal", tour: section_2_scalar_contact, n = tour.size()),
        row!("elastic.midpoint", tour: section_2_elastic_contact, n = tour.size(), cone = Cone::Midpoint),
        row!("scalar.midpoint", tour: section_2_scalar_contact, n = tour.size(), cone = Cone::Midpoint),
        row!("figure.3.2", tour: figure_3_2_alternative, n = tour.size()),
        row!("figure.4.1", tour: figure_4_1_alternative, n = tour.size()),
        row!("lemma.5.2.below", tour: lemma_5_2_poincare_scaling, nu = vec![Order::new(0.25)?], theta = tour.zones()),
        row!("lemma.5.2.half", tour: lemma_5_2_poincare_scaling, nu = vec![Order::HALF], theta = tour.zones()),
        row!("lemma.5.2.above", tour: lemma_5_2_poincare_scaling, nu = vec![Order::new(0.75)?], theta = tour.zones()),
        row!("lemma.6.1", tour: lemma_6_1_local_estimate, functions = tour.functions()),
        row!("theorem.3.1", tour: theorem_3_1_rates, tau = tour.regularities()),
        row!("theorem.4.1", tour: theorem_4_1_rates, tau = tour.regularities()),
    ]
}

/// One finding a row: none of its claims is refuted or undecided.
fn finding(name: &str, headline: &Headline) -> Finding {
    let claims = headline.findings.iter().filter(|f| f.role() == Role::Claim);
    let failed = claims.filter(|f| !matches!(f.outcome(), Outcome::Holds | Outcome::ByProof)).count();
    Finding::claim(name, format!("{}: every claim holds", headline.label))
        .number(failed as f64, 0.0)
        .at_most(0.0, "claims refuted or undecided")
        .otherwise(format!("{}: {{value}} claims are refuted or undecided", headline.label))
}

/// Runs every row and gathers their headlines.
pub fn run(options: &Options) -> Result<Headline> {
    let count = |key, title| Column::new(key, title, Format::Plain, "");
    let mut table = Table::new(vec![
        Column::words("label", "label", 12),
        Column::words("claim", "claim", 22),
        Column::words("measured", "measured", 26),
        Column::words("verdict", "verdict", 17),
        count("holds", "hold"),
        count("refuted", "ref."),
        count("undecided", "und."),
        Column::new("seconds", "s", Format::Significant(2), ""),
    ]);
    let (mut figures, mut values, mut findings) = (Vec::new(), Vec::new(), Vec::new());
    let rows = rows();
    let (bar, started) = (progress(rows.len() as u64), Instant::now());
    for (name, row) in &rows {
        let row_started = Instant::now();
        let headline = row(options)?;
        let seconds = row_started.elapsed().as_secs_f64();
        bar.set_message(headline.label.clone());
        bar.inc(1);
        findings.push(finding(name, &headline));
        let counts = [Outcome::Holds, Outcome::Refuted, Outcome::Undecided].map(|o| headline.count(o));
        let (measured, verdict) = (headline.measured(), headline.verdict().to_string());
        let words = [headline.label, headline.claim, measured, verdict].map(Cell::Text);
        table.push(words.into_iter().chain(counts.map(Cell::from)).chain([seconds.into()]).collect());
        figures.extend(headline.figures);
        values.extend(headline.values);
    }
    bar.finish_and_clear();
    let total = table.rows().len();
    findings.push(
        Finding::remark("seconds", format!("{total} arguments in {{value}} s"))
            .number(started.elapsed().as_secs_f64().round(), 0.5)
            .at_most(60.0, "what a reader waits for")
            .otherwise(format!("{total} arguments took {{value}} s"))
            .told(),
    );
    let claim = "an a priori error analysis for Signorini's problem, argument by argument";
    let mut headline = Headline::new("Hild & Renard 2012", claim, table, findings);
    (headline.figures, headline.values) = (figures, values);
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
