//! Figure 3.1: exponents over τ. The three printed curves, and on them measured orders with their bars.

use signorini::cone::Cone;
use signorini::convergence::Bound;
use signorini::convergence::NoMemory;
use signorini::convergence::{Quantity, RateStudy};
use signorini::convergence::{RateStrip, SceneFamily};
use signorini::error::Result;
use signorini::figures::{Axis, Chart, Series};
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::scenes::StripScene;
use signorini::strip::{Levels, StripKind};

/// What Figure 3.1 is measured on.
#[derive(Debug, Clone)]
pub struct FigureRates {
    /// Regularities τ ∈ (3/2, 2).
    pub taus: Vec<f64>,
    /// Which strip.
    pub kind: StripKind,
    /// The scene.
    pub source: StripScene,
    /// The levels.
    pub levels: Levels,
    /// The reference grid has 2 to this power cells.
    pub reference: u32,
    /// Positions of a single transition.
    pub positions: usize,
}

impl FigureRates {
    /// Number of solved levels.
    pub fn steps(&self) -> u64 {
        (2 * self.taus.len() * self.positions * self.levels.cells().count()) as u64
    }

    /// Studies of both cones at every τ, nodal first.
    ///
    /// # Errors
    /// Those of [`RateStrip::study`].
    pub fn run(&self, report: &mut dyn FnMut()) -> Result<Vec<[RateStudy; 2]>> {
        let mut strip = RateStrip::new(self.kind, self.levels, 1 << self.reference)?;
        let mut store = NoMemory;
        self.taus
            .iter()
            .map(|&tau| {
                let coarsest = self.levels.coarsest_cells();
                let family = SceneFamily::named(&self.source, tau, self.kind, coarsest, self.positions)?;
                let mut study = |cone| strip.study(&family, cone, &mut store, report);
                Ok([study(Cone::Nodal)?, study(Cone::Midpoint)?])
            })
            .collect()
    }
}

/// Table, verdict and quoted numbers.
///
/// # Errors
/// As [`Bound::value`].
pub fn figure_headline(studies: &[[RateStudy; 2]]) -> Result<Headline> {
    let mut table = Table::new(columns());
    let (mut below, mut distance, mut without) = (f64::INFINITY, 0.0f64, 0);
    let mut quotes = Vec::new();
    for pair in studies {
        let tau = pair[0].tau;
        let exponents = [Bound::Earlier, Bound::Paper, Bound::Optimal].map(|bound| bound.exponent(tau));
        let [earlier, paper, optimal] = exponents;
        let (paper, optimal) = (paper?, optimal?);
        let mut row: Vec<Cell> = vec![tau.into(), earlier?.into(), paper.into(), optimal.into()];
        for study in pair {
            for quantity in [Quantity::Error, Quantity::Consistency] {
                let fit = study.fit(quantity);
                row.extend([fit.map(|fit| fit.order).into(), fit.map(|fit| fit.half_width).into()]);
                let Some(fit) = fit else {
                    without += usize::from(quantity == Quantity::Error);
                    continue;
                };
                below = below.min(fit.order + fit.half_width - paper);
                if quantity == Quantity::Error {
                    distance = distance.max((fit.order - optimal).abs());
                }
                let what = if quantity == Quantity::Error { "error" } else { "term" };
                let key = format!("figure.3.1.{}.{what}.{:.0}", study.cone, 100.0 * tau);
                quotes.push((format!("{key}.order"), fit.order));
                quotes.push((format!("{key}.half"), fit.half_width));
            }
        }
        row.push(pair.iter().map(RateStudy::left_out).sum::<usize>().into());
        table.push(row);
    }
    let claim = "the exponent tau^2-5tau/2+2 lies above tau/2-1/4 and below tau-1, furthest from it (1/16) at tau = 7/4";
    let measured = format!("all measured orders of the error within {distance:.3} of tau - 1, both cones");
    let verdict = if without > 0 {
        Verdict::NotConfirmed(format!("{without} orders of the error need more levels"))
    } else if below >= 0.0 {
        Verdict::HoldsLoose("up to h^(1/16): every measured order lies on the optimal line".to_owned())
    } else {
        Verdict::NotConfirmed(format!("an order lies {:.3} below the exponent of the theorem", -below))
    };
    let mut headline = Headline::new("Figure 3.1", claim, table, measured, verdict);
    headline.quote("figure.3.1.distance", distance);
    quotes.into_iter().for_each(|(key, value)| headline.quote(key, value));
    Ok(headline)
}

fn columns() -> Vec<Column> {
    let three = Format::Fixed(3);
    vec![
        Column::new("tau", "tau", Format::Plain, "supremum of the tau with u in H^tau"),
        Column::new("earlier", "(E2)", three, "tau/2 - 1/4"),
        Column::new("paper", "(N1)", three, "tau^2 - 5tau/2 + 2"),
        Column::new("optimal", "tau-1", three, "optimal"),
        Column::new("nodal_error", "error K", three, "order of the error, nodal cone"),
        Column::new("nodal_error_half", "+-", three, ""),
        Column::new("nodal_term", "term K", three, "order of the root of the consistency term, nodal cone"),
        Column::new("nodal_term_half", "+-", three, ""),
        Column::new("midpoint_error", "error M", three, "order of the error, midpoint cone"),
        Column::new("midpoint_error_half", "+-", three, ""),
        Column::new(
            "midpoint_term",
            "term M",
            three,
            "order of the root of the consistency term, midpoint cone",
        ),
        Column::new("midpoint_term_half", "+-", three, ""),
        Column::new("left_out", "out", Format::Plain, "levels left out of the fits"),
    ]
}

/// The paper's figure with measured orders: errors and roots of the consistency terms of both cones, side by side at each τ.
///
/// # Errors
/// As [`Bound::exponent`].
pub fn figure_chart(studies: &[[RateStudy; 2]]) -> Result<Chart> {
    let x = Axis::linear("regularity tau of the solution, u in H^tau").range(1.5, 2.0);
    let y = Axis::linear("exponent of h").range(0.48, 1.02);
    let mut chart = Chart::new("Figure 3.1: printed exponents and measured orders", x, y);
    let names = ["existing: tau/2 - 1/4", "the paper: tau^2 - 5tau/2 + 2", "optimal: tau - 1"];
    for (bound, name) in [Bound::Earlier, Bound::Paper, Bound::Optimal].into_iter().zip(names) {
        let curve: Result<Vec<_>> = (1..=100)
            .map(|k| 1.5 + 0.005 * f64::from(k))
            .map(|tau| Ok((tau, bound.exponent(tau)?)))
            .collect();
        chart = chart.with(Series::line(name, curve?));
    }
    for (k, (cone, quantity)) in [
        (Cone::Nodal, Quantity::Error),
        (Cone::Nodal, Quantity::Consistency),
        (Cone::Midpoint, Quantity::Error),
        (Cone::Midpoint, Quantity::Consistency),
    ]
    .into_iter()
    .enumerate()
    {
        // Side by side, so that bars do not cover each other.
        let shift = 0.004 * (k as f64 - 1.5);
        let fits = studies.iter().flatten().filter(|study| study.cone == cone);
        let fits: Vec<_> = fits.filter_map(|study| Some((study.tau, study.fit(quantity)?))).collect();
        let what = if quantity == Quantity::Error { "error" } else { "root of the term" };
        let points = fits.iter().map(|(tau, fit)| (tau + shift, fit.order)).collect();
        let bars = fits.iter().map(|(_, fit)| fit.half_width).collect();
        chart = chart.with(Series::points(format!("{what}, {cone} cone"), points).bars(bars));
    }
    Ok(chart)
}
