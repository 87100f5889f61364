//! Zones and conditions as options of a command: where zones of any length are put, and what holds on them.

use crate::ErrorExt;
use fractional_sobolev::{Constraint, Error, Given, Result, Zones};
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;

/// A = 3/(2π²): slope of γ² against ln(1/θ) at ν = 1/2 for a zone at an end.
pub const END_SLOPE: f64 = 3.0 / (2.0 * PI * PI);

/// 1/(2π²): the slope for a zone inside.
pub const INTERIOR_SLOPE: f64 = 1.0 / (2.0 * PI * PI);

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
    /// [`Error::OutOfRange`] as for [`Zones::from_start_and_length`].
    pub fn zone(self, theta: f64) -> Result<Zones> {
        let start = match self {
            Place::End => 0.0,
            Place::Centre => 0.5 * (1.0 - theta),
            Place::At(a) => a,
        };
        Zones::from_start_and_length(start, theta)
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

impl Condition {
    /// The condition on a zone.
    ///
    /// # Errors
    /// As for [`Constraint::mean_zero_on`] and [`Constraint::vanishing_on`].
    pub fn on(self, zones: impl Given<Zones>) -> Result<Constraint> {
        match self {
            Self::MeanZero => Constraint::mean_zero_on(zones),
            Self::Vanishing => Constraint::vanishing_on(zones),
        }
    }
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
