//! The contact edge Γ_C of a triangulation as an ordered chain of nodes, or as several chains.
//!
//! A chain is oriented with the domain on its left. Its normal is the outward one; it exists if the chain is
//! straight, as assumed in Section 2.1. A scalar problem needs no normal: its chain may have corners and may be
//! closed. Different chains have no common node; each has its own normal.

use super::geometry::{Part, Point, distance};
use super::triangulation::Triangulation;
use crate::error::{Error, Result, ToolkitError};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Largest deviation of a straight chain from a line, relative to its length: the rounding of a mesh file with ten
/// printed digits.
const STRAIGHTNESS: f64 = 1e-10;
/// Rounding of coordinates relative to the size of the body, after rotation and shear; a node at the origin may be
/// the image of any point of the body.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The nodes of the contact edge Γ_C in order, one piece after another.
///
/// All arrays of contact unknowns in this crate use this order: along the chain with the domain on its left, that is,
/// from left to right on a floor.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactEdge {
    nodes: Vec<usize>,
    points: Vec<Point>,
    arc: Vec<f64>,
    starts: Vec<usize>,
    closed: bool,
    /// The largest coordinate of the body.
    size: f64,
    /// The numbers of the nodes in the file they come from.
    numbers: Vec<usize>,
}

impl ContactEdge {
    /// The contact edge of a triangulation, in one piece.
    ///
    /// ```
    /// use signorini::mesh::{ContactEdge, SideParts, unit_square};
    /// let edge = ContactEdge::of(&unit_square(4, SideParts::HANGING)?)?;
    /// assert_eq!(edge.normal()?, [0.0, -1.0]);
    /// assert_eq!(edge.arc(), [0.0, 0.25, 0.5, 0.75, 1.0]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) without a contact edge,
    /// [`ToolkitError::Edge`](crate::ToolkitError::Edge) if it has several pieces.
    pub fn of(mesh: &Triangulation) -> Result<Self> {
        let whole = Self::in_pieces(mesh)?;
        match whole.starts[..] {
            [_] => Ok(whole),
            [_, second, ..] => Err(Error::Toolkit(ToolkitError::Edge {
                nodes: [whole.numbers[second], whole.numbers[second + 1]],
                reason: "belongs to a second piece of the contact edge, which must be connected",
            })),
            [] => Err(Error::count("contact edges", 0, "[1, inf)")),
        }
    }

    /// The contact edge of a triangulation, in one or more pieces that share no node, in the order in which
    /// their first segments appear among the boundary edges. A closed curve must be the only piece.
    ///
    /// ```
    /// use signorini::mesh::{ContactEdge, Part, SideParts, unit_square};
    /// let parts = [Part::Neumann, Part::Contact, Part::Dirichlet];
    /// let sides = SideParts { right: parts[0], top: parts[1], left: parts[2], ..SideParts::HANGING };
    /// let edge = ContactEdge::in_pieces(&unit_square(2, sides)?)?;
    /// assert_eq!(edge.normals()?, [[0.0, -1.0], [0.0, 1.0]]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) without a contact edge,
    /// [`ToolkitError::Edge`](crate::ToolkitError::Edge) for a closed piece together with other pieces, or for pieces
    /// that touch.
    pub fn in_pieces(mesh: &Triangulation) -> Result<Self> {
        let edges: Vec<[usize; 2]> = mesh
            .boundary()
            .iter()
            .filter(|edge| edge.part == Part::Contact)
            .map(|edge| edge.nodes)
            .collect();
        if edges.is_empty() {
            return Err(Error::count("contact edges", 0, "[1, inf)"));
        }
        let chains = chains(&edges).map_err(|error| mesh.in_own_numbers(error))?;
        let (mut nodes, mut arc, mut starts) = (Vec::new(), Vec::new(), Vec::new());
        for (chain, _) in &chains {
            starts.push(nodes.len());
            arc.push(arc.last().copied().unwrap_or(0.0));
            for pair in chain.windows(2) {
                arc.push(
                    arc[arc.len() - 1] + distance(mesh.nodes()[pair[0]], mesh.nodes()[pair[1]]),
                );
            }
            nodes.extend_from_slice(chain);
        }
        let points: Vec<Point> = nodes.iter().map(|&node| mesh.nodes()[node]).collect();
        let size = mesh.nodes().iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        let numbers = nodes.iter().map(|&node| mesh.number(node)).collect();
        Ok(Self { nodes, points, arc, starts, closed: chains[0].1, size, numbers })
    }

