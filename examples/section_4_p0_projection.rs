//! (4.6) and (4.7): ‖φ − π^h φ‖₀ ≤ C h^r |φ|_r and ‖φ − π^h φ‖_{1/2,*} ≤ C h^{r+1/2} |φ|_r for 0 ≤ r ≤ 1.
//!
//! Best constants on one element, and rates on two roads: of one rough function, and of the supremum over all
//! of H^r. Both roads count, in both norms.

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress, within};
use experiments::EstimateExt;
use experiments::interpolation::{ProjectionRates, ProjectionStudy};
use fractional_sobolev::{Domain, ErrorNorm, Estimate, Tolerance, projection_constant};
use std::process::ExitCode;

/// Distance of a rate from r or r + 1/2, its uncertainty included, that counts as agreement: a tenth of half
/// an order.
const AGREEMENT: f64 = 0.05;
/// Part of the chain's constant that C*(r) is at least.
const CHAIN: f64 = 0.99;

example_frame::options! {
    /// The P0 projection: best constants and rates in L2 and in the dual norm of H^(1/2)
    pub struct Options {
        /// Orders r in [0, 1], comma separated
        #[arg(long, value_delimiter = ',', default_values = ["0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"], value_parser = within::<f64>("[0, 1]"))]
        pub r: Vec<f64>,
    }
}

/// One order.
pub struct Row {
    /// The order.
    pub r: f64,
    /// C(r) C(1/2), the constant of (4.7) by the paper's chain of inequalities.
    pub chain: f64,
    /// In L2 and in the dual norm.
    pub norms: [ProjectionRates; 2],
}

/// Constants and rates for every r.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let bar = progress(options.r.len() as u64);
    let unit = Domain::Interval(1.0);
    let half = projection_constant(unit, ErrorNorm::L2, 0.5, Tolerance::balanced())?.constant;
    let study = ProjectionStudy::new()?;
    let mut rows = Vec::new();
    for &r in &options.r {
        let norms = study.rates(r)?;
        rows.push(Row { r, chain: norms[0].constant.value * half.value, norms });
        bar.inc(1);
    }
    Ok(rows)
}

/// Which of the numbers of one norm is looked at.
type Of = fn(&ProjectionRates) -> Estimate;

/// How far rates are from theory, over all orders, in one norm.
fn off(rows: &[Row], norm: usize, of: Of) -> impl Iterator<Item = Estimate> {
    rows.iter().filter_map(move |row| of(&row.norms[norm]).off(row.norms[norm].theory).ok())
}

/// What decides: rates on both roads in both norms, and the supremum against the best constants.
pub fn findings(_: &Options, rows: &[Row]) -> Vec<Finding> {
    let roads: [(&str, &str, Of); 2] =
        [("function", "one function", |n| n.function), ("supremum", "all of H^r", |n| n.supremum.rate)];
    let norms = [("l2", "L2", "r", "(4.6)"), ("dual", "the dual norm", "r + 1/2", "(4.7)")];
    let rates = roads.iter().flat_map(|(road, words, of)| {
        norms.iter().enumerate().map(move |(norm, (key, name, theory, source))| {
            let words = format!("the rates of {words} in {name} are within {{value}} of {theory}");
            let claim = Finding::claim(format!("{road}.{key}"), words).largest(off(rows, norm, *of));
            claim.at_most(AGREEMENT, *source).told()
        })
    });
    let all = || rows.iter().flat_map(|row| &row.norms);
    let observed = [0, 1].into_iter().flat_map(|norm| off(rows, norm, |n| n.supremum.observed));
    let others = [
        Finding::claim("above", "the supremum takes at most {percent} % of the best constants")
            .largest(all().filter_map(|norm| norm.supremum.share(norm.constant).ok()))
            .at_most(1.0, "best constants C(r), C*(r)"),
        Finding::claim("below", "a wave of half a period per element bounds the supremum from below")
            .smallest(all().filter_map(|norm| norm.supremum.scaled.over(norm.wave).ok()))
            .at_least(1.0, "the wave")
            .by_proof("section_4_p0_projection"),
        Finding::remark("observed", "between 32 and 64 elements as they stand rates are off by {value}")
            .largest(observed)
            .at_most(AGREEMENT, "they near theirs like N^(-2r)")
            .told(),
        Finding::remark("chain", "the best constant C*(r) is at least {value} of the paper's chain")
            .smallest(rows.iter().filter_map(|row| row.norms[1].constant.times(row.chain.recip()).ok()))
            .at_least(CHAIN, "equality at r = 0 and 1/2"),
    ];
    rates.chain(others).collect()
}

