//! Functions given by code with declared breakpoints, between which they are smooth.

use super::arm::Arm;
use super::look::{LOOKS, distance};
use super::octaves::{First, Seen, Spot};
use crate::error::{Error, Result};
use crate::estimate::{SPENT, Tolerance};
use crate::numeric::budget::Budget;
use crate::numeric::check::{require_entry, require_finite, require_finite_at};
use crate::numeric::scale::power_of_two;
use std::sync::{Arc, OnceLock};

/// Number of points of a side at which the size of a function is estimated.
const SAMPLES: usize = 16;
/// Size of values that may overflow closer to a breakpoint, and the accuracy of the t at which they do.
const HUGE: f64 = 1e150;
const TO_LIMIT: f64 = 1e-3;

/// A point of the interval, given by its signed distance from the nearest breakpoint.
///
/// ```
/// use fractional_sobolev::{Function, Position};
/// // x − 1/2 on both sides of the breakpoint 1/2, exact at any distance from it
/// let f = |at: Position| if at.anchor() == 1 { at.offset() } else { at.x() - 0.5 };
/// let u = Function::from_positions(&[0.0, 0.5, 1.0], f)?;
/// assert!((u.seminorm(0.5, 1e-4)?.value - 1.0).abs() < 1e-4);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position<'a> {
    breaks: &'a [f64],
    x: f64,
    anchor: usize,
    offset: f64,
    /// ln of the distance where the distance underflows
    depth: Option<f64>,
}

impl Position<'_> {
    /// The coordinate, rounded.
    pub fn x(&self) -> f64 {
        self.x
    }

    /// Index of the nearest breakpoint, relative to which this position is stored.
    pub fn anchor(&self) -> usize {
        self.anchor
    }

    /// x minus the coordinate of that breakpoint, exact; a signed zero where it underflows.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// |x − c_k| for any breakpoint c_k, to full relative accuracy: |offset| for the nearest one, for the others
    /// the sum of the offset and the distance of the two breakpoints. The same formula for u can then be used
    /// at all breakpoints.
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// // √x ln|x - 3/10|
    /// let u = Function::from_positions(&[0.0, 0.3, 1.0], |at| {
    ///     at.distance_to(0).sqrt() * at.log_distance_to(1)
    /// })?;
    /// let found = u.seminorm(0.4, 1e-4)?;
    /// assert!(found.relative_error() <= 1e-4);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// NaN if there is no breakpoint k; the norms then return an error.
    pub fn distance_to(&self, k: usize) -> f64 {
        if k == self.anchor { self.offset.abs() } else { self.from(k).abs() }
    }

    /// ln of [`Position::distance_to`], also where the distance underflows.
    pub fn log_distance_to(&self, k: usize) -> f64 {
        if k == self.anchor { self.log_distance() } else { self.from(k).abs().ln() }
    }

    /// ln |offset| where the offset may underflow.
    pub(super) fn depth_if_any(&self) -> Option<f64> {
        self.depth
    }

    /// x − c_k.
    fn from(&self, k: usize) -> f64 {
        self.breaks
            .get(k)
            .map_or(f64::NAN, |other| (self.breaks[self.anchor] - other) + self.offset)
    }

    /// ln |offset|, also where the offset underflows, down to −10^{300}.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Position};
    /// // |ln x|^0.3 at 0, its limit at 1
    /// let near = |at: Position| if at.anchor() == 0 { (-at.log_distance()).powf(0.3) } else { (-at.x().ln()).powf(0.3) };
    /// assert!(Function::from_positions(&[0.0, 0.5], near)?.norm(0.25, 1e-4)?.value > 0.5);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    pub fn log_distance(&self) -> f64 {
        self.depth.unwrap_or_else(|| self.offset.abs().ln())
    }
}

/// Values at positions.
pub(super) type Values<'a> = Arc<dyn Fn(Position<'_>) -> f64 + Send + Sync + 'a>;

