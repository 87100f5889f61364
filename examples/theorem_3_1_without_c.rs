//! Theorems 3.1 and 4.1 at tau = 2 with every constant known: a number above the error, on every mesh.
//!
//! `cargo run --release --example theorem_3_1_without_c -- --finest 8`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use signorini::Tolerance;
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::proof::{
    BoundStudy, MeshShape, SegmentConstant, consistency_constant, half_sharpened, product_constant,
};
use signorini::scenes::ClosedForm;
use signorini::sobolev::FractionalOrder;
use std::process::ExitCode;

example_frame::options! {
    /// Compare the bound without C with the error of problems in closed form
    pub struct Options {
        /// Meshes of 4 x 4 ... n x n squares, n = 2 to this power
        #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(4..=11))]
        pub finest: u32,
        /// Lame's first constant of the elastic problems, at least 0
        #[arg(long, default_value_t = 1.0)]
        pub lambda: f64,
        /// Lame's second constant
        #[arg(long, default_value_t = 1.0)]
        pub mu: f64,
    }
}

/// Versions of the constant of a segment: column of the bound over the error, and of the same from |u|_2 alone.
const VERSIONS: [[&str; 2]; 3] = [["c", "c_whole"], ["K", "K_whole"], ["kappa", "kappa_whole"]];

/// Relative accuracy of K and kappa, rounded up by their errors.
const SHARP: f64 = 1e-6;

/// Scalar and elastic, one and two transitions, both cones, on every mesh.
pub fn compute(options: &Options) -> Result<Vec<BoundStudy>> {
    let (nu, asked) = (FractionalOrder::HALF, Tolerance::new(SHARP)?);
    let up = |found: SegmentConstant| found.value.value + found.value.error;
    let sharp = [up(product_constant(nu, asked)?), up(consistency_constant(nu, asked)?)];
    let segment = [half_sharpened(nu), sharp[0], sharp[1]];
    let lame = Some(Lame::new(options.lambda, options.mu)?);
    let bar = progress(8 * u64::from(options.finest - 1));
    let mut studies = Vec::new();
    for (lame, two_transitions) in [(None, false), (None, true), (lame, false), (lame, true)] {
        for cone in [Cone::Nodal, Cone::Midpoint] {
            let scene = ClosedForm { two_transitions, lame };
            studies.push(BoundStudy::new(scene, cone, &segment, options.finest, || bar.inc(1))?);
        }
    }
    Ok(studies)
}

/// Quadrature of the error and data of the sides, relative.
const QUADRATURE: f64 = 1e-3;

