//! Units that are powers of two: division by them is exact, and squares of the quotients neither overflow nor
//! underflow.

pub(crate) use fractional_sobolev_numeric::scale::{largest, power_of_two};

/// [`power_of_two`] of the largest absolute value; 1 if all values are zero.
pub(crate) fn unit_of<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    power_of_two(largest(values))
}

/// A power of two within a factor 2 of √(ab), where a, b > 0.
pub(crate) fn power_between(a: f64, b: f64) -> f64 {
    libm::ldexp(1.0, (libm::ilogb(a) + libm::ilogb(b)) / 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_lie_near_what_they_measure() {
        assert_eq!(unit_of(&[1.0, -9.0]), 8.0);
        for (a, b) in [(1e-300, 1e300), (3.0, 5.0), (1e-8, 1.0)] {
            let quotient = power_between(a, b) / (a.sqrt() * b.sqrt());
            assert!((0.4..2.1).contains(&quotient), "{a} {b}: {quotient}");
        }
    }
}
