//! Points of a triangulation, with exact offsets from declared corners.

use crate::error::{Error, Result};
use crate::plane::geometry::{Point, dot, length, minus, product_difference};
use crate::plane::triangles::Triangles;
use std::f64::consts::PI;

/// A node at which w = w₀ + r^a times a smooth function of the angle and of r.
#[derive(Debug, Clone)]
pub(super) struct Corner {
    pub(super) node: usize,
    pub(super) exponent: f64,
    at: Point,
    /// Direction and angle of the centre of every triangle.
    seen: Vec<(Point, f64)>,
}

/// The declared corners of one function.
#[derive(Debug, Clone)]
pub(super) struct Corners {
    pub(super) all: Vec<Corner>,
}

/// A point of a triangle of a triangulation.
///
/// In the triangles at a declared corner the offset from that corner is exact down to 1e-290; the coordinates
/// are rounded.
///
/// ```
/// use fractional_sobolev::{Function, Triangles};
/// // r² sin²φ + x² = r² about the declared corner 0, a node of both triangles of the unit square
/// let square = Triangles::star(&[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// let w = Function::from_plane_positions(&square, &[(0, 2.0)], |at| {
///     assert!(at.triangle() < 2 && at.offset(0)[0] >= 0.0);
///     (at.radius(0) * at.angle(0).sin()).powi(2) + at.x()[0].powi(2)
/// })?;
/// assert!((w.norm(0.0, 1e-8)?.value.powi(2) - 28.0 / 45.0).abs() < 1e-7);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct PlanePosition<'a> {
    corners: &'a Corners,
    triangle: usize,
    x: Point,
    /// The declared corner relative to which the point is given, and the offset.
    anchor: Option<(usize, Point)>,
}

impl<'a> PlanePosition<'a> {
    pub(super) fn new(
        corners: &'a Corners,
        triangle: usize,
        x: Point,
        anchor: Option<(usize, Point)>,
    ) -> Self {
        Self { corners, triangle, x, anchor }
    }

    /// The coordinates, rounded.
    pub fn x(&self) -> [f64; 2] {
        self.x
    }

    /// The number of the triangle.
    pub fn triangle(&self) -> usize {
        self.triangle
    }

    /// The offset of x from the declared corner with this number, in the order of declaration; NaN if there
    /// is none.
    pub fn offset(&self, corner: usize) -> [f64; 2] {
        match (self.anchor, self.corners.all.get(corner)) {
            (Some((anchor, offset)), _) if anchor == corner => offset,
            (_, Some(corner)) => minus(self.x, corner.at),
            _ => [f64::NAN; 2],
        }
    }

    /// The distance r from the declared corner with this number.
    pub fn radius(&self, corner: usize) -> f64 {
        length(self.offset(corner))
    }

    /// The angle φ at the declared corner with this number, counterclockwise from the side of the polygon at
    /// which the interior begins; from the first axis if the corner is an interior point. It is continuous on
    /// every triangle, and in [0, 2π] on those at the corner.
    pub fn angle(&self, corner: usize) -> f64 {
        let Some(known) = self.corners.all.get(corner) else { return f64::NAN };
        let (middle, angle) = known.seen[self.triangle];
        let offset = self.offset(corner);
        angle + angle_between(middle, offset)
    }
}

/// The angle from a to b in (−π, π].
pub(super) fn angle_between(a: Point, b: Point) -> f64 {
    product_difference(a[0], b[1], a[1], b[0]).atan2(dot(a, b))
}

impl Corners {
    /// The declared corners from pairs (node, exponent).
    pub(super) fn new(mesh: &Triangles, declared: &[(usize, f64)]) -> Result<Self> {
        let mut all: Vec<Corner> = Vec::with_capacity(declared.len());
        for &(node, exponent) in declared {
            Error::require(
                "exponent a",
                exponent,
                "(-1, 20]",
                exponent > -1.0 && exponent <= 20.0,
            )?;
            if !mesh.triangles().iter().any(|corners| corners.contains(&node)) {
                return Err(Error::Node { node, reason: "is not a corner of a triangle" });
            }
            if all.iter().any(|corner| corner.node == node) {
                return Err(Error::Node { node, reason: "is declared twice" });
            }
            all.push(Corner { node, exponent, at: mesh.nodes()[node], seen: seen(mesh, node) });
        }
        let corners = Self { all };
        for (triangle, nodes) in mesh.triangles().iter().enumerate() {
            let count = nodes.iter().filter(|&&node| corners.at(node).is_some()).count();
            if count > 1 {
                let reason =
                    "must be subdivided (Triangles::cut_at): its number of declared corners is";
                return Err(Error::Triangle { triangle, reason, value: count as f64 });
            }
        }
        Ok(corners)
    }

    /// The number of the declared corner at a node.
    pub(super) fn at(&self, node: usize) -> Option<usize> {
        self.all.iter().position(|corner| corner.node == node)
    }
}

/// Direction and angle of the centre of every triangle, seen from a node.
fn seen(mesh: &Triangles, node: usize) -> Vec<(Point, f64)> {
    let from = mesh.nodes()[node];
    let start = first_side(mesh, node);
    let one = |triangle: usize| {
        let [a, b, c] = mesh.corners(triangle).map(|p| minus(p, from));
        let middle = [a[0] / 3.0 + b[0] / 3.0 + c[0] / 3.0, a[1] / 3.0 + b[1] / 3.0 + c[1] / 3.0];
        let size = length(middle);
        let direction = middle.map(|x| x / size);
        let angle = angle_between(start, direction);
        (direction, if angle < 0.0 { angle + 2.0 * PI } else { angle })
    };
    (0..mesh.triangles().len()).map(one).collect()
}

/// The direction of the side at a node from which the polygon lies counterclockwise; the first axis for an
/// interior node.
fn first_side(mesh: &Triangles, node: usize) -> Point {
    let from = mesh.nodes()[node];
    let fan: Vec<[usize; 2]> = (mesh.triangles().iter())
        .filter_map(|corners| {
            let k = corners.iter().position(|&corner| corner == node)?;
            let ends = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            let [a, b] = ends.map(|end| minus(mesh.nodes()[end], from));
            let is_turned = product_difference(a[0], b[1], a[1], b[0]) < 0.0;
            Some(if is_turned { [ends[1], ends[0]] } else { ends })
        })
        .collect();
    let first = fan.iter().find(|[a, _]| fan.iter().all(|[_, end]| end != a));
    first.map_or([1.0, 0.0], |&[a, _]| {
        let side = minus(mesh.nodes()[a], from);
        side.map(|x| x / length(side))
    })
}
