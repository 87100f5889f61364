//! A triangle: its corners, its barycentric coordinates, and the coordinates that collapse it to a corner.

use crate::error::{Error, Result};

/// Barycentric coordinates.
pub(super) type Barycentric = [f64; 3];

/// A triangle for interpolation; its size and position do not affect the accuracy.
///
/// # Method
///
/// From the corner A with B and C behind it: x = A + τ (B − A + a (C − B)), 0 < τ, a < 1, so that τ = β_B +
/// β_C, a = β_C/τ in barycentric coordinates and dx = 2|T| τ dτ da.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TriangleShape {
    corners: [[f64; 2]; 3],
    size: f64,
    twice: f64,
    gradients: [[f64; 2]; 3],
}

/// Sine of the smallest angle that rules of a fixed size resolve.
const THINNEST: f64 = 0.1;

impl TriangleShape {
    /// The triangle with these corners.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a coordinate, [`Error::OutOfRange`] for an angle below 5.8 degrees or above
    /// its supplement.
    pub(super) fn new(corners: [[f64; 2]; 3]) -> Result<Self> {
        for (index, x) in corners.iter().flatten().enumerate() {
            crate::numeric::check::require_finite_at("coordinate", index, *x)?;
        }
        let [a, b, c] = corners;
        let edges = [minus(c, b), minus(a, c), minus(b, a)];
        let lengths = edges.map(|e| e[0].hypot(e[1]));
        let size = lengths.iter().copied().fold(0.0, f64::max);
        let unit = corners.map(|p| minus(p, a).map(|x| x / size));
        let edges = edges.map(|e| e.map(|x| x / size));
        let signed = edges[2][0] * -edges[1][1] - edges[2][1] * -edges[1][0];
        let sines = [0, 1, 2].map(|k| {
            let (first, second) = (lengths[(k + 1) % 3] / size, lengths[(k + 2) % 3] / size);
            signed.abs() / (first * second)
        });
        let least = sines.iter().copied().fold(f64::INFINITY, f64::min);
        Error::require("smallest sine of an angle", least, "[0.1, 1]", least >= THINNEST)?;
        let gradients = edges.map(|e| [-e[1] / signed, e[0] / signed]);
        Ok(Self { corners: unit, size, twice: signed.abs(), gradients })
    }

    /// The length of the longest edge.
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    /// The number 2|T| in units of the longest edge.
    pub(super) fn twice(&self) -> f64 {
        self.twice
    }

    /// The gradients of the barycentric coordinates, in those units.
    pub(super) fn gradients(&self) -> [[f64; 2]; 3] {
        self.gradients
    }

    /// The two edge vectors B − A and C − B for a corner A.
    pub(super) fn frame(&self, apex: usize) -> [[f64; 2]; 2] {
        let [a, b, c] = [0, 1, 2].map(|k| self.corners[(apex + k) % 3]);
        [minus(b, a), minus(c, b)]
    }

    /// The same triangle divided by its longest edge.
    pub(super) fn unit(&self) -> Self {
        Self { size: 1.0, ..*self }
    }
}

/// The barycentric coordinates of the point (τ, a) seen from a corner.
pub(super) fn barycentric(apex: usize, tau: f64, a: f64) -> Barycentric {
    let mut beta = [1.0 - tau; 3];
    beta[(apex + 1) % 3] = tau * (1.0 - a);
    beta[(apex + 2) % 3] = tau * a;
    beta
}

/// (τ, a) of a point seen from a corner; a = 1/2 at the corner itself.
pub(super) fn collapsed(apex: usize, beta: Barycentric) -> (f64, f64) {
    let (b, c) = (beta[(apex + 1) % 3], beta[(apex + 2) % 3]);
    if b + c > 0.0 { (b + c, c / (b + c)) } else { (0.0, 0.5) }
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The barycentric coordinates of a point.
pub(super) fn at_point(corners: &[[f64; 2]; 3], x: [f64; 2]) -> Barycentric {
    let [a, b, c] = *corners;
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let all = cross(minus(b, a), minus(c, a));
    let (second, third) =
        (cross(minus(x, a), minus(c, a)) / all, cross(minus(b, a), minus(x, a)) / all);
    [1.0 - second - third, second, third]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thin_triangles_are_refused_and_points_have_their_coordinates() {
        assert!(TriangleShape::new([[0.0, 0.0], [1.0, 0.0], [0.0, 1e-9]]).is_err());
        let corners = [[1.0, 1.0], [5.0, 1.0], [1.0, 4.0]];
        let shape = TriangleShape::new(corners).unwrap();
        assert_eq!((shape.size(), shape.corners[0]), (5.0, [0.0, 0.0]));
        let beta = at_point(&corners, [2.0, 2.5]);
        assert!((0..3).all(|k| (beta[k] - [0.25, 0.25, 0.5][k]).abs() < 1e-15), "{beta:?}");
    }
}
