//! Double integrals of |x − y|^{-1-2ν} times hat functions over two elements (cells) of lengths p, q at
//! distance d.
//!
//! Every integrand below has one sign, so that every value has full relative accuracy for p, q, d with
//! ratios down to 1e-303. Coordinates s, t run from the ends that face each other, so that |x − y| = d + s +
//! t.
//!
//! - separate cells (d > 0): the inner integral in closed form ([`PowerKernel::hats`]), the outer one by
//!   Gauss rules on pieces that grow away from the other cell; a tensor rule when both cells are shorter than
//!   d;
//! - touching cells (d = 0): the integrand is homogeneous of degree m = 1 − 2ν (quadratic numerator), so over
//!   the two triangles of the rectangle (Duffy 1982) the radial integral is 1/(m + 2) = 1/(3 − 2ν) and one
//!   closed 1D integral is left: ∫₀^p∫₀^q f(s,t) = pq/(m+2) [∫₀¹ f(p, qη) dη + ∫₀¹ f(pη, q) dη].
//!
//! Everything is computed in units of a power of two S near the geometric mean of the smallest and the largest
//! scale of the integral, so that t^{-2ν} remains in the range of binary64 over 300 decades of t, and is then
//! multiplied by S^{1-2ν}.

use super::power::{GaussRules, PowerKernel};
use crate::numeric::scale::power_between;
use crate::order::Order;

/// The integrals over pairs of cells for one order ν.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CellPairs {
    kernel: PowerKernel,
}

/// Two touching cells of lengths p and q; each value is ∫∫ f (s+t)^{-1-2ν} over both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Touching {
    /// f = (s/p)(t/q)
    pub(crate) product: f64,
    /// f = (s/p − t/q)²
    pub(crate) difference_squared: f64,
    /// f = (t/q)(s/p − t/q)
    pub(crate) first: f64,
}

impl CellPairs {
    pub(crate) fn new(order: Order) -> Self {
        Self { kernel: PowerKernel::new(order) }
    }

    /// f(lengths / S) S^{1-2ν} for S a power of two near √(low high).
    fn scaled<const N: usize, const M: usize>(
        &self,
        [low, high]: [f64; 2],
        lengths: [f64; N],
        f: impl FnOnce([f64; N]) -> [f64; M],
    ) -> [f64; M] {
        let scale = power_between(low, high);
        let factor = self.kernel.scaling(scale);
        f(lengths.map(|length| length / scale)).map(|value| value * factor)
    }

    /// ∫∫ λ_a(s) μ_b(t) (d+s+t)^{-1-2ν}, index 0 for the hat function that is 1 at the facing end, 1 at the
    /// other; d > 0.
    pub(crate) fn separate(&self, p: f64, q: f64, d: f64) -> [[f64; 2]; 2] {
        let [a, b, c, e] = self.scaled([d, d.max(p).max(q)], [p, q, d], |[p, q, d]| {
            if p <= d && q <= d {
                self.far(p, q, d)
            } else if p <= q {
                self.near(p, q, d)
            } else {
                let [a, b, c, e] = self.near(q, p, d);
                [a, c, b, e]
            }
        });
        [[a, b], [c, e]]
    }

    fn far(&self, p: f64, q: f64, d: f64) -> [f64; 4] {
        let [along_p, along_q] = [p / d, q / d].map(|ratio| GaussRules::EXACT.simple(ratio));
        let mut sums = [0.0; 4];
        for (s, v) in along_p.iter() {
            let start = d + p * s;
            let (mut near, mut far) = (0.0, 0.0);
            for (t, w) in along_q.iter() {
                let value = w * self.kernel.at(start + q * t);
                near += (1.0 - t) * value;
                far += t * value;
            }
            sums[0] += v * (1.0 - s) * near;
            sums[1] += v * (1.0 - s) * far;
            sums[2] += v * s * near;
            sums[3] += v * s * far;
        }
        sums.map(|sum| p * q * sum)
    }

    /// The same for p ≤ q, with the outer integral over p.
    fn near(&self, p: f64, q: f64, d: f64) -> [f64; 4] {
        let mut sums = [0.0; 4];
        GaussRules::EXACT.graded(d, p, |s, w| {
            // w and s/p may both be tiny, the hats huge: their product is formed in this order.
            let [near, far] = self.kernel.hats(d + s, q).map(|hat| w * hat);
            let (left, right) = ((p - s) / p, s / p);
            sums[0] += left * near;
            sums[1] += left * far;
            sums[2] += right * near;
            sums[3] += right * far;
        });
        sums
    }

