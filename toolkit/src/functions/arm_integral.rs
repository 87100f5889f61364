//! ∫₀^∞ ℓ(t) dt along a side, for integrands that decay like exponentials or like powers of t.
//!
//! Gauss rules of n points on cells of width h; towards t = 0, where ℓ may behave like t^{2−2ν}, cells shrink
//! geometrically. Cells are added until the remainder is small relative to the tolerance; where ℓ decays too
//! slowly for that, wide cells down to the depth of the side are passed to [`crate::quadrature::extrapolate`]
//! and [`Partials`], or a [`DeepTail`] is added. A divergent integral is detected from the growth of its
//! integrand.
//!
//! The remainder beyond a cell is bounded for concave and for convex ln ℓ ([`super::rest`]).

use super::deep_tail::DeepTail;
use super::level::{ArmValue, Density, Level};
use super::partials::Partials;
use super::rest::{rest_by_chords, rest_through};
use crate::error::{Error, Result};
use crate::quadrature::{Limit, Rule};
use std::cell::Cell;

/// Parameters of an integral along a side.
pub(crate) struct ArmIntegral {
    level: Level,
    rule: Rule,
    /// requested relative accuracy of the integral
    tolerance: f64,
    /// depth up to which cells of width h are needed
    structured: f64,
    /// number of layers towards t = 0
    start_layers: usize,
    order: f64,
    /// 1 − 2ν, with all its digits
    decay: f64,
}

/// Number of standard deviations by which the rounding error may exceed its expectation.
const ROUNDING_SAFETY: f64 = 1.5;
/// Ratio of the lengths of consecutive cells towards t = 0.
const START_RATIO: f64 = 0.15;
/// Message: the integrand grows towards the breakpoint.
const GROWS: &str = "contributions still grow at the smallest distance from a breakpoint at which the function \
     can be evaluated";
/// Safety factor for the difference between the geometric and the chord-based remainder.
const BETWEEN: f64 = 4.0;
/// Relative uncertainty of a remainder that is sampled at a few points.
const UNSEEN: f64 = 0.1;
/// Smallest depth at which a tail is accepted: e^{-6} of the side.
const SETTLED: f64 = 6.0;
/// Width of a wide block, beyond all structure, and the number of cells in it.
const BLOCK: f64 = 42.0;
const BLOCK_CELLS: usize = 3;

/// Largest value of (1 − 2ν) T, T the depth of a side, for which the decay like e^{−(1−2ν)t} next to a jump is not
/// seen in values of ℓ.
const UNSEEN_DECAY: f64 = 1e-3;

/// Depth from which the tail formula is used: up to this depth, differences of values keep the digits that the
/// tolerance requires.
const TAIL_START: f64 = 450.0;

impl ArmIntegral {
    /// The parameters; `spread` is ln of the largest ratio of side lengths, `order` is ν and `decay` is 1 − 2ν.
    pub(crate) fn new(
        level: Level,
        tolerance: f64,
        spread: f64,
        order: f64,
        decay: f64,
    ) -> Result<Self> {
        // What lies below the last layer is about its width to the power 3 − 2ν, of which the rule finds all but a
        // thousandth.
        let below = (0.5 * (0.1 * tolerance).ln()).min(tolerance.ln() / (3.0 - 2.0 * order));
        let layers = (below / START_RATIO.ln()).ceil().max(2.0);
        Ok(Self {
            level,
            rule: Rule::gauss_legendre(level.points)?,
            tolerance,
            structured: 45.0 + spread,
            start_layers: layers as usize,
            order,
            decay,
        })
    }

    /// The integral; `scale` is the size of the other terms of the sum, `tail` the tail of the side if it
    /// is known, `samples` the values (t, ℓ) on all scales of the side if they are known, else empty.
    pub(crate) fn integrate(
        &self,
        depth: f64,
        scale: f64,
        tail: Option<&DeepTail>,
        samples: &[(f64, f64)],
        mut density: impl FnMut(f64) -> Result<Density>,
    ) -> Result<ArmValue> {
        let [rounding, last, settled] = [0.0, 0.0, 0.0].map(Cell::new);
        let limit =
            self.limit(depth, scale, tail, samples, [&rounding, &last, &settled], |t, weight| {
                let density = density(t)?;
                last.set(density.rounding);
                rounding.set((weight * density.rounding).hypot(rounding.get()));
                Ok(density.value)
            })?;
        let rounding = ROUNDING_SAFETY * rounding.get();
        Ok(ArmValue { limit, rounding, is_settled: settled.get() > 0.0 })
    }

