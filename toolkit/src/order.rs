//! The order ν of a fractional Sobolev space, 0 < ν < 1.

use crate::error::{Error, Given, Result};
use std::fmt;
use std::str::FromStr;

/// A fractional order 0 < ν < 1, stored together with ν − 1/2.
///
/// # Method
///
/// Formulas change character at ν = 1/2 (traces, logarithms), and most of them contain 1 − 2ν in an exponent or
/// a denominator. The offset δ = ν − 1/2 is therefore stored together with ν: orders such as 1/2 + 1e-20, for
/// which ν rounds to 1/2, are admissible.
#[doc(alias("H1/2", "Sobolev order", "nu", "fractional order"))]
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Order {
    value: f64,
    offset: f64,
}

impl Order {
    /// ν = 1/2, the order of traces.
    pub const HALF: Self = Self { value: 0.5, offset: 0.0 };

    /// The order ν.
    ///
    /// ```
    /// use fractional_sobolev::Order;
    /// assert_eq!(Order::new(0.5)?, Order::HALF);
    /// assert!(Order::new(1.0).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < ν < 1.
    pub fn new(nu: f64) -> Result<Self> {
        let value = Error::require("nu", nu, "(0, 1)", nu > 0.0 && nu < 1.0)?;
        // Exact for ν ≥ 1/4 (Sterbenz); below, δ ≤ −1/4 loses half an ulp and no formula cancels there.
        let offset = value - 0.5;
        Ok(Self { value, offset })
    }

    /// The order 1/2 + δ, with δ kept to full relative accuracy.
    ///
    /// ```
    /// use fractional_sobolev::Order;
    /// let order = Order::half_plus(-1e-20)?; // 1/2 − 1e-20 is not a binary64 number
    /// assert!(order.value() == 0.5 && order.offset() == -1e-20);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless −1/2 < δ < 1/2.
    pub fn half_plus(delta: f64) -> Result<Self> {
        let value = 0.5 + delta;
        let admissible = value > 0.0 && value < 1.0;
        let offset = Error::require("nu - 1/2", delta, "(-1/2, 1/2)", admissible)?;
        Ok(Self { value, offset })
    }

    /// The order ν, rounded.
    pub const fn value(self) -> f64 {
        self.value
    }

    /// The offset ν − 1/2.
    pub const fn offset(self) -> f64 {
        self.offset
    }

    /// The complement 1 − ν, to rounding: above 1/2 from ν − 1/2, because ν may be rounded, by 1e-16/(1 − ν) of it.
    pub(crate) const fn complement(self) -> f64 {
        if self.offset > 0.0 { 0.5 - self.offset } else { 1.0 - self.value }
    }

    /// 1 − 2ν = −2(ν − 1/2): positive where indicator functions have a finite seminorm.
    pub(crate) const fn one_minus_twice(self) -> f64 {
        -2.0 * self.offset
    }

    /// The order 1 + ν of a norm or seminorm, with ν − 1/2 to full relative accuracy.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh, Order};
    /// // u′ = ±1 jumps: the seminorm is finite for every order below 3/2
    /// let tent = Function::linears(&Mesh::uniform(2, 1.0)?, &[0.0, 0.5, 0.0])?;
    /// assert!(tent.seminorm(Order::half_plus(-1e-20)?.plus_one(), 1e-8)?.value > 1e9);
    /// assert!(tent.seminorm(Order::HALF.plus_one(), 1e-8).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    pub const fn plus_one(self) -> SobolevOrder {
        SobolevOrder::OnePlus(self)
    }

    /// True if ν < 1/2, the range in which piecewise constants belong to H^ν.
    pub(crate) fn is_below_half(self) -> bool {
        self.offset < 0.0
    }
}

impl TryFrom<f64> for Order {
    type Error = Error;

    fn try_from(nu: f64) -> Result<Self> {
        Self::new(nu)
    }
}

impl Given<Self> for Order {
    fn given(self) -> Result<Self> {
        Ok(self)
    }
}

impl Given<Order> for f64 {
    fn given(self) -> Result<Order> {
        Order::new(self)
    }
}

impl From<Order> for f64 {
    fn from(order: Order) -> f64 {
        order.value
    }
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.offset != self.value - 0.5 && self.value >= 0.25 {
            write!(f, "1/2{:+e}", self.offset)
        } else if self.value < 1e-4 {
            write!(f, "{:e}", self.value)
        } else {
            write!(f, "{}", self.value)
        }
    }
}

