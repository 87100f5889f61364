//! Accuracy and cost: numerical functions take a [`Tolerance`], except for closed forms, and return an
//! [`Estimate`].
//!
//! A tolerance τ is *relative*: the value v returned for the exact value v* should satisfy |v − v*| ≤ τ |v*|.
//! The `error` of an estimate is *absolute*: it estimates |v − v*| and is at least the rounding error of v.

use crate::error::{Error, Given, Result};
pub use crate::value::{Estimate, Work};
use std::fmt;
use std::str::FromStr;

/// A requested relative accuracy in [1e-15, 0.1], with a work limit.
#[doc(alias("accuracy", "precision", "relative tolerance"))]
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Tolerance {
    relative: f64,
    work: u64,
}

/// Message: the work limit is reached.
pub(crate) const SPENT: &str = "the work limit is reached; raise it with Tolerance::with_work";

impl Tolerance {
    /// Default limit for the function and kernel evaluations of an integral (see [`Tolerance::with_work`]):
    /// about ten seconds for a cheap function.
    pub const WORK: u64 = 1 << 28;

    /// The tolerance with a relative accuracy between 1e-15 and 0.1.
    ///
    /// ```
    /// use fractional_sobolev::Tolerance;
    /// assert!(Tolerance::new(1e-6)? < Tolerance::fast());
    /// assert!("reference".parse::<Tolerance>()? == Tolerance::reference());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for all other numbers.
    pub fn new(relative: f64) -> Result<Self> {
        let admissible = (1e-15..=0.1).contains(&relative);
        Error::require("tolerance", relative, "[1e-15, 0.1]", admissible).map(Self::of)
    }

    const fn of(relative: f64) -> Self {
        Self { relative, work: Self::WORK }
    }

    /// The same tolerance with at most this many evaluations of the function and of the kernel. The limit
    /// applies separately to each integral of a norm.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Tolerance};
    /// let wave = Function::from_fn(&[0.0, 1.0], |x: f64| (300.0 * x).cos())?;
    /// let few = Tolerance::fast().with_work(1000); // too few for 48 periods
    /// assert!(wave.seminorm(0.5, Tolerance::fast()).is_ok() && wave.seminorm(0.5, few).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    pub const fn with_work(self, evaluations: u64) -> Self {
        Self { relative: self.relative, work: evaluations }
    }

    /// The limit for the evaluations of an integral.
    pub(crate) const fn work(self) -> u64 {
        self.work
    }

    /// The tolerance 1e-4: enough for a plot.
    pub const fn fast() -> Self {
        Self::of(1e-4)
    }

    /// The tolerance 1e-8: enough for a table.
    pub const fn balanced() -> Self {
        Self::of(1e-8)
    }

    /// The tolerance 1e-12: close to the limit of binary64.
    pub const fn reference() -> Self {
        Self::of(1e-12)
    }

    /// The relative tolerance as a number.
    ///
    /// ```
    /// assert_eq!(fractional_sobolev::Tolerance::balanced().relative(), 1e-8);
    /// ```
    pub const fn relative(self) -> f64 {
        self.relative
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self::balanced()
    }
}

impl TryFrom<f64> for Tolerance {
    type Error = Error;

    /// As [`Tolerance::new`].
    fn try_from(relative: f64) -> Result<Self> {
        Self::new(relative)
    }
}

impl Given<Self> for Tolerance {
    fn given(self) -> Result<Self> {
        Ok(self)
    }
}

impl Given<Tolerance> for f64 {
    fn given(self) -> Result<Tolerance> {
        Tolerance::new(self)
    }
}

impl fmt::Display for Tolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:e}", self.relative)
    }
}

impl FromStr for Tolerance {
    type Err = Error;

