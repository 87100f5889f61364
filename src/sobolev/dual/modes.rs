//! Dual norms as spectral sums, Σ (1+λ_k)^{-ν} f_k² with cosines or sines, λ_k = (kπ/L)².
//!
//! The spectral sums: what K coefficients leave of ∥f∥²_0, ρ_K, is known by Parseval, so that the tail lies
//! between 0 and (1+λ_K)^{-ν} ρ_K, a rigorous bound that shrinks like 1/K for a jump. Where ρ_K is seen to
//! fall like K^{-s} at two doublings in a row, the tail is ρ_K ∫_K^∞ s K^s k^{-s-1} (1+λ_k)^{-ν} dk ≈
//! (1+λ_K)^{-ν} ρ_K s/(s+2ν), and the error is that of three successive doublings. Cost: O(1) per coefficient
//! and element for piecewise linears, by parts; O(k) points otherwise.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::sum::RunningSum;
use crate::quadrature::Rule;
use crate::sobolev::order::FractionalOrder;
use crate::sobolev::piecewise::PiecewisePolynomial;

/// Coefficients of a spectral sum at most, and values of the function at most: a second or two.
const MAX_MODES: usize = 1 << 15;
const MAX_VALUES: u64 = 1 << 26;
/// Exponents s of the tail that agree so far are taken for its law; below the smallest nothing is seen to
/// fall.
const SAME_EXPONENT: f64 = 0.2;
const SMALLEST_EXPONENT: f64 = 0.5;

impl PiecewisePolynomial {
    pub(super) fn dual_by_modes(
        &self,
        zero: bool,
        order: FractionalOrder,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let total = self.partition().total();
        let scale = self.pieces().iter().map(|piece| piece.size()).fold(0.0, f64::max);
        let whole =
            if scale > 0.0 { (self.l2_norm(tolerance)?.value / scale / total.sqrt()).powi(2) } else { 0.0 };
        if whole == 0.0 {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        let (mut sum, mut seen) = (RunningSum::default(), RunningSum::default());
        let mut tail = Tail::new(whole, order, self.partition().len());
        let (mut work, mut best) = (Work::default(), None);
        for k in usize::from(zero)..MAX_MODES {
            let half_waves = k as f64;
            let (coefficient, points) = self.fourier(half_waves, zero, scale)?;
            work += Work { points, iterations: 1, ..Work::default() };
            let square = coefficient * coefficient * if k == 0 { 1.0 } else { 2.0 };
            let weight = (half_waves * std::f64::consts::PI / total).hypot(1.0).powf(-2.0 * order.value());
            sum.add(weight * square);
            seen.add(square);
            if (k + 1).is_power_of_two() && k >= 63 {
                let squared = tail.add(k + 1, sum.value(), seen.value(), weight, work)?;
                let root = squared.sqrt()?.times(scale * total.sqrt())?;
                if root.relative_error() <= tolerance.relative() {
                    return Ok(root);
                }
                best = Some(root);
            }
            if work.points > MAX_VALUES {
                break;
            }
        }
        let why = "the coefficients that could be taken leave this much in the tail";
        Err(Error::best_of("dual norm", tolerance.relative(), best, why))
    }

    /// ∫ u cos(kπx/L) or ∫ u sin(kπx/L) over L and `scale`, x from the left end; and how many values it took.
    fn fourier(&self, half_waves: f64, sine: bool, scale: f64) -> Result<(f64, u64)> {
        let total = self.partition().total();
        let frequency = half_waves * std::f64::consts::PI;
        let (mut sum, mut points) = (RunningSum::default(), 0);
        let rule = Rule::gauss_legendre(self.degree() / 2 + 16)?;
        for (i, (piece, length)) in self.pieces().iter().zip(self.partition().lengths()).enumerate() {
            let (start, h) = (self.partition().from_left()[i] / total, length / total);
            let waves = frequency * h / std::f64::consts::PI;
            if piece.bubbles.is_empty() && waves > 1.0 {
                // By parts: [u S − u' C'] with S the primitive of the wave; no cancellation beyond half a
                // wave.
                let end = start + h;
                let (left, right) = (piece.left / scale, piece.right / scale);
                let slope = (right - left) / (h * frequency);
                let ((s0, c0), (s1, c1)) = ((frequency * start).sin_cos(), (frequency * end).sin_cos());
                let (ends, inner) = if sine {
                    (left * c0 - right * c1, slope * (s1 - s0))
                } else {
                    (right * s1 - left * s0, slope * (c1 - c0))
                };
                sum.add((ends + inner) / frequency);
                points += 2;
                continue;
            }
            // Enough points for the polynomial and for every half wave in the element.
            let parts = (waves / 4.0).ceil().max(1.0) as usize;
            for part in 0..parts {
                for (t, w) in rule.iter() {
                    let local = (part as f64 + t) / parts as f64;
                    let (s, c) = (frequency * (start + h * local)).sin_cos();
                    sum.add(w * h / parts as f64 * (piece.value(local) / scale) * if sine { s } else { c });
                }
            }
            points += (parts * rule.points().len()) as u64;
        }
        Ok((sum.value(), points))
    }
}

/// What the coefficients beyond the K-th add, from doublings of K.
struct Tail {
    whole: f64,
    order: FractionalOrder,
    /// Number of elements: with fewer coefficients the function may not have been seen.
    elements: usize,
    /// ρ_K at the doublings, and the sums with their tails where the law of ρ is known.
    rests: Vec<f64>,
    limits: Vec<f64>,
    exponent: f64,
}

impl Tail {
    fn new(whole: f64, order: FractionalOrder, elements: usize) -> Self {
        Self { whole, order, elements, rests: Vec::new(), limits: Vec::new(), exponent: 0.0 }
    }

