//! Checks of input: length, finiteness, range of entries.

use crate::error::{Error, Result, ToolkitError};

/// Fails unless the length `given` equals `expected`.
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) under `name`.
pub(crate) fn require_length(name: &'static str, given: usize, expected: usize) -> Result<()> {
    if given == expected {
        Ok(())
    } else {
        Err(Error::Toolkit(ToolkitError::LengthMismatch { name, given, expected }))
    }
}

/// Fails unless `admissible` is true for a count.
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) under `name`.
pub(crate) fn require_count(
    name: &'static str,
    value: usize,
    range: &'static str,
    admissible: bool,
) -> Result<()> {
    if admissible {
        Ok(())
    } else {
        Err(Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range }))
    }
}

/// Fails unless every value is finite.
///
/// # Errors
/// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) under `name`, with the first index of such a value.
pub(crate) fn require_finite(name: &'static str, values: &[f64]) -> Result<()> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(Error::Toolkit(ToolkitError::NotFinite { name, index, value: values[index] })),
    }
}

/// Fails unless there are `expected` values, all finite.
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch),
/// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite).
pub(crate) fn require_values(name: &'static str, values: &[f64], expected: usize) -> Result<()> {
    require_length(name, values.len(), expected)?;
    require_finite(name, values)
}

/// Fails unless `admissible` is true for the entry with this index.
pub(crate) fn require_entry(
    name: &'static str,
    index: usize,
    value: f64,
    range: &'static str,
    admissible: bool,
) -> Result<()> {
    if value.is_nan() {
        Err(Error::Toolkit(ToolkitError::NotFinite { name, index, value }))
    } else if admissible {
        Ok(())
    } else {
        Err(Error::Toolkit(ToolkitError::EntryOutOfRange { name, index, value, range }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_named() {
        assert!(require_values("gap", &[1.0, 2.0], 2).is_ok());
        let short = require_values("gap", &[1.0], 2);
        assert_eq!(
            short,
            Err(Error::Toolkit(ToolkitError::LengthMismatch { name: "gap", given: 1, expected: 2 }))
        );
        let infinite = require_finite("gap", &[1.0, f64::INFINITY]);
        assert_eq!(
            infinite,
            Err(Error::Toolkit(ToolkitError::NotFinite { name: "gap", index: 1, value: f64::INFINITY }))
        );
    }
}
