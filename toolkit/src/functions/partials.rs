//! Partial integrals along a side, and estimates of the remainder from them.

use super::two_rates::{Partial, TwoRates};
use crate::quadrature::{Limit, extrapolate};

/// Value of wT in t^p e^{-wt} from which the exponential is distinguished from corrections to the power, which
/// are about p/T.
const BEGUN: f64 = 1.0;

/// Share of the earlier rate of growth that is left where growth is exponential; 0.71 is left of that of a power.
const STEADY: f64 = 0.8;

/// Largest change of ln ℓ over half of a side that is rounding.
const FLAT: f64 = 1e-9;

/// The partial integrals ∫₀^{t_k} ℓ and the values ℓ(t_k).
pub(super) struct Partials {
    pub(super) ends: Vec<f64>,
    pub(super) partial: Vec<f64>,
    pub(super) densities: Vec<f64>,
    /// 2ν
    pub(super) gap: f64,
    /// rounding errors of the partial integrals, from the rounding of the function's values
    pub(super) roundings: Vec<f64>,
}

/// The increments of t, ln t and ln ℓ on a part of the side.
#[derive(Clone, Copy)]
struct Growth {
    length: f64,
    of_t: f64,
    of_density: f64,
}

impl Partials {
    pub(super) fn end(&self) -> f64 {
        self.ends[self.ends.len() - 1]
    }

    pub(super) fn sum(&self) -> f64 {
        self.partial[self.partial.len() - 1]
    }

    pub(super) fn push(&mut self, end: f64, sum: f64, density: f64, rounding: f64) {
        self.ends.push(end);
        self.partial.push(sum);
        self.densities.push(density);
        self.roundings.push(rounding);
    }

    /// Rounding error of the sum.
    fn rounding(&self) -> f64 {
        self.roundings[self.roundings.len() - 1]
    }

    /// A rough estimate of the integral beyond the last t_k.
    pub(super) fn rest(&self) -> f64 {
        self.densities[self.densities.len() - 1].abs() * self.end()
    }

    /// The increments from T/4 to T/2 and from T/2 to T; `None` if ℓ vanishes there or the two coincide.
    fn growth(&self) -> Option<[Growth; 2]> {
        self.growth_between([0.25, 0.5])
    }

    /// The increments between two shares of T, and from the second one to T.
    fn growth_between(&self, [start, middle]: [f64; 2]) -> Option<[Growth; 2]> {
        let at = |share: f64| self.ends.partition_point(|&t| t < share * self.end());
        let [first, middle, last] = [at(start), at(middle), self.ends.len() - 1];
        let step = |from: usize, to: usize| {
            let [start, end] = [self.ends[from], self.ends[to]];
            let of_density = (self.densities[to] / self.densities[from]).ln();
            let growth = Growth { length: end - start, of_t: (end / start).ln(), of_density };
            (from < to && of_density.is_finite()).then_some(growth)
        };
        Some([step(first, middle)?, step(middle, last)?])
    }

    /// True if ℓ grows exponentially: ln ℓ increases twice as much over twice the length, whereas it
    /// increases equally for a power, and not ever more slowly, as beyond a zero of ℓ.
    pub(super) fn explodes(&self) -> bool {
        let grows = |[before, after]: [Growth; 2]| {
            after.of_density > 4f64.ln() && after.of_density > 1.5 * before.of_density
        };
        let is_steady = |[before, after]: [Growth; 2]| {
            after.of_density / after.length > STEADY * before.of_density / before.length
        };
        !self.sum().is_finite()
            || self.growth().is_some_and(grows)
                && [[0.5, 0.75], [0.75, 0.875]]
                    .into_iter()
                    .all(|shares| self.growth_between(shares).is_some_and(is_steady))
    }

    /// The rate w of ℓ ~ t^p e^{-wt}, from growth = p of_t − w length on two intervals.
    fn final_rate(&self) -> Option<f64> {
        let [before, after] = self.growth()?;
        let determinant = before.of_t * after.length - after.of_t * before.length;
        Some((before.of_density * after.of_t - after.of_density * before.of_t) / determinant)
    }

