//! What was seen of a function: all norms of it read the same samples.
//!
//! A rule along a side asks for u at about 10⁵ distances, which differ from one order to the next. u is therefore
//! taken once on every octave R/2^{k+1} < δ < R/2^k of a side, when a rule first asks for it there: by a Chebyshev
//! polynomial in
//!
//! ```text
//! y = 2 log₂(2^{k+1} δ/R) − 1,    −1 ≤ y ≤ 1,
//! ```
//!
//! through 16 points, or 32. Powers of δ are e^{cy} and powers of logarithms (c + y)^α, of which the coefficients fall below
//! rounding after ten. The polynomial is used if its last coefficients are rounding, if it agrees with u at two other points
//! and at all samples of equal distance in the octave ([`super::look`]), and if u does not vary so much that the rounding of
//! y would count; otherwise u itself is evaluated. Below the smallest distance, where u is a function of t = ln(R/δ)
//! ([`super::deep_tail`]), the same is done on the octaves 2^k < t < 2^{k+1}.
//!
//! Two points of one octave have values of one polynomial: their difference has smaller rounding errors than that of two
//! values of u.

use super::arm::Arm;
use super::function::SingularFunction;
use crate::error::Result;
use std::f64::consts::{LOG2_E, PI};
use std::sync::OnceLock;

/// Numbers of points, until one is enough.
const POINTS: [usize; 2] = [16, 32];
/// Other points at which u and the polynomial are compared.
const BETWEEN: [f64; 2] = [-0.7431, 0.3217];
/// Number of last coefficients that must be rounding.
const LAST: usize = 3;
/// Rounding of a coefficient, and of a value at other points, relative to the largest value.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
const AGREES: f64 = 8.0;
/// Coefficients that are cut off, relative to the largest value.
const NOTHING: f64 = 0.5 * f64::EPSILON;
/// Largest Σ k |c_k|, relative to the largest value: x^10 on an octave.
const STEEP: f64 = 4.0;
/// Number of octaves of t.
const DEEPEST: usize = 1024;

/// The samples of a function, in the units of [`super::function::Normalized`].
#[derive(Debug, Default)]
pub(super) struct Seen {
    /// the unit of the values, and the values at equal distances on every side
    pub(super) first: OnceLock<(f64, Vec<Vec<f64>>)>,
    /// the values on all scales of every side, at t = 1/2, 3/2, ..., and at δ = 3/4 R/2^k, k = 0, 1, ...
    pub(super) scales: OnceLock<Vec<Vec<f64>>>,
    pub(super) middles: OnceLock<Vec<Vec<f64>>>,
    /// the octaves of δ and those of t, of every side
    sides: OnceLock<Vec<[Octaves; 2]>>,
}

/// Polynomials on octaves; `None` where u itself is evaluated.
type Octaves = Vec<OnceLock<Option<Box<[f64]>>>>;

/// A point by its octave and its place in it, 0 at the smaller end, 1 at the larger one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    octave: usize,
    place: f64,
}

impl Spot {
    /// The place of a number in (2^e, 2^{e+1}), and e.
    fn of(x: f64) -> (i32, f64) {
        let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023;
        let mantissa = f64::from_bits((x.to_bits() & ((1 << 52) - 1)) | (1023 << 52));
        (exponent, mantissa.log2())
    }

    /// Of the share δ/R of a side.
    fn of_share(share: f64) -> Option<Self> {
        if !(f64::MIN_POSITIVE..=1.0).contains(&share) {
            return None;
        }
        if share == 1.0 {
            return Some(Self { octave: 0, place: 1.0 });
        }
        let (exponent, place) = Self::of(share);
        Some(Self { octave: (-exponent - 1) as usize, place })
    }

    /// The point at e^s times the distance.
    pub(super) fn farther(self, s: f64) -> Option<Self> {
        let place = self.place + s * LOG2_E;
        let octaves = place.floor();
        let octave = self.octave.checked_sub(octaves as usize)?;
        Some(Self { octave, place: place - octaves })
    }
}

