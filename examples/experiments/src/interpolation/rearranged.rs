//! Seminorms of rough functions and of their monotone rearrangements.

use super::rearrangement::decreasing_rearrangement;
use super::rough::{RoughFamily, RoughSlopes};
use crate::EstimateExt;
use crate::SplitMix;
use crate::parallel;
use fractional_sobolev::Order;
use fractional_sobolev::Result;
use fractional_sobolev::{Estimate, Tolerance};

/// Orders are drawn from [this, 1 − this], for steps from [this, 1/2 − this].
const LEAST_ORDER: f64 = 0.01;

/// |v*|_ν / |v|_ν for `count` functions v of a family and random orders, v* the decreasing rearrangement: the
/// largest, at most one, and one where v is monotone; and the mean of all.
///
/// ```
/// use experiments::interpolation::{RoughFamily, rearranged_shares};
/// let (largest, mean) = rearranged_shares(RoughFamily::Steps, 10, 1)?;
/// assert!(largest.value <= 1.0 + largest.error && mean < largest.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// Those of [`fractional_sobolev::Function::seminorm`].
pub fn rearranged_shares(family: RoughFamily, count: u32, seed: u64) -> Result<(Estimate, f64)> {
    let highest = if family == RoughFamily::Steps { 0.5 - LEAST_ORDER } else { 1.0 - LEAST_ORDER };
    let mut random = SplitMix::new(seed);
    let orders: Vec<f64> = (0..count).map(|_| random.between(LEAST_ORDER, highest)).collect();
    let share = |k: usize| -> Result<Estimate> {
        let order = Order::new(orders[k])?;
        let function = RoughSlopes::new(family, order, seed.wrapping_add(k as u64)).draw()?;
        let sorted = decreasing_rearrangement(&function)?;
        let seminorm = |u: &fractional_sobolev::Function<'_>| u.seminorm(order, Tolerance::balanced());
        seminorm(&sorted)?.over(seminorm(&function)?)
    };
    let shares = parallel::map(orders.len(), &share).into_iter().collect::<Result<Vec<_>>>()?;
    let mean = shares.iter().map(|share| share.value).sum::<f64>() / f64::from(count.max(1));
    let zero = Estimate::new(0.0, 0.0, Default::default())?;
    Ok((Estimate::largest(shares).unwrap_or(zero), mean))
}