    /// The squared norm from the first `count` coefficients.
    fn add(&mut self, count: usize, sum: f64, seen: f64, weight: f64, work: Work) -> Result<Estimate> {
        let rounding = 64.0 * f64::EPSILON * self.whole;
        let rest = (self.whole - seen).max(rounding);
        // Half of what may be left is added, half is the error.
        let half = 0.5 * weight * rest;
        let mut estimate = Estimate::new(sum + half, half + rounding, work)?;
        let exponent = self.rests.last().map_or(0.0, |last| (last / rest).log2());
        let settled = exponent >= SMALLEST_EXPONENT && (exponent / self.exponent - 1.0).abs() < SAME_EXPONENT;
        if settled && count >= 2 * self.elements {
            let s = 0.5 * (exponent + self.exponent);
            self.limits.push(sum + weight * rest * s / (s + 2.0 * self.order.value()));
        } else {
            self.limits.clear();
        }
        if let [.., a, b, c] = self.limits[..] {
            let change = 3.0 * (c - b).abs().max(0.5 * (b - a).abs());
            // The law itself: the exponents differ by so much, and 2ν/s of the tail depends on them.
            let law =
                2.0 * half * (2.0 * self.order.value()).min(1.0) * (exponent / self.exponent - 1.0).abs();
            if change + law < half {
                estimate = Estimate::new(c, change + law + rounding, work)?;
            }
        }
        self.exponent = exponent;
        self.rests.push(rest);
        Ok(estimate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sobolev::{DualOf, Partition};
    use std::f64::consts::PI;

    /// ‖1‖ in the dual of sines on (0, 1): 8/π² Σ_{odd k} k^{-2} (1 + k²π²)^{-ν}, the tail by the midpoint
    /// rule.
    fn one_exactly(nu: f64) -> f64 {
        const LAST: f64 = 200_000.0;
        let term = |k: f64| 8.0 / (PI * k).powi(2) * (PI * k).hypot(1.0).powf(-2.0 * nu);
        let head: f64 = (0..LAST as u32 / 2).rev().map(|m| term(2.0 * f64::from(m) + 1.0)).sum();
        let tail = 4.0 * PI.powf(-2.0 - 2.0 * nu) * LAST.powf(-1.0 - 2.0 * nu) / (1.0 + 2.0 * nu);
        (head + tail).sqrt()
    }

    #[test]
    fn small_orders_are_summed_with_their_tail() {
        let one = PiecewisePolynomial::linears(Partition::uniform(3, 1.0).unwrap(), &[1.0; 4]).unwrap();
        for nu in [1e-6, 0.01, 0.1, 0.3, 0.5, 0.9] {
            let order = FractionalOrder::new(nu).unwrap();
            let exact = one_exactly(nu);
            for tolerance in [1e-2, 1e-4, 1e-6, 1e-8] {
                let tolerance = Tolerance::new(tolerance).unwrap();
                let found = one.dual_norm(DualOf::InterpolationZero, order, tolerance).unwrap();
                let error = (found.value - exact).abs();
                assert!(error <= found.error + 1e-12, "nu {nu}: {found} against {exact}, {error:e}");
                assert!(found.relative_error() <= tolerance.relative());
            }
        }
    }

    #[test]
    fn tighter_tolerances_stay_within_the_errors_of_wider_ones() {
        let partition = Partition::from_lengths(vec![0.21, 0.33, 0.17, 0.29]).unwrap();
        let saw = PiecewisePolynomial::linears(partition, &[1.0, -1.0, 1.0, -1.0, 2.0]).unwrap();
        for nu in [1e-6, 0.01, 0.3, 0.7] {
            let order = FractionalOrder::new(nu).unwrap();
            for of in [DualOf::Interpolation, DualOf::InterpolationZero] {
                let norm = |tolerance| saw.dual_norm(of, order, Tolerance::new(tolerance).unwrap()).unwrap();
                let fine = norm(1e-8);
                for tolerance in [1e-2, 1e-4, 1e-6] {
                    let wide = norm(tolerance);
                    let apart = (wide.value - fine.value).abs();
                    assert!(apart <= wide.error + fine.error, "{of:?} nu {nu} {tolerance}: {wide} {fine}");
                }
            }
        }
    }

    #[test]
    fn sizes_scale_and_what_cannot_be_summed_is_an_error() {
        let one = |length: f64, value: f64| {
            let cells = Partition::uniform(3, length).unwrap();
            PiecewisePolynomial::linears(cells, &[value; 4]).unwrap()
        };
        let norm = |u: PiecewisePolynomial| {
            u.dual_norm(DualOf::Interpolation, FractionalOrder::HALF, Tolerance::fast()).unwrap().value
        };
        for (length, value) in [(1.0, 1e-300), (1.0, 1e300), (1e-300, 1.0), (1e300, 1.0)] {
            let exact = value * f64::sqrt(length);
            assert!((norm(one(length, value)) / exact - 1.0).abs() < 1e-12, "{length} {value}");
        }
        // 3000 jumps of both signs at random: their law is not seen within the modes that are summed
        let signs: Vec<f64> =
            (0..3000u32).map(|i| f64::from(i.wrapping_mul(2_654_435_761) >> 31) - 0.5).collect();
        let noise = PiecewisePolynomial::constants(Partition::uniform(3000, 1.0).unwrap(), &signs).unwrap();
        let tolerance = Tolerance::new(1e-12).unwrap();
        let refused =
            noise.dual_norm(DualOf::InterpolationZero, FractionalOrder::new(0.01).unwrap(), tolerance);
        assert!(matches!(refused, Err(Error::ToleranceNotMet { asked: 1e-12, .. })), "{refused:?}");
    }
}