    /// As [`ArmIntegral::integrate`], for a density that is passed its quadrature weight. The cells hold the
    /// rounding errors of the sum and of the last density, and whether the integrand decayed below rounding.
    fn limit(
        &self,
        depth: f64,
        scale: f64,
        tail: Option<&DeepTail>,
        samples: &[(f64, f64)],
        [rounding, of_last, settled]: [&Cell<f64>; 3],
        mut density: impl FnMut(f64, f64) -> Result<f64>,
    ) -> Result<Limit> {
        let h = self.level.width;
        let mut sum = self.start(&mut density)?;
        let mut found = Partials {
            ends: vec![h],
            partial: vec![sum],
            densities: vec![density(h, 0.0)?],
            roundings: vec![rounding.get()],
            gap: 2.0 * self.order,
        };
        let end = depth.min(self.structured);
        let (mut previous, mut rest_before) = (sum, f64::NAN);
        while found.end() + h <= end {
            let from = found.end();
            let cell = self.cell(&self.rule, from, h, &mut density)?;
            sum += cell;
            let last = density(from + h, 0.0)?;
            found.push(from + h, sum, last, rounding.get());
            let whole = sum.abs() + scale;
            // Nothing here may be nothing yet: a function may be constant over most of its arm, or so small
            // that its squares are zero.
            let ratio = (cell / previous).abs();
            let is_nothing =
                cell == 0.0 || ratio < 0.95 && cell.abs() / (1.0 - ratio) <= 1e-15 * whole;
            if from > SETTLED && sum != 0.0 && cell.abs() <= 1e-17 * whole && is_nothing {
                settled.set(1.0);
                return Ok(Limit { value: sum, error: 1e-17 * whole });
            }
            previous = cell;
            if end < self.structured
                && rounding.get() > (0.02 * self.tolerance * whole).max(0.03 * cell.abs())
            {
                // Deeper, a function of the rounded x has no digits left: go no further, extrapolate.
                break;
            }
            let rest = cell.abs() * ratio / (1.0 - ratio);
            let settles = |rest: f64| rest <= 0.02 * self.tolerance * whole;
            if from > SETTLED && ratio < 0.95 && settles(rest) {
                let end_of_cell = from + h;
                let chords = if samples.is_empty() {
                    rest_by_chords(end_of_cell, last, end, |t| {
                        Ok(Density { value: density(t, 0.0)?, rounding: of_last.get() })
                    })?
                } else {
                    rest_through(end_of_cell, last, samples)
                };
                let error = rest.max(chords - rest);
                if settles(error) {
                    settled.set(1.0);
                    // Where ln ℓ is convex, or concave, the rest lies between the two. A few chords may miss a layer.
                    let changed = (rest_before - cell.abs() - rest).abs();
                    let between = BETWEEN * (chords - rest).abs() + changed;
                    let error = match samples {
                        _ if between.is_nan() => error,
                        [] => between.max(UNSEEN * error).min(error),
                        _ => between,
                    };
                    return Ok(Limit { value: sum + rest.copysign(cell), error });
                }
            }
            rest_before = rest;
        }
        if let Some(tail) = tail
            && depth >= TAIL_START
        {
            return self.with_tail(tail, depth, scale, rounding, &mut found, &mut density);
        }
        if depth >= self.structured + 5.0 * BLOCK
            && let Some(limit) = self.deep(depth, scale, rounding, &mut found, &mut density)?
        {
            return Ok(limit);
        }
        self.decide(&found)
    }

    /// ∫₀^h ℓ dt with layers towards 0.
    fn start(&self, density: &mut impl FnMut(f64, f64) -> Result<f64>) -> Result<f64> {
        let mut right = self.level.width;
        let mut sum = 0.0;
        for _ in 0..self.start_layers {
            let left = right * START_RATIO;
            sum += self.cell(&self.rule, left, right - left, density)?;
            right = left;
        }
        Ok(sum + self.cell(&self.rule, 0.0, right, density)?)
    }

    fn cell(
        &self,
        rule: &Rule,
        from: f64,
        width: f64,
        density: &mut impl FnMut(f64, f64) -> Result<f64>,
    ) -> Result<f64> {
        let mut sum = 0.0;
        for (t, w) in rule.iter() {
            let weight = w * width;
            sum += weight * density(from + width * t, weight)?;
        }
        Ok(sum)
    }

