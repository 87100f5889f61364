//! The sharp constants of one contact segment: how much of one half is lost on the worst contact set?
//!
//! c(ν) by potentials, K(ν) for products of L¹ norms, κ(ν) for one gap, κ̄(ν) for all sets, midpoint cone.
//!
//! `cargo run --release --example segment_constants`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use experiments::EstimateExt;
use fractional_sobolev::{Estimate, Moment, Order, Tolerance, moment};
use signorini::proof::{
    SegmentConstant, consistency_constant, midpoint_bound, product_bound, product_constant,
};
use std::process::ExitCode;

example_frame::options! {
    /// The best constants of a contact segment, by two roads
    pub struct Options {
        /// Orders nu = tau - 3/2 in [0.001, 0.999]
        #[arg(long, value_delimiter = ',', default_value = "0.001,0.1,0.25,0.5,0.75,0.9,0.999")]
        pub nu: Vec<Order>,
        /// The order for which the extremal pair is drawn
        #[arg(long, default_value = "0.25")]
        pub pair: Order,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-9")]
        pub tolerance: Tolerance,
    }
}

/// One order.
pub struct Row {
    /// The order.
    pub nu: Order,
    /// c, exact.
    pub potentials: f64,
    /// K, κ and κ̄.
    pub sharp: [SegmentConstant; 3],
    /// How far the strong form's bounds are from them at most.
    pub apart: f64,
    /// How far K is from its closed form, at ν = 1/2.
    pub closed: Option<f64>,
}

/// The constants of every order, by both roads.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let row = |&nu: &Order| -> Result<Row> {
        let tol = options.tolerance;
        let sharp = [product_constant(nu, tol)?, consistency_constant(nu, tol)?, midpoint_bound(nu, tol)?];
        let apart = sharp.iter().map(|found| Ok(found.apart()?));
        let apart = apart.reduce(|a: Result<f64>, b| Ok(a?.max(b?))).unwrap_or(Ok(0.0))?;
        let off = || -> Result<f64> {
            let exact = moment(Order::HALF, 0.5..1.0, Moment::Mass, tol)?.closed_form()?;
            Ok((sharp[0].value.value / exact.value.powi(2) - 1.0).abs())
        };
        let closed = (nu == Order::HALF).then(off).transpose()?;
        Ok(Row { nu, potentials: product_bound(nu), sharp, apart, closed })
    };
    progress(options.nu.len() as u64).wrap_iter(options.nu.iter()).map(row).collect()
}

/// How far apart the two roads may be.
const ASKED: f64 = 1e-8;
const HALF: &str = "the bound by measures, one half";
/// 24 K/(1−ν) differs from 1 by less than this times 1 − ν: 2.2 was seen.
const NEAR_ONE: f64 = 4.0;

/// What decides: the distance of the two roads, the order of the constants, their limits at one.
pub fn findings(rows: &[Row]) -> Vec<Finding> {
    let apart = rows.iter().map(|row| (row.apart, 0.0)).reduce(|a, b| if b.0 > a.0 { b } else { a });
    let steps = rows.iter().flat_map(|Row { potentials, sharp: [k, kappa, midpoint], .. }| {
        let c = k.value.times(1.0 / potentials);
        [kappa.value.over(midpoint.value), midpoint.value.over(k.value), c].into_iter().flatten()
    });
    let mut findings = vec![
        Finding::claim("half", "c = nu / (2 (4^nu - 1)) in place of 1/2: potentials are weakest at e = 1/2")
            .at_most(0.5, HALF)
            .by_proof("segment_constants"),
        Finding::sharpness("loose", "the best constant is at most {percent} % of one half")
            .largest(rows.iter().flat_map(|row| row.sharp[1].value.times(2.0)))
            .at_most(1.0, HALF),
        Finding::remark("closed", "at nu = 1/2 K is off its closed form by {value} of itself")
            .number_or(rows.iter().find_map(|row| Some((row.closed?, 0.0))), "1/2 is not among the orders")
            .at_most(ASKED, "Wiener and Hopf, roots of tan z = z"),
        Finding::claim("roads", "two roads to the constants are {value} apart, relative to them")
            .number_or(apart, "no order")
            .at_most(ASKED, "the bounds of the strong form around the values by slopes")
            .told(),
        Finding::claim("order", "kappa, midpoint bound, K, c: none is more than {percent} % of the next")
            .largest(steps)
            .at_most(1.0, "one gap, every set, the product of norms, potentials alone"),
    ];
    if let Some(Row { nu, sharp, .. }) = rows.iter().max_by(|a, b| a.nu.value().total_cmp(&b.nu.value())) {
        let left = 0.5 - nu.offset();
        let Estimate { value, error, .. } = sharp[0].value;
        let words = format!("24 K / (1 - nu) is {{value}} at nu = {nu}");
        let finding = Finding::remark("limit", words).number(24.0 * value / left, 24.0 * error / left);
        findings.push(finding.within(NEAR_ONE * left, 1.0, "its limit as nu -> 1"));
    }
    findings.extend(rows.iter().map(|Row { nu, sharp, .. }| {
        let key = format!("kappa.nu{nu}");
        Finding::remark(key, format!("kappa({nu}) = {{value}}")).estimate(sharp[1].value).at_most(0.5, HALF)
    }));
    findings
}

