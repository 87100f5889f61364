//! Which set E of given measure has the largest constant: the zone at an end, by rearrangement.

use crate::EstimateExt;
use crate::SplitMix;
use crate::parallel;
use crate::search::golden_section;
use crate::zones::Condition;
use fractional_sobolev::{Constraint, Zones, gamma};
use fractional_sobolev::{Error, Estimate, Given, Order, Result, Tolerance};

/// Most intervals of a random union.
const MOST_INTERVALS: usize = 5;
/// Measures of random unions: 0.9 and down to this.
const SHORTEST_UNION: f64 = 1e-12;
/// Lengths of the intervals of one union, and of its gaps, differ by this factor at most.
const SPREAD: f64 = 30.0;
/// Orders are drawn from [this, 1 − this].
const LEAST_ORDER: f64 = 1e-3;

/// A zone with its order and condition.
///
/// # Method
///
/// For 0 < ν < 1 and every measurable E of measure θ, γ_E(ν) ≤ γ_(0,θ)(ν), for functions with mean zero on E
/// and for those that vanish there: |v*|_ν ≤ |v|_ν for the decreasing rearrangement v*, whose mean over (0,θ)
/// is the largest over all sets of measure θ. Here both sides for random unions of intervals, and where along
/// the interval a single zone has its least constant.
#[derive(Debug, Clone, PartialEq)]
pub struct ZoneCase {
    /// The order ν.
    pub order: Order,
    /// The set E.
    pub zones: Zones,
    /// What is asked of functions on E.
    pub condition: Condition,
}

impl ZoneCase {
    /// A random case: 1 to 5 intervals of measure 1e-12 to 0.9 on an extent between θ and one, anywhere, a
    /// quarter of the unions from the left end on; ν in \[0.001, 0.999\], half of them within a tenth of 0,
    /// 1/2 or 1.
    ///
    /// # Errors
    /// None for the parameters drawn here; those of [`Zones::from_lengths`] are passed on.
    pub fn random(random: &mut SplitMix) -> Result<Self> {
        let theta = 0.9 * SHORTEST_UNION.powf(random.uniform());
        let count = 1 + random.below(MOST_INTERVALS);
        let mut shares = |count: usize| -> Vec<f64> {
            let raw: Vec<f64> = (0..count).map(|_| SPREAD.powf(random.uniform())).collect();
            let sum: f64 = raw.iter().sum();
            raw.into_iter().map(|share| share / sum).collect()
        };
        let (intervals, gaps) = (shares(count), shares(count - 1));
        let room = 1.0 - theta;
        let within = if count > 1 { room * theta.powf(random.uniform()) } else { 0.0 };
        let left = if count > 1 && random.below(4) == 0 { 0.0 } else { (room - within) * random.uniform() };
        let mut lengths = vec![left, theta * intervals[0]];
        for (gap, interval) in gaps.iter().zip(&intervals[1..]) {
            lengths.extend([within * gap, theta * interval]);
        }
        let nu = match random.below(6) {
            0 => 0.1 * (10.0 * LEAST_ORDER).powf(random.uniform()),
            1 => 1.0 - 0.1 * (10.0 * LEAST_ORDER).powf(random.uniform()),
            2 => random.between(0.4, 0.6),
            _ => random.between(LEAST_ORDER, 1.0 - LEAST_ORDER),
        };
        let condition = [Condition::MeanZero, Condition::Vanishing][random.below(2)];
        Ok(Self { order: Order::new(nu)?, zones: Zones::from_lengths(&lengths)?, condition })
    }

    /// γ_E / γ_(0,θ), at most one.
    ///
    /// ```
    /// use experiments::arrangement::ZoneCase;
    /// use experiments::zones::Condition;
    /// use fractional_sobolev::{Order, Tolerance, Zones};
    /// let zones = Zones::union(&[0.2..0.21, 0.7..0.72])?;
    /// let case = ZoneCase { order: Order::HALF, zones, condition: Condition::Vanishing };
    /// assert!(case.over_end(Tolerance::fast())?.value < 0.8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`gamma`].
    pub fn over_end(&self, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        let end = gamma(self.order, self.condition.on(0.0..self.zones.length()), tolerance)?.constant;
        gamma(self.order, self.condition.on(&self.zones), tolerance)?.constant.over(end)
    }
}

/// `count` random cases with their ratios γ_E / γ_(0,θ); `None` where rounding forbids the tolerance.
///
/// ```
/// use experiments::SplitMix;
/// use experiments::arrangement::{ZoneCase, random_zones};
/// use fractional_sobolev::Tolerance;
/// for (case, ratio) in random_zones(2, 1, Tolerance::fast())? {
///     assert!(ratio.is_none_or(|ratio| ratio.value <= 1.0 + ratio.error), "{}", case.zones);
/// }
/// assert!(ZoneCase::random(&mut SplitMix::new(1))?.zones.length() < 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// Those of [`ZoneCase::over_end`], except for [`Error::ToleranceNotMet`].
pub fn random_zones(
    count: u32,
    seed: u64,
    tolerance: impl Given<Tolerance>,
) -> Result<Vec<(ZoneCase, Option<Estimate>)>> {
    let tolerance = tolerance.given()?;
    let mut random = SplitMix::new(seed);
    let cases = (0..count).map(|_| ZoneCase::random(&mut random)).collect::<Result<Vec<_>>>()?;
    let with_ratio = |case: &ZoneCase| match case.over_end(tolerance) {
        Ok(ratio) => Ok((case.clone(), Some(ratio))),
        Err(Error::ToleranceNotMet { .. }) => Ok((case.clone(), None)),
        Err(error) => Err(error),
    };
    parallel::over(&cases, with_ratio).into_iter().collect()
}

