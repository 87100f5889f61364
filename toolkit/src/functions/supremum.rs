//! max |u| of a function with breakpoints, from the values that all norms see.
//!
//! Let v_k be the values at the points of [`super::look`] and in the middle of an interval between breakpoints, T the largest
//! |v_k|, and Δ^m_k differences of order m over neighbouring points. Where u is smooth, |u| exceeds the larger one of
//! |v_k| and |v_{k+1}| by at most about |Δ²|/8 between them. Only where
//!
//! ```text
//! max(|v_k|, |v_{k+1}|) + |Δ²| + 16 |Δ⁴| > T    (the last term where |Δ⁴| > 1e-5: u is not smooth there)
//! ```
//!
//! more is asked of u: next to a largest v_k the maximum is located by golden-section search if u is smooth there.
//! Otherwise, and where there is a maximum nearer to a breakpoint than the first point, this method refuses, and the polynomials
//! of [`crate::resolved`] answer. Next to a singular breakpoint u is not smooth, but its differences decrease away from
//! it: there no maximum lies between the points.
//!
//! Towards a breakpoint the values at t = ln(R/δ) = 1/2, 3/2, ... are seen. If |u| grows along them the supremum is the limit,
//! 2u(δ) − u(2δ) at the smallest distance where u is smooth up to the breakpoint; otherwise it is extrapolated from the depths
//! T/4, T/2, 3T/4 and T: the differences of a power of δ at equal steps of t are a geometric series, those of a power of ln δ
//! are one when t doubles. If neither decreases it is infinite. Cost: 512 values on every interval and those towards
//! its ends, of which later norms take none, and 40 at every maximum.

use super::arm::Arm;
use super::function::SingularFunction;
use super::look::{LOOKS, share};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::search::golden_section;
use crate::root::accept;

/// Fourth difference of values of a function of size 1 above which it is not smooth on their scale, and its weight.
const ROUGH: f64 = 1e-5;
const WEIGHT: f64 = 16.0;
/// Width, in distances between two points, to which a smooth maximum is located, and the relative change over it from which
/// it is located to less.
const WIDTH: f64 = 1e-8;
const FLAT: f64 = 1e-14;
/// Ratio of differences above which they count as not decreasing: ln t grows by equal amounts when t doubles.
const FALLS: f64 = 1.0 - 1e-9;
/// Ratio of two ratios of steps above which they are not those of a geometric series.
const SLOWER: f64 = 1.02;
/// Relative rounding error of a value of u.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Shares of a side at which the terms of a sum are taken.
const AT_TERMS: [f64; 4] = [1e-6, 0.31, 0.69, 1.0];
/// Rounding of the limit at a breakpoint, and of a coordinate next to it.
const OF_LIMIT: f64 = 16.0 * f64::EPSILON;
const OF_PLACE: f64 = 4.0 * f64::EPSILON;
/// Message: polynomials are asked.
const INSIDE: &str = "the function is not smooth next to its maximum between two breakpoints";
/// Message: the limit at a breakpoint.
const LIMIT: &str = "the limit at a breakpoint, or rounding, limits the accuracy";

/// A value of |u|, or its supremum on a part of the interval.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Peak {
    value: f64,
    error: f64,
}

impl Peak {
    /// The larger one; the error of a smaller one counts as far as it reaches above the other.
    fn or(self, other: Self) -> Self {
        let [low, high] = if self.value <= other.value { [self, other] } else { [other, self] };
        Self { value: high.value, error: high.error.max(low.value + low.error - high.value) }
    }
}

/// The values between two breakpoints, from left to right.
struct Between<'a> {
    u: &'a SingularFunction<'a>,
    sides: [Arm; 2],
    values: Vec<f64>,
    /// the place and value of the last point towards both breakpoints, as seen from them
    inner: [Option<(f64, f64)>; 2],
}

/// The place of value k between two breakpoints, in units of R/256, R half of their distance.
fn place(k: usize) -> f64 {
    match k {
        0..LOOKS => LOOKS as f64 * share(k),
        LOOKS => LOOKS as f64,
        _ => 2.0 * LOOKS as f64 - place(2 * LOOKS - k),
    }
}

