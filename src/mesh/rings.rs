//! Polar rings around the origin, geometrically graded: the mesh for a transition of boundary conditions at the
//! origin.
//!
//! The body is star-shaped with respect to the origin and lies above the axis y = 0, with the outline ϱ(θ) (cos θ,
//! sin θ), 0 ≤ θ ≤ π, ϱ(0) = ϱ(π) = 1. Ring k is the outline times e^{−k s}, with nodes at the angles jπ/n; the
//! innermost ring is filled by a fan of triangles with a vertex at the origin. Boundary conditions: on the bottom
//! Dirichlet for x < 0, contact for x > 0; the outline is free.
//!
//! All rings are similar, and the stiffness matrix of P1 elements in the plane is invariant under scaling, so that
//! the matrix is as accurate at r = 1e−100 as at r = 1. Coordinates near the origin have full relative accuracy.
//! Cost: O(n · rings).

use super::geometry::{BoundaryEdge, Part, Point};
use super::triangulation::Triangulation;
use crate::error::{Error, Result};
use std::f64::consts::PI;

/// Smallest radius for which areas have full precision in binary64.
const SMALLEST: f64 = 1e-140;
const MOST: usize = 4_000_000;

/// The outline of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Outline {
    /// The unit half disc (the polygon with vertices at the given angles).
    #[default]
    HalfDisc,
    /// The rectangle (−1, 1) × (0, 1).
    Rectangle,
}

/// The triangulation by polar rings with `angles` sectors. Ring k is the outline scaled by e^{−k `step`}; the last
/// scale factor is the first one ≤ `smallest`.
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless `angles` is a multiple of 4 in [4,
/// 512] and there are at most four million nodes; [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange)
/// unless 1e−3 ≤ `step` ≤ 2 and 1e−140 ≤ `smallest` ≤ 1/2: areas of smaller rings underflow.
pub(crate) fn polar_rings(
    outline: Outline,
    angles: usize,
    step: f64,
    smallest: f64,
) -> Result<Triangulation> {
    if !(4..=512).contains(&angles) || !angles.is_multiple_of(4) {
        let range = "{4, 8, 12, ..., 512}";
        return Err(Error::count("angles per ring", angles, range));
    }
    Error::require(
        "logarithmic step of the rings",
        step,
        "[1e-3, 2]",
        (1e-3..=2.0).contains(&step),
    )?;
    let admissible = (SMALLEST..=0.5).contains(&smallest);
    Error::require(
        "smallest radius",
        smallest,
        "[1e-140, 1/2] (areas of smaller triangles underflow)",
        admissible,
    )?;
    let rings = (-smallest.ln() / step).ceil() as usize + 1;
    let count = rings * (angles + 1) + 1;
    if count > MOST {
        return Err(Error::count("number of nodes", count, "[1, 4000000]"));
    }
    let around: Vec<Point> = (0..=angles).map(|j| direction(outline, j, angles)).collect();
    let mut nodes = Vec::with_capacity(count);
    for k in 0..rings {
        let radius = (-(k as f64) * step).exp();
        nodes.extend(around.iter().map(|[x, y]| [radius * x, radius * y]));
    }
    nodes.push([0.0, 0.0]);
    let tip = count - 1;
    let node = |k: usize, j: usize| if k == rings { tip } else { k * (angles + 1) + j };
    let mut triangles = Vec::new();
    for k in 1..rings {
        for j in 0..angles {
            let [a, b, c, d] = [node(k, j), node(k - 1, j), node(k - 1, j + 1), node(k, j + 1)];
            // Diagonals reflected at the vertical axis.
            triangles.extend(if j < angles / 2 {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            });
        }
    }
    triangles.extend((0..angles).map(|j| [tip, node(rings - 1, j), node(rings - 1, j + 1)]));
    let edge = |part, from, to| BoundaryEdge { nodes: [from, to], part };
    let boundary = (0..rings)
        .rev()
        .map(|k| edge(Part::Contact, node(k + 1, 0), node(k, 0)))
        .chain((0..angles).map(|j| edge(Part::Neumann, node(0, j), node(0, j + 1))))
        .chain((0..rings).map(|k| edge(Part::Dirichlet, node(k, angles), node(k + 1, angles))))
        .collect();
    Ok(Triangulation::trusted(nodes, triangles, boundary))
}

/// The point of the outline at the angle jπ/n; exact at 0, π/2 and π, mirrored at the vertical axis.
fn direction(outline: Outline, j: usize, angles: usize) -> Point {
    if 2 * j > angles {
        let [x, y] = direction(outline, angles - j, angles);
        return [-x, y];
    }
    let angle = PI * j as f64 / angles as f64;
    let [x, y] = match j {
        0 => [1.0, 0.0],
        _ if 2 * j == angles => [0.0, 1.0],
        _ => [angle.cos(), angle.sin()],
    };
    match outline {
        Outline::HalfDisc => [x, y],
        Outline::Rectangle if 4 * j == angles => [1.0, 1.0],
        Outline::Rectangle => [x / x.max(y), y / x.max(y)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{ContactEdge, doubled_area};

    #[test]
    fn rings_pass_the_check_of_foreign_meshes() {
        for outline in [Outline::HalfDisc, Outline::Rectangle] {
            let mesh = polar_rings(outline, 8, 0.5, 1e-100).unwrap();
            let parts =
                (mesh.nodes().to_vec(), mesh.triangles().to_vec(), mesh.boundary().to_vec());
            assert_eq!(Triangulation::new(&parts.0, &parts.1, &parts.2).unwrap(), mesh);
            let edge = ContactEdge::of(&mesh).unwrap();
            assert_eq!((edge.points()[0], edge.normal().unwrap()), ([0.0, 0.0], [0.0, -1.0]));
            assert!(edge.arc()[1] <= 1e-100 && *edge.arc().last().unwrap() == 1.0);
            let area: f64 =
                (0..mesh.triangles().len()).map(|t| doubled_area(mesh.corners(t)) / 2.0).sum();
            let whole = if outline == Outline::Rectangle { 2.0 } else { 4.0 * (PI / 8.0).sin() };
            assert!((area - whole).abs() < 1e-14, "{outline:?}: {area} {whole}");
        }
    }

    #[test]
    fn rings_that_collapse_are_refused() {
        let rings = |angles, step, smallest| polar_rings(Outline::HalfDisc, angles, step, smallest);
        assert!(rings(0, 0.4, 1e-3).is_err() && rings(6, 0.4, 1e-3).is_err());
        for step in [0.0, -0.4, 1e-9, 3.0, f64::NAN, f64::INFINITY] {
            assert!(rings(8, step, 1e-3).is_err(), "{step}");
        }
        for smallest in [0.0, -1.0, 1e-200, 1.0, f64::NAN] {
            let message = rings(8, 0.4, smallest).unwrap_err().to_string();
            assert!(message.contains("smallest radius"), "{message}");
        }
        assert!(rings(512, 1e-3, 1e-100).is_err());
    }
}
