//! Seminorms of x^a for small |a|, where the values of x^a do not retain the digits of its variation.
//!
//! With x = ty and t = e^{−s}, |x^a|²_ν = a²/(a − ν + 1/2) ∫₀^∞ s² φ(as)² e^{−s} (1 − e^{−s})^{−1−2ν} ds on (0,
//! 1), φ(z) = (1 − e^{−z})/z = 1 − z/2 + ...: no nearly equal numbers are subtracted for any a, and as a → 0
//! the integral tends to that of ln x. The trapezoidal rule in s = exp(τ − e^{−τ}) converges exponentially
//! (Takahasi & Mori, Publ. RIMS 9 (1974) 721-741); the same rule with twice the step gives the error. Cost: 305
//! points.

use super::order::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// Largest |a| for which this method is used.
const NEARLY: f64 = 1.0 / 256.0;
/// Ends of the rule in τ, where the integrand is below 1e-39 of its value at s = 1, and its step.
const ENDS: [i32; 2] = [-144, 160];
const STEP: f64 = 1.0 / 32.0;
/// Relative rounding error of the integrand and of the sum, whose terms are all positive.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// x^a, 0 < |a| ≤ 1/256.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearlyOne(f64);

impl NearlyOne {
    /// The method for x^a; `None` if x^a is far from 1, or equal to 1.
    pub(super) fn new(a: f64) -> Option<Self> {
        (a != 0.0 && a.abs() <= NEARLY).then_some(Self(a))
    }

    /// The seminorm |x^a|_ν.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for a ≤ ν − 1/2; [`Error::ToleranceNotMet`] if the value is subnormal.
    pub(super) fn seminorm(self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let found = self.value(order)?;
        met("seminorm", found, tolerance)
    }

    /// The norm ||x^a||_ν, the square of which is 1/(1 + 2a) + |x^a|²_ν.
    ///
    /// # Errors
    /// As [`NearlyOne::seminorm`].
    pub(super) fn norm(self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let seminorm = self.value(order)?;
        let norm = (1.0 / (1.0 + 2.0 * self.0)).sqrt().hypot(seminorm.value);
        // d||u|| = |u|_ν d|u|_ν / ||u||
        let error = seminorm.error * ((seminorm.value + seminorm.error) / norm).min(1.0);
        met("norm", Estimate::new(norm, error + ROUNDING * norm, seminorm.work)?, tolerance)
    }

    fn value(self, order: Order) -> Result<Estimate> {
        let Self(a) = self;
        let gap = a - order.offset();
        if gap <= 0.0 {
            let why = "x^a is in H^nu(0,1) only for a > nu - 1/2";
            return Err(Error::InfiniteNorm { order: order.value(), why });
        }
        let (mut even, mut odd) = (0.0, 0.0);
        for k in ENDS[0]..=ENDS[1] {
            let term = integrand(a, order, STEP * f64::from(k));
            *if k % 2 == 0 { &mut even } else { &mut odd } += term;
        }
        let [coarse, fine] = [2.0 * STEP * even, STEP * (even + odd)];
        let work = Work { points: u64::from(ENDS[0].abs_diff(ENDS[1])) + 1, ..Work::default() };
        let integral = Estimate::new(fine, (fine - coarse).abs() + ROUNDING * fine, work)?;
        let found = integral.sqrt()?.times(a.abs() / gap.sqrt())?;
        // What is subnormal is rounded.
        Estimate::new(found.value, found.error + f64::MIN_POSITIVE * f64::EPSILON, found.work)
    }
}

/// The integrand in τ, ds = s (1 + e^{−τ}) dτ.
fn integrand(a: f64, order: Order, tau: f64) -> f64 {
    let s = (tau - (-tau).exp()).exp();
    let slope = if a * s == 0.0 { 1.0 } else { -(-a * s).exp_m1() / (a * s) };
    // s² (1 − e^{−s})^{−1−2ν} with −1 − 2ν = −2 − 2 (ν − 1/2)
    let distance = -(-s).exp_m1();
    let kernel = (s / distance).powi(2) * distance.powf(-2.0 * order.offset());
    slope * slope * kernel * (-s).exp() * s * (1.0 + (-tau).exp())
}

