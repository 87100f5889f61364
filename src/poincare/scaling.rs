//! Lemma 5.2 over a sequence of zones: how fast the constants grow, and bounds with explicit constants.

use super::constant::{gamma_at_point, gamma_whole};
use super::limits::END_SLOPE;
use super::mellin::end_limit;
use super::zone::Condition;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::sobolev::FractionalOrder;

/// Growth of γ between the last two of a sequence of zones (θ, γ), longest first: the slope of γ² against
/// ln(1/θ) at ν = 1/2, the exponent of θ at other orders. The error adds those of the constants to the change
/// from the two zones before, where there are three. `None` for fewer than two zones.
///
/// # Errors
/// [`Error::OutOfRange`] unless each zone is shorter than the one before; [`Error::NotFinite`] when zones are
/// too close together.
///
/// ```
/// use signorini::{Estimate, poincare::growth, sobolev::FractionalOrder};
/// let gamma = |theta: f64| Estimate::new(0.5 * theta.powf(-0.25), 1e-9, Default::default());
/// let zones = [(1e-1, gamma(1e-1)?), (1e-2, gamma(1e-2)?), (1e-3, gamma(1e-3)?)];
/// let found = growth(FractionalOrder::new(0.25)?, &zones)?;
/// assert!(found.is_some_and(|exponent| (exponent.value + 0.25).abs() <= exponent.error));
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn growth(order: FractionalOrder, zones: &[(f64, Estimate)]) -> Result<Option<Estimate>> {
    for pair in zones.windows(2) {
        Error::require("theta", pair[1].0, "a shorter zone than before", pair[1].0 < pair[0].0)?;
    }
    let between = |pair: &[(f64, Estimate)]| -> (f64, f64) {
        let [(longer, a), (shorter, b)] = [pair[0], pair[1]];
        let logarithm = (longer / shorter).ln();
        if order.offset() == 0.0 {
            let error = 2.0 * (a.value * a.error + b.value * b.error);
            ((b.value * b.value - a.value * a.value) / logarithm, error / logarithm)
        } else {
            let error = a.relative_error() + b.relative_error();
            (-(b.value / a.value).ln() / logarithm, error / logarithm)
        }
    };
    let mut windows = zones.windows(2).rev().map(between);
    let Some((last, error)) = windows.next() else {
        return Ok(None);
    };
    let change = windows.next().map_or(0.0, |(before, _)| (last - before).abs());
    Estimate::new(last, error + change, Work::default()).map(Some)
}

/// An upper bound of γ_θ(ν) for all zones of length θ with an explicit constant; found here and tested, not
/// proved. With γ₁ the constant of the whole interval:
///
/// * ν < 1/2: (γ₁ + B) θ^{ν−1/2}, B the limit of γ θ^{1/2−ν} at an end;
/// * ν = 1/2: γ₁ + (A ln(1/θ))^{1/2}, A = 3/(2π²);
/// * ν > 1/2: γ₀, the constant of functions that vanish at an end; where f64 does not reach it, just above 1/2,
///   the bound at 1/2, since |u|_ν grows with ν.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ExplicitBound {
    /// C θ^{ν−1/2}.
    Power {
        /// The order ν < 1/2.
        order: FractionalOrder,
        /// C.
        factor: Estimate,
    },
    /// γ₁ + (A ln(1/θ))^{1/2}.
    RootOfLogarithm {
        /// γ₁(1/2).
        whole: Estimate,
    },
    /// γ₀.
    Constant(Estimate),
}

impl ExplicitBound {
    /// The bound for an order; `None` for functions that vanish on the zone when ν ≤ 1/2.
    ///
    /// # Errors
    /// Those of [`gamma_whole`], [`gamma_at_point`] and [`end_limit`].
    pub fn new(order: FractionalOrder, condition: Condition, tolerance: Tolerance) -> Result<Option<Self>> {
        let half = || {
            gamma_whole(FractionalOrder::HALF, tolerance).map(|whole| Some(Self::RootOfLogarithm { whole }))
        };
        if order.offset() > 0.0 {
            return match gamma_at_point(order, 0.0, tolerance) {
                Ok(point) => Ok(Some(Self::Constant(point))),
                Err(Error::ToleranceNotMet { .. }) => half(),
                Err(error) => Err(error),
            };
        }
        if condition == Condition::Vanishing {
            return Ok(None);
        }
        if order.offset() == 0.0 {
            return half();
        }
        let (whole, limit) = (gamma_whole(order, tolerance)?, end_limit(order, tolerance)?);
        let work = whole.work + limit.work;
        let factor = Estimate::new(whole.value + limit.value, whole.error + limit.error, work)?;
        Ok(Some(Self::Power { order, factor }))
    }

    /// The bound at θ.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < θ ≤ 1.
    pub fn at(&self, theta: f64) -> Result<Estimate> {
        Error::require("theta", theta, "(0, 1]", theta > 0.0 && theta <= 1.0)?;
        match *self {
            Self::Power { order, factor } => {
                let power = theta.powf(order.offset());
                Estimate::new(factor.value * power, factor.error * power, factor.work)
            }
            Self::RootOfLogarithm { whole } => {
                Estimate::new(whole.value + (END_SLOPE * -theta.ln()).sqrt(), whole.error, whole.work)
            }
            Self::Constant(point) => Ok(point),
        }
    }
}
