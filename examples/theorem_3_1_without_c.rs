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

/// What is computed.
pub struct Computed {
    /// Constants of a segment, each rounded up.
    pub segment: Vec<f64>,
    /// Scalar and elastic, one and two transitions, both cones.
    pub studies: Vec<BoundStudy>,
}

/// Relative accuracy of K and kappa, rounded up by their errors.
const SHARP: f64 = 1e-6;

/// Constants, and every problem on every mesh.
pub fn compute(options: &Options) -> Result<Computed> {
    let (nu, asked) = (FractionalOrder::HALF, Tolerance::new(SHARP)?);
    let up = |found: SegmentConstant| found.value.value + found.value.error;
    let sharp = [up(product_constant(nu, asked)?), up(consistency_constant(nu, asked)?)];
    let segment = vec![half_sharpened(nu), sharp[0], sharp[1]];
    let lame = Some(Lame::new(options.lambda, options.mu)?);
    let bar = progress(8 * u64::from(options.finest - 1));
    let mut studies = Vec::new();
    for (lame, two_transitions) in [(None, false), (None, true), (lame, false), (lame, true)] {
        for cone in [Cone::Nodal, Cone::Midpoint] {
            let scene = ClosedForm { two_transitions, lame };
            studies.push(BoundStudy::new(scene, cone, &segment, options.finest, || bar.inc(1))?);
        }
    }
    Ok(Computed { segment, studies })
}

/// Quadrature of the error and data of the sides, relative.
const QUADRATURE: f64 = 1e-3;

/// What decides: bound over error on every mesh.
pub fn findings(computed: &Computed) -> Result<Vec<Finding>> {
    let last = VERSIONS.len() - 1;
    let all = |keep: &dyn Fn(&BoundStudy) -> bool, version: usize, local: bool| -> Result<Vec<f64>> {
        let kept = computed.studies.iter().filter(|study| keep(study));
        Ok(kept
            .map(|study| study.effectivities(version, local))
            .collect::<std::result::Result<Vec<_>, _>>()?
            .concat())
    };
    let bar = |quotient: Option<f64>| quotient.map(|quotient| (quotient, QUADRATURE * quotient));
    let every = |_: &BoundStudy| true;
    let plain = |study: &BoundStudy| study.scene.lame.is_none() && study.cone == Cone::Nodal;
    let mut findings = Vec::new();
    for (version, [name, _]) in VERSIONS.iter().enumerate() {
        let words = format!("with {name} the bound is at least {{value}} times the error on every mesh");
        let smallest = bar(all(&every, version, true)?.into_iter().reduce(f64::min));
        let claim = Finding::claim(format!("above.{name}"), words).number_or(smallest, "no mesh");
        findings.push(claim.at_least(1.0, "the error itself").told());
    }
    let largest = |found: Vec<f64>| bar(found.into_iter().reduce(f64::max));
    findings.push(
        Finding::sharpness("whole", "scalar, nodal cone, from |u|_2 alone: at most {value} times the error")
            .number_or(largest(all(&plain, last, false)?), "no mesh")
            .at_least(1.0, "the error itself")
            .told(),
    );
    findings.push(
        Finding::remark("every", "all problems, both cones: the bound is at most {value} times the error")
            .number_or(largest(all(&every, last, true)?), "no mesh")
            .at_most(4.0, "an effectivity of 4")
            .otherwise("on some mesh the bound is {value} times the error"),
    );
    Ok(findings)
}

/// Solves, decides and shows.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "|u - u_h|_a <= C h |u|_2 for tau = 2, any contact set, with a number in the place of C";
    let (found, last) = (findings(&computed)?, VERSIONS.len() - 1);
    let mut headline = Headline::new("Theorems 3.1, 4.1, tau = 2", claim, table(&computed)?, found);
    for study in computed.studies.iter().filter(|study| !study.scene.two_transitions) {
        let kind = if study.scene.lame.is_some() { "elastic" } else { "scalar" };
        for ([name, _], bound) in VERSIONS.iter().zip(&study.bounds) {
            headline.quote(format!("without.c.{kind}.{}.{name}", study.cone), bound.constant());
        }
        if let Some(&finest) = study.effectivities(last, true)?.last() {
            headline.quote(format!("without.c.{kind}.{}.finest", study.cone), finest);
        }
    }
    for ([name, _], constant) in VERSIONS.iter().zip(&computed.segment) {
        headline.quote(format!("without.c.{name}"), *constant);
    }
    headline.quote("without.c.interpolation", MeshShape::right_isosceles().interpolation);
    headline.draw(&options.output, "theorem_3_1_without_c", || draw(&computed))?;
    Ok(headline)
}

fn table(computed: &Computed) -> Result<Table> {
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
    for study in &computed.studies {
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
fn draw(computed: &Computed) -> Result<Chart> {
    let (x, y) = (Axis::logarithmic("h"), Axis::logarithmic("bound over error"));
    let mut chart = Chart::new("How far the bound without C is from the error", x, y);
    for study in computed.studies.iter().filter(|study| !study.scene.two_transitions) {
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