/// A real function on an interval with declared singular points.
///
/// # Method
///
/// The interval between two neighbouring breakpoints is cut in the middle into two *sides*, each belonging
/// to one breakpoint. A point of a side of length R is x = c ± δ, δ = R e^{-t}, t > 0: in t every power and
/// logarithm of the distance to the breakpoint is a smooth function, and double integrals are taken over
/// pairs (t, t′) (`log_energy`). A function of x alone is given the distance to a breakpoint c ≠ 0 only to
/// an ulp of c; a function of the [`Position`] is given the distance itself, or its logarithm.
#[doc(alias(
    "Gagliardo",
    "Slobodeckij",
    "Gagliardo seminorm",
    "fractional Sobolev",
    "H1/2",
    "H^s",
    "closure"
))]
pub(crate) struct SingularFunction<'a> {
    breaks: Vec<f64>,
    function: Values<'a>,
    /// sizes of the terms of the values, where these are sums or made of sums
    terms: Option<Values<'a>>,
    sight: Sight,
    budget: Budget,
    /// the unit of length, a power of two, in which the breakpoints are given
    pub(super) unit: f64,
    /// what all norms of the function have seen of it
    seen: Arc<Seen>,
    is_normalized: bool,
    /// for every side the largest t at which its values do not overflow, once the function is normalized
    limits: Vec<f64>,
}

/// Units of length and value: powers of two near the length and the size of a function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Units {
    pub(crate) length: f64,
    pub(crate) size: f64,
}

/// A function divided by its unit, on an interval divided by a unit of length.
pub(crate) struct Normalized<'a> {
    pub(crate) units: Units,
    pub(crate) u: SingularFunction<'a>,
}

/// The argument with which the function is called.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sight {
    Coordinate,
    Offset,
    LogDistance,
}

impl std::fmt::Debug for SingularFunction<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SingularFunction").field("breaks", &self.breaks).finish_non_exhaustive()
    }
}

impl Clone for SingularFunction<'_> {
    /// The same function, with a work limit that is not spent.
    fn clone(&self) -> Self {
        Self {
            breaks: self.breaks.clone(),
            function: Arc::clone(&self.function),
            terms: self.terms.clone(),
            sight: self.sight,
            budget: Budget::new(u64::MAX, 0.0),
            unit: self.unit,
            seen: Arc::clone(&self.seen),
            is_normalized: self.is_normalized,
            limits: self.limits.clone(),
        }
    }
}

impl<'a> SingularFunction<'a> {
    /// The function f(x) on (breaks\[0\], breaks\[last\]), smooth between the breakpoints.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for fewer than two breakpoints, [`Error::NotFinite`],
    /// [`Error::EntryOutOfRange`] unless they increase by at least 1e-290 and by at least 1e-290 times the
    /// length of the interval.
    pub(crate) fn new(breaks: &[f64], f: impl Fn(f64) -> f64 + Send + Sync + 'a) -> Result<Self> {
        Self::build(breaks, Arc::new(move |at: Position| f(at.x)), Sight::Coordinate)
    }

    /// As [`SingularFunction::new`] for a function of the [`Position`]: exact as close to a breakpoint as
    /// 1e-290.
    ///
    /// # Errors
    /// As [`SingularFunction::new`].
    pub(crate) fn from_positions(
        breaks: &[f64],
        f: impl Fn(Position) -> f64 + Send + Sync + 'a,
    ) -> Result<Self> {
        Self::build(breaks, Arc::new(f), Sight::Offset)
    }

    /// As [`SingularFunction::from_positions`] for a function that is accurate also where offsets
    /// underflow, by [`Position::log_distance`]: for singularities so weak that distances below 1e-300
    /// contribute, such as |ln x|^α at ν = 1/2.
    ///
    /// Along each side the function should be smooth in ln |ln d|, as powers and iterated logarithms of |ln
    /// d| are.
    ///
    /// # Errors
    /// As [`SingularFunction::new`].
    pub(crate) fn from_log_distances(
        breaks: &[f64],
        f: impl Fn(Position) -> f64 + Send + Sync + 'a,
    ) -> Result<Self> {
        Self::build(breaks, Arc::new(f), Sight::LogDistance)
    }

