//! A number with a bound on its error, and arithmetic that propagates the bound.

use fractional_sobolev::Estimate;
use signorini::rates::ConvergenceOrder;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with an absolute error bound; both are NaN if there is no number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// The number.
    pub value: f64,
    /// The absolute error bound, ≥ 0.
    pub error: f64,
}

impl Measured {
    /// A number with its error.
    pub fn new(value: f64, error: f64) -> Self {
        Self { value, error: error.abs() }
    }

    /// No number: every comparison with it is undecided.
    pub const NONE: Self = Self { value: f64::NAN, error: f64::NAN };

    /// |v|.
    #[must_use]
    pub fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }

    /// v², with error 2|v|u + u².
    #[must_use]
    pub fn squared(self) -> Self {
        self * self
    }

    /// 1/v, with error u/(|v| (|v| − u)), infinite for u ≥ |v|.
    #[must_use]
    pub fn recip(self) -> Self {
        Self::from(1.0) / self
    }

    /// √v, with error u/√v (at most √u).
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.value.max(0.0).sqrt();
        let error = if self.error == 0.0 { 0.0 } else { (self.error / root).min(self.error.sqrt()) };
        Self { value: root, error }
    }

    /// ln v, with error −ln(1 − u/v) for u < v.
    #[must_use]
    pub fn ln(self) -> Self {
        Self { value: self.value.ln(), error: -(-self.error / self.value).ln_1p() }
    }
}

impl From<f64> for Measured {
    fn from(value: f64) -> Self {
        Self { value, error: 0.0 }
    }
}

impl From<usize> for Measured {
    fn from(value: usize) -> Self {
        (value as f64).into()
    }
}

impl From<(f64, f64)> for Measured {
    fn from((value, error): (f64, f64)) -> Self {
        Self::new(value, error)
    }
}

impl From<Estimate> for Measured {
    fn from(estimate: Estimate) -> Self {
        Self::new(estimate.value, estimate.error)
    }
}

impl From<ConvergenceOrder> for Measured {
    fn from(found: ConvergenceOrder) -> Self {
        Self::new(found.order, found.uncertainty)
    }
}

impl<T: Into<Measured>> From<Option<T>> for Measured {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::NONE, Into::into)
    }
}

impl Neg for Measured {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl<T: Into<Measured>> Add<T> for Measured {
    type Output = Self;
    fn add(self, other: T) -> Self {
        let other = other.into();
        Self { value: self.value + other.value, error: self.error + other.error }
    }
}

impl<T: Into<Measured>> Sub<T> for Measured {
    type Output = Self;
    fn sub(self, other: T) -> Self {
        self + -other.into()
    }
}

impl<T: Into<Measured>> Mul<T> for Measured {
    type Output = Self;
    fn mul(self, other: T) -> Self {
        let (a, b) = (self, other.into());
        let error = a.value.abs() * b.error + b.value.abs() * a.error + a.error * b.error;
        Self { value: a.value * b.value, error }
    }
}

impl<T: Into<Measured>> Div<T> for Measured {
    type Output = Self;
    fn div(self, other: T) -> Self {
        let (a, b) = (self, other.into());
        let value = a.value / b.value;
        let room = b.value.abs() - b.error;
        let error =
            if a.error == 0.0 && b.error == 0.0 { 0.0 } else { (a.error + value.abs() * b.error) / room };
        Self { value, error: if room > 0.0 || error == 0.0 { error } else { f64::INFINITY } }
    }
}

/// The number with the largest upper bound, value plus error; `None` if there are no numbers.
pub fn largest<T: Into<Measured>>(numbers: impl IntoIterator<Item = T>) -> Option<Measured> {
    let larger = |a: Measured, b: Measured| if b.value + b.error > a.value + a.error { b } else { a };
    numbers.into_iter().map(Into::into).reduce(larger)
}

/// The number with the smallest lower bound, value minus error; `None` if there are no numbers.
pub fn smallest<T: Into<Measured>>(numbers: impl IntoIterator<Item = T>) -> Option<Measured> {
    largest(numbers.into_iter().map(|number| -number.into())).map(|found| -found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_enclose_what_intervals_would() {
        let (a, b) = (Measured::new(3.0, 0.1), Measured::new(-2.0, 0.2));
        let ends = |m: Measured| [m.value - m.error, m.value + m.error];
        for (found, exact) in [
            (a + b, [0.7, 1.3]),
            (a - b, [4.7, 5.3]),
            (a * b, [-3.1 * 2.2, -2.9 * 1.8]),
            (a / b, [-3.1 / 1.8, -2.9 / 2.2]),
            (a.squared(), [2.9 * 2.9, 3.1 * 3.1]),
        ] {
            assert!(
                ends(found)[0] <= exact[0] + 1e-12 && ends(found)[1] >= exact[1] - 1e-12,
                "{found:?} {exact:?}"
            );
        }
        assert_eq!((a / Measured::new(0.1, 0.2)).error, f64::INFINITY);
        assert_eq!(Measured::from(6.0) / 2.0, Measured::new(3.0, 0.0));
        assert!(Measured::from(None::<f64>).value.is_nan());
    }

    #[test]
    fn the_largest_counts_its_error() {
        let found = largest([(1.0, 0.0), (0.9, 0.2), (0.5, 0.1)]).unwrap();
        assert_eq!(found, Measured::new(0.9, 0.2));
        assert_eq!(smallest([1.0, -2.0]).unwrap().value, -2.0);
    }
}