    /// The width of a wide cell: a multiple of h, so that the rules have the same relative error in all wide
    /// cells.
    fn wide(&self) -> f64 {
        (BLOCK / BLOCK_CELLS as f64 / self.level.width).round() * self.level.width
    }

    /// The integral by wide cells up to the start of the tail, plus the tail.
    fn with_tail(
        &self,
        tail: &DeepTail,
        depth: f64,
        scale: f64,
        rounding: &Cell<f64>,
        found: &mut Partials,
        density: &mut impl FnMut(f64, f64) -> Result<f64>,
    ) -> Result<Limit> {
        let rule = Rule::gauss_legendre(self.level.points + 4)?;
        let width = self.wide();
        let start = if tail.start() > depth { depth } else { TAIL_START.max(tail.start() + width) };
        while found.end() + width <= start && !found.explodes() {
            let (from, before) = (found.end(), found.sum());
            let sum = before + self.cell(&rule, from, width, density)?;
            found.push(from + width, sum, density(from + width, 0.0)?, rounding.get());
        }
        if found.explodes() || found.has_growing_rate() || !tail.starts_at(found.end()) {
            return self.decide(found);
        }
        let rest = tail.integrate(found.end(), self.tolerance, found.sum().abs() + scale)?;
        rounding.set(rounding.get().hypot(rest.rounding));
        Ok(Limit { value: found.sum() + rest.limit.value, error: rest.limit.error })
    }

    /// The integral by wide cells, from the depth at which the integrand is smooth on the scale of t; `None` if
    /// its limit does not meet the tolerance.
    fn deep(
        &self,
        depth: f64,
        scale: f64,
        rounding: &Cell<f64>,
        found: &mut Partials,
        density: &mut impl FnMut(f64, f64) -> Result<f64>,
    ) -> Result<Option<Limit>> {
        let rule = Rule::gauss_legendre(self.level.points + 4)?;
        let width = self.wide();
        let mut cells = 0;
        while found.end() + width <= depth {
            let (from, before) = (found.end(), found.sum());
            let sum = before + self.cell(&rule, from, width, density)?;
            found.push(from + width, sum, density(from + width, 0.0)?, rounding.get());
            cells += 1;
            if found.explodes() {
                break;
            }
            if cells % BLOCK_CELLS == 0 && cells >= 5 * BLOCK_CELLS {
                if let Some(limit) = self.beside_a_jump(found) {
                    return Ok(Some(limit));
                }
                // An extrapolated divergent integral has a limit too, and it means nothing.
                if let Some(limit) = found.limit()
                    && !found.diverges()
                    && limit.error <= 0.05 * self.tolerance * (limit.value.abs() + scale)
                {
                    return Ok(Some(limit));
                }
            }
        }
        Ok(None)
    }

    /// True if the decay of a bounded function next to a breakpoint is not seen.
    fn is_slow(&self, found: &Partials) -> bool {
        self.decay > 0.0 && self.decay * found.end() < UNSEEN_DECAY
    }

    /// The limit next to a jump, where values of ℓ do not show its decay.
    fn beside_a_jump(&self, found: &Partials) -> Option<Limit> {
        if self.is_slow(found) { found.beside_a_jump(self.decay) } else { None }
    }

    /// The limit of the partial sums, or the reason why there is none.
    fn decide(&self, found: &Partials) -> Result<Limit> {
        if let Some(limit) = self.beside_a_jump(found) {
            return Ok(limit);
        }
        let is_slow = self.is_slow(found);
        // Where ℓ falls, or ℓ ~ t^p e^{−wt} has begun to decay, a law that grows is one of too few terms.
        let is_doubtful = found.comes_down() || found.has_growing_rate() && !found.still_grows();
        let is_open = is_slow && !found.explodes() || found.grows_slowly() || is_doubtful;
        if found.diverges() && !is_open {
            return Err(Error::InfiniteNorm {
                order: self.order,
                why: "the contributions near a breakpoint do not decay",
            });
        }
        if found.diverges() || found.still_grows() {
            // No more of it can be seen, and the largest part may lie beyond.
            return Err(Error::out_of_reach("integral", self.tolerance, f64::INFINITY, GROWS));
        }
        Ok(found.limit().unwrap_or(Limit { value: found.sum(), error: found.rest() }))
    }
}
