//! The two precisions: f64 for stored quantities, f32 inside a cycle.

use std::ops::{Add, AddAssign, Mul};

/// A floating-point number.
pub(super) trait Real:
    Copy + Default + Send + Sync + Add<Output = Self> + Mul<Output = Self> + AddAssign
{
    /// The nearest number of this precision.
    fn of(value: f64) -> Self;

    /// −self / divisor.
    fn over_negated(self, divisor: Self) -> Self;
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }

    fn over_negated(self, divisor: Self) -> Self {
        -self / divisor
    }
}

impl Real for f32 {
    fn of(value: f64) -> Self {
        value as f32
    }

    fn over_negated(self, divisor: Self) -> Self {
        -self / divisor
    }
}

/// out += a x + b y, entry by entry.
pub(super) fn add_two<T: Real>(out: &mut [T], (a, x): (T, &[T]), (b, y): (T, &[T])) {
    for ((out, &x), &y) in out.iter_mut().zip(x).zip(y) {
        *out += a * x + b * y;
    }
}
