//! The law of γ_θ(ν) as θ → 0 at fixed ν, where one is known.

use super::constant::gamma;
use super::constraint::Constraint;
use super::limits::interior_limit;
use super::mellin::end_limit;
use super::uniform::UniformLaw;
use crate::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};

/// So near below 1/2 the power law needs lengths out of reach, and the law through 1/2 is used.
const NEAR_HALF: f64 = 0.01;

/// γ_θ as θ → 0 at fixed ν; not uniform in ν.
///
/// # Method
///
/// | ν | printed in Lemma 5.2 | true, zone at an end | true, zone inside |
/// | --- | --- | --- | --- |
/// | < 1/2 | C θ^{ν−1/2} | B θ^{ν−1/2}, `end_limit` | √(tan πν / (2π(1+2ν))) θ^{ν−1/2} |
/// | = 1/2 | C ln(1/θ) | γ² = A L + c + d/(A L + c) + O(L⁻²), [`super::UniformLaw`] | γ² ~ L/(2π²) |
/// | > 1/2 | C | γ₀(ν), `Constraint::vanishing_at` | the same at the point |
///
/// A = 3/(2π²), L = ln(1/θ). All are limits θ → 0 at fixed ν.
///
/// ```
/// use fractional_sobolev::{Constraint, Order, gamma, LimitLaw, Tolerance};
/// let (order, asked) = (Order::HALF, Tolerance::balanced());
/// if let Some(law) = LimitLaw::new(order, 0.0, asked)? {
///     let found = gamma(order, Constraint::mean_zero_on(0.0..1e-9), asked)?.constant;
///     assert!((law.gamma(1e-9)?.value / found.value - 1.0).abs() < 1e-2);
/// }
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum LimitLaw {
    /// B θ^{ν−1/2}.
    Power {
        /// The order ν < 1/2.
        order: Order,
        /// B.
        factor: Estimate,
    },
    /// γ₀, the constant of the point.
    Constant(Estimate),
    /// The law through ν = 1/2.
    Uniform(Box<UniformLaw>),
}

impl LimitLaw {
    /// The law for functions with mean zero on zones that shrink to the point `place` of \[0, 1\]; for ν > 1/2
    /// also for those that vanish there. `None` where none is known: at or near 1/2 for a zone inside.
    ///
    /// # Errors
    /// Those of [`gamma`], [`end_limit`] and [`UniformLaw::new`].
    pub fn new(
        order: impl Given<Order>,
        place: f64,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Option<Self>> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        let at_end = place == 0.0 || place == 1.0;
        let uniform = || UniformLaw::new(order, tolerance).map(|law| Some(Self::Uniform(Box::new(law))));
        let power = |factor: Estimate| Some(Self::Power { order, factor });
        if order.offset() > 0.0 {
            return match gamma(order, Constraint::vanishing_at(place), tolerance).map(|found| found.constant)
            {
                Ok(limit) => Ok(Some(Self::Constant(limit))),
                // so close to 1/2 that the point is out of reach of f64
                Err(Error::ToleranceNotMet { .. }) if at_end => uniform(),
                Err(Error::ToleranceNotMet { .. }) => Ok(None),
                Err(error) => Err(error),
            };
        }
        match at_end {
            true if order.offset() < -NEAR_HALF => end_limit(order, tolerance).map(power),
            true => uniform(),
            false if order.is_below_half() => interior_limit(order).map(power),
            false => Ok(None),
        }
    }

    /// γ_θ by the law.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where the law through 1/2 does not reach: θ near 1.
    pub fn gamma(&self, theta: f64) -> Result<Estimate> {
        match self {
            Self::Power { order, factor } => {
                let power = theta.powf(order.offset());
                Estimate::new(factor.value * power, factor.error * power, factor.work)
            }
            Self::Constant(limit) => Ok(*limit),
            Self::Uniform(law) => law.gamma(theta),
        }
    }
}
