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
//! through 14, 20 or 32 points, written in powers of y. Powers of δ are e^{cy} and powers of logarithms (c + y)^α, of which
//! the coefficients fall below rounding after ten. The polynomial is used if its last coefficients are rounding, if it
//! agrees with u at 24 other points (at two in the deepest octaves) and at all samples of equal distance in the octave
//! ([`super::look`]), and if u does not vary so much that the rounding of y would count; otherwise u itself is evaluated. Below the smallest distance, where u is a function of t = ln(R/δ)
//! ([`super::deep_tail`]), the same is done on the octaves 2^k < t < 2^{k+1}.
//!
//! Two points of one octave have values of one polynomial p, and (p(x) − p(y))/(x − y) is a polynomial, too: it keeps its
//! digits as x → y. If the values of p are right to ε, it is right to the largest derivative of a polynomial of degree n < 32
//! of size ε, which is at most
//!
//! ```text
//! ε min(n², n/√(1 − y²)),
//! ```
//!
//! by Markov and Bernstein. At orders near 1 nearly all of |u|²_ν comes from points whose distance is far below that at which
//! the difference of two values has digits.

use super::arm::Arm;
use super::function::SingularFunction;
use super::supremum::Peak;
use crate::error::Result;
use std::cell::Cell;
use std::f64::consts::{LOG2_E, PI};
use std::sync::OnceLock;

/// Numbers of points, until one is enough.
const COUNTS: [usize; 3] = [14, 20, 32];
/// Number of other points at which u and the polynomial are compared: one of [`FEW`] in octaves deeper than [`DEEP`], where
/// nothing else looks for structure either.
const BETWEEN: usize = 24;
const FEW: usize = 12;
const DEEP: usize = 64;
/// Position of the other points in their shares of the octave.
const WITHIN: f64 = 0.4178;
/// Number of last coefficients that must be rounding.
const LAST: usize = 3;
/// Rounding of a coefficient, and of a value at other points, relative to the largest value.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
const AGREES: f64 = 8.0;
/// Coefficients that are cut off, relative to the largest value.
const NOTHING: f64 = 0.5 * f64::EPSILON;
/// Largest Σ k |c_k|, relative to the largest value: x^10 on an octave.
const STEEP: f64 = 4.0;
/// Largest Σ |a_k|, relative to the largest value: above it powers of y would cancel.
const CANCELS: f64 = 8.0;
/// How far beyond y = 1 polynomials are used: 1/32².
const SAME: f64 = 1.0 / 1024.0;
/// Number of octaves of t.
const DEEPEST: usize = 1024;

/// What is seen of a function first: its size, its values at equal distances on every side over that size, and the
/// largest t of every side at which values do not overflow.
#[derive(Debug)]
pub(super) struct First {
    pub(super) size: f64,
    pub(super) samples: Vec<Vec<f64>>,
    pub(super) limits: Vec<f64>,
}

/// The samples of a function, in the units of [`super::function::Normalized`].
#[derive(Debug, Default)]
pub(super) struct Seen {
    /// the unit of the values, and the values at equal distances on every side
    pub(super) first: OnceLock<First>,
    /// the values on all scales of every side, at t = 1/2, 3/2, ..., and at δ = 3/4 R/2^k, k = 0, 1, ...
    pub(super) scales: OnceLock<Vec<Vec<f64>>>,
    pub(super) middles: OnceLock<Vec<Vec<f64>>>,
    /// the largest value, and the number of values that it took
    pub(super) peak: OnceLock<(Peak, u64)>,
    /// the octaves of δ and those of t, of every side
    sides: OnceLock<Vec<[Octaves; 2]>>,
}

/// Polynomials on octaves; `None` where u itself is evaluated.
type Octaves = Vec<OnceLock<Option<Box<[f64]>>>>;

/// A point by its octave and y there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    octave: usize,
    y: f64,
}

/// The slope of the polynomial of an octave in s = ln δ, and what it is at most for a polynomial of size 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slope {
    pub(super) value: f64,
    pub(super) steep: f64,
}

/// ln 2 in two parts, of which the first one times an integer below 2^20 is exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

impl Spot {
    /// y of a number in (2^e, 2^{e+1}), and e.
    fn of(x: f64) -> (i32, f64) {
        let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023;
        let mantissa = f64::from_bits((x.to_bits() & ((1 << 52) - 1)) | (1023 << 52));
        (exponent, 2.0 * mantissa.log2() - 1.0)
    }

    /// Of the share δ/R of a side.
    fn of_share(share: f64) -> Option<Self> {
        if !(f64::MIN_POSITIVE..=1.0).contains(&share) {
            return None;
        }
        if share == 1.0 {
            return Some(Self { octave: 0, y: 1.0 });
        }
        let (exponent, y) = Self::of(share);
        Some(Self { octave: (-exponent - 1) as usize, y })
    }

