//! Theorems 3.1 and 4.1 for an elastic body and 3/2 < tau <= 2 with numbers for all constants: a bound above
//! the error, on every mesh.
//!
//! `cargo run --release --example theorem_3_1_with_numbers_elastic -- --lambda 20 --tau 1.75`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress};
use signorini::Error;
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::proof::{NumberedRow, NumberedStudy, TheoremNumbers};
use signorini::scenes::RoughTransition;
use std::process::ExitCode;

example_frame::options! {
    /// Compare the bound with numbers with the error of elastic bodies of known displacement
    pub struct Options {
        /// tau in (3/2, 2], comma separated
        #[arg(long, value_delimiter = ',', default_values = ["1.6", "1.75", "1.9", "2"])]
        pub tau: Vec<f64>,
        /// The displacement is r^p with p = tau - 1 + this: just in H^tau
        #[arg(long, default_value_t = 0.06)]
        pub above: f64,
        /// Lame's first constant
        #[arg(long, default_value_t = 1.0)]
        pub lambda: f64,
        /// Lame's second constant
        #[arg(long, default_value_t = 1.0)]
        pub mu: f64,
        /// Meshes of 4 x 4 ... n x n squares, n = 2 to this power
        #[arg(long, default_value_t = 6, value_parser = clap::value_parser!(u32).range(3..=9))]
        pub finest: u32,
    }
}

/// Quadrature of the error.
const QUADRATURE: f64 = 1e-3;
/// From this tau on the bound should not be farther from the error than this.
const SHARP_FROM: f64 = 1.75;
const SHARP: f64 = 10.0;

/// Both cones for every tau.
pub fn compute(options: &Options) -> Result<Vec<NumberedStudy>> {
    Error::require("above", options.above, "(0, 0.4]", options.above > 0.0 && options.above <= 0.4)?;
    let lame = Lame::new(options.lambda, options.mu)?;
    let bar = progress(2 * options.tau.len() as u64);
    let mut studies = Vec::new();
    for &tau in &options.tau {
        let numbers = TheoremNumbers::new(tau)?;
        let scene = RoughTransition::new(tau - 1.0 + options.above)?.elastic(lame);
        for cone in [Cone::Nodal, Cone::Midpoint] {
            studies.push(NumberedStudy::new(numbers, scene, cone, options.finest)?);
            bar.inc(1);
        }
    }
    Ok(studies)
}

/// What decides: bound over error on every mesh, and the price of each cone.
pub fn findings(studies: &[NumberedStudy]) -> Vec<Finding> {
    let quotients = |is_meant: fn(&NumberedStudy) -> bool, of: fn(&NumberedRow) -> f64| {
        let rows = studies.iter().filter(move |study| is_meant(study)).flat_map(|study| &study.rows);
        rows.map(of).collect::<Vec<_>>()
    };
    let decide = |finding: Finding, found: Vec<f64>, better: fn(f64, f64) -> f64| {
        let number = found.into_iter().reduce(better).map(|number| (number, QUADRATURE * number));
        finding.number_or(number, "no mesh")
    };
    let whole = |row: &NumberedRow| row.bound / row.error;
    let near = |row: &NumberedRow| row.near / row.error;
    let is_sharp = |study: &NumberedStudy| study.numbers.tau >= SHARP_FROM;
    let is_midpoint = |study: &NumberedStudy| study.cone == Cone::Midpoint;
    let above = Finding::claim("above", "the bound is at least {value} times the error, on every mesh");
    let korn = Finding::claim("korn", "for the midpoint cone, with Korn's constant, {value} times or more");
    let local = Finding::claim(
        "near",
        "with the interpolation error itself and the segment's norms, {value} times or more",
    );
    let sharp = Finding::claim("effectivity", "from tau = 1.75 on it is at most {value} times the error");
    let all = Finding::remark("all", "for every tau it is at most {value} times the error")
        .otherwise("over all tau it comes to {value} times the error, more than 10");
    vec![
        decide(above, quotients(|_| true, whole), f64::min).at_least(1.0, "the error itself").told(),
        decide(korn, quotients(is_midpoint, whole), f64::min).at_least(1.0, "the error itself"),
        decide(local, quotients(|_| true, near), f64::min).at_least(1.0, "the error itself"),
        decide(sharp, quotients(is_sharp, whole), f64::max).at_most(SHARP, "effectivity 10").told(),
        decide(all, quotients(|_| true, whole), f64::max).at_most(SHARP, "effectivity 10"),
    ]
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let studies = compute(options)?;
    let claim = "|u - u_h|_a <= C h^(tau-1), 3/2 < tau <= 2, elastic, every constant a number";
    let (table, found) = (table(&studies), findings(&studies));
    let mut headline = Headline::new("Theorems 3.1, 4.1, numbers, elastic", claim, table, found);
    headline.draw(&options.output, "theorem_3_1_with_numbers_elastic", || Ok(draw(&studies)))?;
    Ok(headline)
}

fn table(studies: &[NumberedStudy]) -> Table {
    let (number, two) = (Format::Scientific(3), Format::Fixed(2));
    let columns = vec![
        Column::new("tau", "tau", Format::Plain, ""),
        Column::words("cone", "cone", 8),
        Column::new("constant", "C(s)", Format::Fixed(5), "interpolation, in the energy, times sqrt M"),
        Column::new("segment", "K(nu)", Format::Fixed(5), "one segment"),
        Column::new("norm", "|u|_tau", Format::Fixed(4), "seminorm on a half disc that holds the square"),
        Column::new("n", "1/h", Format::Plain, "squares along each side"),
        Column::new("error", "error", number, "|u - u_h|_a"),
        Column::new("interpolation", "interp", number, "|u - I^h u|_a"),
        Column::new("bound", "bound", number, "from the norms of the body and the edge"),
        Column::new("effectivity", "bound/err", two, "effectivity"),
        Column::new(
            "near",
            "near/err",
            two,
            "from |u - I^h u|_a and the norms of the segment of the transition",
        ),
    ];
    Table::new(columns).with_rows(studies.iter().flat_map(|study| {
        let numbers = study.numbers;
        study.rows.iter().map(move |row| {
            let cone: Cell = study.cone.to_string().into();
            let known = [numbers.interpolation, numbers.segment, study.norm].map(Cell::from);
            let errors =
                [row.error, row.interpolation, row.bound, row.bound / row.error, row.near / row.error];
            let head = [numbers.tau.into(), cone];
            [head.as_slice(), &known, &[row.n.into()], &errors.map(Cell::from)].concat()
        })
    }))
}

/// Bound over error, both cones.
fn draw(studies: &[NumberedStudy]) -> Chart {
    let (x, y) = (Axis::logarithmic("h"), Axis::linear("bound / error"));
    let title = "How far the bound with numbers is from the error of an elastic body";
    studies.iter().fold(Chart::new(title, x, y), |chart, study| {
        let points = study.rows.iter().map(|row| (1.0 / row.n as f64, row.bound / row.error)).collect();
        let name = format!("{}, tau = {}", study.cone, study.numbers.tau);
        chart.with(match study.cone {
            Cone::Nodal => Series::line_and_points(name, points),
            Cone::Midpoint => Series::dashed(name, points),
        })
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
