//! All constants of Lemma 6.1 at one order, and the full norm just below and just above the length h*(ν).

use super::constant::{ErrorNorm, element_constant, longest_element};
use super::limits;
use crate::Order;
use crate::error::{Given, Result};
use crate::estimate::{Estimate, Tolerance};

/// h* is computed to 1e-4; the printed constant is tried this far from it on both sides, relative to it.
const BESIDE: f64 = 1e-3;

/// Stands for ν → 0: the constants differ from their limits by less than this.
const NEAR_ZERO: f64 = 1e-300;

/// Best constants in place of the printed 1.
///
/// ```
/// use fractional_sobolev::{Order, Tolerance, interpolation::LocalConstants};
/// let bounds = LocalConstants::at_zero()?;
/// let at = LocalConstants::new(Order::HALF, Tolerance::fast())?;
/// assert!(at.l2.value < bounds.l2.value && at.derivative.value < bounds.derivative.value);
/// assert!(at.longest.value > bounds.longest.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalConstants {
    /// C_L2(ν): ‖u − I u‖₀ ≤ C_L2 h^{1+ν} |u|\_{1+ν}.
    pub l2: Estimate,
    /// C_H1(ν): ‖(u − I u)'‖₀ ≤ C_H1 h^ν |u|\_{1+ν}.
    pub derivative: Estimate,
    /// C_1(ν, 1): ‖u − I u‖₁ ≤ C_1 h^ν |u|\_{1+ν} for h ≤ 1, the full norm.
    pub full: Estimate,
    /// h*(ν), up to which the full norm has a constant of at most 1.
    pub longest: Estimate,
    /// C_1(ν, h) at h a thousandth below h*.
    pub below: Estimate,
    /// C_1(ν, h) at h a thousandth above h*.
    pub above: Estimate,
}

impl LocalConstants {
    /// At one order.
    ///
    /// # Errors
    /// As [`element_constant`].
    pub fn new(order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        let best = |norm| element_constant(norm, order, tolerance);
        let longest = longest_element(order, Tolerance::fast())?;
        let beside = |factor: f64| best(ErrorNorm::H1 { h: factor * longest.value });
        Ok(Self {
            l2: best(ErrorNorm::L2)?,
            derivative: best(ErrorNorm::Derivative)?,
            full: best(ErrorNorm::H1 { h: 1.0 })?,
            longest,
            below: beside(1.0 - BESIDE)?,
            above: beside(1.0 + BESIDE)?,
        })
    }

    /// Their limits for ν → 0: since |x − y| ≤ 1 on the unit element, |v|_ν rises in ν and all constants
    /// fall, so these bound the constants of every order, and h* from below.
    ///
    /// # Errors
    /// As [`element_constant`].
    pub fn at_zero() -> Result<Self> {
        let longest = longest_element(Order::new(NEAR_ZERO)?, Tolerance::balanced())?;
        let beside = |factor: f64| limits::at_zero(ErrorNorm::H1 { h: factor * longest.value });
        Ok(Self {
            l2: limits::at_zero(ErrorNorm::L2)?,
            derivative: limits::at_zero(ErrorNorm::Derivative)?,
            full: limits::at_zero(ErrorNorm::H1 { h: 1.0 })?,
            longest,
            below: beside(1.0 - BESIDE)?,
            above: beside(1.0 + BESIDE)?,
        })
    }
}
