//! Arrays in NumPy's `.npy` format.

use crate::error::{Error, Result};

/// The bytes of a `.npy` file (version 1.0, little-endian `float64`, row-major) with these values in the given number
/// of columns; a single column gives a one-dimensional array. `numpy.load` returns the same numbers, bit for bit.
///
/// ```
/// use signorini::contact::npy;
/// let bytes = npy(&[1.0, 2.0, 3.0, 4.0], 2)?;
/// assert!(bytes.starts_with(b"\x93NUMPY\x01\x00") && bytes.len() == 128 + 32);
/// assert_eq!(bytes[128..136], 1.0f64.to_le_bytes());
/// // std::fs::write("displacement.npy", bytes)
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless the number of columns divides the number of values.
#[doc(alias("NumPy", "export", "write", "file"))]
pub fn npy(values: &[f64], columns: usize) -> Result<Vec<u8>> {
    if columns == 0 || !values.len().is_multiple_of(columns) {
        let range = "the set of divisors of the number of values";
        return Err(Error::count("columns", columns, range));
    }
    let rows = values.len() / columns;
    let shape = if columns == 1 { format!("({rows},)") } else { format!("({rows}, {columns})") };
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}");
    // Ten bytes before the header; it ends with a line break, at a multiple of 64.
    let length = (10 + header.len() + 1).next_multiple_of(64) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{header:<width$}\n", width = length - 1).bytes());
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    Ok(bytes)
}
