//! The tail of a side below the range of binary64: ∫_{t₀}^∞ ℓ(t) dt for functions of the logarithm of the
//! distance to their breakpoint.
//!
//! Where t = ln(R/δ) is large, ℓ depends only on points of depth t − s with s = O(1), since other
//! breakpoints contribute O(e^{−t}): ℓ(t) = δ^{1−2ν} (A + B),
//!
//! A = ∫₀^∞ (f(t)−f(t−s))² e^s (e^s−1)^{−1−2ν} ds,  B = ∫₀^∞ (f(t)−g(t−s))² ρ (1+ρ)^{−1−2ν} ds,  ρ = (R′/R)
//! e^s,
//!
//! with the function f on the side and g on the other side, of length R′, of the same breakpoint. A quantity
//! that decays like a power of t decays exponentially in τ = ln t, and τ < 700 reaches ln δ = −10^{300}.
//! There f(t) − f(t−s) would have no digits: f is interpolated in τ on cells by Chebyshev polynomials, p = Σ
//! c_k T_k, and the divided difference is Σ c_k D_k with D₀ = 0, D₁ = 1, D_{k+1} = 2xD_k + 2T_k(y) − D_{k−1},
//! D_k = (T_k(x) − T_k(y))/(x − y), at x − y = −ln(1 − s/t) in τ. Cost: (cells of τ) × (points) × (points in
//! s) × degree.

use super::arm::Arm;
use super::function::SingularFunction;
use super::interpolant::Interpolant;
use super::level::{ArmValue, Level};
use crate::error::{Error, Result};
use crate::kernel::power::PowerKernel;
use crate::quadrature::{Limit, Rule, extrapolate};
use std::mem;

/// Largest width of a cell in τ.
const CELL: f64 = 1.0;
/// Smallest width of a cell in τ.
const NARROWEST: f64 = 0.01;
/// Largest τ for which e^τ is finite in binary64.
const LAST: f64 = 700.0;
/// Largest s: beyond s = 50, e^{−s} is below rounding.
const REACH: f64 = 50.0;
/// Value of x beyond which e^{−x} is below rounding.
const NOTHING: f64 = 36.0;
/// Largest useful reach: a quarter of the largest depth of a side.
const DEEPEST_START: f64 = 170.0;
/// Increment of τ after which a growing integrand, such as that of δ^a with small a, must have begun to
/// decay.
const SETTLED: f64 = 40.0;
/// Rounding error of an exponent of t that is estimated from values.
const FLAT: f64 = 1e-13;
/// Value of |1 − 2ν| t from which on the factor e^{−(1−2ν)t} has an effect.
const BEGUN: f64 = 4.0;
/// Largest growth e^{GROWTH} of f on one cell, estimated between t and STEP t.
const GROWTH: f64 = 4.0;
const STEP: f64 = 1.125;
const MORE_TERMS: f64 = 60.0;
/// Ratio of consecutive cell integrals above which the decay is that of a power of t, which ends at 1e-308, and
/// not that of a function with a limit.
const ALGEBRAIC: f64 = 1e-6;
/// Message: the limit depends on distances that cannot be represented.
const UNSEEN: &str = "so close to the order at which the norm becomes infinite, the value depends on distances below exp(-1e300)";
const BEYOND: &str = "contributions near a breakpoint exceed the range of binary64";
/// The part (0, 2) of s next to the singularity; cells of width 3 beyond.
const NEAR: f64 = 2.0;
const FAR_CELL: f64 = 3.0;

/// A depth difference s and the weight of ((f(t)−f(t−s))/s)², or across the breakpoint of (f(t)−g(t−s))².
type Node = (f64, f64);

/// Quadrature rules in s for one side of a breakpoint and for the other side.
pub(crate) struct DeepTail<'a> {
    function: &'a SingularFunction<'a>,
    arm: Arm,
    other: Option<Arm>,
    own: Vec<Node>,
    across: Vec<Node>,
    rule: Rule,
    /// number of coefficients of an interpolant
    terms: usize,
    reach: f64,
    /// 1 − 2ν, and ln of the side's length in the unit of the energy
    decay: f64,
    log_length: f64,
}

/// Cells in τ and the coefficients of an interpolant on them.
#[derive(Clone, Copy)]
struct Shape {
    cell: f64,
    terms: usize,
}

