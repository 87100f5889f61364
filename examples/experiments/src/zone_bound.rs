//! An upper bound of the constants of all zones of one length.

use crate::ErrorExt;
use crate::zones::{Condition, END_SLOPE};
use fractional_sobolev::{Constraint, gamma, law};
use fractional_sobolev::{Error, Estimate, Given, Order, Result, Tolerance};

/// An upper bound of γ_θ(ν) for all zones of length θ with an explicit constant; found here and tested, not
/// proved. With γ₁ the constant of the whole interval:
///
/// * ν < 1/2: (γ₁ + B) θ^{ν−1/2}, B the limit of γ θ^{1/2−ν} at an end;
/// * ν = 1/2: γ₁ + (A ln(1/θ))^{1/2}, A = 3/(2π²);
/// * ν > 1/2: γ₀, the constant of functions that vanish at an end; where f64 does not reach it, just above
///   1/2, the bound at 1/2, since |u|_ν grows with ν.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ZoneBound {
    /// C θ^{ν−1/2}.
    Power {
        /// The order ν < 1/2.
        order: Order,
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

impl ZoneBound {
    /// The bound for an order; `None` for functions that vanish on the zone when ν ≤ 1/2.
    ///
    /// # Errors
    /// Those of [`gamma`] and [`law`].
    pub fn new(
        order: impl Given<Order>,
        condition: Condition,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Option<Self>> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        let half = || {
            gamma(Order::HALF, Constraint::mean_zero(), tolerance)
                .map(|found| found.constant)
                .map(|whole| Some(Self::RootOfLogarithm { whole }))
        };
        if order.offset() > 0.0 {
            return match gamma(order, Constraint::vanishing_at(0.0), tolerance).map(|found| found.constant) {
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
        let (whole, limit) = (
            gamma(order, Constraint::mean_zero(), tolerance)?.constant,
            law(order, 0.0, tolerance)?.factor()?,
        );
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