/// Σ c_k T_k(y), by Clenshaw's recurrence.
fn value_of(coefficients: &[f64], y: f64) -> f64 {
    let (mut next, mut after) = (0.0, 0.0);
    for c in coefficients[1..].iter().rev() {
        (next, after) = (2.0 * y * next - after + c, next);
    }
    y * next - after + coefficients[0]
}

/// cos(πm/2n) for m < 4n, of which the roots of T_n and the values of all T_k there consist, k < n.
fn cosines(n: usize) -> &'static [f64] {
    static OF: [OnceLock<Vec<f64>>; POINTS.len()] = [const { OnceLock::new() }; POINTS.len()];
    let make = || (0..4 * n).map(|m| (PI * m as f64 / (2 * n) as f64).cos()).collect();
    OF[POINTS.iter().position(|&points| points == n).unwrap_or(0)].get_or_init(make)
}

/// The coefficients of the Chebyshev polynomial through values at the roots of T_n.
fn coefficients_of(values: &[f64], cosines: &[f64]) -> Vec<f64> {
    let n = values.len();
    // Differences from one of them are smaller, and so is their rounding.
    let middle = values[n / 2];
    let of = |k: usize| {
        let term = |(j, v): (usize, &f64)| (v - middle) * cosines[k * (2 * j + 1) % (4 * n)];
        let sum = values.iter().enumerate().map(term).sum::<f64>() / n as f64;
        if k == 0 { middle + sum } else { 2.0 * sum }
    };
    (0..n).map(of).collect()
}

/// The polynomial of a function of the place in an octave, if it agrees with it; `blur` is the relative rounding error of
/// the argument, `seen` are the places and values of other samples.
fn polynomial(
    u: impl Fn(f64) -> Result<f64>,
    blur: f64,
    seen: &[(f64, f64)],
) -> Option<Box<[f64]>> {
    for n in POINTS {
        let cosines = cosines(n);
        let place = |j: usize| 0.5 + 0.5 * cosines[2 * j + 1];
        let values = (0..n).map(|j| u(place(j)).ok()).collect::<Option<Vec<f64>>>()?;
        let (low, high) = values
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)));
        let largest = high.abs().max(low.abs());
        // Constants keep differences that are exactly zero.
        let mut found = if low == high { vec![low] } else { coefficients_of(&values, cosines) };
        let rounding = ROUNDING * largest + 4.0 * (high - low) * blur;
        let is_small = |c: &f64| c.abs() <= rounding;
        if found.len() > LAST && !found[n - LAST..].iter().all(is_small) {
            continue;
        }
        let steep: f64 = found.iter().enumerate().map(|(k, c)| k as f64 * c.abs()).sum();
        if steep > STEEP * largest {
            return None;
        }
        let nothing = (NOTHING * largest).max(0.1 * (rounding - ROUNDING * largest));
        while found.len() > 1 && found.last().is_some_and(|c| c.abs() <= nothing) {
            found.pop();
        }
        // The place of a point is rounded, too.
        let slack = AGREES * rounding + 2.0 * ROUNDING * steep;
        let agrees =
            |place: f64, value: f64| (value - value_of(&found, 2.0 * place - 1.0)).abs() <= slack;
        let is_confirmed = BETWEEN.iter().all(|&y| {
            let place = 0.5 + 0.5 * y;
            u(place).is_ok_and(|value| agrees(place, value))
        });
        if is_confirmed && seen.iter().all(|&(place, value)| agrees(place, value)) {
            return Some(found.into_boxed_slice());
        }
        return None;
    }
    None
}