impl<'a> DeepTail<'a> {
    pub(crate) fn new(
        function: &'a SingularFunction<'a>,
        arm: Arm,
        other: Option<Arm>,
        kernel: PowerKernel,
        level: Level,
        unit: f64,
    ) -> Result<Self> {
        let rule = Rule::gauss_legendre(level.points)?;
        let mut own = Vec::new();
        for (node, w) in Rule::power_weight(level.points + 6, kernel.two_minus)?.iter() {
            let s = NEAR * node;
            let stretch = s.exp_m1() / s;
            own.push((
                s,
                w * NEAR.powf(kernel.two_minus) * s.exp() / stretch * stretch.powf(-kernel.twice),
            ));
        }
        // Points that are s less deep count like e^{−2νs}.
        let own_reach = REACH.max(NOTHING / kernel.twice);
        let is_used = own_reach < DEEPEST_START;
        for (s, w) in cells(&rule, NEAR, if is_used { own_reach } else { REACH }) {
            own.push((s, w * s * s * s.exp() / s.exp_m1() * s.exp_m1().powf(-kernel.twice)));
        }
        let (mut across, mut reach) = (Vec::new(), own_reach);
        if let Some(other) = other.filter(|_| is_used) {
            let quotient = other.length / arm.length;
            reach += quotient.ln().abs();
            for (s, w) in cells(&rule, 0.0, reach) {
                let rho = quotient * s.exp();
                across.push((s, w * rho / (1.0 + rho) * (1.0 + rho).powf(-kernel.twice)));
            }
        }
        Ok(Self {
            function,
            arm,
            other,
            own,
            across,
            rule,
            terms: 8 + level.points / 4,
            reach,
            decay: kernel.one_minus,
            log_length: (arm.length / unit).ln(),
        })
    }

    /// The depth from which the formula holds.
    pub(crate) fn start(&self) -> f64 {
        4.0 * self.reach
    }

    /// True if the formula holds beyond t.
    pub(crate) fn starts_at(&self, t: f64) -> bool {
        self.reach < 0.25 * t
    }

    /// ∫_from^∞ ℓ; `whole` is the integral to which it is added.
    pub(crate) fn integrate(&self, from: f64, tolerance: f64, whole: f64) -> Result<ArmValue> {
        let shape = self.shape(from)?;
        let (mut ends, mut partial, mut densities) = (Vec::new(), Vec::new(), Vec::new());
        let (mut sum, mut rounding, mut previous, mut last) = (0.0f64, 0.0f64, f64::INFINITY, 0.0);
        let mut tau = from.ln();
        while tau + shape.cell <= LAST {
            let (cell, density, noise) = match self.cell(tau, shape.cell, shape.terms) {
                Ok(found) if found.0.is_finite() => found,
                // Grown beyond binary64, and nothing brings it down.
                _ if self.decay <= 0.0 && grows(&densities) => return Err(self.infinite()),
                Ok(_) | Err(Error::NotFinite { .. }) => {
                    return Err(Error::out_of_reach("integral", tolerance, f64::INFINITY, BEYOND));
                }
                Err(error) => return Err(error),
            };
            sum += cell;
            rounding = rounding.hypot(noise);
            tau += shape.cell;
            ends.push(tau);
            partial.push(sum);
            densities.push(density);
            if self.is_infinite(&ends, &densities) {
                return Err(self.infinite());
            }
            let ratio = cell / previous;
            let is_algebraic = mem::replace(&mut last, ratio) > ALGEBRAIC;
            previous = cell;
            let rest = cell * ratio / (1.0 - ratio);
            let small = rest <= 0.002 * tolerance * (whole + sum) || cell <= 1e-17 * (whole + sum);
            let is_seen = self.decay >= 0.0 || -self.decay * tau.exp() > BEGUN;
            if cell == 0.0 && is_algebraic && !is_seen {
                return Err(Error::out_of_reach("integral", tolerance, f64::INFINITY, UNSEEN));
            }
            if cell == 0.0 && self.grows_no_more(tau)?
                || (is_seen && ends.len() > 3 && ratio < 0.99 && small)
            {
                // What is left of an exponential in τ, or less.
                let rest = rest.max(0.0);
                return Ok(ArmValue {
                    limit: Limit { value: sum + rest, error: rest },
                    rounding,
                    is_settled: false,
                });
            }
        }
        if self.decay != 0.0 && self.decay.abs() * tau.exp() <= BEGUN {
            return Err(Error::out_of_reach("integral", tolerance, f64::INFINITY, UNSEEN));
        }
        // Too slow even for 10^{300}: exponentials in τ, with all their digits, have a limit.
        let rest = densities.last().map_or(0.0, |density| density * tau);
        let limit = extrapolate(&ends, &partial, &densities, 1e-14 * sum)
            .unwrap_or(Limit { value: sum, error: rest });
        if limit.error > 0.5 * limit.value {
            return Err(Error::out_of_reach("integral", tolerance, f64::INFINITY, UNSEEN));
        }
        Ok(ArmValue { limit, rounding, is_settled: false })
    }

    /// True if no value at a number of deeper points is larger; a value beyond binary64 counts as larger.
    fn grows_no_more(&self, tau: f64) -> Result<bool> {
        let size = |k: u32| {
            let at = tau + (LAST - tau) * f64::from(k) / 64.0;
            match self.function.at_depth(&self.arm, at.exp()) {
                Err(Error::NotFinite { .. }) => Ok(f64::INFINITY),
                value => value.map(f64::abs),
            }
        };
        let first = size(0)?;
        (1..=64).try_fold(first.is_finite(), |none, k| Ok(none && size(k)? <= first))
    }

