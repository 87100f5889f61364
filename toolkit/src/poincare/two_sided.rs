//! Two-sided bounds for γ: a conforming lower bound, and an upper bound from the constant γ₁ of the whole
//! interval and a dual norm.

use super::constraint::Constraint;
use super::discrete::{Discrete, DualNorm};
use super::mean::largest_mean;
use super::rounding::rounding;
use super::spaces::{Attained, attained};
use crate::Order;
use crate::error::Result;
use crate::estimate::{Estimate, Tolerance};

/// Two-sided bounds for γ that do not depend on the accuracy of the eigenvalue.
///
/// ```
/// use fractional_sobolev::{Constraint, GammaBounds, gamma};
/// // the bounds, which do not use the eigenvalue, relative to the constant of the whole interval
/// let found: GammaBounds = gamma(0.5, Constraint::mean_zero_on(0.0..1e-3), 1e-3)?.bounds()?;
/// let [low, high] = [found.lower, found.upper].map(|bound| bound / found.whole.value);
/// assert!(1.0 < low && low < high && high < 1.1 * low);
/// // max(γ₁, N) ≤ γ
/// assert!(found.dual_norm.value <= found.gamma.value + found.gamma.error);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GammaBounds {
    /// The constant γ with its error.
    pub gamma: Estimate,
    /// A conforming lower bound: the quotient of a function of the space, less its rounding error. For orders
    /// so small that γ is extrapolated from larger ones, γ less its error.
    pub lower: f64,
    /// A sharpened upper bound from γ₁ and the dual norm N, increased by the estimated errors of γ₁ and N.
    /// For extrapolated γ, √(γ₁² + N²) with these errors, and at least γ plus its error.
    pub upper: f64,
    /// The constant γ₁(ν) of the whole interval.
    pub whole: Estimate,
    /// The dual norm N of the mean value: max(γ₁, N)² ≤ γ² ≤ γ₁² + N² for the mean-zero condition.
    pub dual_norm: Estimate,
}

/// The bounds from the results on two spaces, with the dual norm on each of them.
pub(super) fn two_sided(
    order: Order,
    constraint: &Constraint,
    found: &Attained,
    tolerance: Tolerance,
) -> Result<GammaBounds> {
    let whole = || attained(order, &Constraint::mean_zero(), tolerance).map(|found| found.constant);
    match &found.spaces {
        Some(spaces) => {
            let [fine, coarse] = spaces.as_ref();
            let duals = || rayon::join(|| fine.dual_norm(), || coarse.dual_norm());
            let (whole, (fine_dual, coarse_dual)) = rayon::join(whole, duals);
            let whole = whole?;
            let sides = [Sides::new(fine, &fine_dual?, &whole), Sides::new(coarse, &coarse_dual?, &whole)];
            GammaBounds::of_sides(found.constant, rounding(order, constraint), sides, whole)
        }
        // At small orders that have no digits of their own both are continued from larger ones.
        None => {
            let whole = whole()?;
            Ok(GammaBounds::of_estimates(found.constant, whole, largest_mean(order, constraint, tolerance)?))
        }
    }
}

impl GammaBounds {
    /// The bounds for orders at which all digits of the quotient cancel: γ less its error, and √(γ₁² + N²) plus
    /// the errors of γ₁ and N.
    fn of_estimates(gamma: Estimate, whole: Estimate, dual_norm: Estimate) -> Self {
        let upper = (whole.value + whole.error).hypot(dual_norm.value + dual_norm.error);
        let upper = upper.max(gamma.value + gamma.error);
        Self { gamma, lower: gamma.value - gamma.error, upper, whole, dual_norm }
    }

    fn of_sides(gamma: Estimate, rounding: f64, [fine, coarse]: [Sides; 2], whole: Estimate) -> Result<Self> {
        let estimate =
            |a: f64, b: f64| Estimate::new(a.max(b), (a - b).abs() + rounding * a.max(b), gamma.work);
        let dual_norm = estimate(fine.norm, coarse.norm)?;
        let upper = estimate(fine.upper, coarse.upper)?;
        Ok(Self {
            gamma,
            lower: gamma.value * (1.0 - rounding),
            upper: upper.value + upper.error + dual_norm.error,
            whole,
            dual_norm,
        })
    }
}

/// The upper bound and N on one space.
struct Sides {
    upper: f64,
    norm: f64,
}

impl Sides {
    fn new(discrete: &Discrete, dual: &DualNorm, whole: &Estimate) -> Self {
        let whole_here = (whole.value + whole.error) / discrete.factor;
        Self {
            upper: dual.upper_bound(whole_here * whole_here).sqrt() * discrete.factor,
            norm: dual.square.sqrt() * discrete.factor,
        }
    }
}
