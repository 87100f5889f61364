//! The two precisions: f64 for stored quantities, f32 inside a cycle.

use std::ops::{Add, AddAssign, Div, Mul, Neg};

/// A floating-point number.
pub(super) trait Real:
    Copy
    + Default
    + Send
    + Sync
    + Add<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
{
    /// The nearest number of this precision.
    fn of(value: f64) -> Self;
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }
}

impl Real for f32 {
    fn of(value: f64) -> Self {
        value as f32
    }
}

/// out += a x + b y, entry by entry.
pub(super) fn add_two<T: Real>(out: &mut [T], (a, x): (T, &[T]), (b, y): (T, &[T])) {
    for ((out, &x), &y) in out.iter_mut().zip(x).zip(y) {
        *out += a * x + b * y;
    }
}
