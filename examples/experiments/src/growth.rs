//! Lemma 5.2 over a sequence of zones: how fast the constants grow, and bounds with explicit constants.

use crate::EstimateExt;
use crate::zone_bound::ZoneBound;
use crate::zones::{Condition, Place};
pub use crate::zones::{END_SLOPE, INTERIOR_SLOPE};
use fractional_sobolev::{Constraint, GammaBounds, Law, Zones, gamma, law};
use fractional_sobolev::{Error, Estimate, Given, Order, Result, Tolerance, Work};

/// Growth of γ between the last two of a sequence of zones (θ, γ), longest first: the slope of γ² against
/// ln(1/θ) at ν = 1/2, the exponent of θ at other orders. The error adds those of the constants to the change
/// from the two zones before, where there are three. `None` for fewer than two zones.
///
/// # Errors
/// [`Error::EntryOutOfRange`] unless each zone is shorter than the last; [`Error::NotFinite`] for zones so
/// close that their logarithms agree, and for constants that are not positive.
///
/// ```
/// use experiments::growth::growth;
/// use fractional_sobolev::{Estimate, Order};
/// let gamma = |theta: f64| Estimate::new(0.5 * theta.powf(-0.25), 1e-9, Default::default());
/// let zones = [(1e-1, gamma(1e-1)?), (1e-2, gamma(1e-2)?), (1e-3, gamma(1e-3)?)];
/// let found = growth(Order::new(0.25)?, &zones)?;
/// assert!(found.is_some_and(|exponent| (exponent.value + 0.25).abs() <= exponent.error));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
pub fn growth(order: impl Given<Order>, zones: &[(f64, Estimate)]) -> Result<Option<Estimate>> {
    let order = order.given()?;
    for (index, &(value, _)) in zones.iter().enumerate() {
        if !(value > 0.0 && index.checked_sub(1).is_none_or(|k| value < zones[k].0)) {
            let range = "(0, the one before)";
            return Err(Error::EntryOutOfRange { name: "theta", index, value, range });
        }
    }
    if order.offset() != 0.0 {
        return last_exponent(zones);
    }
    last_of(zones, |(longer, a), (shorter, b)| {
        let logarithm = (longer / shorter).ln();
        let error = 2.0 * (a.value * a.error + b.value * b.error);
        ((b.value * b.value - a.value * a.value) / logarithm, error / logarithm)
    })
}

/// To what [`growth`] tends as θ → 0 at fixed ν: ν − 1/2; at ν = 1/2 the slope 3/(2π²) at an end, 1/(2π²)
/// inside; 0.
///
/// ```
/// use experiments::growth::{growth_limit, last_exponent};
/// use experiments::zones::Place;
/// use fractional_sobolev::{Estimate, Order};
/// assert_eq!(growth_limit(Order::new(0.25)?, Place::End), -0.25);
/// let of = |x: f64| Ok::<_, fractional_sobolev::Error>((x, Estimate::new(x * x, 1e-9, Default::default())?));
/// let square = last_exponent(&[of(1.0)?, of(2.0)?, of(4.0)?])?;
/// assert!(square.is_some_and(|p| (p.value - 2.0).abs() <= p.error));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
pub fn growth_limit(order: Order, place: Place) -> f64 {
    match place {
        _ if order.offset() < 0.0 => order.offset(),
        _ if order.offset() > 0.0 => 0.0,
        Place::End => END_SLOPE,
        Place::Centre | Place::At(_) => INTERIOR_SLOPE,
    }
}

/// The exponent p of y ~ x^p between the last two of the points (x, y), y > 0. The error adds those of the
/// values to the change from the two points before, where there are three. `None` for fewer than two points.
///
/// # Errors
/// [`Error::NotFinite`] when points coincide.
pub fn last_exponent(points: &[(f64, Estimate)]) -> Result<Option<Estimate>> {
    last_of(points, |(x, a), (y, b)| {
        let logarithm = (y / x).ln();
        ((b.value / a.value).ln() / logarithm, (a.relative_error() + b.relative_error()) / logarithm.abs())
    })
}