    /// Of the share e^{−t}, with all digits of t.
    fn of_depth(t: f64) -> Self {
        let octave = (t * LOG2_E).floor();
        let rest = (t - octave * LN_2[0]) - octave * LN_2[1];
        Self { octave: octave as usize, y: 1.0 - 2.0 * LOG2_E * rest }
    }

    /// y of the point at e^s times the distance, if it lies in the same octave or so little beyond it that the polynomial
    /// is no less accurate: on (1, 1 + 1/n²) a polynomial of degree n is at most 2.2 times as large as in (−1, 1).
    fn beyond(self, s: f64) -> Option<f64> {
        let y = self.y + 2.0 * LOG2_E * s;
        (y <= 1.0 + SAME).then_some(y)
    }

    /// The point at e^s times the distance.
    pub(super) fn farther(self, s: f64) -> Option<Self> {
        let y = self.y + 2.0 * LOG2_E * s;
        let octaves = (0.5 * (y + 1.0)).floor();
        let octave = self.octave.checked_sub(octaves as usize)?;
        Some(Self { octave, y: y - 2.0 * octaves })
    }
}

/// Σ a_k y^k, of an even number of terms: even and odd powers apart, for half of the time.
fn value_of(powers: &[f64], y: f64) -> f64 {
    let square = y * y;
    let (mut even, mut odd) = (0.0, 0.0);
    for pair in powers.rchunks_exact(2) {
        even = even * square + pair[0];
        odd = odd * square + pair[1];
    }
    even + y * odd
}

/// (p(x) − p(y))/(x − y) of p = Σ a_k y^k: Horner's scheme for p(y), whose quotients are evaluated at x.
fn divided_difference(powers: &[f64], x: f64, y: f64) -> f64 {
    let (mut value, mut quotient) = (0.0, 0.0);
    for a in powers.iter().rev() {
        quotient = quotient * x + value;
        value = value * y + a;
    }
    quotient
}

/// The coefficients of y^k of Σ c_k T_k(y), an even number of them.
fn powers_of(chebyshev: &[f64]) -> Vec<f64> {
    let mut powers = vec![0.0; chebyshev.len().next_multiple_of(2)];
    let (mut before, mut current) = (vec![0.0; powers.len()], vec![0.0; powers.len()]);
    // T_{-1} = T_1 = y
    current[0] = 1.0;
    before[1] = 1.0;
    for (k, c) in chebyshev.iter().enumerate() {
        for (power, t) in powers.iter_mut().zip(&current) {
            *power += c * t;
        }
        // T_{k+1} = 2y T_k − T_{k−1}
        for j in (0..=(k + 1).min(powers.len() - 1)).rev() {
            before[j] = if j > 0 { 2.0 * current[j - 1] } else { 0.0 } - before[j];
        }
        std::mem::swap(&mut before, &mut current);
    }
    powers
}

/// The points of one polynomial.
struct Points {
    /// 2^{(y+1)/2}, the distance in units of the smallest one of the octave
    factors: Vec<f64>,
    /// T_k(y_j), by rows of k
    chebyshev: Vec<f64>,
}

impl Points {
    /// The roots of T_n.
    fn new(n: usize) -> Self {
        let cosine = |m: usize| (PI * (m % (4 * n)) as f64 / (2 * n) as f64).cos();
        Self {
            factors: (0..n).map(|j| factor(cosine(2 * j + 1))).collect(),
            chebyshev: (0..n * n).map(|kj| cosine(kj / n * (2 * (kj % n) + 1))).collect(),
        }
    }

    /// The coefficients of the Chebyshev polynomial through values.
    fn coefficients(&self, values: &[f64]) -> Vec<f64> {
        let n = values.len();
        // Differences from one of them are smaller, and so is their rounding.
        let middle = values[n / 2];
        let apart: Vec<f64> = values.iter().map(|value| value - middle).collect();
        let of = |(k, row): (usize, &[f64])| {
            let sum = row.iter().zip(&apart).map(|(t, v)| t * v).sum::<f64>() / n as f64;
            if k == 0 { middle + sum } else { 2.0 * sum }
        };
        self.chebyshev.chunks_exact(n).enumerate().map(of).collect()
    }
}

fn factor(y: f64) -> f64 {
    (0.5 * y + 0.5).exp2()
}

/// The points of all polynomials.
fn all_points() -> &'static [Points; COUNTS.len()] {
    static OF: OnceLock<[Points; COUNTS.len()]> = OnceLock::new();
    OF.get_or_init(|| COUNTS.map(Points::new))
}

