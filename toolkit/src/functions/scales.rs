//! Samples of a function on all scales: one value per unit of t = ln(R/δ) along every side, down to the
//! smallest distance at which it can be evaluated.
//!
//! They give a rough profile of the integrand along a side: for |u|²_ν
//!
//! e(t) = δ^{1−2ν} max_s e^{−2νs} |u(t−s) − u(t−s−1)|²,
//!
//! and for ∫ |u|^q it is δ |u|^q. Powers and logarithms of δ, and functions that the rules in t resolve cell
//! by cell, have profiles without a local minimum that are smooth in t far from the midpoint. Where a profile
//! rises again after a decay below rounding, as for x + exp(−x/w), or bends sharply at a large depth, as for
//! exp(−x/w), the rules might stop too early or use too wide cells: such functions are computed by
//! `crate::resolved` and [`super::by_scales`].

use super::arm::Arm;
use super::function::SingularFunction;
use super::look::{LOOKS, distance};
use crate::kernel::power::PowerKernel;
use crate::numeric::scale::power_of_two;

/// End of the first cells, which every rule resolves.
const BEGUN: f64 = 3.0;
/// ln of the factor by which a profile increases after a significant local minimum.
const RISE: f64 = 2.0;
/// Depth from which the cells of a rule may be wide, and the second difference of ln e for which they are too
/// wide.
const FAR: f64 = 35.0;
const BEND: f64 = 0.3;
/// Share of the tolerance above which a contribution is significant.
const COUNTS: f64 = 0.01;
/// ln of a size up to which no rescaling is needed.
const MODERATE: f64 = 7.0;
/// ln of the factor by which a convergent profile decreases over half of a side.
const FADES: f64 = 3.0;
/// Differences of this many ulps count as rounding.
const ULPS: f64 = 16.0 * f64::EPSILON;
/// Ratio of neighbouring intervals from which the shorter one is treated as a layer.
const UNEQUAL: f64 = 1e8;

/// Values of u at t = 1/2, 3/2, ... along every side, and at equal distances ([`super::look`]).
pub(super) struct Profile {
    arms: Vec<Arm>,
    values: Vec<Vec<f64>>,
    evenly: Vec<Vec<f64>>,
}

/// ln of a profile along every side, and of its sum, which includes what only the samples at equal distances meet.
pub(super) struct Logs {
    arms: Vec<Vec<f64>>,
    pub(super) whole: f64,
}

/// t of sample k.
fn place(k: usize) -> f64 {
    k as f64 + 0.5
}

impl Profile {
    /// The samples of u until a value is not a number.
    pub(super) fn of(u: &SingularFunction) -> Self {
        let (arms, values) = (u.arms(), u.scales());
        let evenly = (0..arms.len()).map(|k| u.samples_of(k).to_vec()).collect();
        Self { arms, values, evenly }
    }

    /// (δ, u) of the samples of a side, from its far end on.
    pub(super) fn samples(&self, arm: usize) -> impl Iterator<Item = (f64, f64)> {
        let place_of = move |k: usize| self.arms[arm].delta(place(k));
        self.values[arm].iter().enumerate().map(move |(k, &value)| (place_of(k), value))
    }

    /// True if all values are equal to rounding.
    pub(super) fn is_constant(&self) -> bool {
        let all = || self.values.iter().chain(&self.evenly).flatten();
        let (low, high) = all()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
        high - low <= 4.0 * ULPS * high.abs().max(low.abs())
    }

    /// True if some interval is much longer than a neighbour.
    pub(super) fn is_unequal(&self) -> bool {
        let quotient =
            |pair: &[Arm]| (pair[0].length / pair[1].length).max(pair[1].length / pair[0].length);
        self.arms.windows(2).any(|pair| quotient(pair) > UNEQUAL)
    }

    /// ln e.
    pub(super) fn energies(&self, kernel: PowerKernel) -> Logs {
        let fade = (-0.5 * kernel.twice).exp();
        let mut logs = Vec::with_capacity(self.arms.len());
        for (arm, values) in self.arms.iter().zip(&self.values) {
            // The other arm of the same break.
            let other = self.arms.iter().position(|b| b.anchor == arm.anchor && b.sign != arm.sign);
            let across = |k: usize| {
                let other = other?;
                let shift = (self.arms[other].length / arm.length).ln();
                let at = (place(k) + shift - 0.5).round();
                (at >= 0.0).then(|| self.values[other].get(at as usize).copied())?
            };
            let mut seen = 0.0_f64;
            let log = |(k, &value): (usize, &f64)| {
                let differs = |other: f64| {
                    let (apart, size) = ((value - other).abs(), value.abs().max(other.abs()));
                    if apart <= ULPS * size { 0.0 } else { apart }
                };
                let before = if k > 0 { differs(values[k - 1]) } else { 0.0 };
                seen = (fade * seen).max(before);
                let largest = across(k).map_or(seen, |other| seen.max(differs(other)));
                kernel.one_minus * (arm.length.ln() - place(k)) + 2.0 * largest.ln()
            };
            logs.push(values.iter().enumerate().map(log).collect());
        }
        let step = |arm: &Arm| kernel.scaling(arm.length / LOOKS as f64);
        let differences = |(arm, values): (&Arm, &Vec<f64>)| {
            step(arm) * values.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum::<f64>()
        };
        let evenly: f64 = self.arms.iter().zip(&self.evenly).map(differences).sum();
        Logs { whole: log_sum(&logs).max(evenly.ln()), arms: logs }
    }

