//! The end of an arm beyond binary64: ∫_{t₀}^∞ ℓ(t) dt for functions known by the logarithm of the distance
//! to their break.
//!
//! Where t = ln(R/δ) is large, ℓ feels only points of depth t − s with s = O(1), since other breaks
//! contribute O(e^{−t}): ℓ(t) = δ^{1−2ν} (A + B),
//!
//! A = ∫₀^∞ (f(t)−f(t−s))² e^s (e^s−1)^{−1−2ν} ds,  B = ∫₀^∞ (f(t)−g(t−s))² ρ (1+ρ)^{−1−2ν} ds,  ρ = (R′/R)
//! e^s,
//!
//! with g on the other arm (of length R′) of the same break. What decays like a power of t decays
//! exponentially in τ = ln t, and τ < 700 reaches ln δ = −10^{300}. There f(t) − f(t−s) would have no digits:
//! f is interpolated in τ on cells by Chebyshev polynomials, p = Σ c_k T_k, and the divided difference is Σ
//! c_k D_k with D₀ = 0, D₁ = 1, D_{k+1} = 2xD_k + 2T_k(y) − D_{k−1}, D_k = (T_k(x) − T_k(y))/(x − y), at x −
//! y = −ln(1 − s/t) in τ. Cost: (cells of τ) × (points) × (points in s) × degree.

use super::function::{Arm, SingularFunction};
use super::level::{ArmValue, Level};
use crate::error::{Error, Result};
use crate::quadrature::{Limit, PowerWeightRule, Rule, extrapolate};
use crate::sobolev::kernel::power::PowerKernel;
use std::f64::consts::PI;

/// Width of a cell in τ.
const CELL: f64 = 1.0;
/// e^τ is a number of binary64 up to here.
const LAST: f64 = 700.0;
/// Beyond s = 50, e^{−s} is rounding.
const REACH: f64 = 50.0;
/// Cells after which t = e^46: corrections in 1/t to a power of t are below 1e-19.
const SETTLED: usize = 40;
/// The part (0, 2) of s next to the singularity; cells of width 3 beyond.
const NEAR: f64 = 2.0;
const FAR_CELL: f64 = 3.0;

/// A depth difference s and the weight of ((f(t)−f(t−s))/s)², or across the break of (f(t)−g(t−s))².
type Node = (f64, f64);

/// The rules in s for one arm, and its break's other arm.
pub(crate) struct DeepTail<'a> {
    function: &'a SingularFunction<'a>,
    arm: Arm,
    other: Option<Arm>,
    own: Vec<Node>,
    across: Vec<Node>,
    rule: Rule,
    /// coefficients of an interpolant
    terms: usize,
    reach: f64,
    /// 1 − 2ν, and ln of the arm's length in the unit of the energy
    decay: f64,
    log_length: f64,
}

