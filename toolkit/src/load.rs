//! Loads given by their values on hat functions.

use crate::dual::MeshFunctional;
use crate::error::{Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::mesh::Mesh;
use crate::order::Order;

/// The functional with the values ⟨f, φ_i⟩ on the hat functions φ_i of a mesh.
///
/// ```
/// use fractional_sobolev::{Load, Mesh};
/// // v ↦ ∫ v over (0, 1)
/// let f = Load::new(&Mesh::uniform(2, 1.0)?, &[0.25, 0.5, 0.25])?;
/// assert!((f.dual_norm(0.5, 1e-8)?.value - 1.0).abs() < 1e-8);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("functional", "residual"))]
#[derive(Debug)]
pub struct Load(MeshFunctional);

impl Load {
    /// The functional with one value per node.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`](crate::Error::LengthMismatch), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(mesh: &Mesh, values: &[f64]) -> Result<Self> {
        MeshFunctional::new(mesh.clone(), values).map(Self)
    }

    /// The dual norm sup ⟨f, v⟩ / ‖v‖_s, 0 < s < 1, over the piecewise linear functions v on the mesh. Cost: O(N) per
    /// step of an iteration.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`](crate::Error::ToleranceNotMet) with the best value.
    #[doc(alias("H-1/2", "negative norm"))]
    pub fn dual_norm(
        &self,
        s: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        self.0.dual_norm(s.given()?, tolerance.given()?)
    }
}