/// What decides: bound over error on every mesh.
pub fn findings(studies: &[BoundStudy]) -> Result<Vec<Finding>> {
    let korn = |study: &BoundStudy| study.scene.lame.is_some() && study.cone == Cone::Midpoint;
    let all = |keep: &dyn Fn(&BoundStudy) -> bool, version: usize, local: bool| -> Result<Vec<Vec<f64>>> {
        let kept = studies.iter().filter(|study| keep(study));
        Ok(kept.map(|s| s.effectivities(version, local)).collect::<signorini::Result<_>>()?)
    };
    let decide = |finding: Finding, found: Vec<f64>, better: fn(f64, f64) -> f64| {
        let number = found.into_iter().reduce(better).map(|number| (number, QUADRATURE * number));
        finding.number_or(number, "no mesh")
    };
    let mut findings = Vec::new();
    for (version, [name, _]) in VERSIONS.iter().enumerate() {
        let words = format!("with {name} the bound is at least {{value}} times the error on every mesh");
        let claim = Finding::claim(format!("above.{name}"), words);
        let claim = decide(claim, all(&|_| true, version, true)?.concat(), f64::min);
        findings.push(claim.at_least(1.0, "the error itself").told());
    }
    let last = VERSIONS.len() - 1;
    let words = "with kappa and |u|_2 alone, elastic midpoint rows apart, at most {value} times the error";
    let whole = Finding::claim("whole", words);
    let whole = decide(whole, all(&|study| !korn(study), last, false)?.concat(), f64::max);
    findings.push(whole.at_most(4.0, "effectivity 4, all but elasticity with the midpoint cone").told());
    let words = "elastic, midpoint cone: up to {value} times, with |u|_2 near the edge, for Korn's constant";
    let found = Finding::remark("korn", words);
    findings.push(decide(found, all(&korn, last, true)?.concat(), f64::max).at_least(4.0, "effectivity 4"));
    let falls = all(&|_| true, last, true)?;
    let falls = falls.iter().flat_map(|found| found.windows(2).map(|pair| pair[1] / pair[0])).collect();
    let trend = Finding::remark("trend", "from one mesh to the next the quotient changes by {value} at most");
    findings.push(decide(trend, falls, f64::max).at_most(1.0 + QUADRATURE, "the same quotient"));
    Ok(findings)
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let studies = compute(options)?;
    let claim = "|u - u_h|_a <= C h |u|_2 for tau = 2, any contact set, with a number in the place of C";
    let found = findings(&studies)?;
    let mut headline = Headline::new("Theorems 3.1, 4.1, tau = 2", claim, table(&studies)?, found);
    for study in studies.iter().filter(|study| !study.scene.two_transitions) {
        let kind = if study.scene.lame.is_some() { "elastic" } else { "scalar" };
        for ([name, _], bound) in VERSIONS.iter().zip(&study.bounds) {
            headline.quote(format!("without.c.{kind}.{}.{name}", study.cone), bound.constant());
        }
    }
    headline.quote("without.c.interpolation", MeshShape::right_isosceles().interpolation);
    headline.draw(&options.output, "theorem_3_1_without_c", || draw(&studies))?;
    Ok(headline)
}

fn table(studies: &[BoundStudy]) -> Result<Table> {
    let (number, two) = (Format::Scientific(3), Format::Fixed(2));
    let mut columns = vec![
        Column::new("problem", "problem, cone", Format::Plain, ""),
        Column::new("n", "1/h", Format::Plain, "squares along each side"),
        Column::new("error", "error", number, "|u - u_h|_a"),
        Column::new("interpolation", "interp", number, "|u - I^h u|_a"),
        Column::new("share", "near", two, "|u|_2 in the squares on the contact edge over |u|_2"),
    ];
    for [name, whole] in VERSIONS {
        columns.push(Column::new(name, name, two, "bound over error"));
        columns.push(Column::new(whole, whole, two, "the same from |u|_2 alone"));
    }
    let mut table = Table::new(columns);
    for study in studies {
        let version =
            |version| Ok([study.effectivities(version, true)?, study.effectivities(version, false)?]);
        let quotients = (0..VERSIONS.len()).map(version).collect::<Result<Vec<_>>>()?.concat();
        for (i, level) in study.levels.iter().enumerate() {
            let share = level.near.value / study.whole.value;
            let mut row = vec![study.to_string().into(), level.n.into()];
            row.extend([level.error, level.interpolation, share].map(Into::into));
            row.extend(quotients.iter().map(|quotient| quotient[i].into()));
            table.push(row);
        }
    }
    Ok(table)
}

/// Bound over error against h, the best version, problems with one transition.
fn draw(studies: &[BoundStudy]) -> Result<Chart> {
    let (x, y) =
        (Axis::logarithmic("h, mesh size (side of the square = 1)"), Axis::logarithmic("bound / error"));
    let mut chart = Chart::new("How far the bound without C is from the error", x, y);
    for study in studies.iter().filter(|study| !study.scene.two_transitions) {
        let line = |local: bool| -> Result<Vec<(f64, f64)>> {
            let quotients = study.effectivities(VERSIONS.len() - 1, local)?;
            Ok(study.levels.iter().map(|level| 1.0 / level.n as f64).zip(quotients).collect())
        };
        chart = chart.with(Series::line_and_points(study.to_string(), line(true)?));
        chart = chart.with(Series::dashed(format!("{study}, |u|₂ alone"), line(false)?));
    }
    Ok(chart)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
