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

/// The bounds from the results on two spaces, with the dual norm on each of them. For orders at which all digits of
/// the quotient cancel: γ less its error, and √(γ₁² + N²) plus the errors of γ₁ and N.
pub(super) fn two_sided(
    order: Order,
    constraint: &Constraint,
    found: &Attained,
    tolerance: Tolerance,
) -> Result<GammaBounds> {
    let (gamma, rounding) = (found.constant, rounding(order, constraint));
    let whole = || attained(order, &Constraint::mean_zero(), tolerance).map(|found| found.constant);
    let Some(spaces) = &found.spaces else {
        // At small orders that have no digits of their own both are continued from larger ones.
        let (whole, dual_norm) = (whole()?, largest_mean(order, constraint, tolerance)?);
        let upper = (whole.value + whole.error).hypot(dual_norm.value + dual_norm.error);
        let upper = upper.max(gamma.value + gamma.error);
        return Ok(GammaBounds {
            gamma,
            lower: gamma.value - gamma.error,
            upper,
            whole,
            dual_norm,
        });
    };
    let [fine, coarse] = spaces.as_ref();
    let duals = || rayon::join(|| fine.dual_norm(), || coarse.dual_norm());
    let (whole, (of_fine, of_coarse)) = rayon::join(whole, duals);
    let (whole, of_fine, of_coarse) = (whole?, of_fine?, of_coarse?);
    let on_both = |quantity: &dyn Fn(&Discrete, &DualNorm) -> f64| {
        let (a, b) = (quantity(fine, &of_fine), quantity(coarse, &of_coarse));
        Estimate::new(a.max(b), (a - b).abs() + rounding * a.max(b), gamma.work)
    };
    let dual_norm = on_both(&|space, dual| dual.square.sqrt() * space.factor)?;
    let upper = on_both(&|space, dual| {
        let whole_here = (whole.value + whole.error) / space.factor;
        dual.upper_bound(whole_here * whole_here).sqrt() * space.factor
    })?;
    Ok(GammaBounds {
        gamma,
        lower: gamma.value * (1.0 - rounding),
        upper: upper.value + upper.error + dual_norm.error,
        whole,
        dual_norm,
    })
}