    fn build(breaks: &[f64], function: Values<'a>, sight: Sight) -> Result<Self> {
        if breaks.len() < 2 {
            return Err(Error::CountOutOfRange {
                name: "breakpoints",
                value: breaks.len(),
                range: "[2, inf) (both ends of the interval are breakpoints)",
            });
        }
        let total = breaks[breaks.len() - 1] - breaks[0];
        require_finite("breakpoint", breaks)?;
        for (k, pair) in breaks.windows(2).enumerate() {
            let length = pair[1] - pair[0];
            let admissible = length > 1e-290 && length > 1e-290 * total && length.is_finite();
            let range = "(c + 1e-290 max(1, L), inf), c the previous breakpoint, L the length of the interval";
            require_entry("breakpoint", k + 1, pair[1], range, admissible)?;
        }
        Ok(Self {
            breaks: breaks.to_vec(),
            function,
            terms: None,
            sight,
            budget: Budget::new(u64::MAX, 0.0),
            unit: 1.0,
            seen: Arc::default(),
            is_normalized: false,
            limits: Vec::new(),
        })
    }

    /// The breakpoints.
    pub(crate) fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// Length of the interval.
    pub(crate) fn length(&self) -> f64 {
        self.breaks[self.breaks.len() - 1] - self.breaks[0]
    }

    /// The values at equal distances on every side.
    fn look(&self) -> Result<Vec<Vec<f64>>> {
        let of = |arm: &Arm| (0..LOOKS).map(|j| self.at(arm, distance(arm, j))).collect();
        self.arms().iter().map(of).collect()
    }

    /// The samples of a side, once the function is normalized.
    pub(super) fn samples_of(&self, arm: usize) -> &[f64] {
        let first = self.seen.first.get().filter(|_| self.is_normalized);
        first.and_then(|first| first.samples.get(arm)).map_or(&[], Vec::as_slice)
    }

    /// The values at t = 1/2, 3/2, ... on every side, until one is not a number; they are counted in the work limit.
    pub(super) fn scales(&self) -> Vec<Vec<f64>> {
        self.on_scales(&self.seen.scales, |arm| {
            let count = arm.depth.floor() as usize;
            (0..count).map(|k| arm.delta(k as f64 + 0.5)).collect()
        })
    }

    /// The values at δ = 3/4 R/2^k, k = 0, 1, ..., on a side, as far as they are numbers.
    pub(crate) fn middles(&self, arm: &Arm) -> Vec<f64> {
        let mut all = self.on_scales(&self.seen.middles, |arm| {
            let count = (arm.depth / std::f64::consts::LN_2) as usize + 1;
            (0..count).map(|k| 0.75 * arm.length * 0.5f64.powi(k as i32)).collect()
        });
        all.swap_remove(arm.index())
    }

    fn on_scales(
        &self,
        kept: &OnceLock<Vec<Vec<f64>>>,
        places: impl Fn(&Arm) -> Vec<f64>,
    ) -> Vec<Vec<f64>> {
        let of = |arm: &Arm| {
            let values = places(arm).into_iter().map_while(|delta| self.direct(arm, delta).ok());
            values.collect::<Vec<f64>>()
        };
        let take = || self.arms().iter().map(of).collect::<Vec<_>>();
        if !self.is_normalized {
            return take();
        }
        let found = kept.get_or_init(take);
        // Later norms fail for the same limit.
        let _ = self.spend(found.iter().map(|values| values.len() as u64).sum());
        found.clone()
    }

    pub(super) fn seen(&self) -> &Seen {
        &self.seen
    }

    pub(super) fn is_normalized(&self) -> bool {
        self.is_normalized
    }