    /// ∫∫ (d+s+t)^{-1-2ν}, d > 0: constant functions on two cells.
    pub(crate) fn separate_constants(&self, p: f64, q: f64, d: f64) -> f64 {
        let (p, q) = (p.min(q), p.max(q));
        let [sum] = self.scaled([d, d.max(q)], [p, q, d], |[p, q, d]| {
            let mut sum = 0.0;
            if q <= d {
                // The closed inner integral costs two powers, a short rule less.
                let rule = GaussRules::EXACT.simple(q / d);
                GaussRules::EXACT.graded(d, p, |s, v| {
                    sum += v * q * rule.integrate(|t| self.kernel.at(d + s + q * t));
                });
            } else {
                GaussRules::EXACT.graded(d, p, |s, w| sum += w * self.kernel.whole(d + s, q));
            }
            [sum]
        });
        sum
    }

    /// ∫∫ (s+t)^{-1-2ν} for ν < 1/2: constant functions on touching cells.
    pub(crate) fn touching_constants(&self, p: f64, q: f64) -> f64 {
        let [sum] = self.scaled([p, q], [p, q], |[p, q]| {
            [(p * self.kernel.whole(p, q) + q * self.kernel.whole(q, p)) / self.kernel.one_minus]
        });
        sum
    }

    /// The quadratic integrals over two touching cells.
    pub(crate) fn touching(&self, p: f64, q: f64) -> Touching {
        let [product, difference_squared, first] = self.scaled([p, q], [p, q], |[p, q]| {
            // [(1-η)², 2η(1-η), η²] along the far side of each triangle
            let along_q = self.kernel.squares(p, q);
            let along_p = self.kernel.squares(q, p);
            let scale = 1.0 / self.kernel.three_minus;
            let far_q = 0.5 * along_q[1] + along_q[2];
            let far_p = 0.5 * along_p[1] + along_p[2];
            [
                scale * (p * far_q + q * far_p),
                scale * (p * along_q[0] + q * along_p[0]),
                scale * (p * 0.5 * along_q[1] - q * (along_p[0] + 0.5 * along_p[1])),
            ]
        });
        Touching { product, difference_squared, first }
    }

    /// ∫∫ (s/p)² (s+t)^{-1-2ν} over touching cells: a squared hat function that vanishes at the common point,
    /// times a constant.
    pub(crate) fn touching_square_constant(&self, p: f64, q: f64) -> f64 {
        let [sum] = self.scaled([p, q], [p, q], |[p, q]| {
            let along_q = self.kernel.whole(p, q);
            let along_p = self.kernel.squares(q, p)[2];
            [(p * along_q + q * along_p) / self.kernel.three_minus]
        });
        sum
    }

    /// ∫_0^p w(s) ∫_0^q (d+s+t)^{-1-2ν} dt ds, d > 0, for w = (1 − s/p)² and w = (s/p)(1 − s/p).
    pub(crate) fn weighted_against_constant(&self, p: f64, q: f64, d: f64) -> [f64; 2] {
        self.scaled([d, d.max(p)], [p, q, d], |[p, q, d]| {
            let mut sums = [0.0; 2];
            GaussRules::EXACT.graded(d, p, |s, w| {
                let value = w * self.kernel.whole(d + s, q) * ((p - s) / p);
                sums[0] += value * ((p - s) / p);
                sums[1] += value * (s / p);
            });
            sums
        })
    }

    /// ∫_0^p w(s) ∫_d^∞ (s+t)^{-1-2ν} dt ds for w = (1 − s/p)², (s/p)(1 − s/p), (s/p)²: products of hat
    /// functions with the exterior of an interval. For d = 0 only the last one is defined for all ν; the others
    /// are infinite for ν ≥ 1/2.
    pub(crate) fn against_exterior(&self, p: f64, d: f64) -> [f64; 3] {
        if d == 0.0 {
            let last = self.kernel.scaling(p) / (self.kernel.twice * self.kernel.three_minus);
            return [f64::INFINITY, f64::INFINITY, last];
        }
        self.scaled([d, d.max(p)], [p, d], |[p, d]| {
            let mut sums = [0.0; 3];
            GaussRules::EXACT.graded(d, p, |s, w| {
                let value = w * self.kernel.tail(d + s);
                let (near, far) = ((p - s) / p, s / p);
                sums[0] += value * near * near;
                sums[1] += value * near * far;
                sums[2] += value * far * far;
            });
            sums
        })
    }

    /// As [`PowerKernel::own`].
    pub(crate) fn own(&self, p: f64) -> f64 {
        self.kernel.own(p)
    }
}
