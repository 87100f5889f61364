//! What the discrete solutions are compared with, by name.

use crate::error::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;

/// What the discrete solutions are compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// The discrete solution on the strip of the fine grid.
    Nested,
    /// The continuous harmonic function above the fine edge data.
    Harmonic,
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Reference::Nested => "nested",
            Reference::Harmonic => "harmonic",
        })
    }
}

impl FromStr for Reference {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "nested" => Ok(Reference::Nested),
            "harmonic" => Ok(Reference::Harmonic),
            _ => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "reference",
                given: text.to_owned(),
                expected: "nested or harmonic",
            })),
        }
    }
}
