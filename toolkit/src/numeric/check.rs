//! Checks of input: length, finiteness, memory.

use super::Error;
use fractional_sobolev_numeric::memory::shortage;

/// Returns an error unless `given` equals `expected`.
///
/// # Errors
/// [`Error::LengthMismatch`] with this `name`.
pub(crate) fn require_length(
    name: &'static str,
    given: usize,
    expected: usize,
) -> Result<(), Error> {
    if given == expected { Ok(()) } else { Err(Error::LengthMismatch { name, given, expected }) }
}

/// Returns an error unless every value is finite.
///
/// # Errors
/// [`Error::NotFinite`] with this `name` and the index of the first value that is not finite.
pub(crate) fn require_finite(name: &'static str, values: &[f64]) -> Result<(), Error> {
    values.iter().enumerate().try_for_each(|(index, &value)| require_finite_at(name, index, value))
}

/// Returns an error unless the value with this index is finite.
///
/// # Errors
/// [`Error::NotFinite`] with this `name`.
pub(crate) fn require_finite_at(name: &'static str, index: usize, value: f64) -> Result<(), Error> {
    if value.is_finite() { Ok(()) } else { Err(Error::NotFinite { name, index, value }) }
}

/// Returns an error unless there are `expected` values and all of them are finite.
///
/// # Errors
/// [`Error::LengthMismatch`], [`Error::NotFinite`].
pub(crate) fn require_values(
    name: &'static str,
    values: &[f64],
    expected: usize,
) -> Result<(), Error> {
    require_length(name, values.len(), expected)?;
    require_finite(name, values)
}

/// Returns an error unless the entry with this index satisfies `admissible`.
pub(crate) fn require_entry(
    name: &'static str,
    index: usize,
    value: f64,
    range: &'static str,
    admissible: bool,
) -> Result<(), Error> {
    require_not_nan(name, index, value)?;
    if admissible { Ok(()) } else { Err(Error::EntryOutOfRange { name, index, value, range }) }
}

/// Returns an error if `count` items of `bytes` bytes each exceed the machine's memory.
///
/// # Errors
/// [`Error::TooLarge`] with this `name`.
pub(crate) fn require_memory(name: &'static str, count: usize, bytes: usize) -> Result<(), Error> {
    match shortage(count, bytes) {
        None => Ok(()),
        Some((needed, available)) => {
            Err(Error::TooLarge { name, count, needed: needed / 1e9, available: available / 1e9 })
        }
    }
}

fn require_not_nan(name: &'static str, index: usize, value: f64) -> Result<(), Error> {
    if value.is_nan() { Err(Error::NotFinite { name, index, value }) } else { Ok(()) }
}
