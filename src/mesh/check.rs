//! Checks of a triangulation given as input.

use super::geometry::{BoundaryEdge, Point, distance, doubled_area};
use crate::error::{Error, Result, ToolkitError};

/// A triangle whose area is below this multiple of its squared diameter counts as degenerate: 2^10 ε.
const FLATNESS: f64 = 1024.0 * f64::EPSILON;

/// What is wrong with a boundary edge that is not listed.
pub(super) const NO_LABEL: &str = "is on the boundary but has no label";

/// Checks that coordinates are finite, node numbers in range, areas positive, and every node belongs to a triangle.
pub(super) fn nodes_and_triangles(nodes: &[Point], triangles: &[[usize; 3]]) -> Result<()> {
    if triangles.is_empty() {
        return Err(Error::count("triangles", 0, "[1, inf)"));
    }
    for (index, point) in nodes.iter().enumerate() {
        if let Some(&value) = point.iter().find(|x| !x.is_finite()) {
            return Err(Error::Toolkit(ToolkitError::NotFinite {
                name: "node coordinate",
                index,
                value,
            }));
        }
    }
    let mut used = vec![false; nodes.len()];
    for (t, triangle) in triangles.iter().enumerate() {
        for &node in triangle {
            *used.get_mut(node).ok_or_else(|| {
                bad_triangle(t, "refers to a node that does not exist:", node as f64)
            })? = true;
        }
        let corners = triangle.map(|node| nodes[node]);
        let diameter =
            (0..3).fold(0.0, |d: f64, k| d.max(distance(corners[k], corners[(k + 1) % 3])));
        // Divided by the diameter first, so that the shape of tiny and huge triangles is computed accurately.
        let doubled = doubled_area(
            corners.map(|[x, y]| [(x - corners[0][0]) / diameter, (y - corners[0][1]) / diameter]),
        );
        if doubled < -FLATNESS {
            return Err(bad_triangle(t, "is inverted: twice its scaled area is", doubled));
        }
        if doubled.is_nan() || doubled <= FLATNESS {
            return Err(bad_triangle(t, "is degenerate: twice its scaled area is", doubled));
        }
        // Gradients are of the size of diameter/area, entries of the stiffness matrix of their squares times area.
        let area = doubled_area(corners);
        if !area.is_normal()
            || !(diameter / area).powi(2).is_finite()
            || !(diameter * diameter).is_finite()
        {
            return Err(bad_triangle(
                t,
                "is too small, too large or too thin for double precision: twice its area is",
                area,
            ));
        }
    }
    match used.iter().position(|&used| !used) {
        Some(node) => {
            Err(Error::Toolkit(ToolkitError::Node { node, reason: "belongs to no triangle" }))
        }
        None => Ok(()),
    }
}

fn bad_triangle(triangle: usize, reason: &'static str, value: f64) -> Error {
    Error::Toolkit(ToolkitError::Triangle { triangle, reason, value })
}

/// Checks that every edge belongs to one or two triangles and that the labelled edges are exactly those in one;
/// orients them with the domain on the left.
pub(super) fn boundary(labels: &mut [BoundaryEdge], triangles: &[[usize; 3]]) -> Result<()> {
    let bad = |nodes, reason| Err(Error::Toolkit(ToolkitError::Edge { nodes, reason }));
    let mut sides: Vec<([usize; 2], [usize; 2])> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|side| (sorted(side), side))
        .collect();
    sides.sort_unstable();
    let mut outer: Vec<([usize; 2], [usize; 2])> = Vec::new();
    for group in sides.chunk_by(|x, y| x.0 == y.0) {
        match group {
            [only] => outer.push(*only),
            [one, two] if one.1 != two.1 => {}
            _ => {
                return bad(
                    group[0].0,
                    "is shared by more than two triangles or by two that overlap",
                );
            }
        }
    }
    let mut labelled = vec![false; outer.len()];
    for label in labels.iter_mut() {
        let Ok(found) = outer.binary_search_by(|probe| probe.0.cmp(&sorted(label.nodes))) else {
            return bad(label.nodes, "has a label but is not on the boundary");
        };
        if std::mem::replace(&mut labelled[found], true) {
            return bad(label.nodes, "has two labels");
        }
        label.nodes = outer[found].1;
    }
    match labelled.iter().position(|&labelled| !labelled) {
        Some(missing) => bad(outer[missing].1, NO_LABEL),
        None => Ok(()),
    }
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Part, Triangulation};

    fn two_triangles(top: f64, edges: &[[usize; 2]]) -> Result<Triangulation> {
        Triangulation::new(
            &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, top]],
            &[[0, 1, 2], [0, 2, 3]],
            &edges
                .iter()
                .map(|&nodes| BoundaryEdge { nodes, part: Part::Neumann })
                .collect::<Vec<_>>(),
        )
    }

    const AROUND: [[usize; 2]; 4] = [[1, 0], [1, 2], [3, 2], [3, 0]];

    #[test]
    fn edges_are_turned_to_have_the_domain_on_their_left() {
        let mesh = two_triangles(1.0, &AROUND).unwrap();
        let turned: Vec<_> = mesh.boundary().iter().map(|edge| edge.nodes).collect();
        assert_eq!(turned, vec![[0, 1], [1, 2], [2, 3], [3, 0]]);
    }

    #[test]
    fn faults_are_named() {
        assert!(matches!(
            two_triangles(0.0, &AROUND),
            Err(Error::Toolkit(ToolkitError::Triangle { triangle: 1, .. }))
        ));
        assert!(matches!(
            two_triangles(-1.0, &AROUND),
            Err(Error::Toolkit(ToolkitError::Triangle { triangle: 1, .. }))
        ));
        assert!(matches!(
            two_triangles(1.0, &AROUND[..3]),
            Err(Error::Toolkit(ToolkitError::Edge { nodes: [3, 0], .. }))
        ));
        let inner = [AROUND[0], AROUND[1], AROUND[2], AROUND[3], [0, 2]];
        assert!(matches!(
            two_triangles(1.0, &inner),
            Err(Error::Toolkit(ToolkitError::Edge { nodes: [0, 2], .. }))
        ));
        assert!(two_triangles(f64::NAN, &AROUND).is_err());
        for size in [1e-160, 1e160] {
            let mesh = two_triangles(1.0, &AROUND).unwrap().mapped(|point| point.map(|x| size * x));
            assert!(
                matches!(mesh, Err(Error::Toolkit(ToolkitError::Triangle { triangle: 0, .. }))),
                "{size:e}"
            );
        }
    }
}