    /// A power of two near the largest of the samples and of values closer to the breakpoints, so that squares and powers of u
    /// divided by it neither over- nor underflow; 1 where all of them vanish.
    fn size(&self, samples: &[Vec<f64>]) -> Result<f64> {
        let mut largest =
            samples.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
        for arm in self.arms() {
            for k in 0..SAMPLES {
                let t = (arm.depth * (k as f64 + 0.5) / SAMPLES as f64).min(0.1 + 0.3 * k as f64);
                largest = largest.max(self.at(&arm, arm.delta(t))?.abs());
                // Deeper, what counts in L² is u √δ; where it is no number it may never be asked for.
                let deep = arm.depth * (k as f64 + 0.5) / SAMPLES as f64;
                let value = self.at(&arm, arm.delta(deep)).map_or(0.0, f64::abs);
                largest = largest.max(value * (-0.5 * deep).exp());
            }
        }
        Ok(power_of_two(largest))
    }

    /// The largest t of a side at which the values, and their quotients by `size`, do not overflow: x^{−0.98} ln⁶ x is in L¹
    /// and exceeds 1e308 at 1e-298. Infinite where they do not, and where they do not grow up to it: such a value is an error.
    fn limit(&self, arm: &Arm, size: f64) -> f64 {
        let at = |t: f64| self.at(arm, arm.delta(t)).map(|value| (value, value / size));
        let is_number = |t: f64| at(t).is_ok_and(|(_, quotient)| quotient.abs() < HUGE * HUGE);
        if is_number(arm.depth) {
            return f64::INFINITY;
        }
        let (mut low, mut high) = (0.0, arm.depth);
        while high - low > TO_LIMIT {
            let middle = 0.5 * (low + high);
            if is_number(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        match at(low) {
            Ok((value, quotient)) if value.abs().max(quotient.abs()) > HUGE => low,
            _ => f64::INFINITY,
        }
    }

    /// u divided by its size, on the unit interval, so that all quantities compared with numbers are
    /// dimensionless. The function is called at the points of the original interval, with exact offsets; its
    /// evaluations are counted in the work limit of the tolerance, those of the samples at equal distances too.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] if the limit does not suffice for these samples; those of the values.
    pub(crate) fn normalized(&self, tolerance: Tolerance) -> Result<Normalized<'_>> {
        let budget = Budget::new(tolerance.work(), tolerance.relative());
        if !budget.spend((LOOKS * self.arms().len()) as u64) {
            return Err(budget.spent("norm", SPENT));
        }
        if self.is_normalized {
            let u = SingularFunction { budget, ..self.clone() };
            return Ok(Normalized { units: Units { length: 1.0, size: 1.0 }, u });
        }
        let first = match self.seen.first.get() {
            Some(first) => first,
            None => {
                let mut samples = self.look()?;
                let size = self.size(&samples)?;
                samples.iter_mut().flatten().for_each(|value| *value /= size);
                let limits = self.arms().iter().map(|arm| self.limit(arm, size)).collect();
                self.seen.first.get_or_init(|| First { size, samples, limits })
            }
        };
        let (size, limits) = (first.size, first.limits.clone());
        let length = power_of_two(self.length());
        let breaks = self.breaks.iter().map(|at| at / length).collect();
        let shift = length.ln();
        let of = |f: Values<'a>| -> Values<'_> {
            Arc::new(move |at: Position| {
                let offset = at.offset * length;
                let depth = at.depth.map(|depth| depth + shift);
                let x = self.breaks[at.anchor] + offset;
                f(Position { breaks: &self.breaks, x, anchor: at.anchor, offset, depth }) / size
            })
        };
        let u = SingularFunction {
            breaks,
            function: of(Arc::clone(&self.function)),
            terms: self.terms.clone().map(of),
            sight: self.sight,
            budget,
            unit: self.unit * length,
            seen: Arc::clone(&self.seen),
            is_normalized: true,
            limits,
        };
        Ok(Normalized { units: Units { length, size }, u })
    }

    /// The sides, from left to right.
    pub(crate) fn arms(&self) -> Vec<Arm> {
        let mut arms = Vec::with_capacity(2 * self.breaks.len());
        for (i, pair) in self.breaks.windows(2).enumerate() {
            let length = 0.5 * (pair[1] - pair[0]);
            arms.push(self.arm(i, 1.0, length));
            arms.push(self.arm(i + 1, -1.0, length));
        }
        for (arm, limit) in arms.iter_mut().zip(&self.limits) {
            arm.depth = arm.depth.min(*limit);
        }
        arms
    }

    fn arm(&self, anchor: usize, sign: f64, length: f64) -> Arm {
        let start = self.breaks[anchor];
        // Offsets are numbers of binary64 in the unit of the closure.
        let smallest = (1e-300 / self.unit).max(1e-300 * length).max(1e-305);
        // Where x = c + δ is rounded, δ has no digits below an ulp of c and few above it.
        let blurred = match self.sight {
            Sight::Coordinate => start.abs() * 4.0 * f64::EPSILON,
            Sight::Offset | Sight::LogDistance => 0.0,
        };
        let depth = (length / smallest.max(16.0 * blurred).min(0.5 * length)).ln();
        Arm { anchor, start, sign, length, depth, blur: 0.25 * blurred }
    }

    /// The value at distance δ from the breakpoint of a side, by the polynomial of its octave if there is one
    /// ([`super::octaves`]).
    pub(crate) fn at(&self, arm: &Arm, delta: f64) -> Result<f64> {
        match self.spot(arm, delta).and_then(|spot| self.at_spot(arm, spot)) {
            Some(value) => self.spend(1).map(|()| value),
            None => self.evaluated(arm, delta),
        }
    }

    /// The same at δ = R e^{−t}, both of which are given.
    pub(super) fn along(&self, arm: &Arm, t: f64, delta: f64) -> Result<f64> {
        match self.spot_at(t).and_then(|spot| self.at_spot(arm, spot)) {
            Some(value) => self.spend(1).map(|()| value),
            None => self.evaluated(arm, delta),
        }
    }

    /// The value at distance e^s δ, where δ is that of a spot.
    pub(super) fn farther(&self, arm: &Arm, spot: Option<Spot>, s: f64, delta: f64) -> Result<f64> {
        match spot.and_then(|spot| spot.farther(s)).and_then(|spot| self.at_spot(arm, spot)) {
            Some(value) => self.spend(1).map(|()| value),
            None => self.evaluated(arm, delta),
        }
    }

    /// The value at distance δ from the breakpoint of a side, of the function itself.
    pub(crate) fn evaluated(&self, arm: &Arm, delta: f64) -> Result<f64> {
        self.value_at(arm.anchor, arm.sign * delta, None)
    }

    /// The same, not counted in the work limit.
    pub(super) fn direct(&self, arm: &Arm, delta: f64) -> Result<f64> {
        self.uncounted(arm.anchor, arm.sign * delta, None)
    }

    /// The value at δ = R e^{-t} for any t.
    pub(crate) fn at_depth(&self, arm: &Arm, t: f64) -> Result<f64> {
        self.spend(1)?;
        self.at_deep(arm, t).map_or_else(|| self.deep(arm, t), Ok)
    }

    /// The same, of the function itself and not counted in the work limit.
    pub(super) fn deep(&self, arm: &Arm, t: f64) -> Result<f64> {
        let offset = arm.sign * arm.delta(t);
        self.uncounted(arm.anchor, offset, Some(arm.length.ln() - t))
    }

    /// True if the function can be evaluated at any depth.
    pub(crate) fn is_known_at_any_depth(&self) -> bool {
        self.sight == Sight::LogDistance
    }

    /// The value at an offset from a breakpoint; `depth` is ln of the distance where the distance underflows.
    pub(crate) fn value_at(&self, anchor: usize, offset: f64, depth: Option<f64>) -> Result<f64> {
        self.spend(1)?;
        self.uncounted(anchor, offset, depth)
    }

    fn position(&self, anchor: usize, offset: f64, depth: Option<f64>) -> Position<'_> {
        let x = self.breaks[anchor] + offset;
        Position { breaks: &self.breaks, x, anchor, offset, depth }
    }

