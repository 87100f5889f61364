//! A rate study: levels of one scene in one cone, with fits and bounds.

use super::level::RateLevel;
use super::subject::Subject;
use signorini::Result;
use signorini::cone::Cone;
use signorini::rates::Bound;
use signorini::rates::ConvergenceOrder;

/// What stands for the exact solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RateReference {
    /// A discrete solution of this mesh size on the same family of meshes: e² is the difference of two
    /// errors, and is fitted so.
    Discrete(f64),
    /// The exact solution of data that are smooth below this mesh size: a singularity of order p lacks a
    /// share (h_r/h)^{2p} of e².
    Resolved(f64),
    /// The exact solution itself.
    Exact,
}

/// Up to here what the reference grid does not resolve is a large share of the error, and the order is fitted
/// with account of it.
const ROUGH: f64 = 1.5;
/// Share of the change by the account of the reference grid that is uncertain: the account is a model itself.
const UNRESOLVED: f64 = 1.0;

/// The levels of one scene, coarsest first.
#[derive(Debug, Clone, PartialEq)]
pub struct RateStudy {
    /// What was solved.
    pub subject: Subject,
    /// The supremum of the τ with u ∈ H^τ.
    pub tau: f64,
    /// The discrete cone.
    pub cone: Cone,
    /// (‖u_N‖²_{τ−1/2} + ‖σ_N‖²_{τ−3/2})^{1/2} on the contact edge, where it is finite and known.
    pub norm: Option<f64>,
    /// What stands for the exact solution.
    pub reference: RateReference,
    /// How many levels were asked for.
    pub planned: usize,
    /// The levels.
    pub levels: Vec<RateLevel>,
}

/// What is measured on a level.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// |u − u_h|_a.
    Error,
    /// The square root of the consistency term, to stand beside the error.
    Consistency,
}

impl RateStudy {
    /// The levels that count.
    pub fn usable(&self) -> impl Iterator<Item = &RateLevel> {
        self.levels.iter().filter(|level| level.flag.is_none())
    }

    /// How many levels are left out.
    pub fn left_out(&self) -> usize {
        self.levels.len() - self.usable().count()
    }

    /// Largest relative uncertainty of the errors of the levels that count.
    pub fn precision(&self) -> f64 {
        self.usable().map(|level| level.error_bound / level.error).fold(0.0, f64::max)
    }

    /// How many of the planned levels have no error: never solved, left out between others that count, or not
    /// a number.
    pub fn missing(&self) -> usize {
        let counts = |level: &RateLevel| level.flag.is_none() && level.error.is_finite();
        let ends = self.levels.iter().position(counts).zip(self.levels.iter().rposition(counts));
        let Some((first, last)) = ends else { return self.planned };
        let holes = self.levels[first..=last].iter().filter(|level| !counts(level)).count();
        holes + self.planned.saturating_sub(self.levels.len())
    }

    /// (h, quantity) of the levels that count.
    pub fn points(&self, quantity: Quantity) -> Vec<(f64, f64)> {
        let value = |level: &RateLevel| match quantity {
            Quantity::Error => Some(level.error),
            Quantity::Consistency => level.consistency.map(f64::sqrt),
        };
        self.usable().filter_map(|level| Some((level.mesh_size(), value(level)?))).collect()
    }

    /// The order of a quantity with its uncertainty; `None` for too few levels or a quantity that vanishes.
    pub fn fit(&self, quantity: Quantity) -> Option<ConvergenceOrder> {
        match quantity {
            Quantity::Error => self.error_fit(&self.points(quantity)),
            // The term has no smooth part: a power of h alone, once the pieces of the contact set are
            // resolved.
            Quantity::Consistency => ConvergenceOrder::of_power(&self.points(quantity)),
        }
    }

    fn error_fit(&self, points: &[(f64, f64)]) -> Option<ConvergenceOrder> {
        let h = match self.reference {
            RateReference::Discrete(h) => return ConvergenceOrder::against(points, Some(h)),
            RateReference::Exact => return ConvergenceOrder::of(points),
            RateReference::Resolved(h) => h,
        };
        let (with, without) = (ConvergenceOrder::against(points, Some(h))?, ConvergenceOrder::of(points)?);
        let change = (with.order - without.order).abs();
        let mut fit = if self.tau <= ROUGH { with } else { without };
        fit.uncertainty = fit.uncertainty.max(UNRESOLVED * change);
        Some(fit)
    }

    /// quantity / bound(h) on every level that counts.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn ratios(&self, quantity: Quantity, bound: Bound) -> Result<Vec<f64>> {
        self.points(quantity).into_iter().map(|(h, e)| Ok(e / bound.value(h, self.tau)?)).collect()
    }

    /// The smallest C with quantity ≤ C bound(h) on all levels that count.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn constant(&self, quantity: Quantity, bound: Bound) -> Result<f64> {
        Ok(self.ratios(quantity, bound)?.into_iter().fold(0.0, f64::max))
    }

    /// Largest quantity/bound on the finer half of the levels over the one on the coarser half: at most one
    /// where the quotient has stopped to grow. `None` with fewer than two levels; NaN where a quantity is.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn growth(&self, quantity: Quantity, bound: Bound) -> Result<Option<f64>> {
        let ratios = self.ratios(quantity, bound)?;
        let (coarse, fine) = ratios.split_at(ratios.len() / 2);
        let largest =
            |part: &[f64]| part.iter().fold(0.0, |m: f64, &r| if r.is_nan() { r } else { m.max(r) });
        Ok((!coarse.is_empty()).then(|| largest(fine) / largest(coarse)))
    }

    /// Whether quantity/bound stays bounded as far as the levels tell: its order is at least that of the
    /// bound within its uncertainty, or the largest ratio on the finer half of the levels is not above the
    /// one on the coarser half.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn is_bounded(&self, quantity: Quantity, bound: Bound) -> Result<bool> {
        let exponent = bound.exponent(self.tau)?;
        if self.fit(quantity).is_some_and(|fit| fit.order + fit.uncertainty >= exponent) {
            return Ok(true);
        }
        Ok(self.growth(quantity, bound)?.is_none_or(|growth| growth <= 1.0))
    }
}
