//! Units that are powers of two: dividing by them is exact, and squares of the quotients neither overflow
//! nor underflow.

use super::sum::compensated;

/// The largest power of two up to |x|, for finite x ≠ 0, but at least 2^-1000, so that its reciprocal is finite;
/// 1 for x = 0.
pub(crate) fn power_of_two(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::ldexp(1.0, libm::ilogb(x).max(-1000)) }
}

/// The largest power of two up to the largest absolute value; 1 if that is zero, subnormal, or not finite.
pub(crate) fn power_below(values: &[f64]) -> f64 {
    let power = f64::from_bits(largest(values).to_bits() & f64::INFINITY.to_bits());
    if power.is_normal() { power } else { 1.0 }
}

/// max |v|; NaN is ignored.
pub(crate) fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |m: f64, v| m.max(v.abs()))
}

/// The sum Σ a_i b_i, compensated; its terms neither overflow nor underflow unless the result does.
pub(crate) fn careful_dot(a: &[f64], b: &[f64]) -> f64 {
    let (p, q) = (power_below(a), power_below(b));
    compensated(a.iter().zip(b).map(|(a, b)| (a / p) * (b / q))) * p * q
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_powers_of_two_near_what_they_measure() {
        assert_eq!([0.0, 3.0, -0.3, 1e-310].map(power_of_two), [1.0, 2.0, 0.25, 2f64.powi(-1000)]);
        assert_eq!(power_below(&[]), 1.0);
        assert_eq!(power_below(&[5.0, f64::INFINITY]), 1.0);
    }

    #[test]
    fn products_of_extreme_sizes_have_their_sum() {
        let (huge, tiny) = ([1e200, -1e200], [1e-300, 3e-300]);
        assert!((careful_dot(&huge, &tiny) / -2e-100 - 1.0).abs() < 1e-14);
        assert_eq!(careful_dot(&huge, &[1e200, 1e200]), 0.0);
    }
}
