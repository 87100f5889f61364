//! The basis of the trial functions of [`super::strong_form`], and the operator A on it.
//!
//! On s ∈ (0, 1), s the distance from the free end, with the zone from 1 on, (ν)_k the Pochhammer symbols and
//! P_i the Legendre polynomials:
//!
//! * (1−s)^ν (1 + ν s + ... + (ν)_12 s¹²/12!), flat at 0: 1 minus the remainder of a Taylor series;
//! * (1−s)^ν s^β P_i(2s−1), β ∈ (1, 2) the first exponent at a free end, A s^β = 0 on the half line;
//! * (1−s)^{ν+j} ((1−s)^{j(2ν−1)} − 1)/(2ν−1) s⁴ P_i(2s−1), the singular response of the zone; at ν = 1/2
//!   the quotient is j ln(1−s).
//!
//! In y = ln(s/(1−s)) the pairs y ± d are combined: their sum is d^{1−2ν} times an analytic function,
//! integrated by a rule for that power on (0, 1) and Gauss rules beyond. Differences near the free end are
//! computed from the remainder of the series, without the 1. Cost: two thousand values of the basis per point.

use crate::error::Result;
use crate::numeric::parallel;
use crate::numeric::{legendre, search::sign_change};
use crate::poincare::slopes::kernel::exp_quotient;
use crate::quadrature::Rule;
use std::f64::consts::PI;

/// Degrees of the three families, and the number of powers in the response of the zone.
const SMOOTH: usize = 14;
const RETURNED: usize = 4;
const POWERS: usize = 2;
pub(super) const BASIS: usize = 1 + SMOOTH + POWERS * RETURNED;
/// Number of terms of the Taylor series of (1−s)^{−ν}, and of its tail for s < 1/2.
const TAYLOR: usize = 12;
const TAIL: usize = 48;
/// y runs over panels of length 1 from −LEFT to RIGHT; outside, s or 1 − s is below 3e-9.
pub(super) const LEFT: i32 = 20;
const RIGHT: i32 = 24;
/// Number of points per panel of the outer and the inner integrals; inner integrals end where e^{−d} is
/// negligible.
const OUTER: usize = 10;
const INNER: usize = 12;
const REACH: f64 = 38.0;

pub(super) type Row = [f64; BASIS];

/// A point of the outer rule: v and A v, without the part from the end of the zone, for every basis function.
pub(super) struct Collocation {
    pub(super) s: f64,
    pub(super) complement: f64,
    pub(super) weight: f64,
    pub(super) values: Row,
    pub(super) images: Row,
}

/// All points of the outer rule for one order.
pub(super) fn collocate(nu: f64, p: f64) -> Result<Vec<Collocation>> {
    let basis = Basis { nu, p, exponent: free_exponent(nu) };
    let inner = inner_rule(nu)?;
    let outer = Rule::gauss_legendre(OUTER)?;
    let places: Vec<(f64, f64)> = (-LEFT..RIGHT)
        .flat_map(|k| outer.iter().map(move |(t, w)| (f64::from(k) + t, w)))
        .collect();
    Ok(parallel::over(&places, |&(y, w)| basis.collocate(y, w, &inner)))
}

/// The basis of v.
struct Basis {
    nu: f64,
    /// 2ν − 1.
    p: f64,
    exponent: f64,
}

/// (s, 1 − s) at y = ln(s/(1−s)).
fn place(y: f64) -> (f64, f64) {
    (1.0 / (1.0 + (-y).exp()), 1.0 / (1.0 + y.exp()))
}

impl Basis {
    /// The values of the basis at (s, 1−s), with 1 subtracted from the first function.
    fn values(&self, s: f64, c: f64) -> Row {
        let mut row = [0.0; BASIS];
        let at_zone = c.powf(self.nu);
        row[0] = self.flat(s, at_zone);
        let mut polynomials = [0.0; SMOOTH];
        legendre::fill(&mut polynomials, 2.0 * s - 1.0);
        let smooth = at_zone * s.powf(self.exponent);
        row[1..=SMOOTH].iter_mut().zip(polynomials).for_each(|(r, q)| *r = smooth * q);
        let logarithm = c.ln();
        for j in 0..POWERS {
            let power = (j + 1) as f64;
            let back = at_zone
                * s.powi(4)
                * (power * logarithm).exp()
                * exp_quotient(self.p, power * logarithm);
            let start = 1 + SMOOTH + j * RETURNED;
            row[start..start + RETURNED]
                .iter_mut()
                .zip(polynomials)
                .for_each(|(r, q)| *r = back * q);
        }
        row
    }

