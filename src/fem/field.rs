//! Data and exact solutions given as functions of the point.

use crate::error::{Error, Result, ToolkitError};
use crate::mesh::Point;
use crate::numeric::check::require_length;

/// A function on the plane with one component (scalar forms) or two (elasticity).
///
/// ```
/// use signorini::fem::Field;
/// let rotation = |[x, y]: [f64; 2]| [-y, x];
/// let values = Field::Vector(&rotation).sample(&[[1.0, 0.0], [0.0, 2.0]])?;
/// assert_eq!(values, [0.0, 1.0, -2.0, 0.0]);
/// assert!(Field::Scalar(&|[x, _]| 1.0 / x).at([0.0, 1.0]).is_err());
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Clone, Copy)]
pub enum Field<'a> {
    /// A scalar function, for scalar forms.
    Scalar(&'a (dyn Fn(Point) -> f64 + Sync)),
    /// A vector function in Cartesian components, for elasticity.
    Vector(&'a (dyn Fn(Point) -> Point + Sync)),
}

impl std::fmt::Debug for Field<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Field with {} components", self.components())
    }
}

impl Field<'_> {
    /// Number of components.
    pub fn components(&self) -> usize {
        match self {
            Field::Scalar(_) => 1,
            Field::Vector(_) => 2,
        }
    }

    /// The value at a point; for a scalar field the second entry is 0.
    ///
    /// # Errors
    /// [`ToolkitError::NotFiniteAt`](crate::ToolkitError::NotFiniteAt) with the point at which the function returns
    /// NaN or an infinity.
    pub fn at(&self, point: Point) -> Result<Point> {
        let value = match self {
            Field::Scalar(f) => [f(point), 0.0],
            Field::Vector(f) => f(point),
        };
        match value.into_iter().find(|v| !v.is_finite()) {
            Some(value) => Err(Error::Toolkit(ToolkitError::NotFiniteAt {
                name: "value of a load or of a function",
                point,
                value,
            })),
            None => Ok(value),
        }
    }

    /// The values at the given points, node-major.
    ///
    /// # Errors
    /// As for [`Field::at`].
    pub fn sample(&self, points: &[Point]) -> Result<Vec<f64>> {
        let c = self.components();
        let mut values = Vec::with_capacity(points.len() * c);
        for &point in points {
            values.extend_from_slice(&self.at(point)?[..c]);
        }
        Ok(values)
    }

    /// Checks the number of components.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless the field has `components` components.
    pub(crate) fn require(&self, components: usize) -> Result<()> {
        require_length("components of a field", self.components(), components)
    }
}
