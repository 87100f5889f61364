//! Theorems 3.1 and 4.1 with numbers for solutions that are not known: the bound from norms of fine
//! solutions, beside the extrapolated error.
//!
//! `cargo run --release --example theorem_3_1_with_numbers_extrapolated -- --finest 9`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress, within};
use experiments::proof::{ExtrapolatedRow, ExtrapolatedStudy, FineForms, SolvedBody};
use fractional_sobolev::Estimate;
use signorini::problems::PiecewiseLinearLoad;
use signorini::proof::TheoremConstants;
use std::process::ExitCode;

example_frame::options! {
    /// Compare the bound with numbers with the error of problems of unknown solution
    pub struct Options {
        /// tau in (3/2, 2], comma separated; each body takes those below its own regularity
        #[arg(long, value_delimiter = ',', default_values = ["1.6", "1.75", "1.9", "2"], value_parser = within::<f64>("(1.5, 2]"))]
        pub tau: Vec<f64>,
        /// The solution on 2^FINEST squares along each side stands for u; the bound is for meshes up to an
        /// eighth of them
        #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(5..=9))]
        pub finest: u32,
    }
    memory(options) {
        6800.0 * f64::from(2 * options.finest).exp2()
    }
}

/// From this tau on the bound should not be farther from the error than this.
const SHARP_FROM: f64 = 1.75;
const SHARP: f64 = 10.0;
/// Norms nearer than this to the supremum of their order are not extrapolated.
const MARGIN: f64 = 0.1;
/// What the estimates of norms and errors may be off by, and how well that is itself known.
const UNCERTAIN: f64 = 0.25;
const KNOWN: f64 = 0.1;

/// Every body, in its cones, for every tau.
pub fn compute(options: &Options) -> Result<Vec<ExtrapolatedStudy>> {
    let bar = progress((PiecewiseLinearLoad::ALL.len() + options.tau.len()) as u64);
    let mut bodies = Vec::new();
    for body in PiecewiseLinearLoad::ALL {
        bodies.push(SolvedBody::new(body, options.finest)?);
        bar.inc(1);
    }
    let mut studies = Vec::new();
    for &tau in &options.tau {
        let numbers = TheoremConstants::new(tau)?;
        let [a, b, c] = bodies[0].fine_grids();
        let forms = [FineForms::new(tau, a)?, FineForms::new(tau, b)?, FineForms::new(tau, c)?];
        for body in bodies.iter().filter(|body| tau <= body.smoothness - MARGIN) {
            let norms = body.norms(tau, &forms)?;
            for &cone in body.body.cones() {
                studies.push(ExtrapolatedStudy::new(numbers, body, cone, norms)?);
            }
        }
        bar.inc(1);
    }
    Ok(studies)
}

/// What decides: bound over error, each with what it may be off by.
pub fn findings(studies: &[ExtrapolatedStudy]) -> Vec<Finding> {
    let quotients = |from: f64| {
        let rows = studies.iter().filter(move |study| study.numbers.tau >= from).flat_map(|s| &s.rows);
        rows.map(|row| (row.bound / row.error.value, row.bound * row.error.error / row.error.value.powi(2)))
    };
    let least = quotients(0.0).min_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1)));
    let most = |from| quotients(from).max_by(|a, b| (a.0 + a.1).total_cmp(&(b.0 + b.1)));
    let norms = studies.iter().flat_map(|s| [s.norms.body, s.norms.pressure, s.norms.slope]);
    let errors = studies.iter().flat_map(|study| study.rows.iter().map(|row| row.error));
    let doubt = |of: &mut dyn Iterator<Item = Estimate>| {
        of.map(|estimate| estimate.relative_error()).reduce(f64::max).map(|worst| (worst, KNOWN * worst))
    };
    let above = Finding::claim("above", "the bound is at least {value} times the error, on every mesh");
    let sharp = Finding::claim("effectivity", "from tau = 1.75 on it is at most {value} times the error");
    let all = Finding::remark("all", "for every tau it is at most {value} times the error");
    let norm = Finding::claim("norms", "the norms are off by at most {value} of themselves, by estimate");
    let error = Finding::claim("errors", "the errors are off by at most {value} of themselves, by estimate");
    let none = "no mesh";
    vec![
        above.number_or(least, none).at_least(1.0, "the error itself").told(),
        sharp.number_or(most(SHARP_FROM), none).at_most(SHARP, "effectivity 10").told(),
        all.number_or(most(0.0), none).at_most(SHARP, "effectivity 10"),
        norm.number_or(doubt(&mut norms.into_iter()), none).at_most(UNCERTAIN, "a quarter"),
        error.number_or(doubt(&mut errors.into_iter()), none).at_most(UNCERTAIN, "a quarter"),
    ]
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let studies = compute(options)?;
    let claim = "|u - u_h|_a <= C h^(tau-1) with every constant a number, where u is not known";
    let (table, found) = (table(&studies), findings(&studies));
    let mut headline = Headline::new("Theorems 3.1, 4.1, numbers, extrapolated", claim, table, found);
    headline.draw(&options.output, "theorem_3_1_with_numbers_extrapolated", || Ok(draw(&studies)))?;
    Ok(headline)
}

fn table(studies: &[ExtrapolatedStudy]) -> Table {
    let (number, four) = (Format::Scientific(3), Format::Fixed(4));
    let columns = vec![
        Column::words("body", "body", 8),
        Column::new("smoothness", "sup tau", Format::Fixed(3), "u in H^tau below it, from corners and ends"),
        Column::new("tau", "tau", Format::Plain, ""),
        Column::words("cone", "cone", 8),
        Column::new("norm", "|u|_tau", four, "seminorm on the square, extrapolated"),
        Column::new("norm_error", "+-", four, "what it may be off by"),
        Column::new("edge", "|s| |u'|", four, "seminorms of sigma_N and u_N' on the edge, multiplied"),
        Column::new("n", "1/h", Format::Plain, "squares along each side"),
        Column::new("error", "error", number, "|u - u_h|_a, extrapolated"),
        Column::new("error_error", "+-", number, "what it may be off by"),
        Column::new("bound", "bound", number, "from norms rounded up by what they may be off by"),
        Column::new("effectivity", "bound/err", Format::Fixed(2), "effectivity"),
    ];
    Table::new(columns).with_rows(studies.iter().flat_map(|study| {
        let norms = study.norms;
        study.rows.iter().map(move |&ExtrapolatedRow { n, error, bound }| {
            let edge = norms.pressure.value * norms.slope.value;
            let mut cells: Vec<Cell> = vec![study.body.to_string().into(), study.smoothness.into()];
            cells.extend([study.numbers.tau.into(), study.cone.to_string().into()]);
            cells.extend([norms.body.value, norms.body.error, edge].map(Into::into));
            cells.push(n.into());
            cells.extend([error.value, error.error, bound, bound / error.value].map(Into::into));
            cells
        })
    }))
}

/// Bound over error in the nodal cone.
fn draw(studies: &[ExtrapolatedStudy]) -> Chart {
    let (x, y) = (Axis::logarithmic("h"), Axis::linear("nodal cone: bound / error"));
    let nodal = studies.iter().filter(|study| study.cone == signorini::cone::Cone::Nodal);
    nodal.fold(Chart::new("The bound with numbers where the solution is not known", x, y), |chart, study| {
        let points = study.rows.iter().map(|row| (1.0 / row.n as f64, row.bound / row.error.value)).collect();
        let name = format!("{}, tau = {}", study.body, study.numbers.tau);
        chart.with(Series::line_and_points(name, points))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