/// Those of the values at t = 1/2, 3/2, ... that are nearer to the breakpoint than the first point, with their places.
fn nearer(scales: &[f64]) -> impl Iterator<Item = (f64, f64)> + '_ {
    let place = |k: usize| LOOKS as f64 * (-(k as f64 + 0.5)).exp();
    let first = (0..scales.len()).take_while(|&k| place(k) >= LOOKS as f64 * share(0)).count();
    (first..scales.len()).map(move |k| (place(k), scales[k]))
}

/// Polynomials are asked instead.
fn inside(asked: Tolerance) -> Error {
    Error::out_of_reach("L^inf norm", asked.relative(), f64::INFINITY, INSIDE)
}

/// The absolute values of the differences of order N − 1 over N neighbouring points at unit distances. Around the middle, where
/// two points are farther apart, they are divided differences times (N − 1)!.
fn differences<const N: usize>(values: &[f64], weights: [f64; N]) -> Vec<f64> {
    let of = |(first, window): (usize, &[f64])| {
        if first + N <= LOOKS || first > LOOKS {
            return window.iter().zip(&weights).map(|(v, w)| v * w).sum::<f64>().abs();
        }
        let mut table: [f64; N] = std::array::from_fn(|k| window[k]);
        for order in 1..N {
            for k in 0..N - order {
                let apart = place(first + k + order) - place(first + k);
                table[k] = order as f64 * (table[k + 1] - table[k]) / apart;
            }
        }
        table[0].abs()
    };
    values.windows(N).enumerate().map(of).collect()
}

impl SingularFunction<'_> {
    /// max |u|, the essential supremum where u is continuous between its breakpoints.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`]; [`Error::ToleranceNotMet`], without a value where u is not smooth next to its maximum.
    pub(super) fn largest(&self, tolerance: Tolerance) -> Result<Estimate> {
        let (peak, points) = match self.seen().peak.get() {
            Some(&(peak, points)) => {
                self.spend(points)?;
                (peak, points)
            }
            None => {
                let before = self.work_left();
                let peak = self.peak(tolerance)?;
                *self.seen().peak.get_or_init(|| (peak, before - self.work_left()))
            }
        };
        // Where values are sums their rounding is relative to the terms.
        let mut size = peak.value;
        if self.is_sum() {
            for arm in self.arms() {
                for share in AT_TERMS {
                    size = size.max(self.size_of_terms(&arm, share * arm.length)?);
                }
            }
        }
        let error = peak.error + ROUNDING * size;
        let work = Work { points, ..Work::default() };
        accept("L^inf norm", Estimate::new(peak.value, error, work)?, tolerance, LIMIT)
    }

    /// The largest value on all sides; what is refused does not depend on the tolerance, which only the message names.
    fn peak(&self, tolerance: Tolerance) -> Result<Peak> {
        let scales = self.scales();
        let (arms, mut intervals) = (self.arms(), Vec::new());
        for (sides, scales) in arms.chunks_exact(2).zip(scales.chunks_exact(2)) {
            intervals.push(Between::of(self, [sides[0], sides[1]], [&scales[0], &scales[1]])?);
        }
        let seen = intervals.iter().flat_map(|interval| &interval.values);
        let most = seen.chain(scales.iter().flatten()).fold(0.0_f64, |most, v| most.max(v.abs()));
        let mut peak = Peak { value: most, error: 0.0 };
        for (interval, scales) in intervals.iter().zip(scales.chunks_exact(2)) {
            for (arm, scales) in interval.sides.iter().zip(scales) {
                let first = self.samples_of(arm.index())[0];
                peak = peak.or(self.towards(arm, first, scales, most, tolerance)?);
            }
            peak = interval.highest(most, tolerance)?.map_or(peak, |found| peak.or(found));
        }
        Ok(peak)
    }

    /// The supremum nearer to a breakpoint than the first value, from those at t = 1/2, 3/2, ...; nothing if it is no
    /// larger than `most`.
    ///
    /// # Errors
    /// As [`SingularFunction::largest`].
    fn towards(
        &self,
        arm: &Arm,
        first: f64,
        scales: &[f64],
        most: f64,
        asked: Tolerance,
    ) -> Result<Peak> {
        let all: Vec<f64> = std::iter::once(first).chain(nearer(scales).map(|(_, v)| v)).collect();
        let (low, high) =
            all.iter().fold((first, first), |(low, high), &v| (low.min(v), high.max(v)));
        if low.abs().max(high.abs()) + (high - low) < most {
            return Ok(Peak::default());
        }
        let slack = ROUNDING * most;
        let mut pairs = all.windows(2).map(|pair| pair[1].abs() - pair[0].abs());
        if pairs.clone().all(|growth| growth <= slack) {
            return Ok(Peak::default());
        }
        if pairs.any(|growth| growth < -slack) {
            return Err(inside(asked));
        }
        self.limit_at(arm, most)
    }

    /// The limit of |u| at the breakpoint of a side, towards which it grows.
    fn limit_at(&self, arm: &Arm, most: f64) -> Result<Peak> {
        let least = arm.delta(arm.depth);
        let at = |delta: f64| self.evaluated(arm, delta).map(f64::abs);
        let [u, twice, four] = [at(least)?, at(2.0 * least)?, at(4.0 * least)?];
        let (limit, other) = (2.0 * u - twice, 2.0 * twice - four);
        let deep = |share: f64| at(arm.delta(share * arm.depth));
        let [first, second, third] = [deep(0.25)?, deep(0.5)?, deep(0.75)?];
        // The rounding of x moves values along the slope.
        let moved =
            OF_PLACE * self.coordinate_if_seen(arm.anchor).abs() / least * (u - twice).abs();
        let rounding = OF_LIMIT * most + moved;
        let approaches = (second - limit).abs() <= (0.5 * (first - limit).abs()).max(rounding);
        if approaches && (limit - other).abs() <= rounding {
            return Ok(Peak { value: limit, error: (limit - other).abs() + moved });
        }
        beyond([first, second, third, u])
    }
}

