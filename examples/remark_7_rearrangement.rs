//! Remark 7 as a theorem: of all sets of one measure the interval at an end has the largest constant.
//!
//! The decreasing rearrangement v* has |v*|_ν ≤ |v|_ν: sorting lowers Σ (f_i − f_j)² over |i − j| ≤ k, all k.
//!
//! `cargo run --release --example remark_7_rearrangement`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, within};
use experiments::arrangement::{MovedZone, ZoneCase, random_zones};
use experiments::interpolation::{RoughFamily, rearranged_shares};
use experiments::sorting::{sorted_share_of_orders, sorted_share_of_random};
use experiments::zones::Condition;
use fractional_sobolev::{Estimate, Order, Tolerance};
use std::process::ExitCode;

example_frame::options! {
    /// Sorted orders, rearranged functions, and the constants of zones of several intervals
    pub struct Options {
        /// Random sequences, and random functions of each family
        #[arg(long, default_value_t = 1000)]
        pub functions: u32,
        /// Random zones of one to five intervals
        #[arg(long, default_value_t = 100)]
        pub zones: u32,
        /// Length of the zone that is moved, and of the two halves between which a gap opens
        #[arg(long, default_value_t = 1e-2, value_parser = within::<f64>("[1e-299, 0.99]"))]
        pub theta: f64,
        /// Relative tolerance of the constants
        #[arg(long, default_value = "1e-3")]
        pub tolerance: Tolerance,
    }
}

/// What was tried.
pub struct Computed {
    /// Near differences, sorted over given: the largest over all orders of 8 squares, and random sequences.
    pub sorted: f64,
    /// |v*|_ν / |v|_ν: the largest of each family, and the mean.
    pub functions: Vec<(RoughFamily, Estimate, f64)>,
    /// γ_E / γ_(0,θ); none where rounding forbids the tolerance.
    pub zones: Vec<(ZoneCase, Option<Estimate>)>,
    /// One zone moved, and cut in two.
    pub places: Vec<MovedZone>,
}

/// Tries everything.
pub fn compute(options: &Options) -> Result<Computed> {
    let Options { functions, theta, tolerance, .. } = *options;
    let squares: Vec<f64> = (0..8).map(|k| f64::from(k * k)).collect();
    let sorted = sorted_share_of_orders(&squares).max(sorted_share_of_random(functions, 7));
    let mut tried = Vec::new();
    for family in [RoughFamily::Linears, RoughFamily::Steps, RoughFamily::Weierstrass] {
        let (largest, mean) = rearranged_shares(family, functions, 7)?;
        tried.push((family, largest, mean));
    }
    let mut places = Vec::new();
    for nu in [0.25, 0.5, 0.75] {
        for condition in [Condition::MeanZero, Condition::Vanishing] {
            places.push(MovedZone::new(Order::new(nu)?, theta, condition, tolerance)?);
        }
    }
    Ok(Computed { sorted, functions: tried, zones: random_zones(options.zones, 7, tolerance)?, places })
}

/// Places closer than this have constants that differ by less than the tolerance.
const PLACED: f64 = 0.05;

