//! Theorems 3.1 and 4.1 at tau = 2 with every constant known: a number above the error, on every mesh.
//!
//! `cargo run --release --example theorem_3_1_without_c -- --finest 8`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Error, Finding, Format, Headline, Result, Table, progress, within};
use experiments::convergence::Levels;
use experiments::proof::{BoundProblem, BoundRow, BoundStudy, segment_versions};
use fractional_sobolev::Tolerance;
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::problems::KnownSolution;
use signorini::proof::MeshShape;
use std::process::ExitCode;

example_frame::options! {
    /// Compare the bound without C with the error of problems in closed form
    pub struct Options {
        /// Meshes of 4 x 4 ... n x n squares, n = 2 to this power
        #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(4..=11))]
        pub finest: u32,
        /// Mesh sizes h = 2^-COARSEST ... 2^-FINEST on the strip
        #[arg(long, default_value = "4-12")]
        pub levels: Levels,
        /// Lame's first constant of the elastic problems, at least 0
        #[arg(long, default_value_t = 1.0, value_parser = within::<f64>("[0, 1e12]"))]
        pub lambda: f64,
        /// Lame's second constant
        #[arg(long, default_value_t = 1.0, value_parser = within::<f64>("[1e-12, 1e12]"))]
        pub mu: f64,
    }
    check(options) {
        match options.levels.coarsest_cells() {
            cells if cells < 4 * GAPS => Err(Error::Option("--levels: 16 cells or more hold the gaps".to_owned())),
            _ => Ok(()),
        }
    }
    memory(options) {
        4500.0 * f64::from(2 * options.finest).exp2()
    }
}

/// For every constant of a segment: column of the bound over the error, and of the same from |u|_2 alone.
const VERSIONS: [[&str; 2]; 3] = [["c", "c_whole"], ["K", "K_whole"], ["kappa", "kappa_whole"]];

/// Relative accuracy of K and kappa, rounded up by their errors.
const SHARP: f64 = 1e-6;

/// Squares, scalar and elastic, one and two transitions, and a strip, both cones, on every mesh.
pub fn compute(options: &Options) -> Result<Vec<BoundStudy>> {
    let lame = Some(Lame::new(options.lambda, options.mu)?);
    let segments = segment_versions(Tolerance::new(SHARP)?)?;
    let bar = progress(8 * u64::from(options.finest - 1));
    let (mut studies, mut strips) = (Vec::new(), Vec::new());
    for (cone, segment) in [Cone::Nodal, Cone::Midpoint].into_iter().zip(&segments) {
        for scene in [None, lame]
            .into_iter()
            .flat_map(|lame| [KnownSolution::one_transition(lame), KnownSolution::two_transitions(lame)])
        {
            studies.push(BoundStudy::square(scene, cone, segment, options.finest, || bar.inc(1))?);
        }
        strips.push(BoundStudy::strip(GAPS, cone, segment, options.levels, || ())?);
    }
    Ok([studies, strips].concat())
}

/// Gaps of the strip; each has two natural transitions.
const GAPS: usize = 3;
/// Quadrature of the error and data of the sides.
const QUADRATURE: f64 = 1e-3;

