//! All constants of Lemma 6.1 at one order, and the full norm just below and just above the length h*(ν).

use fractional_sobolev::{
    Domain, ErrorNorm, Estimate, Given, Order, Result, Tolerance, interpolation_constant,
};

/// h* is computed to 1e-4; the printed constant is tried this far from it on both sides, relative to it.
const BESIDE: f64 = 1e-3;

/// Stands for ν → 0: the constants differ from their limits by less than this.
const NEAR_ZERO: f64 = 1e-300;

/// Rounding of the tolerance of h*: nothing is asked below it.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Best constants in place of the printed 1.
///
/// ```
/// use experiments::interpolation::LocalConstants;
/// use fractional_sobolev::{Order, Tolerance};
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
    /// As [`interpolation_constant`].
    pub fn new(order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        Self::beside(order, tolerance, longest_element(order, Tolerance::fast())?)
    }

    /// Their limits for ν → 0: since |x − y| ≤ 1 on the unit element, |v|_ν rises in ν and all constants
    /// fall, so these bound the constants of every order, and h* from below.
    ///
    /// # Errors
    /// As [`interpolation_constant`].
    pub fn at_zero() -> Result<Self> {
        let order = Order::new(NEAR_ZERO)?;
        Self::beside(order, Tolerance::balanced(), longest_element(order, Tolerance::balanced())?)
    }

    fn beside(order: Order, tolerance: Tolerance, longest: Estimate) -> Result<Self> {
        let best = |norm| {
            interpolation_constant(Domain::Interval(1.0), norm, order, tolerance).map(|found| found.constant)
        };
        Ok(Self {
            l2: best(ErrorNorm::L2)?,
            derivative: best(ErrorNorm::Derivative)?,
            full: best(ErrorNorm::H1)?,
            longest,
            below: full_constant((1.0 - BESIDE) * longest.value, order, tolerance)?,
            above: full_constant((1.0 + BESIDE) * longest.value, order, tolerance)?,
        })
    }
}

/// C_1(ν, h) of ‖u − I u‖₁ ≤ C_1 h^ν |u|_{1+ν} on an element of length h, the full norm.
///
/// # Errors
/// As [`interpolation_constant`].
pub fn full_constant(h: f64, order: Order, tolerance: Tolerance) -> Result<Estimate> {
    let found = interpolation_constant(Domain::Interval(h), ErrorNorm::H1, order, tolerance)?;
    found.constant.times(h.powf(-order.value()))
}

/// The length h* up to which the second line of Lemma 6.1 holds with the printed constant 1: C_1(ν, h*) = 1.
///
/// C_1 rises with h and lies between h C_L2 and (C_H1² + h² C_L2²)^{1/2}, which brackets h*.
///
/// ```
/// use experiments::interpolation::{full_constant, longest_element};
/// use fractional_sobolev::{Order, Tolerance};
/// let (order, asked) = (Order::HALF, Tolerance::balanced());
/// let h = longest_element(order, asked)?.value;
/// assert!((full_constant(h, order, asked)?.value - 1.0).abs() < 1e-7);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`interpolation_constant`].
pub fn longest_element(order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let unit = |norm| interpolation_constant(Domain::Interval(1.0), norm, order, tolerance);
    let (l2, derivative) = (unit(ErrorNorm::L2)?.constant, unit(ErrorNorm::Derivative)?.constant.value);
    let mut work = l2.work;
    let mut low = (1.0 - derivative * derivative).sqrt() / l2.value;
    let mut high = 1.0 / l2.value;
    let wanted = 0.25 * tolerance.relative().max(ROUNDING);
    while high - low > wanted * high {
        let h = 0.5 * (low + high);
        let full = full_constant(h, order, tolerance)?;
        work += full.work;
        if full.value < 1.0 { low = h } else { high = h }
    }
    let value = 0.5 * (low + high);
    // dC_1/dh is at least about C_L2/2 there: the relative error of C_1 at most doubles.
    Estimate::new(value, 0.5 * (high - low) + 2.0 * l2.relative_error() * value, work)
}
