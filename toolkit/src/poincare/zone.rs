//! The zone E = (a, a+θ) ⊂ (0,1) on which a function is controlled, and how.

use crate::error::{Error, Result};
use std::fmt;
use std::str::FromStr;

/// Shortest length that is admitted: below, f64 itself loses digits.
const SHORTEST: f64 = 1e-300;

/// A zone (a, a+θ) in (0,1), kept as its three lengths a, θ and 1 − a − θ.
///
/// ```
/// use fractional_sobolev::poincare::{Place, Zone, Zones};
/// let zone = Zone::centred(0.5)?;
/// assert_eq!((zone.start(), zone.length(), zone.rest()), (0.25, 0.5, 0.25));
/// assert!(!zone.is_at_an_end() && Zone::at(0.5, 0.5)?.is_at_an_end());
/// assert_eq!((Place::Centre.point(), Place::Centre.zone(0.5)?), (0.5, zone));
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
    /// use fractional_sobolev::poincare::Zone;
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

/// Where zones of any length are put.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Place {
    /// (0, θ).
    #[default]
    End,
    /// In the middle.
    Centre,
    /// (a, a+θ).
    At(f64),
}

impl Place {
    /// The point to which zones at this place shrink.
    pub fn point(self) -> f64 {
        match self {
            Place::End => 0.0,
            Place::Centre => 0.5,
            Place::At(a) => a,
        }
    }

    /// The zone of length θ at this place.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] as for [`Zone::at`].
    pub fn zone(self, theta: f64) -> Result<Zone> {
        match self {
            Place::End => Zone::end(theta),
            Place::Centre => Zone::centred(theta),
            Place::At(a) => Zone::at(a, theta),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::End => f.write_str("end"),
            Place::Centre => f.write_str("centre"),
            Place::At(a) => write!(f, "{a:e}"),
        }
    }
}

impl FromStr for Place {
    type Err = Error;

    /// `end`, `centre` or the start a.
    fn from_str(text: &str) -> Result<Self> {
        match (text, text.parse()) {
            ("end", _) => Ok(Self::End),
            ("centre", _) => Ok(Self::Centre),
            (_, Ok(a)) => Error::require("zone start", a, "[0, 1)", (0.0..1.0).contains(&a)).map(Self::At),
            _ => Err(Error::UnknownName {
                what: "zone",
                given: text.to_owned(),
                expected: "end, centre or the start a in [0, 1)",
            }),
        }
    }
}

/// What is asked of u on the zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Condition {
    /// ∫_E u = 0.
    #[default]
    MeanZero,
    /// u = 0 on E.
    Vanishing,
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Condition::MeanZero => "mean-zero",
            Condition::Vanishing => "vanishing",
        })
    }
}

impl FromStr for Condition {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "mean-zero" => Ok(Self::MeanZero),
            "vanishing" => Ok(Self::Vanishing),
            _ => Err(Error::UnknownName {
                what: "condition",
                given: text.to_owned(),
                expected: "mean-zero or vanishing",
            }),
        }
    }
}
