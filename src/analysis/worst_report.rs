//! The search for a bad contact set: the consistency term that decays slowest, over families at fixed τ.
//!
//! Two searches. Sets of every kind on the whole edge, their terms on levels 2^3 ... 2^15 from the exact data (no discrete problem is solved),
//! with the order of the root of the term and its largest share of ½ h^{2τ−2} |σ_N| |u_N'|. And all contact sets on one segment, where the worst is known to
//! be the complement of gaps at its ends ([`worst_ratio`]): a grid of gaps down to 10^{−5}.
//!
//! A set shows its order only on levels finer than its smallest piece. On coarser ones a Cantor set with σ_N = −1 on short pieces looks
//! like point forces, of order below the theorem's exponent; its norm |σ_N|_{τ−3/2} is as large, so that the share tells the truth there.

use crate::contact::Cone;
use crate::convergence::{Bound, Fit};
use crate::edge::{consistency_terms, edge_norms};
use crate::error::{Error, Result};
use crate::figures::{Axis, Chart, Series};
use crate::proof::worst_ratio;
use crate::report::{Column, Format, Headline, Table, Verdict};
use crate::scenes::{StripScene, TransitionPowers};
use crate::strip::{EdgeData, Sides};

/// A contact set with what the search finds for one cone.
#[derive(Debug, Clone)]
pub struct SearchRow {
    /// The set, in words.
    pub set: String,
    /// Length of the shortest gap or contact piece.
    pub shortest: f64,
    /// Order of the root of the term, nodal and midpoint cone; `None` where it vanishes on some level.
    pub orders: [Option<Fit>; 2],
    /// Largest term over ½ h^{2τ−2} |σ_N|_{τ−3/2} |u_N'|_{τ−3/2} on the edge.
    pub shares: [f64; 2],
}

/// The families: single transitions at many positions and densities of σ_N, many transitions, Cantor sets of several ratios and depths,
/// fat Cantor sets.
///
/// # Errors
/// [`Error::OutOfRange`] for τ outside (3/2, 2).
pub fn search_sets(tau: f64, cells: usize, report: &mut dyn FnMut()) -> Result<Vec<SearchRow>> {
    Error::require("tau", tau, "(3/2, 2)", tau > 1.5 && tau < 2.0)?;
    let mut rows = Vec::new();
    for pressure in [tau - 2.0, 0.0, 0.5] {
        let powers = TransitionPowers { pressure, ..TransitionPowers::of_regularity(tau) };
        let scenes = (0..POSITIONS).map(|k| powers.data(0.3 + 0.125 * k as f64 / POSITIONS as f64, cells));
        let name = format!("transition, sigma_N ~ r^{pressure:.2}");
        rows.push(search_row(name, tau, scenes)?);
        report();
    }
    for kind in kinds() {
        let scene = kind.data(tau, cells, Sides::Natural);
        rows.push(search_row(kind.to_string(), tau, std::iter::once(scene))?);
        report();
    }
    Ok(rows)
}

/// Positions of a transition: odd.
const POSITIONS: usize = 9;

/// How many rows [`search_sets`] has.
pub fn search_size() -> usize {
    3 + kinds().len()
}

fn kinds() -> Vec<StripScene> {
    let many = [3, 11, 47].map(|gaps| StripScene::Transitions { gaps });
    let cantor = [(0.1, 2), (0.2, 3), (0.3, 4), (0.4, 5), (0.45, 6), (0.1, 20), (0.3, 20), (0.45, 20)]
        .map(|(ratio, depth)| StripScene::Cantor { ratio, depth });
    let fat = [4, 30].map(|depth| StripScene::FatCantor { depth });
    many.into_iter().chain(cantor).chain(fat).collect()
}

