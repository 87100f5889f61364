//! The end of a side on which ℓ decays with two rates whose difference is known.
//!
//! If u ~ δ^a with a < 0, the points y that are not deeper than the point x of depth t contribute in two ways:
//! those of about its depth give e^{−wt}, w = 1 + 2a − 2ν, and the shallower ones, where u(y) is negligible
//! compared with u(x), give ∫₀^t e^{2νs} ds e^{−(w+2ν)t}. So
//!
//! ℓ(t) = c₁ e^{−wt} + c₂ e^{−(w+2ν)t},
//!
//! with c₁ ≈ −c₂ ≈ 1/(2ν) for a small order: t e^{−wt} as long as νt is small, which grows until t = 1/w
//! although the integral is finite. The integrals over parts of equal length H follow the same law, with the roundings of
//! some hundred values in each. For three of them, B₀, B₁, B₂ one after the other, with r = e^{−2νH}, the unknown
//! q = e^{−wH} solves
//!
//! r B₀ q² − (1+r) B₁ q + B₂ = 0,
//!
//! of which the smaller root, 2B₂ divided by the sum of (1+r) B₁ and the root of the discriminant, is the one
//! with c₁ > r c₂, both taken at B₀. It loses no digits where c₁ and c₂ nearly cancel. If B₀, B₁, B₂ have independent
//! relative errors ε, the root ρ of ((1+r)² B₁² − 4r B₀B₂)/B₁² is off by at most 8rε/ρ, and the rate w by
//!
//! |δw| H = |δq|/q ≤ 2ε + 8rε/(ρ (1 + r + ρ)).
//!
//! The sum of the parts that follow is that of two geometric series,
//!
//! ∫_T^∞ ℓ = q/(1−q) (B₂ − r (qB₁ − B₂)/(1 − rq)).
//!
//! The law is accepted if two triples, one deeper than the other by 2H, agree in w.

use crate::quadrature::Limit;

/// Smallest relative rounding error of an integral over a part.
const ROUNDING: f64 = 4e-15;

/// Relative difference up to which the rates of the two triples agree.
const AGREED: f64 = 0.05;

/// Partial integrals: ∫₀^t ℓ and its rounding error, from the rounding of the values.
#[derive(Clone, Copy)]
pub(super) struct Partial {
    pub(super) end: f64,
    pub(super) sum: f64,
    pub(super) rounding: f64,
}

/// Integrals over three parts of equal length, one after the other, and their largest relative rounding error.
struct Triple {
    step: f64,
    values: [f64; 3],
    rounding: f64,
}

/// The rate w with its error, and the remainder beyond the last value.
#[derive(Clone, Copy)]
struct Law {
    rate: f64,
    error: f64,
    rest: f64,
}

impl Triple {
    /// The three parts of `count` cells each that end at the partial integral `last`.
    fn ending(partials: &[Partial], last: usize, count: usize) -> Self {
        let at = |back: usize| partials[last - back * count];
        let value = |back: usize| at(back).sum - at(back + 1).sum;
        // Of the values in the part, and of the sums of which it is the difference.
        let rounding = |back: usize| {
            let squares = at(back).rounding.powi(2) - at(back + 1).rounding.powi(2);
            (squares.max(0.0).sqrt() + f64::EPSILON * at(back).sum.abs()) / value(back)
        };
        Self {
            step: at(0).end - at(1).end,
            values: [2, 1, 0].map(value),
            rounding: [0, 1, 2].map(rounding).into_iter().fold(ROUNDING, f64::max),
        }
    }

    /// The law with difference 2ν = `gap`; `None` unless all values are positive.
    fn law(&self, gap: f64) -> Option<Law> {
        let Self { step: h, values: [first, second, third], rounding } = *self;
        if !self.values.iter().all(|&value| value > 0.0 && value.is_finite()) {
            return None;
        }
        let r = (-gap * h).exp();
        // (1+r)²B₁² − 4rB₀B₂ = (1−r)²B₁² + 4r(B₁² − B₀B₂), relative to B₁²
        let opposite = (-gap * h).exp_m1();
        let square = opposite * opposite + 4.0 * r * (1.0 - first / second * (third / second));
        let root = square.max(0.0).sqrt();
        let q = 2.0 * (third / second) / (1.0 + r + root);
        let rate = -q.ln() / h;
        let of_root = 8.0 * r * rounding / (root.max(rounding.sqrt()) * (1.0 + r + root));
        let error = (2.0 * rounding + of_root) / h;
        let slower = r * (q * second - third) / (1.0 - r * q);
        let rest = q / -(-rate * h).exp_m1() * (third - slower);
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
    /// The law from partial integrals, the last of them equidistant; `gap` = 2ν. `None` if there are too few of them, if
    /// parts vanish, or if the two triples disagree.
    pub(super) fn of(partials: &[Partial], gap: f64) -> Option<Self> {
        let last = partials.len().checked_sub(1)?;
        let width = |k: usize| partials[k].end - partials[k - 1].end;
        let step = if last > 0 { width(last) } else { return None };
        let even = (1..=last).rev().take_while(|&k| (width(k) - step).abs() < 1e-6 * step).count();
        // The deep triple ends at the last value, the shallow one begins where the equidistant part does.
        let fifth = even / 5;
        if fifth < 2 {
            return None;
        }
        let [shallow, deep] =
            [last - 2 * fifth, last].map(|end| Triple::ending(partials, end, fifth));
        let rounding = deep.rounding;
        let (shallow, deep) = (shallow.law(gap)?, deep.law(gap)?);
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
    use crate::quadrature::Rule;

    #[test]
    fn two_rates_are_found_and_summed() {
        let rule = Rule::gauss_legendre(24).unwrap();
        let partials = |law: &dyn Fn(f64) -> f64| -> Vec<Partial> {
            let mut sum = 0.0;
            let part = |k: i32| {
                let from = 14.0 * f64::from(k);
                sum += 14.0 * rule.integrate(|t| law(from + 14.0 * t));
                Partial { end: from + 14.0, sum, rounding: 0.0 }
            };
            (0..48).map(part).collect()
        };
        for rate in [1e-6, 1e-4, 3e-3, 0.02] {
            for gap in [0.0, 1e-300, 1e-12, 1e-4, 1e-2] {
                let law = |t: f64| {
                    (-rate * t).exp() * if gap == 0.0 { t } else { -(-gap * t).exp_m1() / gap }
                };
                let found = TwoRates::of(&partials(&law), gap).unwrap();
                assert!(found.decays());
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
        let grows = partials(&|t| t * (1e-5 * t).exp());
        assert!(!TwoRates::of(&grows, 0.0).unwrap().decays());
        assert!(TwoRates::of(&partials(&|t| (1.0 + t).powf(-1.3)), 1.0).is_none());
    }
}
