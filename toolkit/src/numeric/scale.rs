//! Units that are powers of two: division by them is exact, and squares of the quotients neither overflow nor
//! underflow.

/// The largest power of two not exceeding |x|, x ≠ 0 finite, but at least 2^-1000, so that its reciprocal is
/// finite; 1 for x = 0.
pub(crate) fn power_of_two(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::ldexp(1.0, libm::ilogb(x).max(-1000)) }
}

/// [`power_of_two`] of the largest absolute value; 1 if all values are zero.
pub(crate) fn unit_of<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    power_of_two(largest(values))
}

/// A power of two within a factor 2 of √(ab), where a, b > 0.
pub(crate) fn power_between(a: f64, b: f64) -> f64 {
    libm::ldexp(1.0, (libm::ilogb(a) + libm::ilogb(b)) / 2)
}

/// The maximum of |v|; NaN is ignored.
pub(crate) fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |m: f64, v| m.max(v.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_powers_of_two_near_what_they_measure() {
        assert_eq!([0.0, 3.0, -0.3, 1e-310].map(power_of_two), [1.0, 2.0, 0.25, 2f64.powi(-1000)]);
        assert_eq!(unit_of(&[1.0, -9.0]), 8.0);
        for (a, b) in [(1e-300, 1e300), (3.0, 5.0), (1e-8, 1.0)] {
            let quotient = power_between(a, b) / (a.sqrt() * b.sqrt());
            assert!((0.4..2.1).contains(&quotient), "{a} {b}: {quotient}");
        }
    }
}