    /// The tolerance for `fast`, `balanced`, `reference` or a number.
    fn from_str(text: &str) -> Result<Self> {
        match text {
            "fast" => Ok(Self::fast()),
            "balanced" => Ok(Self::balanced()),
            "reference" => Ok(Self::reference()),
            _ => match text.parse() {
                Ok(relative) => Self::new(relative),
                Err(_) => Err(Error::UnknownName {
                    what: "tolerance",
                    given: text.to_owned(),
                    expected: "fast, balanced, reference or a number in [1e-15, 0.1]",
                }),
            },
        }
    }
}

impl Estimate {
    /// The estimate with this value and absolute error; the error is raised to the rounding error of the value
    /// if it is smaller.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the value or the error is NaN or infinite.
    pub fn new(value: f64, error: f64, work: Work) -> Result<Self> {
        for (index, number) in [value, error].into_iter().enumerate() {
            if !number.is_finite() {
                return Err(Error::NotFinite {
                    name: "estimate (value, error)",
                    index,
                    value: number,
                });
            }
        }
        Ok(Self { value, error: error.abs().max(value.abs() * f64::EPSILON), work })
    }

    /// The estimate, or the best estimate if the tolerance was not met, for callers who examine the error
    /// themselves.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, Estimate, Order, gamma, Tolerance};
    /// let order = Order::new(0.25)?;
    /// let refused = gamma(order, Constraint::mean_zero_on(0.0..0.5), Tolerance::new(1e-15)?).map(|found| found.constant);
    /// assert!(refused.is_err());
    /// let best = Estimate::or_best(refused)?;
    /// assert!(best.relative_error() < 1e-11);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// All errors that carry no value.
    pub fn or_best(found: Result<Self>) -> Result<Self> {
        found.or_else(|error| error.best().ok_or(error))
    }

    /// The square root: √v with error √v − √(v − e), or √e if v does not exceed e.
    ///
    /// ```
    /// use fractional_sobolev::{Estimate, Work};
    /// let square = Estimate::new(4.0, 4e-6, Work::default())?;
    /// assert!((square.sqrt()?.error - 1e-6).abs() < 1e-12 && square.times(3.0)?.value == 12.0);
    /// assert!(Estimate::new(f64::NAN, 0.0, Work::default()).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the value is negative by more than its error.
    pub fn sqrt(self) -> Result<Self> {
        if self.value < -self.error {
            return Err(Error::OutOfRange {
                name: "radicand",
                value: self.value,
                range: "[0, inf)",
            });
        }
        let root = self.value.max(0.0).sqrt();
        let error = if self.value > self.error {
            self.error / (root + (self.value - self.error).sqrt())
        } else {
            self.error.sqrt()
        };
        Self::new(root, error, self.work)
    }

    /// √(self² + other²), without overflow of the squares. With the errors d, e of a, b its error is
    /// √((|a|+d)² + (|b|+e)²) − √(a² + b²).
    ///
    /// ```
    /// use fractional_sobolev::{Estimate, Work};
    /// let of = |value, error| Estimate::new(value, error, Work::default());
    /// let root = of(3e200, 1e190)?.hypot(of(4e200, 1e190)?)?;
    /// assert!((root.value / 5e200 - 1.0).abs() < 1e-15 && (root.error / 1.4e190 - 1.0).abs() < 1e-12);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the result overflows.
    pub fn hypot(self, other: Self) -> Result<Self> {
        let parts = [self, other];
        let of = |size: fn(&Self) -> f64| size(&self).hypot(size(&other));
        let both = of(|part| part.value) + of(|part| part.value.abs() + part.error);
        // (a + d)² − a² = d (a + (a + d))
        let share = |part: &Self| {
            let size = part.value.abs();
            if part.error > 0.0 { part.error * ((size + (size + part.error)) / both) } else { 0.0 }
        };
        let error = parts.iter().map(share).sum();
        Self::new(of(|part| part.value), error, self.work + other.work)
    }

