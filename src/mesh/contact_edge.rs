//! The contact edge Γ_C of a triangulation as an ordered chain of nodes.
//!
//! The chain runs with the domain on its left. Its normal is the outward one; it exists when the chain is
//! straight, as Section 2.1 assumes. A scalar problem needs no normal: its chain may turn corners, and may be
//! closed.

use super::geometry::{Part, Point, distance};
use super::triangulation::Triangulation;
use crate::error::{Error, Result};

/// Chains that deviate from a line by more than this times their length are not straight: what a mesh file of
/// ten printed digits may round away.
const STRAIGHTNESS: f64 = 1e-10;

/// The nodes of Γ_C in order.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactEdge {
    nodes: Vec<usize>,
    points: Vec<Point>,
    arc: Vec<f64>,
    closed: bool,
}

impl ContactEdge {
    /// The contact edge of a triangulation.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without a contact edge, [`Error::Edge`] when it falls into several pieces.
    pub fn of(mesh: &Triangulation) -> Result<Self> {
        let edges: Vec<[usize; 2]> =
            mesh.boundary().iter().filter(|edge| edge.part == Part::Contact).map(|edge| edge.nodes).collect();
        let Some(&first) = edges.first() else {
            return Err(Error::CountOutOfRange { name: "contact edges", value: 0, range: "[1, inf)" });
        };
        let (nodes, closed) = chain(&edges, first)?;
        let points: Vec<Point> = nodes.iter().map(|&node| mesh.nodes()[node]).collect();
        let mut arc = vec![0.0];
        for pair in points.windows(2) {
            arc.push(arc[arc.len() - 1] + distance(pair[0], pair[1]));
        }
        Ok(Self { nodes, points, arc, closed })
    }

    /// Node numbers in order; a closed chain does not repeat its first node.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Coordinates of the nodes in order.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Arc length at the nodes, from 0.
    pub fn arc(&self) -> &[f64] {
        &self.arc
    }

    /// True when the chain is the whole of a boundary curve.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// Lengths of the segments between consecutive nodes; for a closed chain also of the closing one.
    pub fn segment_lengths(&self) -> Vec<f64> {
        let ends = self.points.len() - usize::from(!self.closed);
        (0..ends).map(|i| distance(self.points[i], self.points[(i + 1) % self.points.len()])).collect()
    }

    /// Half the length of the segments at each node: the integral of the hat function.
    pub fn nodal_lengths(&self) -> Vec<f64> {
        let mut weights = vec![0.0; self.nodes.len()];
        for (i, length) in self.segment_lengths().into_iter().enumerate() {
            weights[i] += 0.5 * length;
            weights[(i + 1) % self.nodes.len()] += 0.5 * length;
        }
        weights
    }

    /// The outward unit normal of a straight contact edge.
    ///
    /// # Errors
    /// [`Error::Edge`] naming the first segment that leaves the line.
    pub fn normal(&self) -> Result<Point> {
        let (first, last) = (self.points[0], self.points[self.points.len() - 1]);
        let length = distance(first, last);
        let normal = [(last[1] - first[1]) / length, (first[0] - last[0]) / length];
        for i in 1..self.points.len() {
            let d = [self.points[i][0] - first[0], self.points[i][1] - first[1]];
            let off = (d[0] * normal[0] + d[1] * normal[1]).abs();
            // Written so that a closed chain (length zero, normal not a number) fails, too.
            let straight = off <= STRAIGHTNESS * length && self.arc[i] <= length * (1.0 + STRAIGHTNESS);
            if !straight {
                return Err(Error::Edge {
                    nodes: [self.nodes[i - 1], self.nodes[i]],
                    reason: "leaves the line of the contact edge, which must be straight",
                });
            }
        }
        Ok(normal)
    }
}

/// Orders edges that follow each other; true when they close.
fn chain(edges: &[[usize; 2]], first: [usize; 2]) -> Result<(Vec<usize>, bool)> {
    let mut by_start: Vec<[usize; 2]> = edges.to_vec();
    by_start.sort_unstable();
    let after = |node: usize| {
        let at = by_start.partition_point(|edge| edge[0] < node);
        by_start.get(at).filter(|edge| edge[0] == node).map(|edge| edge[1])
    };
    let mut ends: Vec<usize> = edges.iter().map(|edge| edge[1]).collect();
    ends.sort_unstable();
    let head = edges.iter().map(|edge| edge[0]).find(|start| ends.binary_search(start).is_err());
    let mut nodes = vec![head.unwrap_or(first[0])];
    while let Some(next) = after(nodes[nodes.len() - 1]) {
        if next == nodes[0] || nodes.len() > edges.len() {
            break;
        }
        nodes.push(next);
    }
    let expected = edges.len() + usize::from(head.is_some());
    if nodes.len() == expected {
        return Ok((nodes, head.is_none()));
    }
    let outside = edges.iter().find(|edge| !nodes.contains(&edge[0]));
    Err(Error::Edge {
        nodes: *outside.unwrap_or(&first),
        reason: "belongs to a second piece of the contact edge, which must be in one piece",
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Sides, mapped_grid, unit_square};

    #[test]
    fn bottom_of_the_square_points_down() {
        let edge = ContactEdge::of(&unit_square(4, Sides::HANGING).unwrap()).unwrap();
        assert_eq!(edge.nodes(), [0, 1, 2, 3, 4]);
        assert_eq!(edge.normal(), Ok([0.0, -1.0]));
        assert_eq!(edge.nodal_lengths(), [0.125, 0.25, 0.25, 0.25, 0.125]);
        assert!(!edge.is_closed());
    }

    #[test]
    fn whole_boundary_closes_and_has_no_normal() {
        let all =
            Sides { bottom: Part::Contact, right: Part::Contact, top: Part::Contact, left: Part::Contact };
        let edge = ContactEdge::of(&unit_square(3, all).unwrap()).unwrap();
        assert!(edge.is_closed() && edge.nodes().len() == 12 && edge.segment_lengths().len() == 12);
        assert!(edge.normal().is_err());
        let opposite = Sides { left: Part::Neumann, right: Part::Neumann, ..all };
        assert!(ContactEdge::of(&unit_square(3, opposite).unwrap()).is_err());
        let bent = mapped_grid(4, 4, Sides::HANGING, |[x, y]| [x, y - 0.1 * x * x]).unwrap();
        assert!(ContactEdge::of(&bent).unwrap().normal().is_err());
    }
}