impl<'a> Between<'a> {
    fn of(u: &'a SingularFunction<'a>, sides: [Arm; 2], scales: [&[f64]; 2]) -> Result<Self> {
        let [left, right] = sides.map(|arm| u.samples_of(arm.index()));
        let middle = u.evaluated(&sides[0], sides[0].length)?;
        let values = left.iter().chain([&middle]).chain(right.iter().rev()).copied().collect();
        Ok(Self { u, sides, values, inner: scales.map(|scales| nearer(scales).next()) })
    }

    /// |u| at a place; a value that is not finite was reported before, and loses the comparison.
    fn size(&self, place: f64) -> f64 {
        let [left, right] = &self.sides;
        let (arm, place) =
            if place <= LOOKS as f64 { (left, place) } else { (right, 2.0 * LOOKS as f64 - place) };
        self.u.evaluated(arm, arm.length * (place / LOOKS as f64)).map_or(0.0, f64::abs)
    }

    /// The largest value between the points, if it may exceed `most`.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] without a value where u is not smooth there.
    fn highest(&self, most: f64, asked: Tolerance) -> Result<Option<Peak>> {
        let last = self.values.len() - 1;
        let size = |k: usize| self.values[k].abs();
        let bends = differences(&self.values, [1.0, -2.0, 1.0]);
        let fourth = differences(&self.values, [1.0, -4.0, 6.0, -4.0, 1.0]);
        // The largest difference over windows of `width` points that contain points k and k + 1.
        let around = |of: &[f64], width: usize, k: usize| {
            let windows = (k + 2).saturating_sub(width)..(k + 1).min(of.len());
            of[windows].iter().copied().fold(0.0, f64::max)
        };
        let regular = [self.regular(false, &fourth), self.regular(true, &fourth)];
        let mut found: Option<Peak> = None;
        let mut is_candidate = vec![false; last + 1];
        for k in 0..last {
            let rough = around(&fourth, 5, k);
            let is_rough = rough > ROUGH;
            let excess = around(&bends, 3, k) + if is_rough { WEIGHT * rough } else { 0.0 };
            if size(k).max(size(k + 1)) + excess <= most * (1.0 + ROUNDING) {
                continue;
            }
            if k < regular[0] || last - k <= regular[1] {
                continue;
            }
            if is_rough {
                return Err(inside(asked));
            }
            is_candidate[k] = true;
            is_candidate[k + 1] = true;
        }
        for k in (0..=last).filter(|&k| is_candidate[k]) {
            let is_lower = |other: usize| size(other) <= size(k);
            if (k == 0 || is_lower(k - 1)) && (k == last || is_lower(k + 1)) {
                // The values towards the breakpoint are no larger than the first one: `towards`.
                let near = place(0) / std::f64::consts::E;
                let from = if k == 0 { near } else { place(k - 1) };
                let to = if k == last { 2.0 * LOOKS as f64 - near } else { place(k + 1) };
                let peak = self.refined(from, to, size(k));
                found = Some(found.map_or(peak, |found| found.or(peak)));
            }
        }
        Ok(found)
    }