/// y and the factors of the other points.
fn other_points() -> &'static [(f64, f64)] {
    static OF: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    let y = |j: usize| 2.0 * (j as f64 + WITHIN) / BETWEEN as f64 - 1.0;
    OF.get_or_init(|| (0..BETWEEN).map(|j| (y(j), factor(y(j)))).collect())
}

/// The powers of y of a function of 2^{(y+1)/2}, if a polynomial agrees with it; `blur` is the relative rounding error of
/// the argument, `seen` are y and values of other samples, and `step` is 1 for all other points.
fn polynomial(
    u: impl Fn(f64) -> Result<f64>,
    blur: f64,
    seen: &[(f64, f64)],
    step: usize,
) -> Option<Box<[f64]>> {
    for points in all_points() {
        let n = points.factors.len();
        let values = points.factors.iter().map(|&x| u(x).ok()).collect::<Option<Vec<f64>>>()?;
        let (low, high) = values
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)));
        let largest = high.abs().max(low.abs());
        // Constants keep differences that are exactly zero.
        let mut found = if low == high { vec![low] } else { points.coefficients(&values) };
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
        let powers = powers_of(&found);
        if powers.iter().map(|power| power.abs()).sum::<f64>() > CANCELS * largest {
            return None;
        }
        // y is rounded, too.
        let slack = AGREES * rounding + 2.0 * ROUNDING * steep;
        let agrees = |y: f64, value: f64| (value - value_of(&powers, y)).abs() <= slack;
        let mut others = other_points().iter().step_by(step);
        let is_confirmed = seen.iter().all(|&(y, value)| agrees(y, value))
            && others.all(|&(y, x)| u(x).is_ok_and(|value| agrees(y, value)));
        return is_confirmed.then(|| powers.into_boxed_slice());
    }
    None
}

