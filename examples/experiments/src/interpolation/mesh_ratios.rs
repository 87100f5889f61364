//! Lemma 6.2 on one mesh: the ratios of one function, the largest on the mesh, and those of one element.

use super::{error::InterpolationError, sample::SampleSlope};
use fractional_sobolev::Estimate;
use fractional_sobolev::Result;
use fractional_sobolev::interpolation::mesh_constant_on_cells;
use fractional_sobolev::interpolation::{ErrorNorm, LocalConstants};
use fractional_sobolev::{Mesh, Order};

/// Ratios ‖u − I^h u‖₀ / (h^{1+ν} |u|\_{1+ν}), ‖(u − I^h u)'‖₀ / (h^ν |u|\_{1+ν}) and that of the full norm, in
/// this order, on N equal elements of (0, 1).
///
/// ```
/// use experiments::interpolation::{MeshRatios, SampleSlope};
/// use fractional_sobolev::{Order, Tolerance, interpolation::{LocalConstants}};
/// let slope: SampleSlope = "power:0.3".parse()?;
/// let best = LocalConstants::new(Order::HALF, Tolerance::balanced())?;
/// let found = MeshRatios::of_sample(slope, Order::HALF, &best, 4, Some(8))?;
/// assert!(found.function[1].value < found.mesh.unwrap()[1].value);
/// assert!(found.mesh.unwrap()[1].value < found.element[1].value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshRatios {
    /// Order of the lemma.
    pub nu: f64,
    /// Equal elements of (0, 1).
    pub elements: usize,
    /// Ratios of the given function on elements of length h = 1/N.
    pub function: [Estimate; 3],
    /// The largest ratios of slopes linear on cells, on small meshes; full norm on elements of length 2 h*.
    pub mesh: Option<[Estimate; 3]>,
    /// The best constants of one element; full norm on an element of length 1.
    pub element: [Estimate; 3],
}

impl MeshRatios {
    /// Ratios of a slope u' in closed form beside the best constants of its order, computed before; the largest
    /// on the mesh over slopes linear on so many cells of each element, where a number is given. Cost O(N), and
    /// for the largest that of [`mesh_constant_on_cells`] three times.
    ///
    /// # Errors
    /// Those of [`InterpolationError::of_sample`] and [`mesh_constant_on_cells`].
    pub fn of_sample(
        slope: SampleSlope,
        order: Order,
        best: &LocalConstants,
        elements: usize,
        cells: Option<usize>,
    ) -> Result<Self> {
        let mesh = Mesh::uniform(elements, 1.0)?;
        let function = InterpolationError::of_sample(slope, &mesh, order)?.ratios()?;
        let largest = |cells| {
            let on_mesh = |norm| mesh_constant_on_cells(norm, order, elements, cells);
            let long = ErrorNorm::H1 { h: 2.0 * best.longest.value };
            Ok([on_mesh(ErrorNorm::L2)?, on_mesh(ErrorNorm::Derivative)?, on_mesh(long)?])
        };
        let (nu, element) = (order.value(), [best.l2, best.derivative, best.full]);
        Ok(Self { nu, elements, function, mesh: cells.map(largest).transpose()?, element })
    }
}
