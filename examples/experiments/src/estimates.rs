//! Quotients, distances and extreme values of estimates, each with its error.

use fractional_sobolev::{Estimate, Result, Work};

/// What the examples compute from estimates.
///
/// ```
/// use experiments::EstimateExt;
/// use fractional_sobolev::{Estimate, Work};
/// let of = |value, error| Estimate::new(value, error, Work::default());
/// let (a, b) = (of(4.0, 4e-6)?, of(2.0, 0.0)?);
/// assert!((a.over(b)?.error - 2e-6).abs() < 1e-12);
/// assert_eq!((b.recip()?.value, a.off(3.5)?.value, a.relative_distance(&b).0), (0.5, 0.5, 1.0));
/// assert_eq!(Estimate::largest([a, b]).map(|e| e.value), Some(4.0));
/// assert_eq!(Estimate::smallest([a, b]).map(|e| e.value), Some(2.0));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
pub trait EstimateExt: Sized {
    /// (distance to a value found another way, error of that value), both relative to it; absolute where it is 0.
    fn relative_distance(&self, exact: &Self) -> (f64, f64);

    /// The quotient of two estimates, relative errors added; both works count.
    ///
    /// # Errors
    /// [`NotFinite`](fractional_sobolev::Error::NotFinite) when the divisor is zero or the quotient beyond the
    /// range of binary64.
    fn over(self, divisor: Self) -> Result<Self>;

    /// 1/v with error e/v².
    ///
    /// # Errors
    /// [`NotFinite`](fractional_sobolev::Error::NotFinite) for zero.
    fn recip(self) -> Result<Self>;

    /// The distance of the value to a known number, with the same error.
    ///
    /// # Errors
    /// [`NotFinite`](fractional_sobolev::Error::NotFinite) when that number is not finite.
    fn off(self, exact: f64) -> Result<Self>;

    /// The largest of several: the true largest value lies within the error returned. `None` of none.
    fn largest(estimates: impl IntoIterator<Item = Self>) -> Option<Self>;

    /// The smallest of several: the true smallest value lies within the error returned. `None` of none.
    fn smallest(estimates: impl IntoIterator<Item = Self>) -> Option<Self>;
}

impl EstimateExt for Estimate {
    fn relative_distance(&self, exact: &Self) -> (f64, f64) {
        let size = if exact.value == 0.0 { 1.0 } else { exact.value.abs() };
        ((self.value - exact.value).abs() / size, exact.error / size)
    }

    fn over(self, divisor: Self) -> Result<Self> {
        let value = self.value / divisor.value;
        let error = self.error / divisor.value.abs() + value.abs() * divisor.error / divisor.value.abs();
        Self::new(value, error, self.work + divisor.work)
    }

    fn recip(self) -> Result<Self> {
        Self::new(1.0, 0.0, Work::default())?.over(self)
    }

    fn off(self, exact: f64) -> Result<Self> {
        Self::new((self.value - exact).abs(), self.error, self.work)
    }

    fn largest(estimates: impl IntoIterator<Item = Self>) -> Option<Self> {
        estimates.into_iter().reduce(|a, b| {
            let value = a.value.max(b.value);
            let high = (a.value + a.error).max(b.value + b.error) - value;
            let low = value - (a.value - a.error).max(b.value - b.error);
            Self { value, error: high.max(low), work: a.work + b.work }
        })
    }

    fn smallest(estimates: impl IntoIterator<Item = Self>) -> Option<Self> {
        let negated = |e: Self| Self { value: -e.value, ..e };
        Self::largest(estimates.into_iter().map(negated)).map(negated)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_and_largest_values_carry_their_errors() {
        let of = |value, error| Estimate::new(value, error, Work::default()).unwrap();
        let quotient = of(1.0, 0.1).over(of(-4.0, 0.4)).unwrap();
        assert!(quotient.value == -0.25 && (quotient.error - 0.05).abs() < 1e-15);
        assert!(of(1.0, 0.1).over(of(0.0, 0.0)).is_err());
        let largest = Estimate::largest([of(1.0, 0.5), of(1.2, 0.1), of(0.3, 0.1)]).unwrap();
        // The true values may be as large as 1.5 and the largest is at least 1.1.
        assert!(largest.value == 1.2 && (largest.error - 0.3).abs() < 1e-15);
    }
}
