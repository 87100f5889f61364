//! Quadrature on the pieces of a triangle, and on its sides.

use crate::error::Result;
use fractional_sobolev::{gauss_jacobi, gauss_legendre};

/// Points of a triangle by their barycentric coordinates, weights in units of its area.
#[derive(Debug, Clone)]
pub(super) struct TriangleRule {
    pub(super) points: Vec<([f64; 3], f64)>,
}

impl TriangleRule {
    /// n × n points, exact for degree 2n − 1: the Jacobian s is the weight of the radial rule.
    pub(super) fn new(n: usize) -> Result<Self> {
        let (radial, across) = (gauss_jacobi(n, 0.0, 1.0)?, gauss_legendre(n)?);
        let mut points = Vec::with_capacity(n * n);
        for (s, v) in radial.iter() {
            for (t, w) in across.iter() {
                points.push(([1.0 - s, s * (1.0 - t), s * t], 2.0 * v * w));
            }
        }
        Ok(Self { points })
    }
}
