//! The accuracy of the toolkit: per function and range the largest true error, the largest share of the error
//! that was promised, and the seconds.
//!
//! The cases are in `cases/accuracy/mod.rs`: random parameters with a fixed seed, closed forms and values of other
//! programs beside them. An error counts from what the other value may itself be off by.
//!
//! `cargo run --release --example accuracy_table -- --tolerance 1e-6 --each 100 --seed 7`

use cases::{Family, Row, families};
use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress};
use fractional_sobolev::Tolerance;
use std::process::ExitCode;

#[path = "cases/accuracy/mod.rs"]
pub mod cases;

example_frame::options! {
    /// True errors of every function of the toolkit
    pub struct Options {
        /// Relative tolerance asked for: fast, balanced, reference or a number
        #[arg(long, default_value_t = Tolerance::new(1e-7).unwrap_or_default())]
        pub tolerance: Tolerance,
        /// Random cases of each family
        #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=1000))]
        pub each: u32,
        /// Seed of the random parameters
        #[arg(long, default_value_t = 1)]
        pub seed: u64,
    }
}

/// Asks every family.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let all = families(options.each as usize, options.seed)?;
    let bar = progress(all.len() as u64);
    let row = |family: &Family| {
        let row = family.row(options.tolerance);
        bar.inc(1);
        row
    };
    Ok(all.iter().map(row).collect::<fractional_sobolev::Result<_>>()?)
}

/// What decides: true errors against the promise and the tolerance, and what was refused.
pub fn findings(rows: &[Row]) -> Vec<Finding> {
    let worst = |of: &dyn Fn(&Row) -> f64| rows.iter().max_by(|a, b| of(a).total_cmp(&of(b)));
    let named = |row: Option<&Row>| row.map_or("none", |row| row.words[1]);
    let number = |row: Option<&Row>, of: &dyn Fn(&Row) -> f64| row.map(|row| (of(row), 0.0));
    let share = |row: &Row| row.share;
    let error = |row: &Row| row.met;
    let slow = |row: &Row| row.seconds[1];
    let [cases, refused] = [0, 1].map(|k| rows.iter().map(|row| row.cases[k]).sum::<usize>());
    let [promised, met, slowest] = [worst(&share), worst(&error), worst(&slow)];
    let none = "no family was asked";
    vec![
        Finding::claim(
            "promise",
            format!(
                "of {cases} true errors none passes its promise, the largest is {{percent}} % of it ({})",
                named(promised)
            ),
        )
        .number_or(number(promised, &share), none)
        .at_most(1.0, "the error of the estimate")
        .otherwise("a true error is {percent} % of what was promised")
        .told(),
        Finding::claim(
            "met",
            format!("every tolerance is met, with {{percent}} % of it at most ({})", named(met)),
        )
        .number_or(number(met, &error), none)
        .at_most(1.0, "the tolerance")
        .otherwise("a true error is {percent} % of the tolerance")
        .told(),
        Finding::claim("refused", "no question is refused")
            .number_or((cases > 0).then_some((refused as f64, 0.0)), none)
            .at_most(0.0, "all of them have an answer")
            .otherwise("{value} questions are refused"),
        Finding::remark(
            "seconds.slowest",
            format!("the slowest answer takes {{value}} seconds ({})", named(slowest)),
        )
        .number_or(number(slowest, &slow), none)
        .at_most(10.0, "nobody waits longer"),
    ]
}

/// Asks every family and shows the table.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "true errors stay below the errors that are promised";
    let mut headline = Headline::new("Accuracy of the toolkit", claim, table(&rows), findings(&rows));
    headline.quote("accuracy.cases", rows.iter().map(|row| row.cases[0]).sum::<usize>() as f64);
    headline.quote("accuracy.families", rows.len() as f64);
    headline.draw(&options.output, "accuracy_table", || Ok(draw(options, &rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let columns = vec![
        Column::words("name", "name", 12),
        Column::words("function", "function", 32),
        Column::words("range", "range", 24),
        Column::words("by", "by", 32),
        Column::new("cases", "cases", Format::Fixed(0), "questions asked"),
        Column::new("refused", "refused", Format::Fixed(0), "of them"),
        Column::new("error", "error", Format::Scientific(1), "largest true error, relative"),
        Column::new("share", "error/promise", Format::Fixed(2), "largest true error over the error promised"),
        Column::new("seconds", "seconds", Format::Scientific(1), "of all cases"),
    ];
    let cells = |row: &Row| {
        let [name, function, range, by] = row.words.map(Cell::from);
        [
            name,
            function,
            range,
            by,
            (row.cases[0] as f64).into(),
            (row.cases[1] as f64).into(),
            row.error.into(),
            row.share.into(),
            row.seconds[0].into(),
        ]
    };
    Table::new(columns).with_rows(rows.iter().map(cells))
}

fn draw(options: &Options, rows: &[Row]) -> Chart {
    let names = rows.iter().map(|row| row.words[0].to_owned()).collect();
    let points = |of: fn(&Row) -> f64| {
        // An error of zero is drawn where binary64 ends.
        let point = |(k, row): (usize, &Row)| (of(row).max(f64::EPSILON).log10(), -(k as f64));
        rows.iter().enumerate().map(point).collect()
    };
    let title = "True errors of the toolkit";
    Chart::new(title, Axis::linear("log10 of the largest true error"), Axis::rows(names))
        .with(Series::points("largest true error", points(|row| row.error)))
        .with_asymptote(options.tolerance.relative().log10())
}

fn main() -> ExitCode {
    example_frame::main(run)
}
