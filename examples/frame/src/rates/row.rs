//! A rate study with its fits, and the table of many.

use crate::figures::{Axis, Chart, Series};
use crate::{Cell, Column, Finding, Format, Headline, Result, Table};
use signorini::convergence::{Bound, Fit, Quantity, RateStudy, Subject};

/// A study with the orders of error and root of the consistency term.
#[derive(Debug, Clone, PartialEq)]
pub struct RateRow {
    /// The study.
    pub study: RateStudy,
    /// Order of the error; `None` for too few levels or an error that is not a positive number.
    pub error: Option<Fit>,
    /// Order of the root of the consistency term; `None` also where the term vanishes on a level.
    pub term: Option<Fit>,
}

impl RateRow {
    /// Fits both orders.
    pub fn new(study: RateStudy) -> Self {
        let (error, term) = (study.fit(Quantity::Error), study.fit(Quantity::Consistency));
        Self { study, error, term }
    }

    /// "scalar transition, tau = 1.75".
    pub fn words(&self) -> String {
        format!("{}, tau = {:.4}", self.study.subject.name(), self.study.tau)
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
    }

    /// "scalar.transition.175": the scene and 100 τ.
    pub fn key(&self) -> String {
        let scene = match &self.study.subject {
            Subject::Strip(kind, scene) => format!("{kind}.{}", scene.name()),
            Subject::Mesh(scene) => scene.to_string(),
            Subject::Corner { angle, .. } => format!("corner.{angle}"),
        };
        format!("{scene}.{:.0}", 100.0 * self.study.tau)
    }

    /// Order of the error and what it may be off by.
    pub fn order(&self) -> Option<(f64, f64)> {
        self.error.map(|fit| (fit.order, fit.half_width))
    }

    /// Order less the exponent of a bound, and what it may be off by.
    pub fn above(&self, bound: Bound) -> Option<(f64, f64)> {
        let (order, half_width) = self.order()?;
        Some((order - bound.exponent(self.study.tau).ok()?, half_width))
    }

    /// Quotes an order and its half-width under `key.order` and `key.half`.
    pub fn quote(headline: &mut Headline, key: &str, fit: Option<Fit>) {
        if let Some(Fit { order, half_width, .. }) = fit {
            headline.quote(format!("{key}.order"), order);
            headline.quote(format!("{key}.half"), half_width);
        }
    }

    /// error/bound of the theorem on the finer half of the levels over the coarser half, and what rounding leaves of it.
    pub fn growth(&self) -> Option<(f64, f64)> {
        let growth = self.study.growth(Quantity::Error, Bound::Paper).ok()??;
        Some((growth, 2.0 * self.study.precision() * growth))
    }

    /// (order − τ + 1) over what the order may be off by, of the error and of the root of the term.
    pub fn from_optimal(&self) -> [Option<f64>; 2] {
        [self.error, self.term]
            .map(|fit| fit.map(|fit| (fit.order - (self.study.tau - 1.0)) / fit.half_width))
    }
}

/// A number for a finding: the largest of some ratios, of which none may be missing.
pub fn largest(ratios: impl Iterator<Item = Option<f64>>) -> Option<(f64, f64)> {
    let all: Option<Vec<f64>> = ratios.collect();
    all?.into_iter().reduce(|a, b| if a.is_nan() || a > b { a } else { b }).map(|ratio| (ratio, 0.0))
}

/// The cells of an order and its half-width.
pub fn fit_cells(fit: Option<Fit>) -> [Cell; 2] {
    [fit.map(|fit| fit.order).into(), fit.map(|fit| fit.half_width).into()]
}

/// The number whose lower end is lowest; `None` where one is missing or none was given.
pub fn lowest(numbers: impl Iterator<Item = Option<(f64, f64)>>) -> Option<(f64, f64)> {
    let all: Option<Vec<(f64, f64)>> = numbers.collect();
    all?.into_iter().min_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1)))
}

/// The claim that every study has all its levels, each with an error: key `levels`.
pub fn complete<'a>(studies: impl Iterator<Item = &'a RateStudy>) -> Finding {
    let missing: usize = studies.map(RateStudy::missing).sum();
    Finding::claim("levels", "no level is missing or without an error")
        .number(missing as f64, 0.0)
        .at_most(0.0, "every level that was planned")
        .otherwise("{value} levels are missing or have no error")
}

/// Orders over τ with their bars, moved aside by `shift` so that bars do not cover each other.
fn order_points(name: &str, shift: f64, orders: impl Iterator<Item = Option<(f64, Fit)>>) -> Series {
    let orders = orders.flatten().map(|(tau, fit)| ((tau + shift, fit.order), fit.half_width));
    let (points, bars) = orders.unzip();
    Series::points(name, points).bars(bars)
}

