//! What accuracy costs: seconds and work against true error for every numerical function of the toolkit.
//!
//! The one list is `cases/toolkit.rs`: a name, the value found another way, and the function of the
//! tolerance.
//!
//! `cargo run --release --example speed_for_accuracy -- --case closure --repeat 10`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress};
use fractional_sobolev::Tolerance;
use std::process::ExitCode;
use std::time::Instant;
use toolkit::{Case, cases};

#[path = "cases/toolkit.rs"]
mod toolkit;

example_frame::options! {
    /// Seconds against true error
    pub struct Options: Long {
        /// Only cases whose name contains this
        #[arg(long, default_value = "")]
        pub case: String,
        /// Repetitions; the fastest counts
        #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
        pub repeat: u32,
    }
}

/// One tolerance of one case.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Relative tolerance.
    pub asked: f64,
    /// Seconds of the fastest and of the slowest run.
    pub seconds: [f64; 2],
    /// Relative distance to the value found another way, and the relative error of the estimate.
    pub error: [f64; 2],
    /// Points, pairs, iterations and factorizations together.
    pub work: f64,
}

const TOLERANCES: [f64; 5] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11];
/// What the values found another way may be off by: closed forms of some hundred operations, or 16 printed
/// digits.
const REFERENCE: f64 = 1e-14;

/// The rows of every case that was asked for.
pub fn compute(options: &Options) -> Result<Vec<(&'static str, Vec<Row>)>> {
    let chosen: Vec<Case> = cases()?.into_iter().filter(|case| case.0.contains(&options.case)).collect();
    let bar = progress(chosen.len() as u64);
    let measure = |(name, exact, compute): &Case| -> Result<(&'static str, Vec<Row>)> {
        let row = |&asked: &f64| -> Result<Row> {
            let mut seconds = [f64::INFINITY, 0.0];
            let mut found = None;
            for _ in 0..options.repeat {
                let start = Instant::now();
                found = Some(compute(Tolerance::new(asked)?)?);
                let passed = start.elapsed().as_secs_f64();
                seconds = [passed.min(seconds[0]), passed.max(seconds[1])];
            }
            let error =
                found.map_or([f64::NAN; 2], |u| [(u.value / exact - 1.0).abs(), u.error / exact.abs()]);
            Ok(Row { asked, seconds, error, work: found.map_or(0.0, |found| found.work.total() as f64) })
        };
        let rows = TOLERANCES.iter().map(row).collect::<Result<_>>()?;
        bar.inc(1);
        Ok((*name, rows))
    };
    chosen.iter().map(measure).collect()
}

/// What decides: true errors against what was asked and promised; work and seconds against those of more
/// digits.
pub fn findings(cases: &[(&'static str, Vec<Row>)]) -> Vec<Finding> {
    let rows = || cases.iter().flat_map(|case| &case.1);
    let worst = |share: &dyn Fn(&Row) -> (f64, f64)| rows().map(share).max_by(|a, b| a.0.total_cmp(&b.0));
    let pairs = cases.iter().flat_map(|case| case.1.windows(2)).filter(|pair| pair[1].work > 0.0);
    let dearer = pairs.map(|pair| (pair[0].work / pair[1].work, 0.0)).max_by(|a, b| a.0.total_cmp(&b.0));
    let sum = |row: usize, run: usize| cases.iter().map(|case| case.1[row].seconds[run]).sum::<f64>();
    let [loose, tight, spread] =
        [sum(0, 0), sum(4, 0), sum(0, 1) / sum(0, 0) - 1.0 + sum(4, 1) / sum(4, 0) - 1.0];
    let mut shares: Vec<f64> = rows().map(|row| row.error[0] / row.asked).collect();
    shares.sort_by(f64::total_cmp);
    let median = shares.get(shares.len() / 2).map(|&share| (share, 0.0));
    let none = "no case has a name like that";
    vec![
        Finding::claim("met", "every tolerance is met, with a true error of at most {percent} % of it")
            .number_or(worst(&|row| (row.error[0] / row.asked, REFERENCE / row.asked)), none)
            .at_most(1.0, "the tolerance")
            .otherwise("a true error is {percent} % of the tolerance")
            .told(),
        Finding::claim("promise", "no true error passes its estimate, the largest is {percent} % of it")
            .number_or(worst(&|row| (row.error[0] / row.error[1], REFERENCE / row.error[1])), none)
            .at_most(1.0, "the estimate")
            .otherwise("a true error is {percent} % of its estimate"),
        Finding::claim("work", "no looser tolerance takes more points, pairs, iterations and factorizations")
            .number_or(dearer, none)
            .at_most(1.0, "the work of the next tighter tolerance")
            .otherwise("a looser tolerance takes {value} times the work"),
        Finding::remark("spare", "half of the true errors are below {percent} % of the tolerance")
            .number_or(median, none)
            .at_most(1.0, "the tolerance"),
        Finding::remark("seconds", "1e-11 takes {value} times the seconds of 1e-3, all cases together")
            .number_or((!cases.is_empty()).then_some((tight / loose, spread * tight / loose)), none)
            .at_least(1.0, "equal cost"),
    ]
}

/// Measures every case.
pub fn run(options: &Options) -> Result<Headline> {
    let cases = compute(options)?;
    let claim = "a looser tolerance costs less, and every tolerance is met";
    let mut headline = Headline::new("Speed for accuracy", claim, table(&cases), findings(&cases));
    headline.draw(&options.output, "speed_for_accuracy_seconds", || Ok(draw(&cases)))?;
    Ok(headline)
}

fn table(cases: &[(&'static str, Vec<Row>)]) -> Table {
    let columns = vec![
        Column::new("case", "case", Format::Significant(6), ""),
        Column::new("asked", "asked", Format::Scientific(0), "relative tolerance"),
        Column::new("seconds", "seconds", Format::Scientific(2), "fastest run"),
        Column::new(
            "true_error",
            "true error",
            Format::Scientific(1),
            "relative, against a value computed another way",
        ),
    ];
    let cells = |name: &'static str, row: &Row| {
        [Cell::from(name), row.asked.into(), row.seconds[0].into(), row.error[0].into()]
    };
    Table::new(columns)
        .with_rows(cases.iter().flat_map(|(name, rows)| rows.iter().map(|row| cells(name, row))))
}

fn draw(cases: &[(&'static str, Vec<Row>)]) -> Chart {
    let axes = [Axis::logarithmic("seconds"), Axis::logarithmic("true relative error")];
    let [x, y] = axes;
    cases.iter().fold(Chart::new("What accuracy costs", x, y), |chart, (name, rows)| {
        // An error of zero is drawn where binary64 ends.
        let points = rows.iter().map(|row| (row.seconds[0], row.error[0].max(f64::EPSILON))).collect();
        chart.with(Series::line_and_points(*name, points))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
