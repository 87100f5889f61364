//! sup ‖φ − π^h φ‖ / |φ|_r over φ ∈ H^r(0, 1) on N equal elements, without powers of h.

use super::constant::ProjectionNorm;
use crate::error::{Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::interpolation::elements::ElementMesh;
use crate::interpolation::extremal::{Forms, extremal, extremal_on_cells};
use crate::interpolation::forms::{dual_projection_form, projection_form, seminorm_form};

/// The supremum on `elements` equal elements: a lower bound, the supremum at most `error` above it.
///
/// # Method
///
/// Between N and 2N it falls at the rate r or r + 1/2: not slower by (4.6), (4.7), not faster for any
/// estimate of this form. From piecewise linears on cells, as in Lemma 6.2; dense eigenproblems.
///
/// ```
/// use fractional_sobolev::{Tolerance, interpolation::{ProjectionNorm, projection_norm_on_cells, projection_norm_on_mesh}};
/// // r = 1: h/π, attained by cos(πNx)
/// let exact = 0.25 * std::f64::consts::FRAC_1_PI;
/// let found = projection_norm_on_mesh(ProjectionNorm::L2, 1.0, 4, Tolerance::new(1e-3)?)?;
/// assert!((found.value / exact - 1.0).abs() < 1e-3);
/// let coarse = projection_norm_on_cells(ProjectionNorm::L2, 1.0, 4, 8)?;
/// assert!(coarse.value <= exact && exact <= coarse.value + 2.0 * coarse.error);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`](crate::Error::OutOfRange) for r outside [0, 1];
/// [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) without elements or for more than 1024 of them;
/// [`Error::ToleranceNotMet`](crate::Error::ToleranceNotMet) when it takes more than 4096 cells in all.
pub fn projection_norm_on_mesh(
    norm: ProjectionNorm,
    r: f64,
    elements: usize,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let tolerance = tolerance.given()?;
    extremal(elements, tolerance, |mesh| forms(norm, r, mesh))
}

/// The same from piecewise linears on `cells` cells per element; the error is what halving the cells has
/// added.
///
/// # Errors
/// [`Error::OutOfRange`](crate::Error::OutOfRange) for r outside [0, 1];
/// [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) without elements, for fewer than 4 or an odd
/// number of cells per element, or for more than 4096 cells in all.
pub fn projection_norm_on_cells(
    norm: ProjectionNorm,
    r: f64,
    elements: usize,
    cells: usize,
) -> Result<Estimate> {
    extremal_on_cells(elements, cells, |mesh| forms(norm, r, mesh))
}

fn forms(norm: ProjectionNorm, r: f64, mesh: &ElementMesh) -> Result<Forms> {
    let form = match norm {
        ProjectionNorm::L2 => projection_form(mesh),
        ProjectionNorm::Dual => dual_projection_form(mesh)?,
    };
    Ok((seminorm_form(mesh.cells(), r)?, form))
}
