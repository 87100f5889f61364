//! Remark 7: one length of the zone at several places, and what the printed cut of the interval would need.

use crate::EstimateExt;
use crate::growth::last_exponent;
use crate::trial::{BothSides, cut_in_two, trial_quotient, truncated_logarithm};
use fractional_sobolev::{Constraint, GammaBounds, Zones, gamma};
use fractional_sobolev::{Error, Estimate, Function, Given, Mesh, Order, Result, Tolerance};

/// ε/θ: where the odd extremal function starts to differ from zero.
const SHARE: f64 = 1e-3;
/// ln(1/ε) of the odd ramps, ε the inner radius relative to the half of the interval: 2e-4, 2e-8, 2e-16.
const RAMPS: [f64; 3] = [8.517, 17.728, 36.148];

/// A zone at one place.
///
/// Returned by [`Places`].
///
/// ```
/// use experiments::location::{Placed, Places};
/// // a zone of length 0.01 in the middle instead of at the end: by how much γ is smaller
/// let places = Places::new(0.5, 0.01, &[0.0, 0.5], 1e-3)?;
/// let Placed { start, gamma, ratio, repair, .. } = places.zones[1];
/// assert!((start - 0.495).abs() < 1e-15 && ratio.value < 0.9 && gamma.value <= repair.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// Its start a.
    pub start: f64,
    /// γ.
    pub gamma: Estimate,
    /// γ over that of (0, θ).
    pub ratio: Estimate,
    /// (γ₁² + N²)^{1/2}.
    pub repair: Estimate,
    /// γ over that.
    pub share: Estimate,
}

/// Zones of one length at several places, and the printed step for odd functions.
///
/// # Method
///
/// The printed proof cuts the interval inside the zone and uses Lemma 5.2 on both pieces, as if the mean over
/// each part of the zone were zero. With u odd about the middle of a zone in the middle, the mean over the
/// zone is zero whatever u is on the left half, and both sides of the step are those of the left half scaled
/// to (0,1).
///
/// ```
/// use experiments::location::Places;
/// use fractional_sobolev::{Order, Tolerance};
/// // a zone of length 0.01 at the left end and in the middle
/// let found = Places::new(Order::HALF, 0.01, &[0.0, 0.5], Tolerance::fast())?;
/// assert!(found.zones[1].gamma.value < found.zones[0].gamma.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Places {
    /// The order ν.
    pub order: Order,
    /// The zones.
    pub zones: Vec<Placed>,
    /// The left side of the step over its right side with γ_θ as the constant, for an odd extremal function.
    pub step: Estimate,
    /// ν < 1/2: both sides for sgn(x − 1/2), without a constant; the right one is zero.
    pub sign: Option<BothSides>,
    /// ν = 1/2: the exponent of ln(1/ε) in the constant that odd ramps in ln|x − 1/2| need.
    pub ramps: Option<Estimate>,
}

impl Places {
    /// Zones (a, a+θ) at a = `fractions` × (1 − θ).
    ///
    /// # Errors
    /// [`Error::EntryOutOfRange`] for a fraction outside [0, 1], and those of [`Gamma::bounds`](fractional_sobolev::Gamma::bounds) and [`Zones::from_start_and_length`].
    pub fn new(
        order: impl Given<Order>,
        theta: f64,
        fractions: &[f64],
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        // Scaled to (0,1), the left piece (0,1/2) has its zone, of relative length 2ε, at an end.
        let short = 0.0..2.0 * SHARE * theta;
        let start = |(index, &value): (usize, &f64)| match (0.0..=1.0).contains(&value) {
            true => Ok(value * (1.0 - theta)),
            false => Err(Error::EntryOutOfRange { name: "fractions", index, value, range: "[0, 1]" }),
        };
        let starts = fractions.iter().enumerate().map(start).collect::<Result<Vec<f64>>>()?;
        let end = gamma(order, Constraint::mean_zero_on(0.0..theta), tolerance)?.constant;
        let placed = |start: f64| -> Result<Placed> {
            let zone = Zones::from_start_and_length(start, theta);
            let found = gamma(order, Constraint::mean_zero_on(zone), tolerance)?.bounds()?;
            let (gamma, repair) = (found.gamma, simple_bound(&found)?);
            let (ratio, share) = (gamma.over(end)?, gamma.over(repair)?);
            Ok(Placed { start, gamma, ratio, repair, share })
        };
        let step = gamma(order, Constraint::vanishing_on(short), tolerance)?.constant.over(end)?;
        let zones = starts.into_iter().map(placed).collect::<Result<Vec<Placed>>>()?;
        let sign = (order.offset() < 0.0).then(|| sign(order)).transpose()?;
        let ramps = if order.offset() == 0.0 { ramps(order)? } else { None };
        Ok(Self { order, zones, step, sign, ramps })
    }
}

/// (γ₁² + N²)^{1/2}, the bound of the short proof.
fn simple_bound(found: &GammaBounds) -> Result<Estimate> {
    let value = found.whole.value.hypot(found.dual_norm.value);
    let error = found.whole.error.hypot(found.dual_norm.error);
    Estimate::new(value, error, found.whole.work + found.dual_norm.work)
}

fn sign(order: Order) -> Result<BothSides> {
    let sign = Function::piecewise(&Mesh::uniform(2, 1.0)?, 0, &[-1.0, 1.0])?;
    cut_in_two(&sign, 1, order, Tolerance::balanced())
}

fn ramps(order: Order) -> Result<Option<Estimate>> {
    let quotient = |log: f64| -> Result<(f64, Estimate)> {
        Ok((log, trial_quotient(&truncated_logarithm(1.0, log)?, order, Tolerance::balanced())?))
    };
    last_exponent(&RAMPS.into_iter().map(quotient).collect::<Result<Vec<_>>>()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_outside_the_interval_is_named_by_its_index() {
        let outside = Places::new(0.3, 1e-3, &[0.0, 0.5, 1.5], 1e-3);
        assert!(matches!(outside, Err(Error::EntryOutOfRange { index: 2, value: 1.5, .. })), "{outside:?}");
    }
}