    fn uncounted(&self, anchor: usize, offset: f64, depth: Option<f64>) -> Result<f64> {
        let value = (self.function)(self.position(anchor, offset, depth));
        require_finite_at("function value near a breakpoint", anchor, value)?;
        Ok(value)
    }

    /// True if values are sums, or made of sums, in which digits may cancel.
    pub(crate) fn is_sum(&self) -> bool {
        self.terms.is_some()
    }

    /// The size of the terms of the value at an offset from a breakpoint, to which its rounding is relative: |a u| + |b v|
    /// for a u + b v, |u| for a formula.
    pub(super) fn size_at(&self, anchor: usize, offset: f64, depth: Option<f64>) -> Result<f64> {
        let size = match &self.terms {
            Some(terms) => terms(self.position(anchor, offset, depth)),
            None => self.uncounted(anchor, offset, depth)?.abs(),
        };
        require_finite_at("size of the terms of a function near a breakpoint", anchor, size)?;
        Ok(size)
    }

    /// The same at distance δ from the breakpoint of a side.
    pub(crate) fn size_of_terms(&self, arm: &Arm, delta: f64) -> Result<f64> {
        self.size_at(arm.anchor, arm.sign * delta, None)
    }

    /// This function, with the sizes of the terms of its values.
    pub(super) fn with_terms(self, terms: Option<Values<'a>>) -> Self {
        Self { terms, ..self }
    }

