//! The zone E = (a, a+θ) ⊂ (0,1) on which a function is controlled.

use crate::error::{Error, Result};
use std::fmt;

/// Shortest length that is admitted: below, f64 itself loses digits.
const SHORTEST: f64 = 1e-300;

/// A zone (a, a+θ) in (0,1), kept as its three lengths a, θ and 1 − a − θ.
///
/// ```
/// use fractional_sobolev::{Zone, Zones};
/// let zone = Zone::centred(0.5)?;
/// assert_eq!((zone.start(), zone.length(), zone.rest()), (0.25, 0.5, 0.25));
/// assert!(!zone.is_at_an_end() && Zone::at(0.5, 0.5)?.is_at_an_end());
/// // a union of intervals
/// let zones = Zones::union(&[(0.125, 0.25), (0.5, 0.125)])?;
/// assert_eq!(zones.mirrored().intervals(), [(0.375, 0.125), (0.625, 0.25)]);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("interval", "subinterval"))]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    start: f64,
    length: f64,
    rest: f64,
}

impl Zone {
    /// (0, θ), 1e-300 ≤ θ ≤ 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] otherwise.
    pub fn end(theta: f64) -> Result<Self> {
        Self::at(0.0, theta)
    }

    /// (a, a+θ) with a = 0 or a ≥ 1e-300, 1e-300 ≤ θ ≤ 1, a + θ ≤ 1 up to rounding.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] otherwise.
    pub fn at(a: f64, theta: f64) -> Result<Self> {
        let theta = Error::require("theta", theta, "[1e-300, 1]", (SHORTEST..=1.0).contains(&theta))?;
        let inside = a == 0.0 || (SHORTEST..1.0).contains(&a);
        let start = Error::require("zone start", a, "{0} or [1e-300, 1)", inside)?;
        let rest = (1.0 - start) - theta;
        // a + θ = 1 need not hold exactly for the rounded a and θ
        let admissible = rest >= -f64::EPSILON;
        Error::require("zone end", start + theta, "(0, 1]", admissible)?;
        Ok(Self { start, length: theta, rest: if rest <= f64::EPSILON { 0.0 } else { rest } })
    }

    /// (a, b), 0 ≤ a < b ≤ 1: by its ends, where [`Zone::at`] takes its length.
    ///
    /// ```
    /// use fractional_sobolev::Zone;
    /// let zone = Zone::between(0.25, 0.75)?;
    /// assert!(zone.length() == 0.5 && zone.rest() == 0.25);
    /// assert!(Zone::between(0.75, 0.25).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] as for [`Zone::at`], and for b outside (a, 1].
    pub fn between(a: f64, b: f64) -> Result<Self> {
        let inside = a == 0.0 || (SHORTEST..1.0).contains(&a);
        let start = Error::require("zone start", a, "{0} or [1e-300, 1)", inside)?;
        let end =
            Error::require("zone end", b, "(a, 1], at least 1e-300 above a", b - a >= SHORTEST && b <= 1.0)?;
        Ok(Self { start, length: end - start, rest: 1.0 - end })
    }

    /// The zone of length θ in the middle.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 1e-300 ≤ θ ≤ 1.
    pub fn centred(theta: f64) -> Result<Self> {
        Self::at(0.5 * (1.0 - theta), theta)
    }

    /// The left end a.
    pub const fn start(&self) -> f64 {
        self.start
    }

    /// The length θ.
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// What lies right of the zone, 1 − a − θ.
    pub const fn rest(&self) -> f64 {
        self.rest
    }

    /// The zone touches an end of the interval.
    pub fn is_at_an_end(&self) -> bool {
        self.start == 0.0 || self.rest == 0.0
    }
}

impl fmt::Display for Zone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.start == 0.0 {
            write!(f, "(0, {:e})", self.length)
        } else {
            write!(f, "({:e}, {:e})+{:e}", self.start, self.start, self.length)
        }
    }
}

/// What is asked of u on the zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Condition {
    /// ∫_E u = 0.
    MeanZero,
    /// u = 0 on E.
    Vanishing,
}
