//! Sizes of vectors.

/// max |v|; NaN does not count.
pub fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |m: f64, v| m.max(v.abs()))
}

/// The power of two at or below |x|, 1 for 0.
pub(crate) fn power_of_two(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::ldexp(1.0, libm::ilogb(x).max(-1000)) }
}

/// [`power_of_two`] of the largest absolute value.
pub(crate) fn unit_of<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    power_of_two(largest(values))
}