    /// (1−s)^ν Σ_{k ≤ TAYLOR} (ν)_k s^k/k! − 1, which is −(1−s)^ν times the remainder of the series.
    fn flat(&self, s: f64, at_zone: f64) -> f64 {
        let (mut term, mut sum) = (1.0, 1.0);
        for k in 1..=TAYLOR {
            term *= s * (self.nu + k as f64 - 1.0) / k as f64;
            sum += term;
        }
        if s >= 0.5 {
            return at_zone * sum - 1.0;
        }
        let mut rest = 0.0;
        for k in TAYLOR + 1..=TAYLOR + TAIL {
            term *= s * (self.nu + k as f64 - 1.0) / k as f64;
            rest += term;
        }
        -at_zone * rest
    }

    /// The values and images of the basis at y; the weight is that of ds.
    fn collocate(&self, y: f64, weight: f64, inner: &[(f64, f64)]) -> Collocation {
        let (s, c) = place(y);
        let mut values = self.values(s, c);
        let mut images = [0.0; BASIS];
        for &(d, w) in inner {
            for (sign, other) in [(1.0, place(y + d)), (-1.0, place(y - d))] {
                if (sign > 0.0 && y + d > REACH) || (sign < 0.0 && d > REACH) {
                    continue;
                }
                let (t, b) = other;
                // |s − t|/d, from the nearer of the two ends of each.
                let product = if sign > 0.0 { s * b } else { t * c };
                let stretch = product * (d.exp_m1() / d);
                let factor = w * stretch.powf(-1.0 - 2.0 * self.nu) * t * b;
                let at_other = self.values(t, b);
                for k in 0..BASIS {
                    images[k] += factor * (values[k] - at_other[k]);
                }
            }
        }
        values[0] += 1.0;
        Collocation { s, complement: c, weight: weight * s * c, values, images }
    }
}

/// Points d > 0 and weights for ∫ d^{−1−2ν} F(d) dd, F(d) = O(d²) analytic.
fn inner_rule(nu: f64) -> Result<Vec<(f64, f64)>> {
    let near = Rule::power_weight(INNER, 2.0 - 2.0 * nu)?;
    let far = Rule::gauss_legendre(INNER)?;
    let mut rule: Vec<(f64, f64)> = near.iter().map(|(d, w)| (d, w / (d * d))).collect();
    for k in 1..(f64::from(LEFT) + REACH) as i32 {
        rule.extend(far.iter().map(|(t, w)| {
            let d = f64::from(k) + t;
            (d, w * d.powf(-1.0 - 2.0 * nu))
        }));
    }
    Ok(rule)
}

/// Distance from ν = 1/2 beyond which the formula for the exponent is accurate; it need not be exact.
const CANCELLED: f64 = 1e-6;

/// The exponent β in (max(1, 2ν), min(2, 1+2ν)) with A s^β = 0 on the half line, the root of 1/(2ν) + Γ(−2ν)
/// Γ(1+β)/Γ(1+β−2ν) (1 − sin πβ / sin π(2ν−β)) = 0.
fn free_exponent(nu: f64) -> f64 {
    let nu = if (nu - 0.5).abs() < CANCELLED { 0.5 + CANCELLED } else { nu };
    let symbol = |beta: f64| {
        let ratio = libm::tgamma(1.0 + beta) / libm::tgamma(1.0 + beta - 2.0 * nu);
        let turned = 1.0 - (PI * beta).sin() / (PI * (2.0 * nu - beta)).sin();
        0.5 / nu + libm::tgamma(-2.0 * nu) * ratio * turned
    };
    let (low, high) = ((2.0 * nu).max(1.0), (1.0 + 2.0 * nu).min(2.0));
    let (below, above) = sign_change(low, high, 1e-14, |beta| symbol(beta) > 0.0);
    0.5 * (below + above)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exponent_of_a_free_end_at_one_half_is_a_root_of_the_tangent() {
        let root = PI * free_exponent(0.5);
        assert!((root.tan() - root).abs() < 1e-3, "{root}");
        assert!((free_exponent(0.99) - 1.98995).abs() < 1e-5);
    }
}