    /// True if ℓ grows but will decay: its law contains a decaying exponential that has begun to act.
    pub(super) fn comes_down(&self) -> bool {
        self.sum().is_finite() && self.final_rate().is_some_and(|rate| rate * self.end() > BEGUN)
    }

    /// True if ℓ grows like a power of t, by more than rounding: t² e^{−wt}, as next to x^a ln x, grows until t = 2/w, and
    /// does not show whether w > 0 before.
    pub(super) fn grows_slowly(&self) -> bool {
        !self.explodes() && self.growth().is_some_and(|[_, after]| after.of_density > FLAT)
    }

    /// True if ℓ is not smaller at the end than in the middle.
    pub(super) fn still_grows(&self) -> bool {
        self.growth().is_some_and(|[_, after]| after.of_density >= -FLAT)
    }

    /// The asymptotic law with two rates, if it holds.
    fn two_rates(&self) -> Option<TwoRates> {
        let of = |k: usize| {
            let (end, sum, rounding) = (self.ends[k], self.partial[k], self.roundings[k]);
            Partial { end, sum, rounding }
        };
        let partials: Vec<Partial> = (0..self.ends.len()).map(of).collect();
        TwoRates::of(&partials, self.gap)
    }

    /// True if the asymptotic law has two rates and grows: a power of the distance, not of its logarithm.
    pub(super) fn has_growing_rate(&self) -> bool {
        self.two_rates().is_some_and(|found| !found.decays())
    }

    /// True if ℓ does not decay faster than 1/t.
    pub(super) fn diverges(&self) -> bool {
        if let Some(found) = self.two_rates() {
            return !found.decays();
        }
        let (ends, densities) = (&self.ends, &self.densities);
        let last = ends.len() - 1;
        let middle = ends.iter().position(|&t| t >= 0.5 * self.end()).unwrap_or(0);
        if middle == 0 || middle == last || densities[last] <= 0.0 {
            return false;
        }
        let slope = |k: usize| (densities[k - 1] / densities[k]).ln() / (ends[k] - ends[k - 1]);
        // p of ℓ ~ t^{-p}; an exponential would double it from the middle to the end.
        let (at_middle, at_end) = (slope(middle) * ends[middle], slope(last) * ends[last]);
        let algebraic = (at_end - at_middle).abs() < 0.05 * at_end.abs() && at_end <= 1.001;
        algebraic || self.explodes() || self.still_grows() && !self.comes_down()
    }

    /// The limit for ℓ = C e^{−pt} (1 + O(e^{−t})), p = `decay` so small that ℓ changes by less than its rounding: next
    /// to a jump the integral beyond T is ℓ(T)/p. `None` if ℓ e^{pt} is not constant on the last fifth of the
    /// side; a power t^a with an exponent that cannot be told from 0 there is part of the error.
    pub(super) fn beside_a_jump(&self, decay: f64) -> Option<Limit> {
        const CONSTANT: f64 = 1e-10;
        let (from, last) =
            (self.ends.partition_point(|&t| t < 0.8 * self.end()), self.ends.len() - 1);
        let [start, end] = [self.ends[from], self.ends[last]];
        let growth = (self.densities[last] / self.densities[from]).ln() + decay * (end - start);
        let off = growth.abs() + 8.0 * f64::EPSILON;
        let rest = self.densities[last] / decay;
        let powers = 1.0 + (1.0 / (decay * end)).ln().max(0.0) / (end / start).ln();
        let is_constant = from < last && off < CONSTANT && rest.is_finite();
        is_constant.then(|| Limit {
            value: self.sum() + rest,
            error: off * powers * rest.abs() + self.rounding(),
        })
    }

    pub(super) fn limit(&self) -> Option<Limit> {
        // On the first cells the integrand still feels the whole interval.
        let from = self.ends.iter().position(|&t| t >= (0.5 * self.end()).min(25.0)).unwrap_or(0);
        let noise = (4.0 * f64::EPSILON * self.sum()).hypot(self.rounding());
        let general =
            extrapolate(&self.ends[from..], &self.partial[from..], &self.densities[from..], noise);
        let law = self.two_rates().and_then(|found| found.limit(self.sum()));
        general.into_iter().chain(law).min_by(|a, b| a.error.total_cmp(&b.error))
    }
}
