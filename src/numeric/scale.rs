//! Units that are powers of two: dividing by them is exact, and squares of the quotients neither overflow
//! nor underflow.

use super::sum::compensated;
pub(crate) use fractional_sobolev_numeric::scale::{largest, power_of_two};

/// The largest power of two up to the largest absolute value; 1 if that is zero, subnormal, or not finite.
pub(crate) fn power_below(values: &[f64]) -> f64 {
    let power = f64::from_bits(largest(values).to_bits() & f64::INFINITY.to_bits());
    if power.is_normal() { power } else { 1.0 }
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
    fn units_are_powers_of_two_below_what_they_measure() {
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
