//! Theorems 3.1 and 4.1: is there a contact set whose consistency term comes near the paper's exponent?
//!
//! `cargo run --release --example worst_contact_set -- --tau 1.6 --out out`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use signorini::cone::Cone;
use signorini::convergence::{Bound, Fit};
use signorini::proof::{ContactFamily, Exponent, SetTerms, WorstGaps, worst_gaps, worst_ratio};
use signorini::{Estimate, Tolerance};
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
        /// Relative accuracy of the worst ratio of one segment
        #[arg(long, default_value = "0.02")]
        pub tolerance: Tolerance,
    }
}

/// Computed for one τ.
pub struct Computed {
    /// The exponent of the theorem for the root of the term.
    pub paper: f64,
    /// Every family with its terms and the orders of their roots, nodal and midpoint cone.
    pub sets: Vec<(ContactFamily, SetTerms, [Option<Fit>; 2])>,
    /// The worst gaps found on one segment, nodal and midpoint cone.
    pub worst: [WorstGaps; 2],
    /// (θ, worst nodal ratio) for short gaps θ at one end.
    pub short: Vec<(f64, Estimate)>,
}

/// Sets on the whole edge, then all sets on one segment.
pub fn compute(options: &Options) -> Result<Computed> {
    let Options { tau, depth, tolerance, .. } = *options;
    let families = ContactFamily::all(tau);
    let mut sets = Vec::new();
    for family in progress(families.len() as u64).wrap_iter(families.into_iter()) {
        let terms = family.terms(tau, 1 << depth)?;
        let orders = terms.roots().map(|points| Fit::power(&points));
        sets.push((family, terms, orders));
    }
    let worst = [worst_gaps(Cone::Nodal, tau, tolerance)?, worst_gaps(Cone::Midpoint, tau, tolerance)?];
    let short = |theta: f64| Ok((theta, worst_ratio(Cone::Nodal, tau, 0.0, theta, tolerance)?));
    let short = [1e-3, 1e-4, 1e-5].into_iter().map(short).collect::<Result<_>>()?;
    Ok(Computed { paper: Bound::Paper.exponent(tau)?, sets, worst, short })
}

/// An order with a wider bar is no order.
const STEADY: f64 = 0.1;
/// Part of a share that its two seminorms, asked to 1e-8, and the sums may be off by.
const SHARE: f64 = 1e-6;
/// Short gaps have the exponent of the limit up to terms of the size of the gap's own power.
const LIMIT: f64 = 0.05;

/// What decides: the shares and the ratios against one half, and orders against the theorem's exponent.
pub fn findings(options: &Options, computed: &Computed) -> Vec<Finding> {
    let (tau, Computed { paper, sets, worst: [nodal, midpoint], short, .. }) = (options.tau, computed);
    let share = sets.iter().flat_map(|(_, terms, _)| terms.shares).fold(0.0, f64::max);
    let steady = |set: &SetTerms, fit: &Fit| fit.half_width < STEADY && set.shortest >= fit.regime.0;
    let fits = sets.iter().flat_map(|(_, set, fits)| fits.iter().flatten().filter(|f| steady(set, f)));
    let margins = fits.map(|fit| (fit.order - paper, fit.half_width));
    let nearest = margins.min_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1)));
    let ratios: Vec<(f64, f64)> = short.iter().map(|(theta, ratio)| (*theta, ratio.value)).collect();
    let relative = short.iter().map(|(_, ratio)| ratio.relative_error()).fold(0.0, f64::max);
    let fall = Exponent::fit(&ratios).ok().map(|e| (e.value, e.uncertainty + 2.0 * relative / 100f64.ln()));
    let (source, none) = ("half of h^(2 tau - 2) and both seminorms", "no set has a steady order");
    let ratio = |key: &str, cone: &str, found: &WorstGaps| {
        let words = format!("the worst {cone} segment found takes {{value}} of both seminorms");
        Finding::claim(key, words).estimate(found.ratio).at_most(0.5, source).told()
    };
    vec![
        Finding::claim("half", "on every segment the term is at most half of both seminorms, scaled")
            .at_most(0.5, source)
            .by_proof("worst_contact_set"),
        Finding::claim("share", "no set on the edge takes more than {percent} % of that bound")
            .number(share, SHARE * share)
            .at_most(1.0, source),
        ratio("nodal.ratio", "nodal", nodal),
        ratio("midpoint.ratio", "midpoint", midpoint),
        Finding::remark("nearest", "steady orders of resolved sets stay {value} and more above the exponent")
            .number_or(nearest, none)
            .at_least(0.0, format!("tau^2 - 5 tau/2 + 2 = {paper:.4}"))
            .told(),
        Finding::sharpness("loss", "h^{value} in the square on the set that comes nearest to the exponent")
            .number_or(nearest.map(|(margin, half)| (2.0 * margin, 2.0 * half)), none)
            .at_least(0.0, "the exponent of the theorem"),
        Finding::remark("short.gap", "a short gap makes the term of its segment small, like theta^{value}")
            .number_or(fall, "no three short gaps")
            .within(LIMIT, 2.0 * tau - 3.0, "2 tau - 3, a gap beside a constant pressure"),
    ]
}

/// Searches and sets both searches beside the exponent.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let (tau, paper, [nodal, midpoint]) = (options.tau, computed.paper, &computed.worst);
    let claim = format!("tau = {tau}: the term is at most C h^(2 x {paper:.4}); is any set near that?");
    let found = findings(options, &computed);
    let mut headline = Headline::new("Theorems 3.1, 4.1", claim, table(&computed), found);
    for (key, found) in [("nodal", nodal), ("midpoint", midpoint)] {
        headline.quote_with(&format!("worst.contact.set.{key}.ratio"), found.ratio.value, found.ratio.error);
        headline.quote(format!("worst.contact.set.{key}.left"), found.gaps[0]);
        headline.quote(format!("worst.contact.set.{key}.right"), found.gaps[1]);
    }
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
    let mut table = Table::new(columns);
    for (family, terms, [nodal, midpoint]) in &computed.sets {
        let mut row = vec![family.to_string().into(), terms.shortest.into()];
        for fit in [nodal, midpoint] {
            row.extend([fit.map(|fit| fit.order).into(), fit.map(|fit| fit.half_width).into()]);
        }
        row.extend(terms.shares.map(Into::into));
        table.push(row);
    }
    table
}

/// The worst ratio (to a tenth: constants leave the space near τ = 2) over the length θ of an end gap, and θ^{τ−2}.
fn draw() -> Result<Chart> {
    let tolerance = Tolerance::new(0.1)?;
    let x = Axis::logarithmic("length of the end gap over that of the segment");
    let y = Axis::logarithmic("term over the seminorms of sigma_N and u_N'");
    let mut chart = Chart::new("One segment, nodal cone: the worst term for a given gap", x, y);
    let gaps: Vec<f64> = (0..20).map(|k| 10f64.powf(-5.0 + 0.25 * f64::from(k))).collect();
    for tau in [1.55, 1.75, 1.95] {
        let point = |&gap: &f64| Ok((gap, worst_ratio(Cone::Nodal, tau, 0.0, gap, tolerance)?.value));
        let points: Result<_> = gaps.iter().map(point).collect();
        chart = chart.with(Series::line_and_points(format!("tau = {tau}"), points?));
    }
    let line = |power: f64| gaps.iter().map(|&gap| (gap, 0.5 * gap.powf(power))).collect();
    let chart = chart.with(Series::dashed("1/2", line(0.0)));
    Ok(chart.with(Series::dashed("theta^(tau-2)/2, tau = 7/4", line(-0.25))))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
