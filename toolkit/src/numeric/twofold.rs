//! Numbers of twice the digits: unevaluated sums of two numbers of binary64 (Dekker, Numer. Math. 18 (1971) 224-242),
//! with a relative error of a few 2^−104 per operation.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The sum of its parts, the second at most half an ulp of the first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Twofold {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

/// 2^27 + 1, by which a number is split into two of 26 digits.
const SPLIT: f64 = 134_217_729.0;

/// a + b for |a| ≥ |b|.
fn ordered_sum(a: f64, b: f64) -> Twofold {
    let high = a + b;
    Twofold { high, low: b - (high - a) }
}

fn sum(a: f64, b: f64) -> Twofold {
    let high = a + b;
    let of_b = high - a;
    Twofold { high, low: (a - (high - of_b)) + (b - of_b) }
}

fn split(a: f64) -> [f64; 2] {
    let c = SPLIT * a;
    let high = c - (c - a);
    [high, a - high]
}

fn product(a: f64, b: f64) -> Twofold {
    let high = a * b;
    let ([a0, a1], [b0, b1]) = (split(a), split(b));
    Twofold { high, low: ((a0 * b0 - high) + a0 * b1 + a1 * b0) + a1 * b1 }
}

impl Twofold {
    pub(crate) fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::from(self.high.sqrt());
        }
        let root = self.high.sqrt();
        let rest = self - product(root, root);
        ordered_sum(root, rest.high / (2.0 * root))
    }

    /// The nearest number of binary64.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

impl From<f64> for Twofold {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Neg for Twofold {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for Twofold {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.high, other.high), sum(self.low, other.low));
        let first = ordered_sum(high.high, high.low + low.high);
        ordered_sum(first.high, first.low + low.low)
    }
}

impl Sub for Twofold {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let found = product(self.high, other.high);
        ordered_sum(found.high, found.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Twofold {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        ordered_sum(first, second) + Self::from(rest.high / other.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_keep_thirty_digits() {
        let third = Twofold::from(1.0) / Twofold::from(3.0);
        let one = third + third + third - Twofold::from(1.0);
        assert!(one.value().abs() < 1e-31, "{one:?}");
        let root = Twofold::from(2.0).sqrt();
        let rest = root * root - Twofold::from(2.0);
        assert!(rest.value().abs() < 1e-30, "{rest:?}");
        let close = Twofold::from(1.0) + Twofold::from(1e-25);
        assert_eq!((close - Twofold::from(1.0)).value(), 1e-25);
        assert!((close * close - Twofold::from(1.0) - Twofold::from(2e-25)).value().abs() < 1e-45);
    }
}
