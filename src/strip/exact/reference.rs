//! The reference solutions, by name.

use crate::error::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;

/// The reference with which discrete solutions are compared.
///
/// With `Nested` the error is |u_fine − u_h|_a, u_fine the discrete solution on the fine mesh; the error of the fine
/// mesh is not included. With `Harmonic` it is. Both errors depend only on the edge values.
///
/// ```
/// use signorini::strip::Reference;
/// assert_eq!(Reference::Nested.to_string().parse::<Reference>()?, Reference::Nested);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// The discrete solution on the strip of the fine grid.
    Nested,
    /// The continuous harmonic function with the fine edge data.
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
                what: "reference solution",
                given: text.to_owned(),
                expected: "nested or harmonic",
            })),
        }
    }
}