    fn infinite(&self) -> Error {
        Error::InfiniteNorm {
            order: 0.5 * (1.0 - self.decay),
            why: "the contributions near a breakpoint do not decay",
        }
    }

    /// True if t ℓ(t) does not decay in ln t; false as long as the factor e^{−(1−2ν)t} has no effect.
    fn is_infinite(&self, ends: &[f64], densities: &[f64]) -> bool {
        let [first, last] = [ends[0], ends[ends.len() - 1]];
        if self.decay > 0.0 || last - first < SETTLED {
            return false;
        }
        // The power of t, over the latter half; corrections to it are of the size reach/t.
        let from = ends.partition_point(|&tau| tau < 0.5 * (first + last));
        let power = (densities[densities.len() - 1] / densities[from]).ln() / (last - ends[from]);
        power > 4.0 * self.reach * (-ends[from]).exp() - FLAT
    }

    /// Width of the cells in τ on which f, a power of t, grows by at most e^{GROWTH}, and the number of
    /// coefficients on them.
    fn shape(&self, from: f64) -> Result<Shape> {
        let [here, there] = [from, STEP * from].map(|t| self.function.at_depth(&self.arm, t));
        let power = ((there? / here?).abs().ln() / STEP.ln()).abs();
        let power = if power.is_finite() { power } else { 0.0 };
        let cell = CELL.min(GROWTH / power);
        let reach = -(-self.reach / from).ln_1p();
        // The interpolants also reach back; the terms of e^{zx} on (−1, 1) fall like (z/2)^n/n!.
        let terms = self.terms + (0.75 * power * (cell + reach)).min(MORE_TERMS) as usize;
        Ok(Shape { cell, terms })
    }

    /// (∫ ℓ dt, t ℓ at the end, rounding) on (τ, τ + width), in halves where the interpolants are not resolved.
    fn cell(&self, tau: f64, width: f64, terms: usize) -> Result<(f64, f64, f64)> {
        let from = tau + (-self.reach / tau.exp()).ln_1p();
        let whole = tau + width - from;
        let own = Interpolant::new(self.function, &self.arm, from, whole, terms)?;
        let other = self
            .other
            .map(|other| Interpolant::new(self.function, &other, from, whole, terms))
            .transpose()?;
        if width > NARROWEST
            && !(own.is_resolved() && other.as_ref().is_none_or(Interpolant::is_resolved))
        {
            let (first, _, noise) = self.cell(tau, 0.5 * width, terms)?;
            let (second, density, rounding) = self.cell(tau + 0.5 * width, 0.5 * width, terms)?;
            return Ok((first + second, density, noise.hypot(rounding)));
        }
        let (mut sum, mut noise, mut density) = (0.0, 0.0, 0.0);
        for (point, w) in self.rule.iter() {
            let at = tau + width * point;
            let (value, rounding) = self.density(&own, other.as_ref(), at, from, whole);
            density = at.exp() * value;
            sum += w * width * density;
            noise += w * width * at.exp() * rounding;
        }
        Ok((sum, density, noise))
    }

    /// ℓ at τ and its rounding.
    fn density(
        &self,
        own: &Interpolant,
        other: Option<&Interpolant>,
        tau: f64,
        from: f64,
        width: f64,
    ) -> (f64, f64) {
        let t = tau.exp();
        let x = 2.0 * (tau - from) / width - 1.0;
        // Coefficients are right to some ε; the derivative of T_k is k² at most, k^{3/2} in the mean.
        let blur =
            |p: &Interpolant| f64::EPSILON * p.largest * (p.coefficients.len() as f64).powf(1.5);
        let (mut sum, mut rounding) = (0.0, 0.0);
        for &(s, weight) in &self.own {
            let step = -(-s / t).ln_1p() * 2.0 / width;
            let slope = step / s;
            let quotient = slope * own.divided_difference(x, x - step);
            sum += weight * quotient * quotient;
            rounding += 2.0 * weight * (quotient * slope).abs() * blur(own);
        }
        if let Some(other) = other {
            let gap = own.minus(other, x);
            for &(s, weight) in &self.across {
                let step = -(-s / t).ln_1p() * 2.0 / width;
                let difference = gap + step * other.divided_difference(x, x - step);
                sum += weight * difference * difference;
                let noise =
                    step * blur(other) + f64::EPSILON * if gap == 0.0 { 0.0 } else { own.largest };
                rounding += 2.0 * weight * difference.abs() * noise;
            }
        }
        let scale = (self.decay * (self.log_length - t)).exp();
        (scale * sum, scale * rounding)
    }
}

/// True if the last value exceeds the one before.
fn grows(densities: &[f64]) -> bool {
    matches!(densities, [.., before, last] if last > before)
}

/// Gauss points and weights on cells of (from, to).
fn cells(rule: &Rule, from: f64, to: f64) -> Vec<Node> {
    let count = ((to - from) / FAR_CELL).ceil();
    let width = (to - from) / count;
    (0..count as usize)
        .flat_map(|k| rule.iter().map(move |(t, w)| (from + width * (k as f64 + t), w * width)))
        .collect()
}
