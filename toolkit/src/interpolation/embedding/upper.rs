//! C(q), the best constant of H^ν(0,1) ⊂ L^q(0,1), ν ≤ 1/2: ‖u‖\_{L^q} ≤ C(q) ‖u‖_ν with the full norm (1.1);
//! (3.6), (3.10), (4.12).

use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use std::f64::consts::PI;

/// Number of terms of the maximum that are computed; the tail is bounded.
const TERMS: usize = 100_000;

/// Rounding error of products of this many factors.
const ROUNDING: f64 = 1e-10;

/// Checks ν ≤ 1/2 and 2 ≤ q ≤ 2/(1−2ν), q < ∞.
pub(super) fn check(order: Order, q: f64) -> Result<()> {
    let nu = order.value();
    Error::require("nu", nu, "(0, 1/2] for the embedding into L^q", order.offset() <= 0.0)?;
    // q = 2/(1−2ν) itself is rounded.
    let admissible =
        (2.0..=1e6).contains(&q) && q * order.one_minus_twice() <= 2.0 * (1.0 + 4.0 * f64::EPSILON);
    Error::require("q", q, "[2, min(2/(1-2 nu), 1e6)]", admissible).map(|_| ())
}

/// The critical exponent 2/(1−2ν), infinite at ν = 1/2.
pub(super) fn critical_exponent(order: Order) -> f64 {
    // + 0: 1 − 2ν may be −0.
    2.0 / (order.one_minus_twice() + 0.0)
}

/// An upper bound of C(q) for every function of H^ν(0,1), rounded up.
///
/// `value` is the bound; max_k (m_k/w_k)^{1/2}, the best bound of this method, is smaller by at most `error`:
/// rounding, and the possible contribution of the terms beyond the 100 000th. The distance to C(q) is bounded
/// by the functions of [`super::trial`].
///
/// # Method
///
/// For ν = 1/2 the range of q is 2 ≤ q < ∞, for ν < 1/2 it is 2 ≤ q ≤ 2/(1−2ν). C(q) ≥ 1, as u = 1 shows.
///
/// For all functions, the even reflection U of u to the circle (−1, 1) has ‖U‖_q = ‖u‖_q (normalised measure);
/// let c_k be its Fourier coefficients, p = 1 + 2ν ≤ 2 and K(t) = |2 sin(πt/2)/π|^{-p}. Then
/// ```text
/// ∫∫_{(−1,1)²} (U(x)−U(y))² K(x−y) = 2 ∫∫_{(0,1)²} (u(x)−u(y))² [K(x−y) + K(x+y)],
/// ```
/// K(x+y) ≤ K(x−y), because sin(π(x+y)/2) ≥ |sin(π(x−y)/2)|, and K(t) ≤ t^{-p} + b with b = (π/2)^p − 1 on
/// (0, 1), because (s/sin s)^p has positive Taylor coefficients. The left side is Σ Ω_k |c_k|² in closed
/// form. Together
/// ```text
/// ‖u‖²_ν ≥ Σ w_k |c_k|²,  w_0 = 1,  w_k = 1 − 2b + κ (R_k − R_0),  κ = π^p/(sin(πν) Γ(p)),
/// R_k = Γ(k+1/2+ν)/Γ(k+1/2−ν);
/// ```
/// at ν = 1/2 w_k = π² k + 3 − π²/2. Beckner's sharp inequality on the circle (Ann. of Math. 138 (1993)
/// 213-242) is
/// ```text
/// ‖U‖²_q ≤ Σ m_k |c_k|²,  m_k = Γ(1/q) Γ(k+1−1/q) / (Γ(1−1/q) Γ(k+1/q)).
/// ```
/// Hence C(q)² ≤ max_k m_k/w_k. m_k/R_k decreases with k, which bounds the tail. If the maximum is 1, C(q) = 1
/// exactly. Cost: one pass over k, up to the term from which the tail is below the maximum.
///
/// # Errors
/// [`Error::OutOfRange`] outside the domain.
pub(super) fn upper_bound(order: Order, q: f64) -> Result<Estimate> {
    check(order, q)?;
    let (nu, below) = (order.value(), -order.offset());
    let p = 1.0 + 2.0 * nu;
    let kappa = PI.powf(p) / ((PI * nu).sin() * libm::tgamma(p));
    // R_0 = Γ(1/2+ν)/Γ(1/2−ν), R_1 = R_0 (1/2+ν)/(1/2−ν) = Γ(3/2+ν)/Γ(3/2−ν): no pole at ν = 1/2.
    let first = libm::tgamma(1.5 + nu) / libm::tgamma(1.0 + below);
    let start = first * below / (0.5 + nu);
    let shift = 1.0 - 2.0 * ((0.5 * PI).powf(p) - 1.0) - kappa * start;
    // R/(A + κR) rises to 1/κ, or falls from its value here.
    let tail = |r: f64, m: f64| (m / r) * (1.0 / kappa).max(r / (shift + kappa * r));
    let (mut r, mut m, mut largest, mut terms) = (first, q - 1.0, 1.0f64, 1);
    while terms < TERMS && tail(r, m) > largest {
        largest = largest.max(m / (shift + kappa * r));
        let j = terms as f64;
        r *= (j + 0.5 + nu) / (j + below);
        m *= (j + 1.0 - 1.0 / q) / (j + 1.0 / q);
        terms += 1;
    }
    let bound = largest.max(tail(r, m));
    let work = Work { points: terms as u64, ..Work::default() };
    // Where nothing exceeds the constant function the bound is attained by it.
    if bound <= 1.0 {
        return Estimate::new(1.0, 0.0, work);
    }
    let value = (bound * (1.0 + ROUNDING)).sqrt();
    Estimate::new(value, value - largest.sqrt() + ROUNDING * value, work)
}
