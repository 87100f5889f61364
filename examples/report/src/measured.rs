//! A number with a bound on its error, and arithmetic that propagates the bound.

use fractional_sobolev::Estimate;
use std::f64::consts::LN_2;
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
        let error =
            if self.error == 0.0 { 0.0 } else { (self.error / root).min(self.error.sqrt()) };
        Self { value: root, error }
    }

    /// min(v, bound), with an error that contains min(w, bound) for every w within the error of v.
    #[must_use]
    pub fn min(self, bound: f64) -> Self {
        match self.value > bound {
            true => Self { value: bound, error: (bound - (self.value - self.error)).max(0.0) },
            false => self,
        }
    }

    /// ln v, with error −ln(1 − u/v) for u < v.
    #[must_use]
    pub fn ln(self) -> Self {
        Self { value: self.value.ln(), error: -(-self.error / self.value).ln_1p() }
    }
}

conversions! { Measured:
    f64 => |value: f64| Measured { value, error: 0.0 },
    usize => |count: usize| Measured::from(count as f64),
    (f64, f64) => |(value, error): (f64, f64)| Measured::new(value, error),
    Estimate => |estimate: Estimate| Measured::new(estimate.value, estimate.error),
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
        let error = if a.error == 0.0 && b.error == 0.0 {
            0.0
        } else {
            (a.error + value.abs() * b.error) / room
        };
        Self { value, error: if room > 0.0 || error == 0.0 { error } else { f64::INFINITY } }
    }
}

/// The number with the largest upper bound, value plus error; `None` if there are no numbers.
pub fn largest<T: Into<Measured>>(numbers: impl IntoIterator<Item = T>) -> Option<Measured> {
    let larger =
        |a: Measured, b: Measured| if b.value + b.error > a.value + a.error { b } else { a };
    numbers.into_iter().map(Into::into).reduce(larger)
}

/// The number with the smallest lower bound, value minus error; `None` if there are no numbers.
pub fn smallest<T: Into<Measured>>(numbers: impl IntoIterator<Item = T>) -> Option<Measured> {
    largest(numbers.into_iter().map(|number| -number.into())).map(|found| -found)
}

/// The exponent p of y ~ x^p between two points (x, y).
pub fn exponent_between<T: Into<Measured>>(a: (f64, T), b: (f64, T)) -> Measured {
    let ((x, y), (x_b, y_b)) = (a, b);
    (y_b.into() / y.into()).ln() / (x_b / x).ln()
}

/// The exponent p of y ~ x^p from the first to the last of at least three points (x, y); ± is the
/// difference of the exponents of both halves, and the effect of the errors of y. No number with
/// fewer points.
pub fn exponent_of<T: Copy + Into<Measured>>(points: &[(f64, T)]) -> Measured {
    let [first, _, .., last] = points else { return Measured::NONE };
    let middle = points[points.len() / 2];
    let whole = exponent_between(*first, *last);
    let halves = exponent_between(*first, middle) - exponent_between(middle, *last);
    Measured::new(whole.value, halves.value.abs() + whole.error)
}

/// The exponent p of y = A h^p + B from its values for h, h/2 and h/4: the increments fall by 2^p.
pub fn order_of_increments(y: [f64; 3]) -> f64 {
    ((y[0] - y[1]) / (y[1] - y[2])).log2()
}

/// The order p of errors e on meshes h, h/2, h/4, .. with e² ≈ A h^(2p) + B h² + const, from their
/// squares:
///
/// ```text
/// p = ½ log₂ |t(h)/t(h/2^k)|/k,   t(h) = 4 d(h/2) − d(h) ~ h^(2p),   d(h) = e(h)² − e(h/2)²,
/// k = halvings,
/// ```
///
/// on the last meshes. ± is the largest change of p since the three meshes before it, or as many as
/// there are (a drift, about as large as p is off its limit), and what the errors of the last
/// squares do to p. No number with fewer than k + 4 squares, where nothing is known of a change.
pub fn order_of_squares<T: Copy + Into<Measured>>(squares: &[T], halvings: usize) -> Measured {
    let squares: Vec<Measured> = squares.iter().map(|&square| square.into()).collect();
    // t = 4 (b − c) − (a − b), every square once: errors of the same square do not add up twice.
    let t: Vec<Measured> = squares.windows(3).map(|s| s[1] * 5.0 - s[2] * 4.0 - s[0]).collect();
    let order = |t: &[Measured]| (t[0] / t[halvings]).abs().ln() * (0.5 / (halvings as f64 * LN_2));
    let p: Vec<Measured> = t.windows(halvings + 1).rev().take(4).map(order).collect();
    let [last, before @ ..] = &p[..] else { return Measured::NONE };
    let change = before.iter().map(|q| (q.value - last.value).abs()).reduce(f64::max);
    change.map(|change| (last.value, change + last.error)).into()
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

    #[test]
    fn exponents_of_powers() {
        let power = |x: f64| (x, 3.0 * x.powf(-0.7));
        let points = [1.0, 2.0, 5.0, 7.0].map(power);
        assert!((exponent_between(points[0], points[2]).value + 0.7).abs() < 1e-14);
        let found = exponent_of(&points);
        assert!((found.value + 0.7).abs() < 1e-14 && found.error < 1e-14, "{found:?}");
        let with_error = points.map(|(x, y)| (x, Measured::new(y, 1e-3 * y)));
        assert!(exponent_of(&with_error).error > 1e-3);
        assert!(exponent_of(&points[..2]).value.is_nan());
        let y = [1.0, 0.5, 0.25].map(|h: f64| 5.0 * h.powf(1.3) - 2.0);
        assert!((order_of_increments(y) - 1.3).abs() < 1e-14);
    }

    #[test]
    fn an_order_is_read_beside_a_square_and_a_constant() {
        let squares: Vec<f64> = (0..8)
            .map(|k| 0.5f64.powi(k))
            .map(|h| 3.0 * h.powf(1.4) + 20.0 * h * h - 0.5 + 0.1 * h.powi(3))
            .collect();
        for halvings in [1, 2] {
            let p = order_of_squares(&squares, halvings);
            assert!((p.value - 0.7).abs() < p.error && p.error < 0.02, "{p:?}");
            // Errors of the squares widen ±; one that covers a difference of squares leaves no
            // order.
            let wide = |share: f64| -> Vec<Measured> {
                squares.iter().map(|s| Measured::new(*s, share * s)).collect()
            };
            let [q, none] = [1e-6, 1.0].map(|share| order_of_squares(&wide(share), halvings));
            assert!(q.value == p.value && q.error > p.error + 1e-6 && q.error < 0.1, "{q:?}");
            assert!(!none.error.is_finite(), "{none:?}");
        }
        let exact: Vec<f64> =
            (0..8).map(|k| 7.0 * 0.25f64.powi(k) - 2.0 * 0.5f64.powi(k)).collect();
        assert!((order_of_squares(&exact, 2) - 0.5).abs().value < 1e-12);
        assert!(order_of_squares(&squares[..5], 2).value.is_nan());
    }

    #[test]
    fn a_minimum_keeps_what_lies_below() {
        let ends = |v: f64, u: f64| {
            (Measured::new(v, u).min(1.0).value, Measured::new(v, u).min(1.0).error)
        };
        assert_eq!(
            [ends(0.75, 0.5), ends(1.25, 0.5), ends(2.0, 0.5)],
            [(0.75, 0.5), (1.0, 0.25), (1.0, 0.0)]
        );
        assert!(Measured::NONE.min(1.0).value.is_nan());
    }
}
