//! Both sides of Lemma 6.1 for one function, given by its slope v = u'.
//!
//! e' = v − v̄ and e(x) = ∫₀^x (v − v̄). A slope on cells as short as 1e-300 is taken as it is; nothing is divided by a cell
//! length. For v = x^a everything is closed:
//! ‖e'‖₀² = a²/((2a+1)(a+1)²),  ‖e‖₀² = 2a²/(3(2a+3)(a+3)(a+1)²).

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::quadrature::Rule;
use crate::sobolev::{FractionalOrder, PiecewisePolynomial, closed_forms};

/// Relative rounding of the sums below: positive terms, each from a few operations on (v − v̄).
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The norms in Lemma 6.1 for one function on an interval of length h.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalError {
    /// Length of the interval.
    pub h: f64,
    /// ‖u − I u‖₀.
    pub l2: Estimate,
    /// ‖(u − I u)'‖₀.
    pub derivative: Estimate,
    /// |u|_{1+ν} = |v|_ν.
    pub seminorm: Estimate,
    order: FractionalOrder,
}

impl LocalError {
    /// For the slope v of u.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] when v jumps and ν ≥ 1/2; [`Error::ToleranceNotMet`].
    pub fn of_slope(
        slope: &PiecewisePolynomial,
        order: FractionalOrder,
        tolerance: Tolerance,
    ) -> Result<Self> {
        let seminorm = slope.seminorm(0, order, tolerance)?;
        let (l2, derivative) = error_norms(slope)?;
        Ok(Self { h: slope.partition().total(), l2, derivative, seminorm, order })
    }

    /// ‖u − I u‖₀ / (h^{1+ν} |u|_{1+ν}): at most 1 by the lemma, at most C_L2(ν) in truth.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] when |u|_{1+ν} = 0: for affine u the ratio is 0/0.
    pub fn l2_ratio(&self) -> Result<Estimate> {
        let ratio = self.quotient(self.l2)?;
        Estimate::new(ratio.value / self.h, ratio.error / self.h, ratio.work)
    }

    /// ‖(u − I u)'‖₀ / (h^ν |u|_{1+ν}): at most C_H1(ν).
    ///
    /// # Errors
    /// As [`LocalError::l2_ratio`].
    pub fn derivative_ratio(&self) -> Result<Estimate> {
        self.quotient(self.derivative)
    }

    /// ‖u − I u‖₁ / (h^ν |u|_{1+ν}) with the full norm: at most C_1(ν, h).
    ///
    /// # Errors
    /// As [`LocalError::l2_ratio`].
    pub fn h1_ratio(&self) -> Result<Estimate> {
        let (l2, derivative) = (self.quotient(self.l2)?, self.quotient(self.derivative)?);
        let value = l2.value.hypot(derivative.value);
        Estimate::new(value, l2.error + derivative.error, l2.work)
    }

    fn quotient(&self, part: Estimate) -> Result<Estimate> {
        let seminorm = self.seminorm.value;
        Error::require("|u'|_nu", seminorm, "(0, inf): the ratio of an affine u is 0/0", seminorm > 0.0)?;
        let value = part.value / seminorm / self.h.powf(self.order.value());
        let relative = part.relative_error() + self.seminorm.relative_error() + 4.0 * f64::EPSILON;
        Estimate::new(value, value * relative, part.work + self.seminorm.work)
    }
}

/// (‖e‖₀, ‖e'‖₀).
pub(super) fn error_norms(slope: &PiecewisePolynomial) -> Result<(Estimate, Estimate)> {
    let partition = slope.partition();
    let mean = slope.mean()?.value;
    let rule = Rule::gauss_legendre(slope.degree() + 2)?;
    let (mut squares, mut error_squares, mut error, mut largest) = (0.0, 0.0, 0.0, 0.0f64);
    for (index, &h) in partition.lengths().iter().enumerate() {
        let deviation = |t: f64| slope.value(index, t).map(|v| v - mean);
        for (t, w) in rule.iter() {
            let d = deviation(t)?;
            squares += h * w * d * d;
            let mut inner = 0.0;
            for (s, v) in rule.iter() {
                inner += t * v * deviation(s * t)?;
            }
            error_squares += h * w * (error + h * inner).powi(2);
        }
        let mut rise = 0.0;
        for (s, v) in rule.iter() {
            rise += v * deviation(s)?;
        }
        error += h * rise;
        largest = largest.max(error.abs());
    }
    let work = Work { points: (partition.len() * rule.points().len().pow(2)) as u64, ..Work::default() };
    let total = partition.total();
    // The running value of e carries the rounding of the mean.
    let absolute = ROUNDING * (mean.abs() * total + largest) * total.sqrt();
    let l2 = error_squares.sqrt();
    let derivative = squares.sqrt();
    let mean_rounding = ROUNDING * mean.abs() * total.sqrt();
    Ok((
        Estimate::new(l2, ROUNDING * l2 + absolute, work)?,
        Estimate::new(derivative, ROUNDING * derivative + mean_rounding, work)?,
    ))
}

