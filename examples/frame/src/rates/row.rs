//! A rate study with its fits, and the table of many.

use crate::{Cell, Column, Finding, Format, Headline, Result, Table};
use experiments::convergence::{FamilyScene, Quantity, RateStudy, Subject};
use signorini::problems::StripData;
use signorini::rates::Bound;
use signorini::rates::ConvergenceOrder;

/// A study with the orders of error and root of the consistency term.
#[derive(Debug, Clone, PartialEq)]
pub struct RateRow {
    /// The study.
    pub study: RateStudy,
    /// Order of the error; `None` for too few levels or an error that is not a positive number.
    pub error: Option<ConvergenceOrder>,
    /// Order of the root of the consistency term; `None` also where the term vanishes on a level.
    pub term: Option<ConvergenceOrder>,
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
            Subject::Transition { whole_boundary, .. } => {
                if *whole_boundary { "closed.transition" } else { "mesh.transition" }.to_owned()
            }
        };
        format!("{scene}.{:.0}", 100.0 * self.study.tau)
    }

    /// Whether the contact set is a fat Cantor set: it repeats itself after a factor 2^{1/(4−2τ)} in h, too
    /// few periods for an order as sharp as others.
    pub fn is_fat(&self) -> bool {
        matches!(self.study.subject, Subject::Strip(_, FamilyScene::Named(StripData::FatCantor { .. })))
    }

    /// Order of the error and what it may be off by.
    pub fn order(&self) -> Option<(f64, f64)> {
        self.error.map(|fit| (fit.order, fit.uncertainty))
    }

    /// Order less the exponent of a bound, and what it may be off by.
    pub fn above(&self, bound: Bound) -> Option<(f64, f64)> {
        let (order, half_width) = self.order()?;
        Some((order - bound.exponent(self.study.tau).ok()?, half_width))
    }

    /// Quotes an order and its half-width under `key.order` and `key.half`.
    pub fn quote(headline: &mut Headline, key: &str, fit: Option<ConvergenceOrder>) {
        if let Some(ConvergenceOrder { order, uncertainty, .. }) = fit {
            headline.quote(format!("{key}.order"), order);
            headline.quote(format!("{key}.half"), uncertainty);
        }
    }

    /// Quotes the orders of the error of both cones under `key.cone`.
    pub fn quote_pair(headline: &mut Headline, key: &str, pair: &[Self; 2]) {
        for row in pair {
            Self::quote(headline, &format!("{key}.{}", row.study.cone), row.error);
        }
    }

    /// error/bound of the theorem on the finer half of the levels over the coarser half, and what rounding
    /// leaves of it.
    pub fn growth(&self) -> Option<(f64, f64)> {
        let growth = self.study.growth(Quantity::Error, Bound::Paper).ok()??;
        Some((growth, 2.0 * self.study.precision() * growth))
    }

    /// (order − τ + 1) over what the order may be off by, of the error and of the root of the term.
    pub fn from_optimal(&self) -> [Option<f64>; 2] {
        [self.error, self.term]
            .map(|fit| fit.map(|fit| (fit.order - (self.study.tau - 1.0)) / fit.uncertainty))
    }
}

/// A number for a finding: the largest of some ratios, of which none may be missing.
pub fn largest(ratios: impl Iterator<Item = Option<f64>>) -> Option<(f64, f64)> {
    let all: Option<Vec<f64>> = ratios.collect();
    all?.into_iter().reduce(|a, b| if a.is_nan() || a > b { a } else { b }).map(|ratio| (ratio, 0.0))
}

/// The remarks on the consistency terms: keys `terms`, the order of their roots where they do not vanish, and
/// `terms.silent`.
pub fn term_remarks(rows: &[&RateRow]) -> [Finding; 2] {
    let ratios = || rows.iter().map(|row| row.from_optimal()[1]);
    let seen = ratios().filter(Option::is_some).map(|ratio| ratio.map(f64::abs));
    let silent = ratios().filter(Option::is_none).count() as f64;
    [
        Finding::remark("terms", "where it was seen, the root of the consistency term has order tau - 1")
            .number_or(largest(seen), "no term could be fitted")
            .at_most(1.0, "tau - 1; in units of +-"),
        Finding::remark(
            "terms.silent",
            "the number of scenes without a consistency term to fit, as it vanishes, is {value}",
        )
        .number(silent, 0.0)
        .at_most(0.5 * rows.len() as f64, "half of the scenes; sigma_N = 0 at corners"),
    ]
}

/// Two columns for [`fit_cells`]: an order, and what it may be off by; `half_width` is the meaning of the
/// second one.
pub fn order_columns(keys: [&'static str; 2], title: &str, of: &str, half_width: &str) -> [Column; 2] {
    let order = Column::new(keys[0], title, Format::Fixed(3), format!("order of the {of}"));
    [order, Column::new(keys[1], "+-", Format::Fixed(3), half_width)]
}

/// The cells of an order and its half-width.
pub fn fit_cells(fit: Option<ConvergenceOrder>) -> [Cell; 2] {
    [fit.map(|fit| fit.order).into(), fit.map(|fit| fit.uncertainty).into()]
}

/// The number whose lower end is lowest, or one that is NaN; `None` where one is missing or none was given.
pub fn lowest(numbers: impl Iterator<Item = Option<(f64, f64)>>) -> Option<(f64, f64)> {
    let all: Option<Vec<(f64, f64)>> = numbers.collect();
    all?.into_iter().reduce(|a, b| if (a.0 - a.1).is_nan() || a.0 - a.1 <= b.0 - b.1 { a } else { b })
}

/// The largest value that a number may have: a lower bound is refuted only where even that is below it.
pub fn highest((value, uncertainty): (f64, f64)) -> (f64, f64) {
    (value + uncertainty, 0.0)
}

/// The claim that every study has all its levels, each with an error: key `levels`.
pub fn complete<'a>(studies: impl Iterator<Item = &'a RateStudy>) -> Finding {
    let missing: usize = studies.map(RateStudy::missing).sum();
    Finding::claim("levels", "no level is missing or without an error")
        .number(missing as f64, 0.0)
        .at_most(0.0, "every level that was planned")
        .otherwise("{value} levels are missing or have no error")
}

/// What "+-" beside an order says, for the meaning of a column.
pub const HALF_WIDTH: &str = "what the order as h -> 0 may be off by, with the terms beside the leading one that the levels leave possible";

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
            "which explain the levels best: p alone, beside the smooth part 1, beside h ln h",
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
        Column::new("term_half_width", "+-", three, "the same for it, with any terms beside"),
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
        error.map(|fit| fit.uncertainty).into(),
        error.map_or(Cell::Missing, |fit| fit.model.to_string().into()),
        Bound::Optimal.exponent(study.tau)?.into(),
        paper.into(),
        error.map(|fit| fit.order - paper).into(),
        ratio.into(),
        study.norm.map(|norm| ratio / norm).into(),
        term.map(|fit| fit.order).into(),
        term.map(|fit| fit.uncertainty).into(),
        (term_ratio > 0.0).then_some(term_ratio).into(),
        study.left_out().into(),
    ])
}
