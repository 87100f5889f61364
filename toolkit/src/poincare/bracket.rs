//! Explicit lower and upper bounds for the law γ_θ(1/2)² ~ (3/(2π²)) ln(1/θ).
//!
//! With t = −ln x, v(t) = u(e^{−t}), L = ln(1/θ) and W(r) = ∫₀^∞ (v(t+r) − v(t))² dt,
//!
//! |u|²_{1/2} = 2 ∫₀^∞ W(r) / (4 sinh²(r/2)) dr.
//!
//! **Lower bound.** The ramp v = 1 − min(t, L)/L vanishes on the zone. W = r²/L − 2r³/(3L²) for r ≤ L and L/3
//! for r ≥ L, so ‖u‖₀² = 1 − 2/L + 2(1 − θ)/L² and |u|² ≤ 2π²/(3L) − 8ζ(3)/L² + 4θ/(1−θ)² (1/L + 2/L²).
//!
//! **Upper bound.** γ² ≤ γ₁² + N², N the dual norm of D(u) = mean u − mean_(0,θ) u = ∫ e^{−t} (v(t) − v(t+L))
//! dt. For r ≤ 2L let k ≥ 1 be the integer nearest to L/r. The Cauchy-Schwarz inequality along t, t + r, ...,
//! t + kr gives W(r) ≥ (r/k) Δ², Δ the difference of the means of v over (0, r) and (kr, kr + r). Δ differs from
//! D(u) by the functional ∫ (1_{(0,r)}/r − e^{−t}) v dt, which occurs twice, once shifted, and whose norm in
//! L²(0,1) is ((e^r − 1)/r² − 1)^{1/2}, and by the shift of a mean by at most r/2, with norm (e^{r/2} −
//! 1)^{1/2}. All three depend only on u − mean u, so that with |u| = 1
//!
//! |Δ| ≥ D(u) − C(r),  C(r) = γ₁ [2 ((e^r − 1)/r² − 1)^{1/2} + (e^{r/2} − 1)^{1/2}],
//! 1 ≥ ∫₀^{2L} (N − C(r))₊² r² / (2 sinh²(r/2)) dr / (L + r/2),
//!
//! which bounds N, since the right side grows with it. ∫₀^∞ r²/(2 sinh²(r/2)) dr = 2π²/3 gives the law.

use super::constant::gamma;
use super::constraint::Constraint;
use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::Tolerance;
use crate::numeric::search::{golden_section, sign_change};
use crate::quadrature::Rule;
use std::f64::consts::PI;

/// ζ(3), Apéry's constant.
const ZETA_3: f64 = 1.202_056_903_159_594_3;
/// Number of panels in ln r and of points of the rule on each: the integrand is smooth between its double
/// zeros.
const PANELS: usize = 64;
const POINTS: usize = 12;
/// Smallest and largest r: outside this range the integrand is below the rounding error of the rest.
const SHORTEST: f64 = 1e-30;
const LONGEST: f64 = 120.0;
/// Relative amount by which the upper bound is raised to account for rounding in the quadrature and the search.
const ROUNDED_UP: f64 = 1e-9;

/// Lower and upper bound of γ_θ(1/2)² at L = ln(1/θ): the square of the quotient of the ramp, and γ₁² + N² with
/// N bounded by the inequality along chains.
pub(super) fn bracket(log: f64) -> Result<[f64; 2]> {
    Error::require("ln(1/theta)", log, "[1, 1e15]", (1.0..=1e15).contains(&log))?;
    let whole = gamma(Order::HALF, Constraint::mean_zero(), Tolerance::balanced())?.constant;
    let whole = whole.value + whole.error;
    let dual = Chains::new(whole, log)?.dual_norm() * (1.0 + ROUNDED_UP);
    Ok([ramp(log), whole * whole + dual * dual])
}

/// A lower bound of (‖u‖₀/|u|_{1/2})² for the ramp.
fn ramp(log: f64) -> f64 {
    let theta = (-log).exp();
    let norm = 1.0 - 2.0 / log + 2.0 * (1.0 - theta) / (log * log);
    let tail = 4.0 * theta / (1.0 - theta).powi(2) * (1.0 + 2.0 / log) / log;
    norm / (2.0 * PI * PI / (3.0 * log) - 8.0 * ZETA_3 / (log * log) + tail)
}

/// The inequality along chains with steps r.
struct Chains {
    whole: f64,
    log: f64,
    rule: Rule,
    /// The point at which C(r) is smallest.
    least: f64,
}

impl Chains {
    fn new(whole: f64, log: f64) -> Result<Self> {
        let rule = Rule::gauss_legendre(POINTS)?;
        let least = golden_section(0.1f64.ln(), 4f64.ln(), 1e-6, |s| loss(whole, s.exp())).exp();
        Ok(Self { whole, log, rule, least })
    }

    /// L ∫ (N − C)₊² r²/(2 sinh²(r/2)) dr / (L + r/2) over those r ≤ 2L with N > C(r).
    fn energy(&self, dual: f64) -> f64 {
        let longest = LONGEST.min(2.0 * self.log);
        let room = |s: f64| dual - loss(self.whole, s.exp());
        let middle = self.least.min(longest).ln();
        if room(middle) <= 0.0 {
            return 0.0;
        }
        let (_, first) = sign_change(SHORTEST.ln(), middle, 0.0, |s| room(s) > 0.0);
        let (last, _) = sign_change(middle, longest.ln(), 0.0, |s| room(s) <= 0.0);
        let width = (last - first) / PANELS as f64;
        let panel = |k: usize| {
            let start = first + k as f64 * width;
            width * self.rule.integrate(|z| self.density(dual, (start + width * z).exp()))
        };
        (0..PANELS).map(panel).sum()
    }

    /// The integrand times r, for the variable ln r.
    fn density(&self, dual: f64, r: f64) -> f64 {
        let above = (dual - loss(self.whole, r)).max(0.0);
        let quotient = r / (0.5 * r).sinh();
        above * above * 0.5 * quotient * quotient * self.log / (self.log + 0.5 * r) * r
    }

    /// The value of N for which the inequality becomes an equality.
    fn dual_norm(&self) -> f64 {
        let mut high = 1.0 + self.log.sqrt();
        while self.energy(high) < self.log {
            high *= 2.0;
        }
        sign_change(0.0, high, 0.0, |dual| self.energy(dual) >= self.log).1
    }
}

/// The value C(r).
fn loss(whole: f64, r: f64) -> f64 {
    let window = (r.exp_m1() / (r * r) - 1.0).max(0.0);
    whole * (2.0 * window.sqrt() + (0.5 * r).exp_m1().sqrt())
}
