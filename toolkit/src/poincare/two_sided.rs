//! Two-sided bounds of γ: a conforming lower bound, and an upper bound from γ₁ and a dual norm.

use super::constraint::Constraint;
use super::continuation::Continuation;
use super::discrete::Discrete;
use super::mean::largest_mean;
use super::mesh::MeshModel;
use super::rounding::rounding;
use super::spaces::{constant_and_function, refine};
use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// γ between two bounds that do not use the eigenvalue itself.
///
/// ```
/// use fractional_sobolev::{Constraint, GammaBounds, gamma};
/// // how much is certain without the eigenvalue: the bounds over the constant of the whole interval
/// let found: GammaBounds = gamma(0.5, Constraint::mean_zero_on(0.0..1e-3), 1e-3)?.bounds()?;
/// let [low, high] = [found.lower, found.upper].map(|bound| bound / found.whole.value);
/// assert!(1.0 < low && low < high && high < 1.1 * low);
/// // max(γ₁, N) ≤ γ
/// assert!(found.dual_norm.value <= found.gamma.value + found.gamma.error);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GammaBounds {
    /// γ with its error.
    pub gamma: Estimate,
    /// A conforming lower bound: the quotient of a function of the space, less its rounding. For orders so
    /// small that γ is continued from larger ones, γ less its error.
    pub lower: f64,
    /// An upper bound from γ₁ and the dual norm N, sharpened; raised by the estimated errors of γ₁ and N.
    pub upper: f64,
    /// γ₁(ν), the constant of the whole interval.
    pub whole: Estimate,
    /// N, the dual norm of the mean value: max(γ₁, N)² ≤ γ² ≤ γ₁² + N² for the mean-zero condition.
    pub dual_norm: Estimate,
}

pub(super) fn two_sided(
    order: Order,
    parts: &Constraint,
    constant: Estimate,
    tolerance: Tolerance,
) -> Result<GammaBounds> {
    let (whole, _) = constant_and_function(order, &Constraint::mean_zero(), tolerance)?;
    let direct = refine(
        order,
        rounding(order, parts),
        tolerance,
        |model| Sides::new(order, parts, model, &whole),
        |fine, coarse| fine.join(&coarse, whole),
        |found| found.gamma,
    );
    match direct {
        // At small orders that have no digits of their own both are continued from larger ones.
        Err(Error::ToleranceNotMet { .. })
            if Continuation::to(order, parts.shortest(), tolerance).is_some() =>
        {
            let dual_norm = largest_mean(order, parts, tolerance)?;
            Ok(GammaBounds::of_estimates(constant, whole, dual_norm))
        }
        result => result,
    }
}

impl GammaBounds {
    /// Where no function of the space has digits of its own: γ less its error, and √(γ₁² + N²) with their
    /// errors.
    fn of_estimates(gamma: Estimate, whole: Estimate, dual_norm: Estimate) -> Self {
        let upper = (whole.value + whole.error).hypot(dual_norm.value + dual_norm.error);
        let upper = upper.max(gamma.value + gamma.error);
        Self { gamma, lower: gamma.value - gamma.error, upper, whole, dual_norm }
    }
}

/// γ, its upper bound and N on one space.
struct Sides {
    gamma: f64,
    upper: f64,
    norm: f64,
    rounding: f64,
    work: Work,
}

impl Sides {
    fn new(order: Order, constraint: &Constraint, model: &MeshModel, whole: &Estimate) -> Result<Self> {
        let mut discrete = Discrete::new(order, constraint, model)?;
        let (gamma, _) = discrete.largest_quotient()?;
        let dual = discrete.dual_norm()?;
        let whole_here = (whole.value + whole.error) / discrete.factor;
        Ok(Self {
            gamma,
            upper: dual.upper_bound(whole_here * whole_here).sqrt() * discrete.factor,
            norm: dual.square.sqrt() * discrete.factor,
            rounding: rounding(order, constraint),
            work: discrete.work,
        })
    }

    fn join(&self, coarse: &Self, whole: Estimate) -> Result<GammaBounds> {
        let work = self.work + coarse.work;
        let estimate =
            |a: f64, b: f64| Estimate::new(a.max(b), (a - b).abs() + self.rounding * a.max(b), work);
        let gamma = estimate(self.gamma, coarse.gamma)?;
        let dual_norm = estimate(self.norm, coarse.norm)?;
        let upper = estimate(self.upper, coarse.upper)?;
        Ok(GammaBounds {
            gamma,
            lower: gamma.value * (1.0 - self.rounding),
            upper: upper.value + upper.error + dual_norm.error,
            whole,
            dual_norm,
        })
    }
}
