//! Theorems 3.1 and 4.1: is there a contact set whose consistency term comes near the paper's exponent?
//!
//! `cargo run --release --example worst_contact_set -- --tau 1.6 --out out`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::rates::STEADY;
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress};
use experiments::proof::{ContactFamily, SegmentSearch, SegmentSets, SetTerms};
use fractional_sobolev::{Order, Tolerance};
use signorini::cone::Cone;
use signorini::proof::SegmentConstant;
use signorini::proof::{consistency_constant, midpoint_bound, one_gap_ratio};
use signorini::rates::Bound;
use signorini::rates::ConvergenceOrder;
use std::process::ExitCode;

example_frame::options! {
    /// Search families of contact sets for the consistency term that decays slowest
    pub struct Options {
        /// Regularity, 3/2 < tau < 2
        #[arg(long, default_value_t = 1.75)]
        pub tau: f64,
        /// The data live on 2 to this power cells
        #[arg(long, default_value_t = 17, value_parser = clap::value_parser!(u32).range(13..=24))]
        pub depth: u32,
        /// Relative accuracy of the sharp constants
        #[arg(long, default_value = "1e-9")]
        pub tolerance: Tolerance,
    }
    memory(options) {
        270.0 * f64::from(options.depth).exp2()
    }
}

/// Computed for one τ.
pub struct Computed {
    /// The exponent of the theorem for the root of the term.
    pub paper: f64,
    /// Every family with its terms and the orders of their roots, nodal and midpoint cone.
    pub sets: Vec<(ContactFamily, SetTerms, [Option<ConvergenceOrder>; 2])>,
    /// κ, the best constant for one gap, and what no set passes under the midpoint cone.
    pub sharp: [SegmentConstant; 2],
    /// Sets made of the cells of a mesh, nodal and midpoint cone.
    pub searched: [SegmentSearch; 2],
}

/// Sets on the whole edge, then all sets on one segment.
pub fn compute(options: &Options) -> Result<Computed> {
    let Options { tau, depth, tolerance, .. } = *options;
    let families = ContactFamily::all(tau);
    let mut sets = Vec::new();
    for family in progress(families.len() as u64).wrap_iter(families.into_iter()) {
        let terms = family.terms(tau, 1 << depth)?;
        let orders = terms.roots().map(|points| ConvergenceOrder::of_power(&points));
        sets.push((family, terms, orders));
    }
    let order = Order::new(tau - 1.5)?;
    let sharp = [consistency_constant(order, tolerance)?, midpoint_bound(order, tolerance)?];
    let search = |cone| SegmentSets::new(order, CELLS)?.search(cone, GAPS, SETS, SEED);
    let searched = [search(Cone::Nodal)?, search(Cone::Midpoint)?];
    Ok(Computed { paper: Bound::Paper.exponent(tau)?, sets, sharp, searched })
}

/// Cells of one segment, how many gaps sets of them have at most, how many random sets.
const CELLS: usize = 48;
const GAPS: usize = 20;
const SETS: usize = 10_000;
const SEED: u64 = 2012;
/// Part of a share that its two seminorms, asked to 1e-8, and the sums may be off by.
const SHARE: f64 = 1e-6;

