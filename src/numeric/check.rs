//! Checks of input: length, finiteness, memory. The errors are those of the toolkit.

use crate::error::{Error, Result, ToolkitError};
use fractional_sobolev_numeric::memory::shortage;

/// Returns an error unless `given` equals `expected`.
///
/// # Errors
/// [`ToolkitError::LengthMismatch`] with this `name`.
pub(crate) fn require_length(name: &'static str, given: usize, expected: usize) -> Result<()> {
    let error = || Error::Toolkit(ToolkitError::LengthMismatch { name, given, expected });
    (given == expected).then_some(()).ok_or_else(error)
}

/// Returns an error unless every value is finite.
///
/// # Errors
/// [`ToolkitError::NotFinite`] with this `name` and the index of the first value that is not finite.
pub(crate) fn require_finite(name: &'static str, values: &[f64]) -> Result<()> {
    values.iter().enumerate().try_for_each(|(index, &value)| require_finite_at(name, index, value))
}

/// Returns an error unless the value with this index is finite.
///
/// # Errors
/// [`ToolkitError::NotFinite`] with this `name`.
pub(crate) fn require_finite_at(name: &'static str, index: usize, value: f64) -> Result<()> {
    let error = || Error::Toolkit(ToolkitError::NotFinite { name, index, value });
    value.is_finite().then_some(()).ok_or_else(error)
}

/// Returns an error unless there are `expected` values and all of them are finite.
///
/// # Errors
/// [`ToolkitError::LengthMismatch`], [`ToolkitError::NotFinite`].
pub(crate) fn require_values(name: &'static str, values: &[f64], expected: usize) -> Result<()> {
    require_length(name, values.len(), expected)?;
    require_finite(name, values)
}

/// Returns an error unless the entry with this index satisfies `admissible`; NaN never does.
///
/// # Errors
/// [`ToolkitError::NotFinite`] for NaN, [`ToolkitError::EntryOutOfRange`], with this `name`.
pub(crate) fn require_entry(
    name: &'static str,
    index: usize,
    value: f64,
    range: &'static str,
    admissible: bool,
) -> Result<()> {
    match (value.is_nan(), admissible) {
        (true, _) => Err(Error::Toolkit(ToolkitError::NotFinite { name, index, value })),
        (false, true) => Ok(()),
        (false, false) => {
            Err(Error::Toolkit(ToolkitError::EntryOutOfRange { name, index, value, range }))
        }
    }
}

/// Returns an error if `count` items of `bytes` bytes each exceed the machine's memory.
///
/// # Errors
/// [`ToolkitError::TooLarge`] with this `name`.
pub(crate) fn require_memory(name: &'static str, count: usize, bytes: usize) -> Result<()> {
    match shortage(count, bytes) {
        None => Ok(()),
        Some((needed, available)) => {
            let (needed, available) = (needed / 1e9, available / 1e9);
            Err(Error::Toolkit(ToolkitError::TooLarge { name, count, needed, available }))
        }
    }
}