/// Exponent of a bound over (from, to).
///
/// # Errors
/// As [`Bound::exponent`].
fn exponent_curve(bound: Bound, (from, to): (f64, f64)) -> Result<Vec<(f64, f64)>> {
    const STEPS: u32 = 100;
    let taus = (1..=STEPS).map(|k| from + (to - from) * f64::from(k) / f64::from(STEPS));
    taus.map(|tau| Ok((tau, bound.exponent(tau)?))).collect()
}

/// What "+-" beside an order says, for the meaning of a column.
pub const HALF_WIDTH: &str =
    "what the order may be off by: windows of levels, scatter, next model, smooth part, whichever is largest";

/// One row per study: order, theorem's exponent, constants, term.
///
/// # Errors
/// As [`Bound::value`].
pub fn rate_table(rows: &[RateRow]) -> Result<Table> {
    let three = Format::Fixed(3);
    let mut table = Table::new(vec![
        Column::new("scene", "scene", Format::Plain, ""),
        Column::new("tau", "tau", Format::Significant(4), "supremum of the tau with u in H^tau"),
        Column::new("order", "order", three, "of the error in h"),
        Column::new("half_width", "+-", three, HALF_WIDTH),
        Column::new(
            "model",
            "orders",
            Format::Plain,
            "which orders were told apart: p alone, beside the smooth part 1, beside 1 and 3/2",
        ),
        Column::hidden("optimal"),
        Column::new("paper", "paper", three, "exponent of the theorem"),
        Column::new("beaten", "beaten", three, "order less exponent of the theorem"),
        Column::new(
            "ratio",
            "e/bound",
            Format::Significant(3),
            "largest error over the bound of the theorem, C = 1",
        ),
        Column::new(
            "constant",
            "C",
            Format::Significant(2),
            "the same over the norms of u_N and sigma_N on the edge",
        ),
        Column::new("term_order", "term", three, "order of the root of the consistency term"),
        Column::new("term_half_width", "+-", three, "the same for it: halves of the window, scatter"),
        Column::new(
            "term_ratio",
            "t/bound",
            Format::Significant(3),
            "largest root of the term over the bound",
        ),
        Column::new(
            "left_out",
            "out",
            Format::Plain,
            "levels left out: not converged, digits lost, near the reference",
        ),
    ]);
    for row in rows {
        table.push(cells(row)?);
    }
    Ok(table)
}

fn cells(RateRow { study, error, term }: &RateRow) -> Result<Vec<Cell>> {
    let paper = Bound::Paper.exponent(study.tau)?;
    let ratio = study.constant(Quantity::Error, Bound::Paper)?;
    let term_ratio = study.constant(Quantity::Consistency, Bound::Paper)?;
    Ok(vec![
        study.subject.name().into(),
        study.tau.into(),
        error.map(|fit| fit.order).into(),
        error.map(|fit| fit.half_width).into(),
        error.map_or(Cell::Missing, |fit| fit.model.to_string().into()),
        Bound::Optimal.exponent(study.tau)?.into(),
        paper.into(),
        error.map(|fit| fit.order - paper).into(),
        ratio.into(),
        study.norm.map(|norm| ratio / norm).into(),
        term.map(|fit| fit.order).into(),
        term.map(|fit| fit.half_width).into(),
        (term_ratio > 0.0).then_some(term_ratio).into(),
        study.left_out().into(),
    ])
}

/// Measured orders over τ for a chart: name, then τ and fit where there is one.
pub type OrderSeries = (String, Vec<Option<(f64, Fit)>>);

/// Exponents over τ: curves of bounds, each over its own τ, and measured orders with their bars, each series `shift` beside the last.
///
/// # Errors
/// As [`Bound::exponent`].
pub fn exponents_chart(
    title: &str,
    (x, y): ((f64, f64), (f64, f64)),
    curves: &[(&str, Bound, (f64, f64))],
    orders: Vec<OrderSeries>,
    shift: f64,
) -> Result<Chart> {
    let x = Axis::linear("regularity tau of the solution, u in H^tau").range(x.0, x.1);
    let mut chart = Chart::new(title, x, Axis::linear("exponent of h").range(y.0, y.1));
    for (name, bound, taus) in curves {
        chart = chart.with(Series::line(*name, exponent_curve(*bound, *taus)?));
    }
    let middle = 0.5 * (orders.len() as f64 - 1.0);
    for (k, (name, fits)) in orders.into_iter().enumerate() {
        chart = chart.with(order_points(&name, shift * (k as f64 - middle), fits.into_iter()));
    }
    Ok(chart)
}