/// Measures the rates on both roads in both norms.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "|phi - pi^h phi| <= C h^r |phi|_r in L2 and C h^(r+1/2) |phi|_r in the dual norm of H^(1/2)";
    let mut headline = Headline::new("(4.6), (4.7)", claim, table(&rows), findings(options, &rows));
    let worst = |of: Of| {
        let distances = [0, 1].into_iter().flat_map(|norm| off(&rows, norm, of));
        distances.map(|distance| distance.value).fold(0.0, f64::max)
    };
    let [function, supremum] = [worst(|n| n.function), worst(|n| n.supremum.rate)];
    headline.quote("section_4_projection.worst_rate", f64::max(function, supremum));
    headline.quote("section_4_projection.worst_function_rate", function);
    headline.quote("section_4_projection.worst_supremum_rate", supremum);
    headline.quote("section_4_projection.worst_observed_rate", worst(|n| n.supremum.observed));
    for Row { r, norms: [l2, dual], .. } in &rows {
        headline.quote(format!("section_4_projection.constant_l2.r_{r}"), l2.constant.value);
        headline.quote(format!("section_4_projection.constant_dual.r_{r}"), dual.constant.value);
    }
    headline.draw(&options.output, "section_4_p0_projection", || Ok(draw(&rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let (rate, digits) = (Format::Fixed(4), Format::Fixed(7));
    let phi = "rate of phi = x^(r-1/2+0.005), theory r + 0.005; of cos(pi x) for r = 1";
    let sup = "rate of the supremum over H^r, theory r: S^-2 = A N^(2 rate) - B for 16 ... 64 elements";
    let same = "the same in the dual norm, theory r + 1/2";
    Table::new(vec![
        Column::new("r", "r", Format::Significant(3), ""),
        Column::new("constant_l2", "C(r)", digits, "best constant of (4.6) on one element"),
        Column::new("function_l2", "phi L2", rate, phi),
        Column::new("function_error_l2", "+- phi", rate, "3.5 times the change from coarser meshes"),
        Column::new("supremum_l2", "sup L2", rate, sup),
        Column::new("error_l2", "+- sup", rate, "three times that change, and that from half as many cells"),
        Column::new("constant_dual", "C*(r)", digits, "best constant of (4.7) element by element"),
        Column::new("function_dual", "phi dual", rate, same),
        Column::new("function_error_dual", "+-", rate, "in the dual norm"),
        Column::new("supremum_dual", "sup dual", rate, same),
        Column::new("error_dual", "+-", rate, "in the dual norm"),
        Column::new("chain", "chain", digits, "C(r) C(1/2), from the paper's chain of inequalities"),
    ])
    .with_rows(rows.iter().map(|row| {
        let norms = row.norms.iter().flat_map(|norm| {
            let (phi, sup) = (norm.function, norm.supremum.rate);
            [norm.constant.value, phi.value, phi.error, sup.value, sup.error]
        });
        [row.r].into_iter().chain(norms).chain([row.chain]).collect::<Vec<_>>()
    }))
}

fn draw(rows: &[Row]) -> Chart {
    let x = Axis::linear("r, smoothness of the function");
    let chart =
        Chart::new("(4.6), (4.7): rates of the P0 projection", x, Axis::linear("rate, exponent of h"));
    [("L2", "r"), ("dual norm", "r + 1/2")].iter().enumerate().fold(chart, |chart, (k, (norm, theory))| {
        let points = |of: fn(&ProjectionRates) -> f64| -> Vec<(f64, f64)> {
            rows.iter().map(|row| (row.r, of(&row.norms[k]))).collect()
        };
        chart
            .with(Series::dashed(*theory, points(|n| n.theory)))
            .with(Series::points(format!("{norm}, one function"), points(|n| n.function.value)))
            .with(Series::points(format!("{norm}, supremum"), points(|n| n.supremum.rate.value)))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
