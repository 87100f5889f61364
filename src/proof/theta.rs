//! θ, the share of a segment that counts as near a vertex, or as a large contact set.

use crate::error::{Error, Result};

/// θ = h^{2τ−3} for 3/2 < τ < 2 and θ = h² for τ = 2: the choice that balances both cases ("Globally",
/// Section 3).
///
/// # Errors
/// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 0 < h < 1 and 3/2 < τ ≤ 2.
fn printed_theta(h: f64, tau: f64) -> Result<f64> {
    Error::require("h", h, "(0, 1)", h > 0.0 && h < 1.0)?;
    Error::require("tau", tau, "(3/2, 2]", tau > 1.5 && tau <= 2.0)?;
    Ok(if tau == 2.0 { h * h } else { h.powf(2.0 * tau - 3.0) })
}

/// 2τ² − 5τ + 4 below τ = 2, 2 at τ = 2 (times ln(1/h)), 2τ − 2 above: the exponent of h in the squared error
/// that θ = h^{2τ−3} gives, (3.1)-(3.2), (4.2)-(4.4).
///
/// Twice the exponent of [`Bound::Paper`](crate::rates::Bound::Paper) for 3/2 < τ ≤ 2.
///
/// ```
/// use signorini::{proof::printed_exponent, rates::Bound};
/// assert_eq!(printed_exponent(1.75), 2.0 * Bound::Paper.exponent(1.75)?);
/// assert_eq!(printed_exponent(2.0), 2.0);
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn printed_exponent(tau: f64) -> f64 {
    if tau < 2.0 { 2.0 * tau * tau - 5.0 * tau + 4.0 } else { 2.0 * tau - 2.0 }
}

pub(super) fn checked_theta(theta: f64) -> Result<f64> {
    Error::require("theta", theta, "(0, 1)", theta > 0.0 && theta < 1.0)
}

/// The choice of θ for h = 1/n.
///
/// ```
/// use signorini::proof::ThetaRule;
/// assert_eq!(ThetaRule::Fixed(0.3).theta(0.25)?, 0.3);
/// assert!(ThetaRule::Fixed(1.5).theta(0.25).is_err());
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ThetaRule {
    /// θ = h^{2τ−3}, at τ = 2 θ = h²: the paper's choice.
    Printed {
        /// Sobolev regularity, 3/2 < τ ≤ 2.
        tau: f64,
    },
    /// The same θ on every mesh.
    Fixed(f64),
}

impl ThetaRule {
    /// The value of θ on a mesh of size h.
    ///
    /// ```
    /// use signorini::proof::ThetaRule;
    /// let theta = |tau: f64| ThetaRule::Printed { tau }.theta(0.25);
    /// assert_eq!((theta(1.75)?, theta(2.0)?), (0.5, 0.0625));
    /// assert!(theta(2.25).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for τ, θ or h outside their ranges.
    pub fn theta(self, h: f64) -> Result<f64> {
        match self {
            ThetaRule::Printed { tau } => printed_theta(h, tau),
            ThetaRule::Fixed(theta) => checked_theta(theta),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_theta_balances_both_cases() {
        assert_eq!(printed_theta(0.25, 1.75), Ok(0.5));
        assert_eq!(printed_theta(0.25, 2.0), Ok(0.0625));
        assert!(printed_theta(0.25, 1.5).is_err() && printed_theta(1.0, 1.75).is_err());
    }
}