impl SingularFunction<'_> {
    /// A point of a side by its octave, δ given.
    pub(super) fn spot(&self, arm: &Arm, delta: f64) -> Option<Spot> {
        if self.is_normalized() { Spot::of_share(delta / arm.length) } else { None }
    }

    /// A point of a side by its octave, t given.
    pub(super) fn spot_at(&self, t: f64) -> Option<Spot> {
        if self.is_normalized() && t >= 0.0 { Some(Spot::of_depth(t)) } else { None }
    }

    /// The value there by the polynomial of its octave, if there is one.
    pub(super) fn at_spot(&self, arm: &Arm, spot: Spot) -> Option<f64> {
        let [octaves, _] = self.octaves(arm)?;
        let found = octaves.get(spot.octave)?.get_or_init(|| self.octave(arm, spot.octave));
        found.as_ref().map(|found| value_of(found, spot.y))
    }

    /// (u(δ) − u(e^s δ))/s of a spot at distance δ by the polynomial of the octave, if both points belong to it and if
    /// this has the smaller error.
    pub(super) fn slope_at(&self, arm: &Arm, spot: Spot, s: f64) -> Option<Slope> {
        let bound = |degree: f64| {
            let inside = (1.0 - spot.y * spot.y).max(0.0).sqrt().recip();
            2.0 * LOG2_E * degree * inside.min(degree)
        };
        if s * bound(COUNTS[0] as f64) >= 1.0 {
            return None;
        }
        let y = spot.beyond(s)?;
        let [octaves, _] = self.octaves(arm)?;
        let found = octaves.get(spot.octave)?.get_or_init(|| self.octave(arm, spot.octave));
        let powers = found.as_ref()?;
        let steep = bound(powers.len().max(COUNTS[0]) as f64);
        let value = -2.0 * LOG2_E * divided_difference(powers, y, spot.y);
        Some(Slope { value, steep }).filter(|_| s * steep < 1.0)
    }

    /// The value at depth t by the polynomial of its octave, if there is one.
    pub(super) fn at_deep(&self, arm: &Arm, t: f64) -> Option<f64> {
        if !self.is_normalized() || !(1.0..f64::MAX).contains(&t) {
            return None;
        }
        let [_, octaves] = self.octaves(arm)?;
        let (octave, y) = Spot::of(t);
        let fill = || self.counted(|x| self.deep(arm, libm::ldexp(x, octave)), 0.0, &[], FEW);
        let found = octaves.get(octave as usize)?.get_or_init(fill);
        match found {
            Some(found) => Some(value_of(found, y)),
            // A power of δ, as steep as an exponential of t.
            None if t < arm.depth => self.at_spot(arm, Spot::of_depth(t)),
            None => None,
        }
    }

    fn octaves(&self, arm: &Arm) -> Option<&[Octaves; 2]> {
        let empty = |count: usize| (0..count).map(|_| OnceLock::new()).collect();
        let make = || {
            let of_side = |arm: Arm| {
                let deep = if self.is_known_at_any_depth() { DEEPEST } else { 0 };
                [empty((arm.depth * LOG2_E).ceil() as usize), empty(deep)]
            };
            self.arms().into_iter().map(of_side).collect()
        };
        self.seen().sides.get_or_init(make).get(arm.index())
    }

    fn octave(&self, arm: &Arm, octave: usize) -> Option<Box<[f64]>> {
        let near = arm.length * libm::ldexp(1.0, -(octave as i32) - 1);
        let seen: Vec<(f64, f64)> = self
            .seen_within(arm, near, 2.0 * near)
            .map(|(delta, value)| (2.0 * (delta / near).log2() - 1.0, value))
            .collect();
        // The logarithm of the distance is a rounded number, too.
        let blur = if self.is_known_at_any_depth() { near.ln().abs() * f64::EPSILON } else { 0.0 };
        let step = if octave < DEEP { 1 } else { FEW };
        self.counted(|x| self.direct(arm, near * x), blur.max(arm.blur / near), &seen, step)
    }

    /// [`polynomial`], with its values in the work limit.
    fn counted(
        &self,
        u: impl Fn(f64) -> Result<f64>,
        blur: f64,
        seen: &[(f64, f64)],
        step: usize,
    ) -> Option<Box<[f64]>> {
        let count = Cell::new(0);
        let one = |x: f64| {
            count.set(count.get() + 1);
            u(x)
        };
        let found = polynomial(one, blur, seen, step);
        // The next value is refused if this exceeds the limit.
        let _ = self.spend(count.get());
        found
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

    /// Of x^a: −δ^a (e^{as} − 1)/s, where the difference of two values would have no digits.
    #[test]
    fn slopes_of_octaves_keep_their_digits() {
        for a in [-0.4, 0.003, 0.5, 2.0] {
            let u = SingularFunction::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
                0 => at.offset().powf(a),
                _ => 1.0,
            });
            let u = u.unwrap();
            let normal = u.normalized(crate::Tolerance::balanced()).unwrap();
            let (arm, size) = (normal.u.arms()[0], normal.units.size);
            let mut worst = 0.0_f64;
            for k in 0..2000 {
                let t = 0.0173 + 0.0371 * f64::from(k);
                let spot = normal.u.spot_at(t).unwrap();
                for s in [1e-15, 1e-9, 1e-4, 0.01] {
                    let Some(slope) = normal.u.slope_at(&arm, spot, s) else { continue };
                    let value = arm.delta(t).powf(a) / size;
                    let exact = -value * ((a * s).exp_m1() / s);
                    let off = (slope.value - exact).abs() / (f64::EPSILON * value);
                    assert!(off <= slope.steep + 4.0 * a.abs(), "{a} {t} {s}: {off}");
                    worst = worst.max(off / slope.steep);
                }
            }
            assert!(worst > 0.01, "{a}: {worst}");
        }
    }

    #[test]
    fn kinks_layers_and_noise_are_evaluated() {
        let refused = |f: fn(f64) -> f64| polynomial(|x| Ok(f(x)), 0.0, &[], 1).is_none();
        assert!(refused(|x| (x - 1.3).abs()) && refused(|x| (-100.0 * (x - 1.0)).exp()));
        assert!(refused(|x| x + 1e-12 * (1e6 * x).sin()) && !refused(f64::sin));
        // a narrow bell that none of the 14 points meets
        let bell = |x: f64| Ok(1.0 + (-0.5 * ((x - 1.31) / 0.003).powi(2)).exp());
        assert!(polynomial(bell, 0.0, &[], FEW).is_some());
        assert!(polynomial(bell, 0.0, &[], 1).is_none());
        // a bell between the points, at one of the other samples
        assert!(polynomial(|_| Ok(1.0), 0.0, &[(0.123, 1.5)], 1).is_none());
    }

    #[test]
    fn a_point_has_one_place_by_its_distance_and_by_its_depth() {
        for k in 0..6900 {
            let t = 0.1 * f64::from(k) + 0.037;
            let (a, b) = (Spot::of_share((-t).exp()).unwrap(), Spot::of_depth(t));
            assert!(a.octave == b.octave && (a.y - b.y).abs() < 1e-15, "{t}: {a:?} {b:?}");
        }
    }

    #[test]
    fn powers_have_the_values_of_chebyshev_polynomials() {
        let chebyshev = [0.7, -0.2, 0.05, 3e-3, -1e-4];
        let powers = powers_of(&chebyshev);
        for y in [-1.0f64, -0.3, 0.0, 0.8, 1.0] {
            let sum: f64 =
                chebyshev.iter().enumerate().map(|(k, c)| c * (k as f64 * y.acos()).cos()).sum();
            assert!((value_of(&powers, y) - sum).abs() < 1e-15);
        }
        assert_eq!(value_of(&powers_of(&[2.5]), 0.3), 2.5);
    }
}