/// What decides: bound over error on every mesh.
pub fn findings(studies: &[BoundStudy]) -> Vec<Finding> {
    let all = |version, local| studies.iter().map(|s| s.effectivities(version, local)).collect::<Vec<_>>();
    let decide = |finding: Finding, found: Vec<f64>, better: fn(f64, f64) -> f64| {
        let number = found.into_iter().reduce(better).map(|number| (number, QUADRATURE * number));
        finding.number_or(number, "no mesh")
    };
    let (mut findings, last) = (Vec::new(), VERSIONS.len() - 1);
    for (version, [name, _]) in VERSIONS.iter().enumerate() {
        let words = format!("with {name} the bound is at least {{value}} times the error on every mesh");
        let claim = Finding::claim(format!("above.{name}"), words);
        let claim = decide(claim, all(version, true).concat(), f64::min);
        findings.push(claim.at_least(1.0, "the error itself").told());
    }
    let near =
        Finding::remark("near", "with kappa and |u|_2 near the edge it is at most {value} times the error");
    findings.push(decide(near, all(last, true).concat(), f64::max).at_most(4.0, "effectivity 4").told());
    let whole = Finding::remark("whole", "with kappa and |u|_2 of the body at most {value} times the error");
    findings.push(decide(whole, all(last, false).concat(), f64::max).at_most(4.0, "effectivity 4"));
    let near = all(last, true);
    let falls = near.iter().flat_map(|found| found.windows(2).map(|pair| pair[1] / pair[0])).collect();
    let trend =
        Finding::remark("trend", "from one mesh to the next the quotient is multiplied by {value} at most");
    findings.push(decide(trend, falls, f64::max).at_most(1.0 + QUADRATURE, "the same quotient"));
    findings
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let studies = compute(options)?;
    let claim = "|u - u_h|_a <= C h |u|_2 for tau = 2, any contact set, with a number in the place of C";
    let mut headline =
        Headline::new("Theorems 3.1, 4.1, tau = 2", claim, table(&studies), findings(&studies));
    for study in &studies {
        if let BoundProblem::Square(known) = study.problem
            && known.transitions().len() == 1
        {
            let kind = if known.lame().is_some() { "elastic" } else { "scalar" };
            for ([name, _], bound) in VERSIONS.iter().zip(&study.bounds) {
                headline.quote(format!("without.c.{kind}.{}.{name}", study.cone), bound.constant());
            }
        }
    }
    headline.quote("without.c.interpolation", MeshShape::right_isosceles().interpolation);
    headline.draw(&options.output, "theorem_3_1_without_c", || Ok(draw(&studies)))?;
    Ok(headline)
}

fn table(studies: &[BoundStudy]) -> Table {
    let (number, two) = (Format::Scientific(3), Format::Fixed(2));
    let mut columns = vec![
        Column::new("problem", "problem, cone", Format::Plain, ""),
        Column::new("n", "1/h", Format::Plain, "squares along each side, first and last mesh"),
        Column::new("error", "error", number, "|u - u_h|_a"),
        Column::new("interpolation", "interp", number, "|u - I^h u|_a"),
        Column::new("share", "near", two, "|u|_2 in the squares on the contact edge over |u|_2"),
    ];
    for [name, whole] in VERSIONS {
        columns.push(Column::new(name, name, two, "bound over error; midpoint cone: c/2, K/2, K/2"));
        columns.push(Column::new(whole, whole, two, "the same from |u|_2 alone"));
    }
    let mut table = Table::new(columns);
    for study in studies {
        for row in [study.rows.first(), study.rows.last()].into_iter().flatten() {
            let mut cells = vec![study.to_string().into(), row.n.into()];
            cells.extend([Some(row.error), Some(row.interpolation), row.share].map(Into::into));
            let versions =
                (0..VERSIONS.len()).flat_map(|v| [true, false].map(|local| row.effectivity(v, local)));
            cells.extend(versions.map(Into::into));
            table.push(cells);
        }
    }
    table
}

/// Bound over error against h, the best version, one transition and the strip.
fn draw(studies: &[BoundStudy]) -> Chart {
    let x = Axis::logarithmic("h, mesh size (side of the square or period of the strip = 1)");
    let y = Axis::logarithmic("bound / error");
    let mut chart = Chart::new("How far the bound without C is from the error", x, y);
    let drawn = |study: &&BoundStudy| !matches!(study.problem, BoundProblem::Square(known) if known.transitions().len() == 2);
    for study in studies.iter().filter(drawn) {
        let points = |row: &BoundRow| Some((1.0 / row.n as f64, row.effectivity(VERSIONS.len() - 1, true)?));
        let points = study.rows.iter().filter_map(points).collect();
        chart = chart.with(Series::line_and_points(study.to_string(), points));
    }
    chart
}

fn main() -> ExitCode {
    example_frame::main(run)
}