    /// The product of two estimates: v w with error |v| e + |w| d + d e, d and e the errors of v and w.
    ///
    /// ```
    /// use fractional_sobolev::{Estimate, Work};
    /// let of = |value, error| Estimate::new(value, error, Work::default());
    /// let product = of(2.0, 0.5)?.product(of(3.0, 1.0)?)?; // within 1.5 · 2 and 2.5 · 4
    /// assert!(product.value == 6.0 && product.error == 4.0);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the product is not finite.
    pub fn product(self, other: Self) -> Result<Self> {
        let error = self.value.abs() * other.error
            + other.value.abs() * self.error
            + self.error * other.error;
        Self::new(self.value * other.value, error, self.work + other.work)
    }

    /// The quotient of two estimates: v/w with error (d + |v/w| e)/(|w| − e), d and e the errors of v and w.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the quotient is not finite; [`Error::OutOfRange`] unless |w| > e.
    pub(crate) fn quotient(self, other: Self) -> Result<Self> {
        let least = other.value.abs() - other.error;
        Error::require("least size of the divisor", least, "(0, inf)", least > 0.0)?;
        let value = self.value / other.value;
        let error = (self.error + value.abs() * other.error) / least;
        Self::new(value, error, self.work + other.work)
    }

    /// The estimate multiplied by an exact number.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the product is not finite.
    pub fn times(self, factor: f64) -> Result<Self> {
        Self::new(self.value * factor, self.error * factor, self.work)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerance_is_read_from_presets_and_numbers() {
        assert_eq!("fast".parse(), Ok(Tolerance::fast()));
        assert_eq!("1e-9".parse(), Tolerance::new(1e-9));
        for bad in ["0", "nan", "1", "tight"] {
            assert!(bad.parse::<Tolerance>().is_err(), "{bad}");
        }
    }

    #[test]
    fn square_root_of_an_estimate_carries_its_error() {
        let root = Estimate::new(4.0, 4e-6, Work::default()).unwrap().sqrt().unwrap();
        let largest = 2.0 - (4.0f64 - 4e-6).sqrt();
        assert!(root.value == 2.0 && (root.error - largest).abs() < 1e-15);
        // The square may be 0.001, whose root is 0.968 away.
        let rough = Estimate::new(1.0, 0.999, Work::default()).unwrap().sqrt().unwrap();
        assert!((rough.error - (1.0 - 0.001f64.sqrt())).abs() < 1e-12, "{rough}");
        assert!(Estimate::new(-1.0, 0.1, Work::default()).unwrap().sqrt().is_err());
        assert!(Estimate::new(f64::NAN, 0.0, Work::default()).is_err());
    }
    /// Every pair of numbers within the errors has its product, quotient and root of squares within the stated one, and the
    /// farthest pair attains it.
    #[test]
    fn combinations_of_estimates_contain_the_terms_of_second_order() {
        let of = |value, error| Estimate::new(value, error, Work::default()).unwrap();
        for (v, d, w, e) in [
            (2.0, 0.5, 3.0, 1.0),
            (-2.0, 1.9, 1.0, 0.5),
            (0.0, 1.0, 2.0, 1.0),
            (3.0, 0.1, -4.0, 3.0),
        ] {
            let (a, b) = (of(v, d), of(w, e));
            let found = [a.product(b).unwrap(), a.quotient(b).unwrap(), a.hypot(b).unwrap()];
            let mut farthest = [0.0_f64; 3];
            for s in [-1.0, 0.0, 1.0] {
                for t in [-1.0, 0.0, 1.0] {
                    let (x, y) = (v + s * d, w + t * e);
                    for (k, value) in [x * y, x / y, x.hypot(y)].into_iter().enumerate() {
                        farthest[k] = farthest[k].max((value - found[k].value).abs());
                    }
                }
            }
            for (estimate, farthest) in found.iter().zip(farthest) {
                assert!((estimate.error / farthest - 1.0).abs() < 1e-12, "{estimate} {farthest}");
            }
        }
        assert!(of(1.0, 0.0).quotient(of(1.0, 1.0)).is_err());
    }
}