impl FromStr for Order {
    type Err = Error;

    /// The order given as a number in (0, 1), `1/2`, or `1/2` with a signed offset such as `1/2+1e-20`.
    fn from_str(text: &str) -> Result<Self> {
        let text = text.trim();
        match text.strip_prefix("1/2") {
            Some("") => Ok(Self::HALF),
            Some(offset) if offset.starts_with(['+', '-']) => {
                offset.parse().map_or_else(|_| Err(unreadable(text)), Self::half_plus)
            }
            _ => text.parse().map_or_else(|_| Err(unreadable(text)), Self::new),
        }
    }
}

fn unreadable(text: &str) -> Error {
    Error::UnknownName {
        what: "order nu",
        given: text.to_owned(),
        expected: "a number in (0, 1), 1/2, or 1/2+offset",
    }
}

/// The order s of a norm, −1 < s < 2, stored as −ν, 0, ν, 1 or 1 + ν with an [`Order`] ν, so that its distance from
/// ±1/2 and 3/2 has full relative accuracy.
///
/// It is given as a plain number, as an [`Order`] ν for s = ν, as `-ν`, or by [`Order::plus_one`].
///
/// ```
/// use fractional_sobolev::{Function, Order};
/// let u = Function::from_fn(&[0.0, 1.0], |x| x)?;
/// assert_eq!(u.norm(-Order::HALF, 1e-6)?.value, u.norm(-0.5, 1e-6)?.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SobolevOrder {
    /// s = −ν: the norm dual to that of order ν.
    Dual(Order),
    /// s = 0.
    Zero,
    /// s = ν.
    Fractional(Order),
    /// s = 1.
    One,
    /// s = 1 + ν.
    OnePlus(Order),
}

/// The order −ν of a dual norm, with ν − 1/2 to full relative accuracy.
impl std::ops::Neg for Order {
    type Output = SobolevOrder;

    fn neg(self) -> SobolevOrder {
        SobolevOrder::Dual(self)
    }
}

impl Given<SobolevOrder> for SobolevOrder {
    fn given(self) -> Result<SobolevOrder> {
        Ok(self)
    }
}

impl Given<SobolevOrder> for Order {
    fn given(self) -> Result<SobolevOrder> {
        Ok(SobolevOrder::Fractional(self))
    }
}

impl Given<SobolevOrder> for f64 {
    fn given(self) -> Result<SobolevOrder> {
        Error::require("order of the norm", self, "(-1, 2)", self > -1.0 && self < 2.0)?;
        Ok(match self {
            s if s < 0.0 => SobolevOrder::Dual(Order::new(-s)?),
            0.0 => SobolevOrder::Zero,
            s if s < 1.0 => SobolevOrder::Fractional(Order::new(s)?),
            1.0 => SobolevOrder::One,
            s => SobolevOrder::OnePlus(Order::new(s - 1.0)?),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_are_read_and_keep_their_offset() {
        let half: Order = "1/2".parse().unwrap();
        assert_eq!((half.value(), half.offset()), (0.5, 0.0));
        let near: Order = "1/2-1e-20".parse().unwrap();
        assert_eq!((near.value(), near.offset()), (0.5, -1e-20));
        assert!(near.is_below_half() && !half.is_below_half());
        assert_eq!(near.to_string(), "1/2-1e-20");
        assert_eq!(near.to_string().parse(), Ok(near));
        assert_eq!("0.3".parse(), Order::new(0.3));
        assert_eq!(Order::new(0.25).unwrap().one_minus_twice(), 0.5);
    }

    #[test]
    fn the_complement_near_one_is_that_of_the_offset() {
        let near = Order::half_plus(0.49999).unwrap();
        assert_eq!(near.complement(), 0.5 - 0.49999);
        assert_ne!(near.complement(), 1.0 - near.value());
        assert_eq!(Order::new(0.99999).unwrap().complement(), 1.0 - 0.99999);
    }

    #[test]
    fn orders_outside_the_open_interval_are_errors() {
        for bad in ["0", "1", "-0.1", "nan", "inf", "1/2+0.5", "1/2 0.1", "half", ""] {
            assert!(bad.parse::<Order>().is_err(), "{bad}");
        }
        assert!(Order::try_from(f64::NAN).is_err());
    }
}
