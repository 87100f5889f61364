//! Piecewise constant and continuous piecewise linear functions on a triangulation.

use super::geometry::minus;
use super::means::Shape;
use super::triangles::Triangles;
use crate::error::Result;
use crate::numeric::check::require_values;

/// A piecewise constant or a continuous piecewise linear function.
#[doc(alias("Gagliardo", "fractional Sobolev", "H1/2", "triangulation"))]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlaneFunction {
    mesh: Triangles,
    shape: Shape,
    values: Vec<f64>,
}

impl PlaneFunction {
    /// The function with the given value on every triangle.
    ///
    /// # Errors
    /// [`crate::Error::LengthMismatch`], [`crate::Error::NotFinite`].
    pub(crate) fn constants(mesh: Triangles, values: Vec<f64>) -> Result<Self> {
        require_values("values on the triangles", &values, mesh.triangles().len())?;
        Ok(Self { mesh, shape: Shape::Constants, values })
    }

    /// The continuous function, linear on every triangle, with the given value at every node.
    ///
    /// # Errors
    /// [`crate::Error::LengthMismatch`], [`crate::Error::NotFinite`].
    pub(crate) fn linears(mesh: Triangles, values: Vec<f64>) -> Result<Self> {
        require_values("nodal values", &values, mesh.nodes().len())?;
        Ok(Self { mesh, shape: Shape::Linears, values })
    }

    /// The triangulation.
    pub(crate) fn mesh(&self) -> &Triangles {
        &self.mesh
    }

    /// The values: on triangles for piecewise constant functions, at nodes for piecewise linear ones.
    pub(crate) fn values(&self) -> &[f64] {
        &self.values
    }

    /// True for a piecewise constant function.
    pub(crate) fn is_piecewise_constant(&self) -> bool {
        self.shape == Shape::Constants
    }

    /// The two partial derivatives, which are piecewise constant.
    ///
    /// # Errors
    /// [`crate::Error::NotFinite`] on overflow.
    pub(crate) fn gradient(&self) -> Result<[Self; 2]> {
        let count = self.mesh.triangles().len();
        let mut parts = [vec![0.0; count], vec![0.0; count]];
        for triangle in (0..count).filter(|_| self.shape == Shape::Linears) {
            let [a, b, c] = self.mesh.corners(triangle);
            let [u, v, w] = self.on(triangle);
            let (p, q) = (minus(b, a), minus(c, a));
            // Twice the area with the sign of the orientation.
            let twice = 2.0 * self.mesh.areas()[triangle] * (p[0] * q[1] - p[1] * q[0]).signum();
            parts[0][triangle] = ((v - u) * (q[1] / twice)) - ((w - u) * (p[1] / twice));
            parts[1][triangle] = ((w - u) * (p[0] / twice)) - ((v - u) * (q[0] / twice));
        }
        let [x, y] = parts;
        Ok([Self::constants(self.mesh.clone(), x)?, Self::constants(self.mesh.clone(), y)?])
    }

    pub(super) fn shape(&self) -> Shape {
        self.shape
    }

    /// The values at the corners of a triangle.
    pub(super) fn on(&self, triangle: usize) -> [f64; 3] {
        match self.shape {
            Shape::Constants => [self.values[triangle]; 3],
            Shape::Linears => self.mesh.triangles()[triangle].map(|node| self.values[node]),
        }
    }
}