fn search_row(set: String, tau: f64, scenes: impl Iterator<Item = Result<EdgeData>>) -> Result<SearchRow> {
    let mut sums: [Vec<(usize, f64)>; 2] = Default::default();
    let mut shares = [0.0f64; 2];
    let mut shortest = 1.0f64;
    for scene in scenes {
        let scene = scene?;
        let norms = edge_norms(&scene, tau)?;
        shortest = shortest.min(shortest_piece(&scene));
        for (k, cone) in [Cone::Nodal, Cone::Midpoint].into_iter().enumerate() {
            let terms = levels(&scene, cone);
            for &(cells, term) in &terms {
                let bound = 0.5 * (cells as f64).powf(2.0 - 2.0 * tau) * norms.slope * norms.pressure;
                shares[k] = shares[k].max(term / bound);
            }
            if sums[k].is_empty() {
                sums[k] = terms;
            } else {
                sums[k].iter_mut().zip(terms).for_each(|(sum, term)| sum.1 += term.1);
            }
        }
    }
    let orders = sums.map(|terms| {
        let points: Vec<(f64, f64)> = terms.iter().map(|&(n, term)| (1.0 / n as f64, term.sqrt())).collect();
        Fit::power(&points)
    });
    Ok(SearchRow { set, shortest, orders, shares })
}

/// Length of the shortest run of nodes that are all open or all in contact.
fn shortest_piece(scene: &EdgeData) -> f64 {
    let values = scene.values();
    let runs = values.chunk_by(|a, b| (*a < 0.0) == (*b < 0.0)).map(<[f64]>::len);
    runs.min().unwrap_or(0) as f64 / scene.cells() as f64
}

/// Terms on 2^3 ... N/32 cells, coarsest first.
fn levels(scene: &EdgeData, cone: Cone) -> Vec<(usize, f64)> {
    let mut terms = consistency_terms(scene, cone);
    terms.retain(|&(cells, _)| cells >= 8 && 32 * cells <= scene.cells());
    terms.reverse();
    terms
}

