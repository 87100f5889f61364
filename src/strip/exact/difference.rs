//! The modes of g − P g_h: interpolation from a coarse edge is diagonal up to aliasing, so that no transform of the
//! fine length is needed once ĝ is known.
//!
//! P interpolates linearly from n to N = r n cells; its kernel is the hat function of width r, whose transform is the
//! square of the Dirichlet kernel divided by r. With the periods P and p = P/r of the (evenly extended) edges
//!
//! (P g_h)^(k) = s(k) ĝ_h(k mod p),  s(k) = sin²(πk/p) / (r sin²(πk/P)) for k ≠ 0,  s(0) = r.
//!
//! Rounding: the error of ĝ is η ‖ĝ‖₂ with η = ε log₂ P, as usual for a transform. By Parseval's identity this
//! changes the energy norm of the difference by at most η (γ max S)^(1/2) ‖g‖₂, the norm of the extended nodal
//! values. Cost per coarse edge: O(N) with one product per mode, and a transform of the coarse length.

use fractional_sobolev_numeric::transforms::Complex;
use std::f64::consts::PI;

/// 1/sin²(πk/P), k = 1 ... P/2, of a fine edge.
#[derive(Debug, Clone)]
pub(super) struct Interpolation {
    period: usize,
    inverse: Vec<f64>,
}

/// The modes of P g_h, without the factor 1/sin²(πk/P) of the fine edge.
pub(super) struct Interpolated<'a> {
    fine: &'a Interpolation,
    /// sin²(πj/p)/r ĝ_h(j), j = 0 ... p/2.
    modes: Vec<Complex<f64>>,
    /// p − 1, p a power of two.
    mask: usize,
    /// r ĝ_h(0).
    mean: Complex<f64>,
}

impl Interpolation {
    /// The interpolation to the edge of period P, a power of two.
    pub(super) fn new(period: usize) -> Self {
        let inverse =
            (0..=period / 2).map(|k| (PI * k as f64 / period as f64).sin().powi(-2)).collect();
        Self { period, inverse }
    }

    /// The edge function with modes ĝ_h(j), j = 0 ... p/2.
    pub(super) fn of(&self, mut modes: Vec<Complex<f64>>) -> Interpolated<'_> {
        let period = 2 * (modes.len() - 1);
        let ratio = (self.period / period) as f64;
        let mean = modes[0] * ratio;
        for (j, mode) in modes.iter_mut().enumerate() {
            *mode *= (PI * j as f64 / period as f64).sin().powi(2) / ratio;
        }
        Interpolated { fine: self, modes, mask: period - 1, mean }
    }
}

impl Interpolated<'_> {
    /// (P g_h)^(k), k = 0 ... P/2.
    pub(super) fn mode(&self, k: usize) -> Complex<f64> {
        if k == 0 {
            return self.mean;
        }
        let j = k & self.mask;
        let mirrored = self.mask + 1 - j;
        let mode = if j <= mirrored { self.modes[j] } else { self.modes[mirrored].conj() };
        mode * self.fine.inverse[k]
    }
}

/// The effect of rounding errors in the modes `exact` of period P on the square root of Σ S |ĝ − ĝ_h|² γ/P.
///
/// ε log₂ P (γ max S)^{1/2} ‖g‖₂: absolute, in the energy norm.
pub(super) fn rounding(exact: &[Complex<f64>], largest_symbol: f64) -> f64 {
    let period = 2.0 * (exact.len() - 1) as f64;
    // Σ over k mod P of |ĝ|²/P is the square of the norm of the extended nodal values; γ ≤ 1.
    let square: f64 = exact.iter().map(|mode| 2.0 * mode.norm_sqr()).sum::<f64>() / period;
    f64::EPSILON * period.log2() * (largest_symbol * square).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strip::operator::edge::EdgeOperator;
    use crate::strip::sides::LateralCondition;
    use crate::strip::transfer::prolong;

    /// Transforms of length ≤ 256 of numbers up to 1.
    const ROUNDING: f64 = 1e-12;

    #[test]
    fn modes_of_the_interpolant_are_those_of_its_nodal_values() {
        for sides in [LateralCondition::Natural, LateralCondition::Periodic] {
            let operator = |n: usize| {
                let symbol = vec![1.0; sides.period(n) / 2 + 1];
                EdgeOperator::new(n, sides, &symbol).unwrap()
            };
            let fine = 128;
            let interpolation = Interpolation::new(sides.period(fine));
            for coarse in [2, 4, 32, 128] {
                let values: Vec<f64> =
                    (0..sides.nodes(coarse)).map(|i| (1.0 + i as f64).sin()).collect();
                let modes = operator(coarse).modes(&values).unwrap();
                let mut interpolant = values;
                let mut n = coarse;
                while n < fine {
                    n *= 2;
                    interpolant = prolong(&interpolant, sides.nodes(n));
                }
                let known = operator(fine).modes(&interpolant).unwrap();
                let found = interpolation.of(modes);
                for (k, mode) in known.iter().enumerate() {
                    let off = (found.mode(k) - mode).norm();
                    assert!(off < ROUNDING, "{sides:?}, {coarse} cells, mode {k}: {off}");
                }
            }
        }
    }
}
