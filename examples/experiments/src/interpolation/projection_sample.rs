//! ‖φ − π^h φ‖₀ and ‖φ − π^h φ‖_{1/2,*} of one φ in closed form.

use super::dual_norm::DualNorm;
use super::elements::ElementMesh;
use super::{
    norms::{require_unit, sample_norms},
    panels::PanelRules,
    sample::SampleSlope,
};
use fractional_sobolev::Estimate;
use fractional_sobolev::Mesh;
use fractional_sobolev::Result;

/// ‖φ − π^h φ‖₀ on a mesh of (0, 1) for φ in closed form; cost O(N).
///
/// ```
/// use experiments::interpolation::{SampleSlope, sample_projection_dual_error, sample_projection_error};
/// use fractional_sobolev::{Mesh};
/// // φ = x on 4 elements: h/√12
/// let phi = SampleSlope::Power(1.0);
/// let found = sample_projection_error(phi, &Mesh::uniform(4, 1.0)?)?;
/// assert!((found.value - 0.25 / 12f64.sqrt()).abs() < 1e-12);
/// let cells = Mesh::uniform(32, 1.0)?;
/// assert!(sample_projection_dual_error(phi, &cells, 8)?.value < found.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`](fractional_sobolev::Error::OutOfRange) unless the mesh is one of (0, 1), or for parameters of φ
/// out of range.
pub fn sample_projection_error(phi: SampleSlope, mesh: &Mesh) -> Result<Estimate> {
    sample_norms(phi, mesh).map(|(_, projection)| projection)
}

/// ‖φ − π^h φ‖\_{1/2,*} for φ in closed form, on elements of `cells_per_element` cells of a mesh of (0, 1): the
/// supremum over the piecewise linears on the cells, its error from the cells joined in pairs. Cost O(N³).
///
/// # Errors
/// [`Error::LengthMismatch`](fractional_sobolev::Error::LengthMismatch) unless the cells divide into such elements;
/// [`Error::OutOfRange`](fractional_sobolev::Error::OutOfRange) for another interval;
/// [`Error::CountOutOfRange`](fractional_sobolev::Error::CountOutOfRange) for an odd number of cells or more than 4096.
pub fn sample_projection_dual_error(
    phi: SampleSlope,
    cells: &Mesh,
    cells_per_element: usize,
) -> Result<Estimate> {
    projection_dual_error(phi, &DualNorm::new(cells)?, cells_per_element)
}

/// [`sample_projection_dual_error`] with a norm that is factorized.
pub(super) fn projection_dual_error(
    phi: SampleSlope,
    norm: &DualNorm,
    cells_per_element: usize,
) -> Result<Estimate> {
    phi.check()?;
    require_unit(norm.cells())?;
    let (lengths, starts) = (norm.cells().lengths(), norm.cells().from_left());
    let elements = lengths.len() / cells_per_element.max(1);
    let mesh = ElementMesh::new(norm.cells().clone(), &vec![cells_per_element; elements])?;
    let rules = PanelRules::new()?;
    let mut load = vec![0.0; lengths.len() + 1];
    for range in mesh.elements() {
        let moments: Vec<[f64; 2]> =
            range.clone().map(|i| phi.cell_moments(starts[i], lengths[i], &rules)).collect();
        let integral: f64 = range.clone().zip(&moments).map(|(i, m)| lengths[i] * (m[0] + m[1])).sum();
        let mean = integral / mesh.cells().lengths()[range.clone()].iter().sum::<f64>();
        for (i, [falling, rising]) in range.clone().zip(moments) {
            load[i] += lengths[i] * (falling - 0.5 * mean);
            load[i + 1] += lengths[i] * (rising - 0.5 * mean);
        }
    }
    norm.of_load(&load)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_by_moments_are_those_of_points() {
        // φ = x: loads of φ − π φ by moments and by Gauss points.
        let cells = Mesh::uniform(32, 1.0).unwrap();
        let sample = sample_projection_dual_error(SampleSlope::Power(1.0), &cells, 4).unwrap();
        let direct = DualNorm::new(&cells).unwrap().of(|i, t| ((i % 4) as f64 + t - 2.0) / 32.0).unwrap();
        assert!((sample.value / direct.value - 1.0).abs() < 1e-10, "{sample} {direct}");
    }
}