/// The worst ratio on one segment over gaps at one end, 10^{−5} ... 0.9, and at both ends, 0.05 ... 0.8; and the gaps where it is taken.
///
/// # Errors
/// As [`worst_ratio`].
pub fn worst_gaps(cone: Cone, tau: f64) -> Result<(f64, [f64; 2])> {
    let one = [1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
    let both = [0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8];
    let pairs = both.iter().flat_map(|&right| both.iter().map(move |&left| (left, right)));
    let pairs = pairs.filter(|(left, right)| left <= right && left + right < 0.99);
    let mut worst = (0.0, [0.0; 2]);
    for (left, right) in one.iter().map(|&right| (0.0, right)).chain(pairs) {
        let ratio = worst_ratio(cone, tau, left, right)?;
        if ratio > worst.0 {
            worst = (ratio, [left, right]);
        }
    }
    Ok(worst)
}

/// Table of the sets, with what the search on one segment found in words.
///
/// # Errors
/// As [`Bound::exponent`] and [`worst_gaps`].
pub fn search_headline(tau: f64, rows: &[SearchRow]) -> Result<Headline> {
    let (paper, three) = (Bound::Paper.exponent(tau)?, Format::Fixed(3));
    let mut table = Table::new(vec![
        Column::new("set", "contact set", Format::Plain, ""),
        Column::new(
            "shortest",
            "piece",
            Format::Scientific(0),
            "shortest gap or piece: the order counts on finer levels only",
        ),
        Column::new("nodal", "nodal", three, "order of the root of the term, nodal cone"),
        Column::new("nodal_half", "+-", three, ""),
        Column::new("midpoint", "midpoint", three, "the same, midpoint cone"),
        Column::new("midpoint_half", "+-", three, ""),
        Column::new("margin", "margin", three, "smaller order less the theorem's exponent"),
        Column::new(
            "nodal_share",
            "share K",
            Format::Significant(2),
            "largest term over h^(2tau-2) |sigma_N| |u_N'| / 2, nodal",
        ),
        Column::new("midpoint_share", "share M", Format::Significant(2), "the same, midpoint cone"),
    ]);
    let (mut nearest, mut largest_share) = (f64::INFINITY, 0.0f64);
    for row in rows {
        let orders = row.orders.map(|fit| fit.map(|fit| fit.order));
        let margin = orders.iter().flatten().copied().reduce(f64::min).map(|order| order - paper);
        let steady = row.orders.iter().flatten().filter(|fit| fit.half_width < STEADY);
        let steady = steady.filter(|fit| row.shortest >= fit.regime.0);
        nearest = steady.fold(nearest, |m, fit| m.min(fit.order - paper));
        largest_share = row.shares.iter().fold(largest_share, |m, &s| m.max(s));
        table.push(vec![
            row.set.as_str().into(),
            row.shortest.into(),
            orders[0].into(),
            row.orders[0].map(|fit| fit.half_width).into(),
            orders[1].into(),
            row.orders[1].map(|fit| fit.half_width).into(),
            margin.into(),
            row.shares[0].into(),
            row.shares[1].into(),
        ]);
    }
    let [nodal, midpoint] = [worst_gaps(Cone::Nodal, tau)?, worst_gaps(Cone::Midpoint, tau)?];
    let worst = nodal.0.max(midpoint.0);
    let measured = format!(
        "no set with a steady order (+- below {STEADY}) on meshes that resolve it comes nearer than {nearest:.3} to the exponent {paper:.4}; worst of all sets on one segment: {:.4} nodal, {:.4} midpoint, below 1/2",
        nodal.0, midpoint.0,
    );
    let claim = format!(
        "tau = {tau}: the consistency term is at most C h^(2 x {paper:.4}); is any contact set near that?"
    );
    let verdict = if worst <= 0.5 && largest_share <= 1.0 {
        Verdict::HoldsLoose(
            "h^(2(tau-3/2)(2-tau)): no set is bad, half the seminorms times h^(2tau-2) bounds all".to_owned(),
        )
    } else {
        Verdict::NotConfirmed(format!("ratio {worst:.3} against 1/2, share {largest_share:.3} against 1"))
    };
    let mut headline = Headline::new("Theorems 3.1, 4.1", claim, table, measured, verdict);
    for (key, value) in [
        ("nearest", nearest),
        ("nodal.ratio", nodal.0),
        ("midpoint.ratio", midpoint.0),
        ("nodal.left", nodal.1[0]),
        ("nodal.right", nodal.1[1]),
        ("share", largest_share),
    ] {
        headline.quote(format!("worst.contact.set.{key}"), value);
    }
    Ok(headline)
}

/// An order with a wider bar is no order.
const STEADY: f64 = 0.1;

/// The worst ratio against the length θ of a gap at one end, for some τ, and what the second case of the proof allows, θ^{τ−2}.
///
/// # Errors
/// As [`worst_ratio`].
pub fn search_chart() -> Result<Chart> {
    let x = Axis::logarithmic("length of the gap at one end, over the length of the segment");
    let y = Axis::logarithmic("term over the seminorms of sigma_N and u_N'");
    let mut chart = Chart::new("One segment, nodal cone: the worst term for a given gap", x, y);
    let gaps: Vec<f64> =
        (0..20).map(|k| 10f64.powf(-5.0 + 0.25 * f64::from(k))).filter(|t| *t < 1.0).collect();
    for tau in [1.55, 1.75, 1.95] {
        let points: Result<Vec<_>> =
            gaps.iter().map(|&t| Ok((t, worst_ratio(Cone::Nodal, tau, 0.0, t)?))).collect();
        chart = chart.with(Series::line_and_points(format!("tau = {tau}"), points?));
    }
    let allowed = gaps.iter().map(|&t| (t, 0.5 * t.powf(-0.25))).collect();
    Ok(chart
        .with(Series::dashed("1/2", gaps.iter().map(|&t| (t, 0.5)).collect()))
        .with(Series::dashed("theta^(tau-2)/2, tau = 7/4", allowed)))
}