/// What decides: the shares and the ratios against one half, and orders against the theorem's exponent.
pub fn findings(computed: &Computed) -> Vec<Finding> {
    let Computed { paper, sets, sharp: [kappa, all], searched } = computed;
    let share = sets.iter().flat_map(|(_, terms, _)| terms.shares).fold(0.0, f64::max);
    let steady =
        |set: &SetTerms, fit: &ConvergenceOrder| fit.uncertainty < STEADY && set.shortest >= fit.regime.0;
    let fits = sets.iter().flat_map(|(_, set, fits)| fits.iter().flatten().filter(|f| steady(set, f)));
    let margins = fits.map(|fit| (fit.order - paper, fit.uncertainty));
    let nearest = margins.min_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1)));
    let (source, none) = ("half of h^(2 tau - 2) and both seminorms", "no set has a steady order");
    let best = searched.iter().map(SegmentSearch::largest).fold(0.0, f64::max) / kappa.value.value;
    let gaps = searched.iter().map(|found| found.climbed.gaps()).max().unwrap_or(0);
    vec![
        Finding::claim("half", "on every segment the term is at most half of both seminorms, scaled")
            .at_most(0.5, source)
            .by_proof("worst_contact_set"),
        Finding::claim("share", "no set on the edge takes more than {percent} % of that bound")
            .number(share, SHARE * share)
            .at_most(1.0, source),
        Finding::claim("nodal.ratio", "the worst segment with one gap takes {value} of both seminorms")
            .estimate(kappa.value)
            .at_most(0.5, source)
            .told(),
        Finding::claim("midpoint.ratio", "no set takes more than {value} under the midpoint cone")
            .estimate(all.value)
            .at_most(0.5, source),
        Finding::claim("search", "random sets and intervals take {percent} % of the worst gap at most")
            .number(best, best * kappa.value.relative_error())
            .at_most(1.0, "the sharp constant for one gap at an end")
            .told(),
        Finding::remark("climb", "gaps left after climbing from the best random set: {value} at most")
            .number(gaps as f64, 0.0)
            .at_most(1.0, "one gap at an end"),
        Finding::remark("nearest", "steady orders of resolved sets stay {value} and more above the exponent")
            .number_or(nearest, none)
            .at_least(0.0, format!("tau^2 - 5 tau/2 + 2 = {paper:.4}"))
            .told(),
        Finding::sharpness("loss", "h^{value} in the square on the set nearest to the exponent")
            .number_or(nearest.map(|(margin, half)| (2.0 * margin, 2.0 * half)), none)
            .at_least(0.0, "the exponent of the theorem"),
    ]
}

/// Searches and sets both searches beside the exponent.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = format!("tau = {}: term <= C h^(2 x {:.4}); which set?", options.tau, computed.paper);
    let mut headline = Headline::new("Theorems 3.1, 4.1", claim, table(&computed), findings(&computed));
    headline.draw(&options.output, "worst_contact_set", draw)?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
    let (three, two) = (Format::Fixed(3), Format::Significant(2));
    let columns = vec![
        Column::new("set", "contact set", Format::Plain, ""),
        Column::new("shortest", "piece", Format::Scientific(0), "shortest: orders count on finer levels"),
        Column::new("nodal", "nodal", three, "order of the root of the term, nodal cone"),
        Column::new("nodal_half", "+-", three, "what it may be off by: drift between halves, scatter"),
        Column::new("midpoint", "midpoint", three, "the same, midpoint cone"),
        Column::new("midpoint_half", "+-", three, ""),
        Column::new("nodal_share", "share K", two, "largest term over half of both seminorms, nodal"),
        Column::new("midpoint_share", "share M", two, "the same, midpoint cone"),
    ];
    Table::new(columns).with_rows(computed.sets.iter().map(|(family, terms, fits)| {
        let orders = fits.iter().flat_map(|f| [f.map(|f| f.order).into(), f.map(|f| f.uncertainty).into()]);
        let first: [Cell; 2] = [family.to_string().into(), terms.shortest.into()];
        first.into_iter().chain(orders).chain(terms.shares.map(Cell::from))
    }))
}

/// The best constant for one gap of length θ, and θ^{τ−2}.
fn draw() -> Result<Chart> {
    let x = Axis::logarithmic("length of the gap over that of the segment");
    let y = Axis::logarithmic("term over both seminorms");
    let mut chart = Chart::new("One segment, nodal cone: the worst term for a given gap", x, y);
    let gaps: Vec<f64> = (0..21).map(|k| 10f64.powf(-5.0 + 0.25 * f64::from(k)).min(0.9)).collect();
    for tau in [1.55, 1.75, 1.95] {
        let order = Order::new(tau - 1.5)?;
        let point = |&gap: &f64| Ok((gap, one_gap_ratio(Cone::Nodal, order, gap, Tolerance::fast())?.value));
        let points = gaps.iter().map(point).collect::<Result<_>>()?;
        chart = chart.with(Series::line_and_points(format!("tau = {tau}"), points));
    }
    let line = |power: f64| gaps.iter().map(|&gap| (gap, 0.5 * gap.powf(power))).collect();
    let chart = chart.with(Series::dashed("1/2", line(0.0)));
    Ok(chart.with(Series::dashed("theta^(tau-2)/2, tau = 7/4", line(-0.25))))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