type Point = (f64, Estimate);

/// What `between` finds for the last two points, with its error, and the change from the two before.
fn last_of(points: &[Point], between: impl Fn(Point, Point) -> (f64, f64)) -> Result<Option<Estimate>> {
    let mut windows = points.windows(2).rev().map(|pair| between(pair[0], pair[1]));
    let Some((last, error)) = windows.next() else {
        return Ok(None);
    };
    let change = windows.next().map_or(0.0, |(before, _)| (last - before).abs());
    Estimate::new(last, error + change, Work::default()).map(Some)
}

/// Distances 1 − θ at which the printed growth is tried near θ = 1.
const NEAR_ONE: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// The exponent p in γ_θ(1/2) / ln(1/θ) ~ (1 − θ)^p as θ → 1. The bound (5.2) with one constant needs p ≥ 0.
///
/// # Errors
/// As [`gamma`].
pub fn printed_exponent_near_one(tolerance: impl Given<Tolerance>) -> Result<Option<Estimate>> {
    let tolerance = tolerance.given()?;
    let order = Order::HALF;
    let point = |distance: f64| -> Result<Point> {
        let theta = 1.0 - distance;
        let found = gamma(order, Constraint::mean_zero_on(0.0..theta), tolerance)?.constant;
        let printed = printed_growth(order, theta);
        Ok((distance, Estimate::new(found.value / printed, found.error / printed, found.work)?))
    };
    last_exponent(&NEAR_ONE.into_iter().map(point).collect::<Result<Vec<Point>>>()?)
}

/// The growth that Lemma 5.2 prints: θ^{ν−1/2}, ln(1/θ), 1.
///
/// ```
/// use experiments::growth::printed_growth;
/// use fractional_sobolev::Order;
/// assert_eq!(printed_growth(Order::new(0.25)?, 1e-4), 10.0);
/// assert_eq!(printed_growth(Order::new(0.75)?, 1e-4), 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
pub fn printed_growth(order: Order, theta: f64) -> f64 {
    if order.offset() < 0.0 {
        theta.powf(order.offset())
    } else if order.offset() == 0.0 {
        -theta.ln()
    } else {
        1.0
    }
}

/// What γ_θ of one order is compared with, and zones compared with it.
///
/// ```
/// use experiments::zone_bound::ZoneBound;
/// use experiments::growth::Scaling;
/// use experiments::zones::{Condition, Place};
/// use fractional_sobolev::{Order, Tolerance};
/// let (order, asked) = (Order::new(0.25)?, Tolerance::fast());
/// let point = Scaling::new(order, Place::End, Condition::MeanZero, asked)?.point(1e-3)?;
/// let bound = ZoneBound::new(order, Condition::MeanZero, asked)?.map(|bound| bound.at(1e-3));
/// assert!(bound.transpose()?.is_some_and(|bound| point.found.gamma.value < bound.value));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Scaling {
    order: Order,
    place: Place,
    condition: Condition,
    tolerance: Tolerance,
    law: Option<Law>,
    bound: Option<ZoneBound>,
}

/// One zone.
///
/// Returned by [`Scaling::point`].
///
/// ```
/// use experiments::growth::{Scaling, ScalingPoint};
/// use experiments::zones::{Condition, Place};
/// let scaling = Scaling::new(0.5, Place::End, Condition::MeanZero, 1e-3)?;
/// let ScalingPoint { found, side, over_law, .. } = scaling.point(1e-9)?;
/// // between its bounds, and near what the limit law says
/// assert!(found.lower <= found.gamma.value && side.value <= 1.0);
/// assert!(over_law.is_some_and(|quotient| (quotient.value - 1.0).abs() < 1e-3));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ScalingPoint {
    /// The order ν.
    pub order: Order,
    /// Its length θ.
    pub theta: f64,
    /// The zone.
    pub zone: Zones,
    /// γ with its bounds.
    pub found: GammaBounds,
    /// γ over its upper bound.
    pub side: Estimate,
    /// γ over the explicit bound, where there is one.
    pub share: Option<Estimate>,
    /// The limit law at θ, where there is one and it reaches.
    pub law: Option<Estimate>,
    /// γ over the law.
    pub over_law: Option<Estimate>,
    /// γ over the printed growth θ^{ν−1/2}, ln(1/θ), 1; none at θ = 1.
    pub over_printed: Option<f64>,
}