/// What decides: every comparison of the proof, and the constants.
pub fn findings(options: &Options, computed: &Computed) -> Vec<Finding> {
    let (tolerance, page) = (options.tolerance.relative(), "remark_7_rearrangement");
    let Computed { sorted, functions, zones, places } = computed;
    let ratios = || zones.iter().filter_map(|(_, ratio)| *ratio);
    let off = places.iter().map(|place| 0.5 - place.share).fold(0.0, f64::max);
    let free = places.iter().filter(|place| place.condition == Condition::MeanZero);
    let halves = free.flat_map(|place| place.gaps.iter().filter_map(|gap| gap.1.over(place.whole).ok()));
    vec![
        Finding::claim("worst", "of all sets of one measure the interval at an end is the worst")
            .at_most(1.0, "the interval at an end")
            .by_proof(page),
        Finding::claim("orders", "no order of eight numbers, no random one has less than the sorted one")
            .number(*sorted, 0.0)
            .at_most(1.0, "near differences, sorted over given, for every reach"),
        Finding::claim("functions", "rearranged functions have at most {value} of the seminorm")
            .largest(functions.iter().map(|&(_, largest, _)| largest))
            .at_most(1.0 + Tolerance::balanced().relative(), "the seminorm of the function")
            .told(),
        Finding::remark("average", "on average at most {value} of it")
            .number(functions.iter().map(|&(.., mean)| mean).fold(0.0, f64::max), 0.0)
            .at_most(1.0, "the seminorm of the function"),
        Finding::claim("zones", "up to five intervals have at most {value} of the constant at the end")
            .largest(ratios())
            .at_most(1.0 + 2.0 * tolerance, "the interval at an end, to the tolerance of both")
            .told(),
        Finding::remark("refused", "for {value} of the zones rounding forbids the tolerance")
            .number((zones.len() - ratios().count()) as f64, 0.0)
            .at_most(0.1 * zones.len() as f64, "a tenth of the zones"),
        Finding::remark("middle", "one interval has its least constant in the middle")
            .number(off, 0.0)
            .within(PLACED, 0.0, "one half less its start over 1 - theta")
            .told(),
        Finding::remark("apart", "two halves have {value} of the constant at one end or more")
            .smallest(places.iter().map(|place| place.gaps[place.gaps.len() - 1].1))
            .at_most(1.0 - tolerance, "the interval at an end"),
        Finding::remark("floor", "with mean zero two halves come down to {value} of gamma_1")
            .smallest(halves)
            .within(4.0 * tolerance, 1.0, "gamma_1, below which no set comes"),
    ]
}

/// Tries everything, and says what held.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "the constant of a set of measure theta is at most that of (0, theta)";
    let mut headline = Headline::new("Remark 7", claim, table(&computed), findings(options, &computed));
    headline.draw(&options.output, "remark_7_unions", || Ok(draw_unions(&computed.zones)))?;
    headline.draw(&options.output, "remark_7_gaps", || Ok(draw_gaps(&computed.places)))?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
    let four = Format::Significant(4);
    let columns = vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("condition", "condition", Format::Plain, ""),
        Column::new("least_at", "least at", Format::Fixed(2), "start of the best interval over 1 - theta"),
        Column::new("least", "middle/end", four, "its constant over that at the end"),
        Column::new("narrow", "short gap", four, "two halves 1e-4 apart in the middle, over the end"),
        Column::new("ends", "both ends", four, "two halves at both ends, over one end"),
    ];
    Table::new(columns).with_rows(computed.places.iter().map(|place| {
        let ends = [0, place.gaps.len() - 1].map(|k| place.gaps[k].1.value);
        let mut row: Vec<Cell> = vec![place.order.value().into(), place.condition.to_string().into()];
        row.extend([place.share, place.least.value, ends[0], ends[1]].map(Cell::from));
        row
    }))
}

fn draw_unions(zones: &[(ZoneCase, Option<Estimate>)]) -> Chart {
    let (x, y) = ("theta, measure of the zone", "constant over that of (0, theta)");
    let chart = Chart::new("Random zones of one to five intervals", Axis::logarithmic(x), Axis::linear(y));
    (1..=5).fold(chart, |chart, count| {
        let cases = zones.iter().filter(|(case, _)| case.zones.count() == count);
        let points = cases.filter_map(|(case, ratio)| Some((case.zones.length(), (*ratio)?.value)));
        chart.with(Series::points(format!("intervals: {count}"), points.collect()))
    })
}

fn draw_gaps(places: &[MovedZone]) -> Chart {
    let x = Axis::linear("gap between the halves of a zone in the middle (interval = 1)");
    let chart = Chart::new("A gap inside the zone", x, Axis::linear("constant over that at the end"));
    places.iter().fold(chart, |chart, place| {
        let points = place.gaps.iter().map(|(gap, ratio)| (*gap, ratio.value)).collect();
        let is_vanishing = place.condition == Condition::Vanishing;
        let series = if is_vanishing { Series::dashed } else { Series::line_and_points };
        chart.with(series(format!("ν = {}, {}", place.order, place.condition), points))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