/// Computes, compares, draws.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "a segment's term is at most kappa h^(2 tau - 2) |sigma_N| |u_N'|, kappa far below 1/2";
    let mut headline = Headline::new("Sharp constants", claim, table(&rows), findings(&rows));
    headline.draw(&options.output, "segment_constants", || Ok(draw(&rows)))?;
    headline.draw(&options.output, "segment_constants_pair", || draw_pair(options.pair))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let (ten, none) = (Format::Significant(10), Format::Scientific(0));
    let columns = vec![
        Column::new("nu", "nu", Format::Plain, "tau - 3/2"),
        Column::new("c", "c", Format::Significant(6), "by potentials: nu / (2 (4^nu - 1))"),
        Column::new("product", "K", ten, "best constant of the product of L^1 norms, any set"),
        Column::new("consistency", "kappa", ten, "best constant of the term, one gap, either cone"),
        Column::new("contact", "contact", Format::Fixed(4), "contact length at which it is reached"),
        Column::new("midpoint", "midpoint", Format::Significant(8), "bound of the midpoint cone, any set"),
        Column::new("roads", "roads", none, "how far the strong form's bounds are, relative"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let [product, consistency, midpoint] = row.sharp.map(|found| found.value.value);
        let [nu, c, contact] = [row.nu.value(), row.potentials, row.sharp[1].contact];
        [nu, c, product, consistency, contact, midpoint, row.apart]
    }))
}

fn draw(rows: &[Row]) -> Chart {
    let axes = (Axis::linear("ν = τ - 3/2"), Axis::linear("constant"));
    let points = |value: &dyn Fn(&Row) -> f64| rows.iter().map(|row| (row.nu.value(), value(row))).collect();
    Chart::new("Bounds of the term of one segment", axes.0, axes.1)
        .with(Series::dashed("1/2", points(&|_| 0.5)))
        .with(Series::line_and_points("c, potentials", points(&|row| row.potentials)))
        .with(Series::line_and_points("K, any set", points(&|row| row.sharp[0].value.value)))
        .with(Series::line_and_points("midpoint, any set", points(&|row| row.sharp[2].value.value)))
        .with(Series::line_and_points("κ, one gap", points(&|row| row.sharp[1].value.value)))
}

/// The pair for which κ is attained: σ_N on the right, u_N' on the gap at the left end.
fn draw_pair(nu: Order) -> Result<Chart> {
    let fast = Tolerance::fast();
    let gap = 1.0 - consistency_constant(nu, fast)?.contact;
    let sigma = moment(nu, 0.0..gap, Moment::FromFreeEnd, fast)?.extremal()?;
    let slope = moment(nu, gap..1.0, Moment::Mass, fast)?.extremal()?;
    let places = || (0..=400).map(|k| f64::from(k) / 400.0);
    let (x, y) = (Axis::linear("place on the segment"), Axis::linear("seminorms 1"));
    Ok(Chart::new(format!("The worst pair, ν = {nu}, gap {gap:.3}"), x, y)
        .with(Series::line("σ_N", places().map(|x| (x, -sigma.value(&[x]))).collect()))
        .with(Series::line("u_N'", places().map(|x| (x, slope.value(&[x]))).collect())))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