impl Scaling {
    /// The limit law and the explicit bound of an order.
    ///
    /// # Errors
    /// Those of [`law`] and [`ZoneBound::new`].
    pub fn new(
        order: impl Given<Order>,
        place: Place,
        condition: Condition,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        let law = match condition {
            // for functions that vanish on the zone a law is known above 1/2 only
            Condition::Vanishing if order.offset() <= 0.0 => None,
            _ => Some(law(order, place.point(), tolerance)?),
        };
        let bound = ZoneBound::new(order, condition, tolerance)?;
        Ok(Self { order, place, condition, tolerance, law, bound })
    }

    /// The zone of length θ.
    ///
    /// # Errors
    /// Those of [`Gamma::bounds`](fractional_sobolev::Gamma::bounds) and [`Place::zone`].
    pub fn point(&self, theta: f64) -> Result<ScalingPoint> {
        let zone = self.place.zone(theta)?;
        let found =
            gamma(self.order, self.condition.on(&zone), self.tolerance).and_then(|found| found.bounds())?;
        let gamma = found.gamma;
        // The law through 1/2 does not reach θ near 1.
        let law = self.law.as_ref().and_then(|law| law.at(theta).ok());
        let share = self.bound.map(|bound| gamma.over(bound.at(theta)?)).transpose()?;
        Ok(ScalingPoint {
            order: self.order,
            theta,
            zone,
            found,
            side: gamma.over(Estimate::new(found.upper, 0.0, Work::default())?)?,
            share,
            law,
            over_law: law.map(|law| gamma.over(law)).transpose()?,
            over_printed: (theta < 1.0).then(|| gamma.value / printed_growth(self.order, theta)),
        })
    }
}

/// By which factor (5.2) with C from θ = 1/2 is loose at the constant γ of a shorter zone at an end.
///
/// ```
/// use experiments::growth::{looseness_at_half, printed_exponent_near_one};
/// use fractional_sobolev::{Constraint, Order, gamma, Tolerance};
/// let asked = Tolerance::fast();
/// let short = gamma(Order::HALF, Constraint::mean_zero_on(0.0..1e-6), asked)?.constant;
/// assert!(looseness_at_half(1e-6, short, asked)?.value > 1.0);
/// // (5.2) cannot hold up to θ = 1
/// assert!(printed_exponent_near_one(asked)?.is_some_and(|p| p.value < 0.0));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`gamma`].
pub fn looseness_at_half(
    theta: f64,
    shorter: Estimate,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let tolerance = tolerance.given()?;
    let order = Order::HALF;
    let middle = gamma(order, Constraint::mean_zero_on(0.0..0.5), tolerance)?.constant;
    let printed = printed_growth(order, theta) / printed_growth(order, 0.5);
    let loose = middle.over(shorter)?;
    Estimate::new(loose.value * printed, loose.error * printed, loose.work)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zones_that_do_not_shrink_are_named_by_their_index() {
        let zone = Estimate::new(1.0, 1e-9, Work::default()).unwrap();
        let same = growth(0.5, &[(0.3, zone), (0.2, zone), (0.2, zone)]);
        assert!(matches!(same, Err(Error::EntryOutOfRange { index: 2, value: 0.2, .. })), "{same:?}");
        let negative = growth(0.3, &[(0.3, zone), (-0.1, zone)]);
        assert!(
            matches!(negative, Err(Error::EntryOutOfRange { index: 1, value: -0.1, .. })),
            "{negative:?}"
        );
    }
}