    /// The number of evaluations that remain within the work limit.
    pub(crate) fn work_left(&self) -> u64 {
        self.budget.left()
    }

    /// The size of the rounded coordinates near breakpoint k; 0 for a function of the offset.
    pub(crate) fn blur(&self, k: usize) -> f64 {
        self.coordinate_if_seen(k).abs()
    }

    /// The coordinate of breakpoint k for a function of x, 0 for a function of positions.
    pub(crate) fn coordinate_if_seen(&self, k: usize) -> f64 {
        if self.sight == Sight::Coordinate { self.breaks[k] } else { 0.0 }
    }

    /// True if the distance to some breakpoint is known only up to the rounding of a coordinate.
    pub(super) fn has_rounded_distances(&self) -> bool {
        self.sight == Sight::Coordinate && self.breaks.iter().any(|&at| at != 0.0)
    }

    /// Deducts kernel values from the work limit.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] if the limit is exceeded.
    pub(super) fn spend(&self, count: u64) -> Result<()> {
        if self.budget.spend(count) { Ok(()) } else { Err(self.budget.spent("norm", SPENT)) }
    }

    /// True if this function is given less exact arguments than another one.
    pub(super) fn is_less_exact_than(&self, other: &Self) -> bool {
        let rank = |sight: Sight| match sight {
            Sight::Coordinate => 0,
            Sight::Offset => 1,
            Sight::LogDistance => 2,
        };
        rank(self.sight) < rank(other.sight)
    }

    /// A function of positions with the same arguments as this one.
    pub(crate) fn seen_likewise<'b>(
        &self,
        breaks: &[f64],
        f: impl Fn(Position<'_>) -> f64 + Send + Sync + 'b,
    ) -> Result<SingularFunction<'b>> {
        let mut found = SingularFunction::build(breaks, Arc::new(f), self.sight)?;
        found.unit = self.unit;
        Ok(found)
    }

    /// The smallest distance to a breakpoint at which the function is evaluated, in units of the
    /// breakpoints.
    pub(crate) fn closest(&self) -> f64 {
        1e-290 * self.unit.recip().max(1.0)
    }
}
