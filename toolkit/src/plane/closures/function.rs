//! Functions of two variables given by code, smooth in every triangle except at declared corners.

use super::position::{Corners, PlanePosition};
use crate::error::Result;
use crate::numeric::check::require_finite_at;
use crate::numeric::scale::power_of_two;
use crate::plane::geometry::{Point, minus};
use crate::plane::triangles::Triangles;
use std::collections::HashMap;

/// A function that is smooth in every triangle, except that w = w₀ + r^a (smooth function of r and of the
/// angle) at declared corners. It may jump across edges.
pub(crate) struct SingularPlaneFunction<'a> {
    mesh: Triangles,
    corners: Corners,
    function: Box<dyn Fn(&PlanePosition<'_>) -> f64 + Sync + 'a>,
    largest: f64,
    jumps: bool,
}

impl std::fmt::Debug for SingularPlaneFunction<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SingularPlaneFunction")
            .field("triangles", &self.mesh.triangles().len())
            .field("corners", &self.corners.all.len())
            .finish_non_exhaustive()
    }
}

/// Barycentric coordinates of the points at which the size of a function is estimated.
const SAMPLES: [[f64; 3]; 4] =
    [[0.34, 0.33, 0.33], [0.8, 0.1, 0.1], [0.1, 0.8, 0.1], [0.1, 0.1, 0.8]];
/// Positions on an edge at which both sides are compared.
const EDGE_SAMPLES: [f64; 3] = [0.2, 0.5, 0.7];
/// Values on both sides count as equal if they differ by less than this share of the largest value.
const EQUAL: f64 = 1e-9;

impl<'a> SingularPlaneFunction<'a> {
    /// The function w on a triangulation; `corners` are pairs (node, a).
    ///
    /// # Errors
    /// [`crate::Error::OutOfRange`] unless −1 < a ≤ 20, [`crate::Error::Node`] for a node that belongs to
    /// no triangle or is declared twice, [`crate::Error::Triangle`] for a triangle with two declared
    /// corners, [`crate::Error::NotFinite`] for a sampled value that is not finite.
    pub(crate) fn new(
        mesh: Triangles,
        corners: &[(usize, f64)],
        function: impl Fn(&PlanePosition<'_>) -> f64 + Sync + 'a,
    ) -> Result<Self> {
        let corners = Corners::new(&mesh, corners)?;
        let mut made =
            Self { mesh, corners, function: Box::new(function), largest: 0.0, jumps: false };
        for triangle in 0..made.mesh.triangles().len() {
            for shares in SAMPLES {
                let value = made.at_shares(triangle, shares);
                require_finite_at("function value in a triangle", triangle, value)?;
                made.largest = made.largest.max(value.abs());
            }
        }
        made.jumps = made.finds_jump();
        Ok(made)
    }

    /// The triangulation.
    pub(crate) fn mesh(&self) -> &Triangles {
        &self.mesh
    }

    pub(super) fn corners(&self) -> &Corners {
        &self.corners
    }

    /// True if the values on the two sides of an inner edge differ.
    pub(super) fn jumps(&self) -> bool {
        self.jumps
    }

    /// A power of two comparable to the values.
    pub(super) fn unit(&self) -> f64 {
        power_of_two(self.largest)
    }

    /// The value at base + offset, where `anchor` is the declared corner at the base.
    pub(super) fn at(
        &self,
        triangle: usize,
        base: Point,
        offset: Point,
        anchor: Option<usize>,
    ) -> f64 {
        let x = [base[0] + offset[0], base[1] + offset[1]];
        let anchor = anchor.map(|corner| (corner, offset));
        (self.function)(&PlanePosition::new(&self.corners, triangle, x, anchor))
    }

    /// The value at a weighted mean of the corners of a triangle.
    fn at_shares(&self, triangle: usize, shares: [f64; 3]) -> f64 {
        let (nodes, corners) = (self.mesh.triangles()[triangle], self.mesh.corners(triangle));
        let known = (0..3).find_map(|k| self.corners.at(nodes[k]).map(|corner| (k, corner)));
        let base = corners[known.map_or(0, |(k, _)| k)];
        let offset =
            |axis: usize| (0..3).map(|k| shares[k] * minus(corners[k], base)[axis]).sum::<f64>();
        self.at(triangle, base, [offset(0), offset(1)], known.map(|(_, corner)| corner))
    }

    fn finds_jump(&self) -> bool {
        let mut seen: HashMap<[usize; 2], [f64; 3]> = HashMap::new();
        for (triangle, nodes) in self.mesh.triangles().iter().enumerate() {
            for k in 0..3 {
                let (i, j) =
                    if nodes[k] < nodes[(k + 1) % 3] { (k, (k + 1) % 3) } else { ((k + 1) % 3, k) };
                let values = EDGE_SAMPLES.map(|share| {
                    let mut shares = [0.0; 3];
                    (shares[i], shares[j]) = (1.0 - share, share);
                    self.at_shares(triangle, shares)
                });
                if let Some(other) = seen.insert([nodes[i], nodes[j]], values) {
                    let differ = |k: usize| (values[k] - other[k]).abs() > EQUAL * self.largest;
                    if (0..3).any(differ) {
                        return true;
                    }
                }
            }
        }
        false
    }
}