fn met(what: &'static str, found: Estimate, tolerance: Tolerance) -> Result<Estimate> {
    if found.error <= tolerance.relative() * found.value {
        return Ok(found);
    }
    Err(Error::not_met(
        what,
        tolerance.relative(),
        found,
        "rounding of the exponent and of the value limits the accuracy",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Function, closed_forms};

    /// a, ν − 1/2, |x^a|_ν rounded to binary64: quadrature of (1 − t^a)² (1 − t)^{−1−2ν} with 40 digits; the Beta
    /// function with 80 digits gives the same where a is above 1e-20 and ν is not 1/2.
    const REFERENCES: [(f64, f64, f64); 14] = [
        (1e-300, -0.25, 3.308239505263967e-300),
        (1e-300, 0.0, 1.8137993642342178e-150),
        (1e-300, 5e-301, 2.5650996603237283e-150),
        (1e-160, 0.0, 1.813799364234218e-80),
        (1e-16, -0.01, 1.8055379946415934e-15),
        (1e-12, 0.0, 1.8137993642322297e-06),
        (1e-12, -1e-16, 1.8137086810651988e-06),
        (1e-12, 9e-13, 5.735737209541572e-06),
        (-1e-12, -0.25, 3.3082395052747023e-12),
        (1e-6, 0.0, 0.0018137973760511913),
        (-1e-6, -2e-6, 0.0018137996781978122),
        (3e-3, 1e-3, 0.12133141459762853),
        (-3e-3, -0.25, 0.010022278630088597),
        (1e-300, -0.4375, 2.3784480434146776e-300),
    ];

    #[test]
    fn powers_next_to_the_constant_have_their_norms() {
        for (a, offset, exact) in REFERENCES {
            let (order, power) = (Order::half_plus(offset).unwrap(), Function::power(a).unwrap());
            let found = power.seminorm(order, 1e-12).unwrap();
            let off = (found.value - exact).abs();
            assert!(
                off <= found.error && found.relative_error() < 2e-14,
                "{a} {offset}: {found:?}, {exact}"
            );
            let closed = closed_forms::power_seminorm(a, order).unwrap();
            let apart = (closed.value - found.value).abs();
            assert!(apart <= closed.error + found.error, "{a} {offset}: {closed:?} {found:?}");
            let norm = power.norm(order, 1e-12).unwrap();
            let both = (exact * exact + 1.0 / (1.0 + 2.0 * a)).sqrt();
            assert!((norm.value - both).abs() <= norm.error, "{a} {offset}: {norm:?}, {both}");
        }
    }

    #[test]
    fn the_rule_meets_the_series_wherever_it_is_used() {
        for k in 0..=320 {
            for a in [1.0, -1.0].map(|sign| sign * NEARLY * 10f64.powf(-f64::from(k) / 20.0)) {
                for offset in [-0.5 + 1e-9, -0.3, -0.01, -1e-3, 0.0, 0.5 * a, 0.999 * a] {
                    let order = Order::half_plus(offset).unwrap();
                    let (found, closed) =
                        (NearlyOne(a).value(order), closed_forms::power_seminorm(a, order));
                    match (found, closed) {
                        (Ok(found), Ok(closed)) => {
                            let apart = (found.value - closed.value).abs();
                            assert!(
                                apart <= found.error + closed.error,
                                "{a} {offset}: {found:?} {closed:?}"
                            );
                        }
                        (Err(Error::InfiniteNorm { .. }), Err(Error::InfiniteNorm { .. })) => {}
                        other => panic!("{a} {offset}: {other:?}"),
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_infinite_or_without_digits_is_refused() {
        let power = |a: f64| Function::power(a).unwrap();
        assert!(matches!(power(1e-300).seminorm(0.6, 1e-6), Err(Error::InfiniteNorm { .. })));
        assert!(matches!(power(-1e-300).norm(0.5, 1e-6), Err(Error::InfiniteNorm { .. })));
        let subnormal = power(5e-324).seminorm(0.25, 1e-6).unwrap_err();
        assert!(
            subnormal.best().is_some_and(|best| (best.value - 1.65e-323).abs() <= best.error),
            "{subnormal}"
        );
        assert!((power(5e-324).norm(0.25, 1e-6).unwrap().value - 1.0).abs() < 1e-15);
    }
}
