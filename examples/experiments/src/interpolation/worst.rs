//! The largest ratios of Lemma 6.1 over rough functions and powers at the edge of H^ν: what a search by hand
//! finds.

use super::error::{InterpolationError, power_slope};
use super::local::LocalConstants;
use super::rough::{RoughFamily, RoughSlopes};
use crate::EstimateExt;
use fractional_sobolev::Order;
use fractional_sobolev::{Estimate, Tolerance};
use fractional_sobolev::{Given, Result};

/// Exponents of the powers tried, above the critical ν − 1/2: from the edge of H^ν to smooth functions.
const GAPS: [f64; 7] = [1e-6, 1e-2, 0.1, 0.4, 0.8, 1.3, 2.0];

/// The largest ratios found.
///
/// Returned by [`worst_ratios`].
///
/// ```
/// use experiments::interpolation::{LocalConstants, WorstRatios, worst_ratios};
/// let WorstRatios { l2, derivative } = worst_ratios(0.5, 5, 7)?;
/// // functions tried at random stay below the best constants, by not much
/// let best = LocalConstants::new(0.5, 1e-6)?;
/// assert!(l2.value < best.l2.value && derivative.value < best.derivative.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorstRatios {
    /// ‖u − I u‖₀ / (h^{1+ν} |u|_{1+ν}).
    pub l2: Estimate,
    /// ‖(u − I u)'‖₀ / (h^ν |u|_{1+ν}).
    pub derivative: Estimate,
}

impl WorstRatios {
    /// What part of the best constants, of the function and of the derivative, is reached: at most 1.
    ///
    /// # Errors
    /// None for constants of the same order, which are positive.
    pub fn shares(&self, best: &LocalConstants) -> Result<[Estimate; 2]> {
        Ok([self.l2.over(best.l2)?, self.derivative.over(best.derivative)?])
    }
}

/// The largest ratios over `functions` random slopes of each family with members in H^ν, and over seven
/// powers.
///
/// ```
/// use experiments::interpolation::{LocalConstants, worst_ratios};
/// use fractional_sobolev::{Order, Tolerance};
/// let order = Order::HALF;
/// let shares = worst_ratios(order, 3, 1)?.shares(&LocalConstants::new(order, Tolerance::fast())?)?;
/// assert!(shares.iter().all(|share| share.value < 1.0));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::ToleranceNotMet`](fractional_sobolev::Error::ToleranceNotMet) when a seminorm cannot be had to 1e-8.
pub fn worst_ratios(order: impl Given<Order>, functions: usize, seed: u64) -> Result<WorstRatios> {
    let order = order.given()?;
    let mut tried = Vec::new();
    for family in RoughFamily::admissible(order) {
        let mut slopes = RoughSlopes::new(family, order, seed);
        for _ in 0..functions {
            tried.push(InterpolationError::of_slope(&slopes.draw()?, order, Tolerance::balanced())?);
        }
    }
    // The slope 1 = x⁰ belongs to an affine u, whose ratio is 0/0.
    for exponent in GAPS.map(|gap| order.offset() + gap).into_iter().filter(|a| *a != 0.0) {
        tried.push(power_slope(exponent, order)?);
    }
    let l2 = tried.iter().map(InterpolationError::l2_ratio).collect::<Result<Vec<_>>>()?;
    let derivative = tried.iter().map(InterpolationError::derivative_ratio).collect::<Result<Vec<_>>>()?;
    let none = Estimate::new(0.0, 0.0, Default::default())?;
    let largest = |ratios: Vec<Estimate>| Estimate::largest(ratios).unwrap_or(none);
    Ok(WorstRatios { l2: largest(l2), derivative: largest(derivative) })
}