impl SingularFunction<'_> {
    /// The place of a point of a side in its octave.
    pub(super) fn spot(&self, arm: &Arm, delta: f64) -> Option<Spot> {
        if self.is_normalized() { Spot::of_share(delta / arm.length) } else { None }
    }

    /// The value there by the polynomial of its octave, if there is one.
    pub(super) fn at_spot(&self, arm: &Arm, spot: Spot) -> Option<f64> {
        let [octaves, _] = self.octaves(arm)?;
        let found = octaves.get(spot.octave)?.get_or_init(|| self.octave(arm, spot.octave));
        found.as_ref().map(|found| value_of(found, 2.0 * spot.place - 1.0))
    }

    /// The value at depth t by the polynomial of its octave, if there is one.
    pub(super) fn at_deep(&self, arm: &Arm, t: f64) -> Option<f64> {
        if !self.is_normalized() || !(1.0..f64::MAX).contains(&t) {
            return None;
        }
        let [_, octaves] = self.octaves(arm)?;
        let (octave, place) = Spot::of(t);
        let depth = |place: f64| libm::ldexp(place.exp2(), octave);
        let fill = || polynomial(|place| self.deep(arm, depth(place)), 0.0, &[]);
        let found = octaves.get(octave as usize)?.get_or_init(fill);
        found.as_ref().map(|found| value_of(found, 2.0 * place - 1.0))
    }

    fn octaves(&self, arm: &Arm) -> Option<&[Octaves; 2]> {
        let empty = |count: usize| (0..count).map(|_| OnceLock::new()).collect();
        let make = || {
            let of_side = |arm: Arm| {
                let deep = if self.is_known_at_any_depth() { DEEPEST } else { 0 };
                [empty((arm.depth * LOG2_E) as usize), empty(deep)]
            };
            self.arms().into_iter().map(of_side).collect()
        };
        self.seen().sides.get_or_init(make).get(arm.index())
    }

    fn octave(&self, arm: &Arm, octave: usize) -> Option<Box<[f64]>> {
        let near = arm.length * libm::ldexp(1.0, -(octave as i32) - 1);
        let seen: Vec<(f64, f64)> = self
            .seen_within(arm, near, 2.0 * near)
            .map(|(delta, value)| ((delta / near).log2(), value))
            .collect();
        polynomial(|place| self.direct(arm, near * place.exp2()), arm.blur / near, &seen)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_octaves_are_those_of_the_function_to_rounding() {
        let of_power = |a: f64| {
            let u = SingularFunction::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
                0 => at.offset().powf(a),
                _ => (a * at.offset().ln_1p()).exp(),
            });
            u.unwrap()
        };
        for a in [-0.4, 0.1, 0.5, 2.0, 7.3] {
            let u = of_power(a);
            let normal = u.normalized(crate::Tolerance::balanced()).unwrap().u;
            for arm in normal.arms() {
                let mut found = 0;
                for k in 0..400 {
                    let delta = arm.delta(0.173 * f64::from(k));
                    let exact = normal.direct(&arm, delta).unwrap();
                    let Some(spot) = normal.spot(&arm, delta) else { continue };
                    let Some(value) = normal.at_spot(&arm, spot) else { continue };
                    // relative to the largest value in the octave
                    let largest = exact.abs() * 2f64.powf(a.abs());
                    assert!((value - exact).abs() <= 24.0 * f64::EPSILON * largest, "{a} {delta}");
                    found += 1;
                    let farther = spot.farther(0.4).filter(|_| delta < 0.5 * arm.length);
                    if let Some(value) = farther.and_then(|spot| normal.at_spot(&arm, spot)) {
                        let exact = normal.direct(&arm, delta * 0.4f64.exp()).unwrap();
                        let largest = exact.abs() * 2f64.powf(a.abs());
                        assert!((value - exact).abs() <= 32.0 * f64::EPSILON * largest);
                    }
                }
                assert_eq!(found, 400, "{a}");
            }
        }
    }

    #[test]
    fn kinks_layers_and_noise_are_evaluated() {
        let refused = |f: fn(f64) -> f64| polynomial(|place| Ok(f(place)), 0.0, &[]).is_none();
        assert!(refused(|t| (t - 0.4).abs()) && refused(|t| (-100.0 * t).exp()));
        assert!(refused(|t| t + 1e-12 * (1e6 * t).sin()) && !refused(f64::sin));
        // a bell between the points, at one of the other samples
        let none = polynomial(|_| Ok(1.0), 0.0, &[(0.123, 1.5)]);
        assert!(none.is_none());
    }
}
