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

/// The quotient of a function of the space, less its rounding error. For orders so small that γ is extrapolated from
/// larger ones, γ less its error.
pub(super) fn lower_bound(order: Order, constraint: &Constraint, found: &Attained) -> f64 {
    let gamma = found.constant;
    if found.spaces.is_none() {
        return gamma.value - gamma.error;
    }
    gamma.value * (1.0 - rounding(order, constraint))
}

/// The bounds from the results on two spaces, with the dual norm on each of them. For orders at which all digits of
/// the quotient cancel: γ less its error, and √(γ₁² + N²) plus the errors of γ₁ and N.
pub(super) fn two_sided(
    order: Order,
    constraint: &Constraint,
    found: &Attained,
    tolerance: Tolerance,
) -> Result<[f64; 2]> {
    let (gamma, rounding) = (found.constant, rounding(order, constraint));
    let lower = lower_bound(order, constraint, found);
    let whole = || attained(order, &Constraint::mean_zero(), tolerance).map(|found| found.constant);
    let Some(spaces) = &found.spaces else {
        // At small orders that have no digits of their own both are continued from larger ones.
        let (whole, dual_norm) = (whole()?, largest_mean(order, constraint, tolerance)?);
        let upper = (whole.value + whole.error).hypot(dual_norm.value + dual_norm.error);
        return Ok([lower, upper.max(gamma.value + gamma.error)]);
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
    Ok([lower, upper.value + upper.error + dual_norm.error])
}