    /// The range of each piece in [`ContactEdge::nodes`].
    ///
    /// ```
    /// use signorini::mesh::{ContactEdge, Part, SideParts, unit_square};
    /// let both = SideParts { top: Part::Contact, left: Part::Dirichlet, ..SideParts::HANGING };
    /// let edge = ContactEdge::in_pieces(&unit_square(2, both)?)?;
    /// assert_eq!(edge.pieces(), [0..3, 3..6]);
    /// // The domain is on the left: the top runs from right to left.
    /// assert_eq!((edge.points()[0], edge.points()[3]), ([0.0, 0.0], [1.0, 1.0]));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn pieces(&self) -> Vec<Range<usize>> {
        let ends = self.starts.iter().skip(1).copied().chain([self.nodes.len()]);
        self.starts.iter().zip(ends).map(|(&start, end)| start..end).collect()
    }

    /// Checks that the edge is in one piece.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for an edge in several pieces.
    pub(crate) fn require_one_piece(&self) -> Result<()> {
        match self.starts.len() {
            1 => Ok(()),
            value => Err(Error::count("pieces of the contact edge", value, "{1}")),
        }
    }

    /// The node numbers in order; a closed chain does not repeat its first node.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// The coordinates of the nodes in order.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The arc length at the nodes, from 0; each further piece starts at the final value of the previous one.
    pub fn arc(&self) -> &[f64] {
        &self.arc
    }

    /// True if the chain is closed, that is, an entire boundary curve.
    ///
    /// ```
    /// use signorini::mesh::{ContactEdge, Part::Contact, SideParts, unit_square};
    /// let all = SideParts { bottom: Contact, right: Contact, top: Contact, left: Contact };
    /// let edge = ContactEdge::of(&unit_square(2, all)?)?;
    /// assert!(edge.is_closed() && edge.normal().is_err());
    /// assert_eq!((edge.nodes().len(), edge.segment_lengths().iter().sum::<f64>()), (8, 4.0));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The lengths of the segments between consecutive nodes of a piece, including the closing segment of a closed
    /// chain.
    pub fn segment_lengths(&self) -> Vec<f64> {
        self.segments().map(|[i, j]| distance(self.points[i], self.points[j])).collect()
    }

    /// Half the total length of the segments at each node: the integral of its hat function.
    ///
    /// The entries sum to the length of Γ_C; a multiplier λ_i corresponds to the mean pressure λ_i / (nodal length).
    ///
    /// ```
    /// use signorini::mesh::{ContactEdge, SideParts, unit_square};
    /// let edge = ContactEdge::of(&unit_square(4, SideParts::HANGING)?)?;
    /// assert_eq!(edge.segment_lengths(), [0.25; 4]);
    /// assert_eq!(edge.nodal_lengths(), [0.125, 0.25, 0.25, 0.25, 0.125]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn nodal_lengths(&self) -> Vec<f64> {
        let mut weights = vec![0.0; self.nodes.len()];
        for ([i, j], length) in self.segments().zip(self.segment_lengths()) {
            weights[i] += 0.5 * length;
            weights[j] += 0.5 * length;
        }
        weights
    }

    /// Positions of the two ends of every segment.
    fn segments(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let count = self.nodes.len();
        let begins = move |i: usize| self.starts.binary_search(&i).is_ok();
        let closing = self.closed.then_some([count - 1, 0]);
        (1..count).filter(move |&i| !begins(i)).map(|i| [i - 1, i]).chain(closing)
    }

    /// The outward unit normals of the pieces, which must be straight.
    ///
    /// A piece is straight if its nodes deviate from the line through its ends by at most 1e-10 of its length plus 8ε
    /// times the largest coordinate of the body, which accounts for the rounding of coordinates. The normal is
    /// accurate to about the ratio of this deviation to the length.
    ///
    /// # Errors
    /// [`ToolkitError::Edge`](crate::ToolkitError::Edge) naming the first segment that deviates from the line of its piece.
    pub fn normals(&self) -> Result<Vec<Point>> {
        self.pieces().into_iter().map(|piece| self.normal_of(piece)).collect()
    }

    /// The outward unit normal of a straight contact edge in one piece.
    ///
    /// # Errors
    /// [`ToolkitError::Edge`](crate::ToolkitError::Edge) naming the first segment that deviates from the line,
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for several pieces.
    pub fn normal(&self) -> Result<Point> {
        self.require_one_piece()?;
        self.normal_of(0..self.nodes.len())
    }

    /// (b_y − a_y, a_x − b_x)/|b − a| of the first node a and the last node b; every other node is tested against the line.
    fn normal_of(&self, piece: Range<usize>) -> Result<Point> {
        let (points, arc) = (&self.points[piece.clone()], &self.arc[piece.clone()]);
        let (first, last) = (points[0], points[points.len() - 1]);
        let length = distance(first, last);
        let normal = [(last[1] - first[1]) / length, (first[0] - last[0]) / length];
        // Nodes on a line deviate from it by the rounding of their coordinates, however short the piece.
        let rounded = ROUNDING * self.size;
        let allowed = STRAIGHTNESS * length + rounded;
        for i in 1..points.len() {
            let d = [points[i][0] - first[0], points[i][1] - first[1]];
            let off = (d[0] * normal[0] + d[1] * normal[1]).abs();
            // Negated so that a closed chain (length zero, normal NaN) fails as well.
            let straight =
                off <= allowed && arc[i] - arc[0] <= length * (1.0 + STRAIGHTNESS) + rounded;
            if !straight {
                return Err(Error::Toolkit(ToolkitError::Edge {
                    nodes: [self.numbers[piece.start + i - 1], self.numbers[piece.start + i]],
                    reason: "deviates from the line of its contact edge, which must be straight: separate \
                             contact edges of different directions by a free edge",
                }));
            }
        }
        Ok(normal)
    }
}

