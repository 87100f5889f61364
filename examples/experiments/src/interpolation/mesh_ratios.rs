//! Lemma 6.2 on one mesh: the ratios of one function, the largest on the mesh, and those of one element.

use super::{error::InterpolationError, local::LocalConstants, sample::SampleSlope};
use fractional_sobolev::{Domain, ErrorNorm, Estimate, Mesh, Order, Result, interpolation_constant};

/// Accuracy asked of the largest ratios on a mesh.
const ON_MESH: f64 = 0.01;

/// Ratios ‖u − I^h u‖₀ / (h^{1+ν} |u|\_{1+ν}), ‖(u − I^h u)'‖₀ / (h^ν |u|\_{1+ν}) and that of the full norm, in
/// this order, on N equal elements of (0, 1).
///
/// ```
/// use experiments::interpolation::{LocalConstants, MeshRatios, SampleSlope};
/// use fractional_sobolev::{Order, Tolerance};
/// let slope: SampleSlope = "power:0.3".parse()?;
/// let best = LocalConstants::new(Order::HALF, Tolerance::balanced())?;
/// let found = MeshRatios::of_sample(slope, Order::HALF, &best, 4, true)?;
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
    /// The best constants on the mesh, from below, on small meshes; full norm on elements of length 2 h*.
    pub mesh: Option<[Estimate; 3]>,
    /// The best constants of one element; full norm on an element of length 1.
    pub element: [Estimate; 3],
}

impl MeshRatios {
    /// Ratios of a slope u' in closed form beside the best constants of its order, computed before; the best
    /// constants on the mesh to 1 % where they are asked for. Cost O(N), and for the mesh that of
    /// [`interpolation_constant`] three times.
    ///
    /// # Errors
    /// Those of [`InterpolationError::of_sample`] and [`interpolation_constant`].
    pub fn of_sample(
        slope: SampleSlope,
        order: Order,
        best: &LocalConstants,
        elements: usize,
        on_mesh: bool,
    ) -> Result<Self> {
        let mesh = Mesh::uniform(elements, 1.0)?;
        let function = InterpolationError::of_sample(slope, &mesh, order)?.ratios()?;
        let nu = order.value();
        // On elements of length h, in powers of h.
        let constant = |norm, h: f64, power: f64| {
            let mesh = Mesh::uniform(elements, elements as f64 * h)?;
            interpolation_constant(Domain::Mesh(mesh), norm, order, ON_MESH)?.constant.times(h.powf(-power))
        };
        let largest = || -> Result<[Estimate; 3]> {
            let long = 2.0 * best.longest.value;
            Ok([
                constant(ErrorNorm::L2, 1.0, 1.0 + nu)?,
                constant(ErrorNorm::Derivative, 1.0, nu)?,
                constant(ErrorNorm::H1, long, nu)?,
            ])
        };
        let element = [best.l2, best.derivative, best.full];
        Ok(Self { nu, elements, function, mesh: on_mesh.then(largest).transpose()?, element })
    }
}
