//! Beside Remark 2: the dual norm of the interpolation error of a smooth function, which is of order h².

use super::dual_norm::DualNorm;
use fractional_sobolev::Estimate;
use fractional_sobolev::Mesh;
use fractional_sobolev::Result;

/// Cells per element of the dual norm.
const CELLS: usize = 4;

/// ‖u − I^h u‖_{1/2,*} for u = −e^x on N equal elements of (0, 1).
///
/// ```
/// use experiments::interpolation::smooth_dual_error;
/// // e ≈ h² e^x/12 on average: between its mean and its L² norm
/// let scaled = smooth_dual_error(16)?.value * 12.0 * 256.0;
/// assert!(scaled > 1.71 && scaled < 2.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::CountOutOfRange`](fractional_sobolev::Error::CountOutOfRange) without elements or for more than 1024 of them.
pub fn smooth_dual_error(elements: usize) -> Result<Estimate> {
    let cells = Mesh::uniform(elements.saturating_mul(CELLS), 1.0)?;
    let h = 1.0 / elements as f64;
    DualNorm::new(&cells)?.of(|cell, t| {
        let (element, s) = (cell / CELLS, ((cell % CELLS) as f64 + t) / CELLS as f64);
        // e^{x₀} ((1−s) + s e^h − e^{sh}), with differences from 1
        (h * element as f64).exp() * (s * h.exp_m1() - (s * h).exp_m1())
    })
}