    /// A power of two near the largest δ^{1/q} |u|; 1 where that is not far from 1.
    pub(super) fn unit_in_lq(&self, q: f64) -> f64 {
        let logs = self.densities(q);
        let evenly = |(arm, values): (&Arm, &Vec<f64>)| {
            // Towards the breakpoint δ decreases, so that only larger values count.
            let (mut largest, mut log) = (0.0_f64, f64::NEG_INFINITY);
            for (j, value) in values.iter().enumerate().rev() {
                if value.abs() > largest {
                    largest = value.abs();
                    log = log.max(distance(arm, j).ln() + q * largest.ln());
                }
            }
            log
        };
        let evenly = self.arms.iter().zip(&self.evenly).map(evenly);
        let largest =
            logs.arms.into_iter().flatten().chain(evenly).fold(f64::NEG_INFINITY, f64::max) / q;
        if largest.is_finite() && largest.abs() > MODERATE {
            power_of_two(largest.exp())
        } else {
            1.0
        }
    }

    /// ln of δ |u|^q.
    pub(super) fn densities(&self, q: f64) -> Logs {
        let of = |(arm, values): (&Arm, &Vec<f64>)| {
            let log = |(k, value): (usize, &f64)| arm.length.ln() - place(k) + q * value.abs().ln();
            values.iter().enumerate().map(log).collect()
        };
        let logs: Vec<Vec<f64>> = self.arms.iter().zip(&self.values).map(of).collect();
        let sum = |(arm, values): (&Arm, &Vec<f64>)| {
            arm.length / LOOKS as f64 * values.iter().map(|value| power(*value, q)).sum::<f64>()
        };
        let evenly: f64 = self.arms.iter().zip(&self.evenly).map(sum).sum();
        Logs { whole: log_sum(&logs).max(evenly.ln()), arms: logs }
    }
}

/// |u|^q; for general q this costs as much as all other work on a value.
pub(super) fn power(u: f64, q: f64) -> f64 {
    match q {
        1.0 => u.abs(),
        2.0 => u * u,
        3.0 => (u * u * u).abs(),
        4.0 => (u * u) * (u * u),
        _ => u.abs().powf(q),
    }
}

/// ln of the sum of a profile.
fn log_sum(logs: &[Vec<f64>]) -> f64 {
    let all = || logs.iter().flatten().copied().filter(|log| !log.is_nan());
    let largest = all().fold(f64::NEG_INFINITY, f64::max);
    if largest.is_finite() {
        largest + all().map(|log| (log - largest).exp()).sum::<f64>().ln()
    } else {
        largest
    }
}

/// True if a contribution significant at this tolerance lies behind a local minimum, or the profile bends
/// sharply at a large depth.
pub(super) fn is_deep(logs: &Logs, tolerance: f64) -> bool {
    let whole = logs.whole;
    let (counts, nothing) = (whole + (COUNTS * tolerance).ln(), whole + tolerance.ln());
    logs.arms.iter().any(|arm| {
        let mut lowest = f64::INFINITY;
        (0..arm.len()).any(|k| {
            let here = arm[k];
            let rises = here > counts && lowest < nothing && here > lowest + RISE;
            let bends = place(k) > FAR && here > counts && k + 1 < arm.len() && {
                let bend = arm[k - 1] - 2.0 * here + arm[k + 1];
                bend.is_finite() && bend.abs() > BEND
            };
            if place(k) > BEGUN {
                lowest = lowest.min(here);
            }
            rises || bends
        })
    })
}

/// Share of the whole in what lies behind a local minimum and does not count for [`is_deep`].
pub(super) fn hidden(logs: &Logs, tolerance: f64) -> f64 {
    let whole = logs.whole;
    let (counts, nothing) = (whole + (COUNTS * tolerance).ln(), whole + tolerance.ln());
    let behind = |arm: &Vec<f64>| {
        let (mut lowest, mut sum) = (f64::INFINITY, 0.0);
        for (k, &here) in arm.iter().enumerate() {
            if here <= counts && lowest < nothing && here > lowest + RISE {
                sum += (here - whole).exp();
            }
            if place(k) > BEGUN {
                lowest = lowest.min(here);
            }
        }
        sum
    };
    logs.arms.iter().map(behind).sum()
}

/// True if significant contributions extend to the smallest distance without decreasing over half of the
/// side.
pub(super) fn is_endless(logs: &Logs, tolerance: f64) -> bool {
    let counts = logs.whole + (COUNTS * tolerance).ln();
    logs.arms.iter().any(|arm| match arm.last() {
        Some(&last) => last > counts && last > arm[arm.len() / 2] - FADES,
        None => false,
    })
}
