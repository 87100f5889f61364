//! B(ν) = lim θ^{1/2−ν} γ_θ(ν), ν < 1/2, for a zone at an end: the Mellin transform of the problem on a half
//! line.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::{HalfLineSymbol, Order};
use std::f64::consts::PI;

/// Successive steps of the rule, each half of the previous one, until two values agree to the tolerance.
const STEPS: [f64; 6] = [1.0 / 8.0, 1.0 / 16.0, 1.0 / 32.0, 1.0 / 64.0, 1.0 / 128.0, 1.0 / 256.0];

/// Relative rounding error of the sum.
const ROUNDING: f64 = 1e-14;

/// The limit B(ν) for ν < 1/2.
///
/// # Method
///
/// B² = (1/π) ∫₀^∞ dt / ( ((ν+1/2)² + t²) C(t) ),
/// C(t) = (1/ν) [ 2 Γ(1−2ν) Re( Γ(1/2+ν+it) / Γ(1/2−ν+it) ) − 1 ],
///
/// C is the symbol of the seminorm on (0,∞). Differences of ln Γ over the distance p = 1 − 2ν are formed term
/// by term, so that there is no cancellation as ν → 1/2, where B² ≈ 3/(2π²(1−2ν)). Cost: 130 to 1000 values of
/// C.
///
/// # Errors
/// [`Error::OutOfRange`] for ν ≥ 1/2, where γ does not grow like a power of θ; [`Error::ToleranceNotMet`] if
/// the rounding error of p = 1 − 2ν, in relative terms 9e-16/p, exceeds the tolerance.
pub(super) fn end_limit(order: Order, tolerance: Tolerance) -> Result<Estimate> {
    let (limit, asked) = (reached(order, tolerance)?, tolerance.relative());
    if limit.relative_error() > asked {
        let why = "rounding of the order nu limits the accuracy of 1 - 2 nu";
        return Err(Error::not_met("limit of the Poincare constant", asked, limit, why));
    }
    Ok(limit)
}

/// B(ν) with its error, which may exceed the tolerance.
pub(super) fn reached(order: Order, tolerance: Tolerance) -> Result<Estimate> {
    Error::require("nu", order.value(), "(0, 1/2)", order.is_below_half())?;
    let (nu, p) = (order.value(), order.one_minus_twice());
    let symbol = HalfLineSymbol::new(p);
    let integrand = |t: f64| nu / (((nu + 0.5).powi(2) + t * t) * symbol.at(t)) / PI;
    // The symbol is of order p² where it matters; the order itself is rounded to f64.
    let rounding = ROUNDING + 4.0 * f64::EPSILON / p;
    let (mut square, mut points) = half_line(&integrand, STEPS[0]);
    let mut apart = f64::INFINITY;
    for &step in &STEPS[1..] {
        let (finer, more) = half_line(&integrand, step);
        (apart, square, points) = ((finer - square).abs(), finer, points + more);
        if apart <= tolerance.relative() * square {
            break;
        }
    }
    Estimate::new(square, apart + rounding * square, Work { points, ..Work::default() })?.sqrt()
}

/// ∫₀^∞ f by the double exponential rule t = exp(π/2 sinh x) with step h, for f bounded at 0 and O(t^−2) at
/// infinity.
fn half_line(f: &dyn Fn(f64) -> f64, h: f64) -> (f64, u64) {
    // t from 1e-20 to 1e20
    let last = (4.1 / h).ceil() as i32;
    let sum: f64 = (-last..=last)
        .map(|k| {
            let x = f64::from(k) * h;
            let t = (0.5 * PI * x.sinh()).exp();
            f(t) * t * 0.5 * PI * x.cosh()
        })
        .sum();
    (h * sum, 2 * u64::from(last.unsigned_abs()) + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_that_rounds_too_near_one_half_is_refused() {
        let near: Order = "1/2-1e-9".parse().unwrap();
        let refused = end_limit(near, Tolerance::balanced());
        assert!(matches!(refused, Err(Error::ToleranceNotMet { .. })), "{refused:?}");
        assert!(end_limit(near, Tolerance::fast()).is_ok());
    }
}