/// The norms of Lemma 6.1 on (0, 1) for u' = x^a, a > ν − 1/2, a > −1/2, by closed forms.
///
/// # Errors
/// [`Error::InfiniteNorm`] for a ≤ ν − 1/2, [`Error::OutOfRange`] for a not finite or above 1e4.
pub fn power_slope(a: f64, order: FractionalOrder) -> Result<LocalError> {
    let seminorm = closed_forms::power(a, order)?.sqrt()?;
    let next = a + 1.0;
    let derivative = a.abs() / next / (2.0 * a + 1.0).sqrt();
    let l2 = a.abs() / next * (2.0 / (3.0 * (2.0 * a + 3.0) * (a + 3.0))).sqrt();
    // 2a + 1 is exact to the rounding of a, which weighs where it is small.
    let relative = ROUNDING + f64::EPSILON * (a / (2.0 * a + 1.0)).abs();
    let estimate = |value: f64| Estimate::new(value, relative * value, Work::default());
    Ok(LocalError { h: 1.0, l2: estimate(l2)?, derivative: estimate(derivative)?, seminorm, order })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sobolev::Partition;

    #[test]
    fn a_linear_slope_has_the_power_s_norms() {
        let partition = Partition::geometric(7, 0.3, 1.0).unwrap();
        let nodes = partition.nodes();
        let slope = PiecewisePolynomial::linears(partition, &nodes).unwrap();
        for nu in [0.1, 0.5, 0.9] {
            let order = FractionalOrder::new(nu).unwrap();
            let cells = LocalError::of_slope(&slope, order, Tolerance::reference()).unwrap();
            let closed = power_slope(1.0, order).unwrap();
            for (a, b) in [
                (cells.l2, closed.l2),
                (cells.derivative, closed.derivative),
                (cells.seminorm, closed.seminorm),
                (cells.h1_ratio().unwrap(), closed.h1_ratio().unwrap()),
            ] {
                assert!((a.value - b.value).abs() <= a.error + b.error, "{nu}: {a} {b}");
            }
        }
    }

    #[test]
    fn ratios_do_not_depend_on_the_length() {
        let order = FractionalOrder::new(0.3).unwrap();
        let ratio = |h: f64| {
            let partition = Partition::from_lengths(vec![0.2 * h, 0.5 * h, 0.3 * h]).unwrap();
            let slope = PiecewisePolynomial::linears(partition, &[0.0, 1.0, -1.0, 0.5]).unwrap();
            LocalError::of_slope(&slope, order, Tolerance::balanced()).unwrap()
        };
        let unit = ratio(1.0);
        for h in [1e-100, 1e-3, 7.0, 1e100] {
            let scaled = ratio(h);
            for (a, b) in [
                (unit.l2_ratio().unwrap(), scaled.l2_ratio().unwrap()),
                (unit.derivative_ratio().unwrap(), scaled.derivative_ratio().unwrap()),
            ] {
                assert!((a.value - b.value).abs() <= 1e-12 * a.value, "{h}: {a} {b}");
            }
        }
    }

    #[test]
    fn affine_functions_have_no_ratio() {
        let partition = Partition::uniform(3, 1.0).unwrap();
        let slope = PiecewisePolynomial::constants(partition, &[2.0; 3]).unwrap();
        let order = FractionalOrder::new(0.3).unwrap();
        let error = LocalError::of_slope(&slope, order, Tolerance::fast()).unwrap();
        assert!(matches!(error.l2_ratio(), Err(Error::OutOfRange { value: 0.0, .. })));
        assert!(matches!(power_slope(0.0, order).unwrap().derivative_ratio(), Err(Error::OutOfRange { .. })));
        assert!(power_slope(-0.2, order).is_err());
    }
}