/// Chains of edges that follow each other: those with a first node in the order of their first edges, or one
/// that closes (`true`). Cost: O(N log N).
fn chains(edges: &[[usize; 2]]) -> Result<Vec<(Vec<usize>, bool)>> {
    let pinched = |&nodes: &[usize; 2]| {
        Error::Toolkit(ToolkitError::Edge {
            nodes,
            reason: "touches another piece of the contact edge",
        })
    };
    let (mut after, mut ends) = (BTreeMap::new(), BTreeSet::new());
    for edge in edges {
        if after.insert(edge[0], edge[1]).is_some() || !ends.insert(edge[1]) {
            return Err(pinched(edge));
        }
    }
    let heads = edges.iter().map(|edge| edge[0]).filter(|start| !ends.contains(start));
    let mut found: Vec<(Vec<usize>, bool)> =
        heads.map(|head| (follow(&mut after, head), false)).collect();
    // Every edge belongs to a chain with a first node, or to a closed one.
    let Some(closed) = edges.iter().find(|edge| after.contains_key(&edge[0])) else {
        return Ok(found);
    };
    let mut nodes = follow(&mut after, closed[0]);
    nodes.pop();
    if !found.is_empty() || !after.is_empty() {
        return Err(Error::Toolkit(ToolkitError::Edge {
            nodes: *closed,
            reason: "belongs to a closed contact edge, which must be the only one",
        }));
    }
    found.push((nodes, true));
    Ok(found)
}

/// The nodes from this one on, taken from the map.
fn follow(after: &mut BTreeMap<usize, usize>, head: usize) -> Vec<usize> {
    let mut nodes = vec![head];
    while let Some(next) = after.remove(&nodes[nodes.len() - 1]) {
        nodes.push(next);
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{SideParts, mapped_grid, unit_square};

    #[test]
    fn whole_boundary_closes_and_has_no_normal() {
        let all = SideParts {
            bottom: Part::Contact,
            right: Part::Contact,
            top: Part::Contact,
            left: Part::Contact,
        };
        let edge = ContactEdge::of(&unit_square(3, all).unwrap()).unwrap();
        assert!(edge.is_closed() && edge.nodes().len() == 12 && edge.segment_lengths().len() == 12);
        assert!(edge.normal().is_err());
        let opposite = SideParts { left: Part::Neumann, right: Part::Neumann, ..all };
        let opposite = unit_square(3, opposite).unwrap();
        assert!(ContactEdge::of(&opposite).is_err());
        let both = ContactEdge::in_pieces(&opposite).unwrap();
        assert_eq!(
            (both.pieces(), both.normals()),
            (vec![0..4, 4..8], Ok(vec![[0.0, -1.0], [0.0, 1.0]]))
        );
        assert!(
            both.normal().is_err() && both.segment_lengths().len() == 6 && both.arc()[7] == 2.0
        );
        assert_eq!(both.nodal_lengths().iter().sum::<f64>(), 2.0);
        let bent = mapped_grid(4, 4, SideParts::HANGING, |[x, y]| [x, y - 0.1 * x * x]).unwrap();
        assert!(ContactEdge::of(&bent).unwrap().normal().is_err());
    }

    /// Of 1e-12 of the body, turned far from the origin and moved there: its coordinates are small, their
    /// rounding is not.
    #[test]
    fn a_short_piece_is_straight_to_the_rounding_of_the_body() {
        for step in 0..50 {
            let (sin, cos) = (0.1 + 0.12 * f64::from(step)).sin_cos();
            let turned = |[x, y]: Point| {
                [cos * (x + 1.0) - sin * (y + 1.0), sin * (x + 1.0) + cos * (y + 1.0)]
            };
            let origin = turned([0.0, 0.0]);
            let made = |bulge: f64| {
                mapped_grid(4, 4, SideParts::HANGING, |[x, y]| {
                    let off = if y == 0.0 && x == 0.5 { bulge } else { 0.0 };
                    let [a, b] = turned([(1e-12 + y) * x, y - off]);
                    [a - origin[0], b - origin[1]]
                })
                .and_then(|mesh| ContactEdge::of(&mesh)?.normal())
            };
            let normal = made(0.0).unwrap_or_else(|error| panic!("{step}: {error}"));
            assert!((normal[0] - sin).hypot(normal[1] + cos) < 1e-3, "{step}: {normal:?}");
            assert!(made(1e-13).is_err(), "{step}: a bulge of a tenth");
        }
    }
}
