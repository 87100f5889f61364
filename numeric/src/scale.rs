//! Units that are powers of two: division by them is exact, and squares of the quotients neither overflow nor
//! underflow.

/// The largest power of two not exceeding |x|, x ≠ 0 finite, but at least 2^-1000, so that its reciprocal is
/// finite; 1 for x = 0.
#[inline]
pub fn power_of_two(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::ldexp(1.0, libm::ilogb(x).max(-1000)) }
}

/// The maximum of |v|; NaN is ignored.
pub fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |m: f64, v| m.max(v.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_powers_of_two_near_what_they_measure() {
        assert_eq!([0.0, 3.0, -0.3, 1e-310].map(power_of_two), [1.0, 2.0, 0.25, 2f64.powi(-1000)]);
        assert_eq!(largest(&[1.0, -3.0, f64::NAN]), 3.0);
    }
}