/// A Chebyshev interpolant on (from, from + width) of τ.
struct Interpolant {
    coefficients: Vec<f64>,
    largest: f64,
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
        for (node, w) in PowerWeightRule::new(level.points + 6, kernel.two_minus)?.iter() {
            let s = NEAR * node;
            let stretch = s.exp_m1() / s;
            own.push((s, w * NEAR.powf(kernel.two_minus) * s.exp() / stretch * stretch.powf(-kernel.twice)));
        }
        for (s, w) in cells(&rule, NEAR, REACH) {
            own.push((s, w * s * s * s.exp() / s.exp_m1() * s.exp_m1().powf(-kernel.twice)));
        }
        let (mut across, mut reach) = (Vec::new(), REACH);
        if let Some(other) = other {
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

    /// True when the end beyond t is deep enough for the formula.
    pub(crate) fn starts_at(&self, t: f64) -> bool {
        self.reach < 0.25 * t
    }

    /// ∫_from^∞ ℓ; `whole` is what it will be added to.
    pub(crate) fn integrate(&self, from: f64, tolerance: f64, whole: f64) -> Result<ArmValue> {
        let (mut ends, mut partial, mut densities) = (Vec::new(), Vec::new(), Vec::new());
        let (mut sum, mut rounding, mut previous) = (0.0f64, 0.0f64, f64::INFINITY);
        let mut tau = from.ln();
        while tau + CELL <= LAST {
            let (cell, density, noise) = self.cell(tau)?;
            sum += cell;
            rounding = rounding.hypot(noise);
            tau += CELL;
            ends.push(tau);
            partial.push(sum);
            densities.push(density);
            let ratio = cell / previous;
            previous = cell;
            if ends.len() > SETTLED && ratio >= 1.0 - 1e-9 {
                return Err(Error::InfiniteNorm {
                    order: 0.5 * (1.0 - self.decay),
                    why: "t l(t) does not decay in ln t",
                });
            }
            let rest = cell * ratio / (1.0 - ratio);
            let small = rest <= 0.002 * tolerance * (whole + sum) || cell <= 1e-17 * (whole + sum);
            if cell == 0.0 || (ends.len() > 3 && ratio < 0.99 && small) {
                return Ok(ArmValue { limit: Limit { value: sum, error: rest.max(0.0) }, rounding });
            }
        }
        // Too slow even for 10^{300}: exponentials in τ, with all their digits, have a limit.
        let rest = densities.last().map_or(0.0, |density| density * tau);
        let limit = extrapolate(&ends, &partial, &densities, 1e-14 * sum)
            .unwrap_or(Limit { value: sum, error: rest });
        Ok(ArmValue { limit, rounding })
    }

    /// (∫ ℓ dt, t ℓ at the end, rounding) on (τ, τ + CELL).
    fn cell(&self, tau: f64) -> Result<(f64, f64, f64)> {
        let from = tau + (-self.reach / tau.exp()).ln_1p();
        let width = tau + CELL - from;
        let own = self.interpolant(&self.arm, from, width)?;
        let other = self.other.map(|other| self.interpolant(&other, from, width)).transpose()?;
        let (mut sum, mut noise, mut density) = (0.0, 0.0, 0.0);
        for (point, w) in self.rule.iter() {
            let at = tau + CELL * point;
            let (value, rounding) = self.density(&own, other.as_ref(), at, from, width);
            density = at.exp() * value;
            sum += w * CELL * density;
            noise += w * CELL * at.exp() * rounding;
        }
        Ok((sum, density, noise))
    }

    fn interpolant(&self, arm: &Arm, from: f64, width: f64) -> Result<Interpolant> {
        let n = self.terms;
        let angles: Vec<f64> = (0..n).map(|j| PI * (j as f64 + 0.5) / n as f64).collect();
        let values = angles
            .iter()
            .map(|angle| self.function.at_depth(arm, (from + 0.5 * width * (1.0 + angle.cos())).exp()))
            .collect::<Result<Vec<f64>>>()?;
        let coefficients = (0..n)
            .map(|k| {
                let sum: f64 = angles.iter().zip(&values).map(|(a, v)| v * (k as f64 * a).cos()).sum();
                sum * if k == 0 { 1.0 } else { 2.0 } / n as f64
            })
            .collect();
        Ok(Interpolant { coefficients, largest: values.iter().fold(0.0, |m, v| v.abs().max(m)) })
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
        let blur = |p: &Interpolant| f64::EPSILON * p.largest * (self.terms as f64).powf(1.5);
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
                let noise = step * blur(other) + f64::EPSILON * if gap == 0.0 { 0.0 } else { own.largest };
                rounding += 2.0 * weight * difference.abs() * noise;
            }
        }
        let scale = (self.decay * (self.log_length - t)).exp();
        (scale * sum, scale * rounding)
    }
}

impl Interpolant {
    /// (p(x) − p(y))/(x − y).
    fn divided_difference(&self, x: f64, y: f64) -> f64 {
        let (mut before, mut current) = (0.0, 1.0);
        let (mut chebyshev_before, mut chebyshev) = (1.0, y);
        let mut sum = 0.0;
        for c in &self.coefficients[1..] {
            sum += c * current;
            (before, current) = (current, 2.0 * (x * current + chebyshev) - before);
            (chebyshev_before, chebyshev) = (chebyshev, 2.0 * y * chebyshev - chebyshev_before);
        }
        sum
    }

    /// p(x) − q(x), exactly zero for equal p and q.
    fn minus(&self, other: &Self, x: f64) -> f64 {
        let (mut before, mut current, mut sum) = (x, 1.0, 0.0);
        for (a, b) in self.coefficients.iter().zip(&other.coefficients) {
            sum += (a - b) * current;
            (before, current) = (current, 2.0 * x * current - before);
        }
        sum
    }
}

/// Gauss points and weights on cells of (from, to).
fn cells(rule: &Rule, from: f64, to: f64) -> Vec<Node> {
    let count = ((to - from) / FAR_CELL).ceil();
    let width = (to - from) / count;
    (0..count as usize)
        .flat_map(|k| rule.iter().map(move |(t, w)| (from + width * (k as f64 + t), w * width)))
        .collect()
}
