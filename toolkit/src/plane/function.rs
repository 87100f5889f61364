//! Piecewise constant and continuous piecewise linear functions on a triangulation.

use super::geometry::minus;
use super::means::Shape;
use super::triangles::Triangles;
use crate::error::Result;
use crate::numeric::check::require_values;

/// A piecewise constant or a continuous piecewise linear function.
///
/// ```
/// use fractional_sobolev::{Order, PlaneFunction, Tolerance, Triangles};
/// let x = PlaneFunction::linears(Triangles::grid([1, 1], 1.0)?, vec![0.0, 1.0, 0.0, 1.0])?;
/// let (order, asked) = (Order::new(0.3)?, Tolerance::balanced());
/// assert!((x.l2_norm(asked)?.value - 1.0 / 3f64.sqrt()).abs() < 1e-14);
/// assert!(x.norm(order, asked)?.value > x.l2_norm(asked)?.value);
/// // the gradient (1, 0) on both triangles has no seminorm: ||x||²_{1+s} = 1/3 + 1
/// assert!((x.norm_with_gradient(order, asked)?.value.powi(2) - 4.0 / 3.0).abs() < 1e-8);
/// let [along, across] = x.gradient()?;
/// assert!(along.is_piecewise_constant() && along.values() == [1.0, 1.0] && across.values() == [0.0, 0.0]);
/// assert_eq!(x.mesh().triangles().len(), 2);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("Gagliardo", "fractional Sobolev", "H1/2", "triangulation"))]
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneFunction {
    mesh: Triangles,
    shape: Shape,
    values: Vec<f64>,
}

impl PlaneFunction {
    /// The function with the given value on every triangle.
    ///
    /// ```
    /// use fractional_sobolev::{PlaneFunction, Triangles};
    /// let triangle = Triangles::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], vec![[0, 1, 2]])?;
    /// assert!(PlaneFunction::constants(triangle, vec![2.0])?.seminorm(0.25, 1e-6)?.value < 1e-12);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`crate::Error::LengthMismatch`], [`crate::Error::NotFinite`].
    pub fn constants(mesh: Triangles, values: Vec<f64>) -> Result<Self> {
        require_values("values on triangles", &values, mesh.triangles().len())?;
        Ok(Self { mesh, shape: Shape::Constants, values })
    }

    /// The continuous function, linear on every triangle, with the given value at every node.
    ///
    /// # Errors
    /// [`crate::Error::LengthMismatch`], [`crate::Error::NotFinite`].
    pub fn linears(mesh: Triangles, values: Vec<f64>) -> Result<Self> {
        require_values("values at nodes", &values, mesh.nodes().len())?;
        Ok(Self { mesh, shape: Shape::Linears, values })
    }

    /// The triangulation.
    pub fn mesh(&self) -> &Triangles {
        &self.mesh
    }

    /// The values: of triangles for piecewise constants, of nodes for piecewise linears.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// True for a piecewise constant function.
    pub fn is_piecewise_constant(&self) -> bool {
        self.shape == Shape::Constants
    }

    /// The two partial derivatives, piecewise constant.
    ///
    /// # Errors
    /// [`crate::Error::NotFinite`] on overflow.
    pub fn gradient(&self) -> Result<[Self; 2]> {
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