/// A zone of one length, moved along the interval, and cut in two.
///
/// ```
/// use experiments::arrangement::MovedZone;
/// use experiments::zones::Condition;
/// use fractional_sobolev::{Order, Tolerance};
/// let found = MovedZone::new(Order::HALF, 0.1, Condition::MeanZero, Tolerance::fast())?;
/// assert!(found.least.value < 1.0 && found.whole.value <= found.least.value + 1e-3);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MovedZone {
    /// The order ν.
    pub order: Order,
    /// Mean zero or vanishing.
    pub condition: Condition,
    /// Where the constant of (a, a + θ) is least for a ≤ (1 − θ)/2, to a thousandth: a/(1 − θ), one half in
    /// the middle.
    pub share: f64,
    /// The least constant over that of (0, θ).
    pub least: Estimate,
    /// γ₁ over that of (0, θ): with mean zero no set has less, and a symmetric one has γ₁ where an odd
    /// function is extremal.
    pub whole: Estimate,
    /// (g, γ_E / γ_(0,θ)) for two halves, symmetric about the middle, with the gap g between them: from
    /// 1e-4 (1 − θ) to 1 − θ, where they lie at both ends.
    pub gaps: Vec<(f64, Estimate)>,
}

impl MovedZone {
    /// Moves and cuts a zone of length θ. Cost: some fifty constants.
    ///
    /// # Errors
    /// Those of [`gamma`] and [`Zones::from_start_and_length`].
    pub fn new(
        order: impl Given<Order>,
        theta: f64,
        condition: Condition,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        let (share, least) = best_place(order, theta, condition, tolerance)?;
        let end = gamma(order, condition.on(0.0..theta), tolerance)?.constant;
        let whole = gamma(order, Constraint::mean_zero(), tolerance)?.constant.over(end)?;
        let gaps = opening_gap(order, theta, condition, tolerance)?;
        Ok(Self { order, condition, share, least, whole, gaps })
    }
}

/// Gaps over 1 − θ.
const GAPS: [f64; 16] =
    [1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.06, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];

/// (g, γ_E / γ_(0,θ)) for the two halves of a zone of length θ, symmetric about the middle, as the gap g
/// between them opens to 1 − θ, where they lie at both ends.
///
/// # Errors
/// Those of [`ZoneCase::over_end`].
fn opening_gap(
    order: Order,
    theta: f64,
    condition: Condition,
    tolerance: Tolerance,
) -> Result<Vec<(f64, Estimate)>> {
    let opened = |share: &f64| {
        let gap = (1.0 - theta) * share;
        let before = 0.5 * ((1.0 - theta) - gap);
        let zones = Zones::from_lengths(&[before, 0.5 * theta, gap, 0.5 * theta])?;
        Ok((gap, ZoneCase { order, zones, condition }.over_end(tolerance)?))
    };
    parallel::over(&GAPS, opened).into_iter().collect()
}

/// Places tried before the search, and the width to which the best one is searched.
const PLACES: usize = 8;
const PLACED: f64 = 1e-3;

/// The start a ∈ [0, (1 − θ)/2] of the zone (a, a + θ) with the least γ, as a share of 1 − θ, and its γ over
/// that of (0, θ): places at equal steps, then golden sections around the best.
fn best_place(
    order: Order,
    theta: f64,
    condition: Condition,
    tolerance: Tolerance,
) -> Result<(f64, Estimate)> {
    let value = |share: f64| {
        gamma(order, condition.on(Zones::from_start_and_length(share * (1.0 - theta), theta)), tolerance)
            .map(|found| found.constant)
    };
    let shares = [0, 1, 2, 3, 4, 5, 6, 7, PLACES].map(|k| 0.5 * k as f64 / PLACES as f64);
    let found = parallel::over(&shares, |&share| Ok(value(share)?.value));
    let found = found.into_iter().collect::<Result<Vec<f64>>>()?;
    let best = (0..=PLACES).min_by(|&i, &j| found[i].total_cmp(&found[j])).unwrap_or(PLACES);
    let (low, high) = (shares[best.saturating_sub(1)], shares[(best + 1).min(PLACES)]);
    let searched = golden_section(low, high, PLACED, |share| value(share).map_or(f64::INFINITY, |g| g.value));
    let share = if value(searched)?.value < found[best] { searched } else { shares[best] };
    Ok((share, value(share)?.over(value(0.0)?)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_cases_are_admissible_and_reach_their_extremes() {
        let mut random = SplitMix::new(1);
        let cases: Vec<ZoneCase> = (0..2000).map(|_| ZoneCase::random(&mut random).unwrap()).collect();
        let shortest = cases.iter().map(|case| case.zones.length()).fold(1.0, f64::min);
        let least = cases.iter().map(|case| case.order.value()).fold(1.0, f64::min);
        assert!(shortest < 1e-11 && least < 2e-3);
        assert!((1..=MOST_INTERVALS).all(|n| cases.iter().any(|case| case.zones.count() == n)));
    }
}
