//! A rate study: levels of one scene in one cone, with fits and bounds.

use super::bounds::Bound;
use super::fit::Fit;
use super::level::RateLevel;
use crate::contact::Cone;
use crate::error::Result;

/// The levels of one scene, coarsest first.
#[derive(Debug, Clone, PartialEq)]
pub struct RateStudy {
    /// What was solved, in words.
    pub scene: String,
    /// The supremum of the τ with u ∈ H^τ.
    pub tau: f64,
    /// The discrete cone.
    pub cone: Cone,
    /// (‖u_N‖²_{τ−1/2} + ‖σ_N‖²_{τ−3/2})^{1/2} on the contact edge, where it is finite and known.
    pub norm: Option<f64>,
    /// Mesh size of the reference, a discrete solution or data that are smooth below it: fits account for it.
    pub reference: Option<f64>,
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

    /// (h, quantity) of the levels that count.
    pub fn points(&self, quantity: Quantity) -> Vec<(f64, f64)> {
        let value = |level: &RateLevel| match quantity {
            Quantity::Error => Some(level.error),
            Quantity::Consistency => level.consistency.map(f64::sqrt),
        };
        self.usable().filter_map(|level| Some((level.mesh_size(), value(level)?))).collect()
    }

    /// The order of a quantity with its uncertainty; `None` for too few levels or a quantity that vanishes.
    pub fn fit(&self, quantity: Quantity) -> Option<Fit> {
        match quantity {
            Quantity::Error => {
                let points = self.points(quantity);
                let mut fit = Fit::against(&points, self.reference)?;
                if self.tau <= 1.5 {
                    // Here the account of the reference is a model itself: half of what it changes is uncertain.
                    let without = Fit::of(&points).map_or(fit.order, |without| without.order);
                    fit.half_width = fit.half_width.max(0.5 * (without - fit.order).abs());
                }
                Some(fit)
            }
            // The term has no smooth part: a power of h alone, once the pieces of the contact set are resolved.
            Quantity::Consistency => Fit::power(&self.points(quantity)),
        }
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

    /// Whether quantity/bound stays bounded as far as the levels tell: its order is at least that of the bound within its uncertainty, or
    /// the largest ratio on the finer half of the levels is not above the one on the coarser half.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn is_bounded(&self, quantity: Quantity, bound: Bound) -> Result<bool> {
        let exponent = bound.exponent(self.tau)?;
        if self.fit(quantity).is_some_and(|fit| fit.order + fit.half_width >= exponent) {
            return Ok(true);
        }
        let ratios = self.ratios(quantity, bound)?;
        let (coarse, fine) = ratios.split_at(ratios.len() / 2);
        let largest =
            |part: &[f64]| part.iter().fold(0.0, |m: f64, &r| if r.is_nan() { r } else { m.max(r) });
        Ok(largest(fine) <= largest(coarse))
    }
}
