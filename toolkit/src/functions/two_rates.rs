//! The end of a side on which ℓ decays with two rates whose difference is known.
//!
//! If u ~ δ^a with a < 0, the points y that are not deeper than the point x of depth t contribute in two ways:
//! those of about its depth give e^{−wt}, w = 1 + 2a − 2ν, and the shallower ones, where u(y) is negligible
//! compared with u(x), give ∫₀^t e^{2νs} ds e^{−(w+2ν)t}. So
//!
//! ℓ(t) = c₁ e^{−wt} + c₂ e^{−(w+2ν)t},
//!
//! with c₁ ≈ −c₂ ≈ 1/(2ν) for a small order: t e^{−wt} as long as νt is small, which grows until t = 1/w
//! although the integral is finite. For three values ℓ₀, ℓ₁, ℓ₂ at distances H, with r = e^{−2νH}, the unknown
//! q = e^{−wH} solves
//!
//! r ℓ₀ q² − (1+r) ℓ₁ q + ℓ₂ = 0,
//!
//! of which the smaller root, 2ℓ₂ divided by the sum of (1+r) ℓ₁ and the root of the discriminant, is the one
//! with c₁ > r c₂, both taken at ℓ₀. It loses no digits where c₁ and c₂ nearly cancel. With b = ℓ(T−H)/ℓ(T) =
//! e^{wH} (1 + βE), E = (e^{2νH} − 1)/(2ν), the remainder is
//!
//! ∫_T^∞ ℓ = ℓ(T) (1/w − β/(w (w+2ν))).
//!
//! The law is accepted if two triples, one twice as deep as the other, agree in w.

use crate::quadrature::Limit;

/// Smallest relative rounding error of the densities.
const ROUNDING: f64 = 4e-15;

/// Ratio of the rounding error of a density to that of a sum of some hundred densities.
const OF_ONE: f64 = 16.0;

/// Relative difference up to which the rates of the two triples agree.
const AGREED: f64 = 0.05;

/// Three values of ℓ at equal distances, the last one at the end of the part that is summed.
struct Triple {
    step: f64,
    values: [f64; 3],
}

/// The rate w with its error, and the remainder beyond the last value.
#[derive(Clone, Copy)]
struct Law {
    rate: f64,
    error: f64,
    rest: f64,
}

impl Triple {
    /// The law with difference 2ν = `gap`.
    fn law(&self, gap: f64, rounding: f64) -> Option<Law> {
        let (h, [first, second, third]) = (self.step, self.values);
        let r = (-gap * h).exp();
        // (1+r)²ℓ₁² − 4rℓ₀ℓ₂ = (1−r)²ℓ₁² + 4r(ℓ₁² − ℓ₀ℓ₂), relative to ℓ₁²
        let opposite = (-gap * h).exp_m1();
        let square = opposite * opposite + 4.0 * r * (1.0 - first / second * (third / second));
        let root = square.max(0.0).sqrt();
        let q = 2.0 * (third / second) / (1.0 + r + root);
        let rate = -q.ln() / h;
        let error =
            (8.0 * rounding / root.max(rounding.sqrt()) + 2.0 * rounding) / ((1.0 + r + root) * h);
        let spread = if gap == 0.0 { h } else { (gap * h).exp_m1() / gap };
        let beta = ((second / third) * q - 1.0) / spread;
        let rest = third / rate * (1.0 - beta / (rate + gap));
        (rate.is_finite() && rest.is_finite()).then_some(Law { rate, error, rest })
    }
}

/// The law fitted to two triples.
#[derive(Clone, Copy)]
pub(super) struct TwoRates {
    shallow: Law,
    deep: Law,
    rounding: f64,
}

impl TwoRates {
    /// The law from values ℓ(t), the last of them equidistant; `gap` = 2ν, `rounding` is the relative rounding
    /// error of a sum. `None` if there are too few values, if they vanish, or if the two triples disagree.
    pub(super) fn of(t: &[f64], densities: &[f64], gap: f64, rounding: f64) -> Option<Self> {
        let rounding = ROUNDING.max(OF_ONE * rounding);
        let last = t.len().checked_sub(1)?;
        let step = t[last] - t[last.checked_sub(1)?];
        let even =
            (1..=last).rev().take_while(|&k| (t[k] - t[k - 1] - step).abs() < 1e-6 * step).count();
        // The deep triple ends at the last value, the shallow one in the middle of the equidistant part.
        let quarter = even / 4;
        if quarter < 3 {
            return None;
        }
        let triple = |end: usize| {
            let values = [2, 1, 0].map(|back| densities[end - back * quarter]);
            let law = Triple { step: t[end] - t[end - quarter], values };
            values.iter().all(|&v| v > 0.0 && v.is_finite()).then_some(law)?.law(gap, rounding)
        };
        let (shallow, deep) = (triple(last - 2 * quarter)?, triple(last)?);
        let apart = (shallow.rate - deep.rate).abs();
        let agrees = apart <= AGREED * deep.rate.abs()
            && deep.error + shallow.error <= AGREED * deep.rate.abs();
        agrees.then_some(Self { shallow, deep, rounding })
    }

    /// w > 0: the integral is finite.
    pub(super) fn decays(self) -> bool {
        self.deep.rate > 0.0
    }

    /// The limit of an integral with the partial sum `sum`.
    pub(super) fn limit(self, sum: f64) -> Option<Limit> {
        let Self { shallow, deep, rounding } = self;
        // The rest is at most of the kind 1/w².
        let relative = 2.0 * (deep.error + (shallow.rate - deep.rate).abs()) / deep.rate;
        let error = relative * deep.rest.abs() + rounding * (sum.abs() + deep.rest.abs());
        self.decays().then_some(Limit { value: sum + deep.rest, error })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_rates_are_found_and_summed() {
        let t: Vec<f64> = (1..=48).map(|k| 14.0 * f64::from(k)).collect();
        for rate in [1e-6, 1e-4, 3e-3, 0.02] {
            for gap in [0.0, 1e-300, 1e-12, 1e-4, 1e-2] {
                let law = |t: f64| {
                    (-rate * t).exp() * if gap == 0.0 { t } else { -(-gap * t).exp_m1() / gap }
                };
                let densities: Vec<f64> = t.iter().map(|&t| law(t)).collect();
                let found = TwoRates::of(&t, &densities, gap, 0.0).unwrap();
                assert!(found.decays());
                // ∫₀^T from the whole: 1/(w (w+2ν)) less the rest
                let end = 14.0 * 48.0;
                let (shrunk, slower) = ((-rate * end).exp(), rate + gap);
                let far = if gap == 0.0 { end } else { -(-gap * end).exp_m1() / gap };
                let rest = shrunk * (1.0 / (rate * slower) + far / slower);
                let rest =
                    if gap == 0.0 { shrunk * (end / rate + 1.0 / (rate * rate)) } else { rest };
                let limit = found.limit(0.0).unwrap();
                let off = (limit.value - rest).abs();
                assert!(
                    off <= limit.error && limit.error <= 1e-4 * rest,
                    "{rate} {gap}: {limit:?} {rest:e}"
                );
            }
        }
        // Growth beyond doubt, and a power of t, are told apart.
        let grows: Vec<f64> = t.iter().map(|t| t * (1e-5 * t).exp()).collect();
        assert!(!TwoRates::of(&t, &grows, 0.0, 0.0).unwrap().decays());
        let algebraic: Vec<f64> = t.iter().map(|t| (1.0 + t).powf(-1.3)).collect();
        assert!(TwoRates::of(&t, &algebraic, 1.0, 0.0).is_none());
    }
}