    /// The number of steps from the left or the right end on which u is not smooth, but monotone with decreasing steps as next
    /// to a singular breakpoint; 0 if it is something else.
    fn regular(&self, from_right: bool, fourth: &[f64]) -> usize {
        let last = self.values.len() - 1;
        let at = |k: usize| self.values[if from_right { last - k } else { k }];
        let rough = |k: usize| fourth[if from_right { fourth.len() - 1 - k } else { k }] > ROUGH;
        let count = (0..fourth.len()).take_while(|&k| rough(k)).count();
        if count == 0 {
            return 0;
        }
        let end = (count + 3).min(last);
        let step = |k: usize| at(k + 1) - at(k);
        let is_steeper =
            |before: f64, after: f64| before * after > 0.0 && before.abs() > after.abs();
        let is_regular = (1..end).all(|k| is_steeper(step(k - 1), step(k)));
        let inner = self.inner[usize::from(from_right)];
        let is_monotone = inner
            .is_some_and(|(at_inner, v)| is_steeper((at(0) - v) / (place(0) - at_inner), step(0)));
        if is_regular && is_monotone { end } else { 0 }
    }

    /// The maximum between two places, of which u has one, next to a value between them.
    fn refined(&self, from: f64, to: f64, seen: f64) -> Peak {
        let around = |width: f64| {
            let at = golden_section(from, to, width, |at| -self.size(at));
            let beside = |at: f64| self.size(at.clamp(from, to));
            let mut found = [beside(at - width), self.size(at), beside(at + width)];
            found.sort_by(f64::total_cmp);
            found
        };
        let mut found = around(WIDTH);
        if found[2] - found[0] > FLAT * found[2] {
            // A kink is located to rounding.
            found = around(FLAT.max(16.0 * f64::EPSILON * to));
        }
        // Of three values at a step, two lie on its upper side. A search that ends below its start has met several maxima.
        let missed = (seen - found[2]).max(0.0);
        Peak { value: found[2].max(seen), error: found[2] - found[1] + missed }
    }
}

/// The limit of values that grow along the depths T/4, T/2, 3T/4, T, and its uncertainty, all of the extrapolation.
fn beyond([first, second, third, last]: [f64; 4]) -> Result<Peak> {
    let last_step = last - third;
    if last_step <= ROUNDING * last {
        return Ok(Peak { value: last, error: last_step.max(0.0) });
    }
    let rest = |step: f64, ratio: f64| {
        (ratio > 0.0 && ratio < FALLS).then(|| step * ratio / (1.0 - ratio))
    };
    let ratio = last_step / (third - second);
    let doubled = (last - second) / (second - first);
    // Of a power of ln δ the ratio of equal steps grows.
    let is_power = ratio <= SLOWER * (third - second) / (second - first);
    match (rest(last_step, ratio), rest(last - second, doubled)) {
        (Some(of_power), None) if is_power => Ok(Peak { value: last + of_power, error: of_power }),
        (Some(of_power), Some(of_logarithm)) => {
            Ok(Peak { value: last + of_power, error: of_power.max(of_logarithm) })
        }
        _ => Err(Error::InfiniteNorm {
            order: 0.0,
            why: "the function grows without bound near a breakpoint",
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maxima_inside_at_breaks_and_infinite_ones() {
        let largest = |f: fn(f64) -> f64| {
            SingularFunction::new(&[0.0, 1.0], f)
                .unwrap()
                .lq_norm(f64::INFINITY, Tolerance::balanced())
        };
        let parabola = largest(|x| 4.0 * x * (1.0 - x)).unwrap();
        assert!(
            (parabola.value - 1.0).abs() <= parabola.error && parabola.error < 1e-12,
            "{parabola}"
        );
        let root = largest(|x| 1.0 - x.sqrt()).unwrap();
        assert!((root.value - 1.0).abs() <= root.error, "{root}");
        let steep = largest(|x| (7.0 * x).sin()).unwrap();
        assert!((steep.value - 1.0).abs() <= steep.error, "{steep}");
        for unbounded in [(|x: f64| x.powf(-0.01)) as fn(f64) -> f64, |x| (-x.ln()).powf(0.25)] {
            assert!(matches!(largest(unbounded), Err(Error::InfiniteNorm { .. })));
        }
    }
}
