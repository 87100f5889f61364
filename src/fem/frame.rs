//! The directions of the two unknowns of a node: Cartesian, or those of a straight contact edge.

use crate::mesh::Point;
use qd::Quad;

/// The two unknowns of every node: Cartesian, or (u_T, u_N) with u_T = u·t, u_N = u·n, t = (−n_y, n_x).
///
/// The transformation is orthogonal (a reflection), so lengths are preserved. On a floor, n = (0, −1),
/// u_N = −u_y and u_T = u_x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    normal: Option<Point>,
}

impl Frame {
    /// The frame with Cartesian unknowns.
    pub(crate) fn cartesian() -> Self {
        Self { normal: None }
    }

    /// The frame with unknowns (u_T, u_N) for the given unit normal.
    pub(crate) fn turned(normal: Point) -> Self {
        Self { normal: Some(normal) }
    }

    /// The components (u_T, u_N) of a vector given by its Cartesian components.
    pub(crate) fn to_frame(self, [x, y]: Point) -> Point {
        let Some([nx, ny]) = self.normal else { return [x, y] };
        [ny.mul_add(-x, nx * y), nx.mul_add(x, ny * y)]
    }

    /// The Cartesian components of a vector given by (u_T, u_N).
    pub(crate) fn to_cartesian(self, [t, n]: Point) -> Point {
        let Some([nx, ny]) = self.normal else { return [t, n] };
        [ny.mul_add(-t, nx * n), nx.mul_add(t, ny * n)]
    }

    /// Whether the unknowns are Cartesian components up to sign and order.
    fn is_along_axes(&self) -> bool {
        self.normal.is_none_or(|normal| normal.contains(&0.0))
    }

    /// The components (u_T, u_N) in double-double.
    fn to_frame_precisely(self, [x, y]: [Quad; 2]) -> [Quad; 2] {
        let Some(normal) = self.normal else { return [x, y] };
        let [nx, ny] = normal.map(Quad::from);
        [nx * y - ny * x, nx * x + ny * y]
    }

    /// R B R'.
    pub(super) fn turn_block(&self, block: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        self.turn_between(block, self)
    }

    /// R B S', S the turn of the other frame.
    fn turn_between(&self, block: [[f64; 2]; 2], other: &Frame) -> [[f64; 2]; 2] {
        if self.normal.is_none() && other.normal.is_none() {
            return block;
        }
        let rows = block.map(|row| other.to_frame(row));
        let columns = [0, 1].map(|b| self.to_frame([rows[0][b], rows[1][b]]));
        [[columns[0][0], columns[1][0]], [columns[0][1], columns[1][1]]]
    }
}

/// The frame of every node: one for all, or that of its own contact edge on the nodes of several edges.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frames {
    common: Frame,
    /// The separate frames by node, in ascending order.
    own: Vec<(usize, Frame)>,
}

impl Frames {
    pub(crate) fn all(common: Frame) -> Self {
        Self { common, own: Vec::new() }
    }

    /// Frames of single nodes, Cartesian ones elsewhere.
    pub(crate) fn of_nodes(mut own: Vec<(usize, Frame)>) -> Self {
        own.sort_unstable_by_key(|&(node, _)| node);
        Self { common: Frame::cartesian(), own }
    }

    /// The frame where it is the same for all nodes.
    pub(crate) fn common(&self) -> Option<&Frame> {
        if self.own.is_empty() { Some(&self.common) } else { None }
    }

    /// Whether no frame mixes Cartesian components.
    pub(crate) fn are_along_axes(&self) -> bool {
        self.common.is_along_axes() && self.own.iter().all(|(_, frame)| frame.is_along_axes())
    }

    /// The block of two nodes in the unknowns of their frames, in double-double.
    pub(super) fn turn_precisely(
        &self,
        block: [[Quad; 2]; 2],
        row: usize,
        column: usize,
    ) -> [[Quad; 2]; 2] {
        let (row, column) = (self.at(row), self.at(column));
        let [first, second] = block.map(|row| column.to_frame_precisely(row));
        let [a, b] = [0, 1].map(|k| row.to_frame_precisely([first[k], second[k]]));
        [[a[0], b[0]], [a[1], b[1]]]
    }

    pub(crate) fn at(&self, node: usize) -> &Frame {
        match self.own.binary_search_by_key(&node, |&(node, _)| node) {
            Ok(found) => &self.own[found].1,
            Err(_) => &self.common,
        }
    }

    /// The block of two nodes in the unknowns of their frames.
    pub(super) fn turn_block(
        &self,
        block: [[f64; 2]; 2],
        row: usize,
        column: usize,
    ) -> [[f64; 2]; 2] {
        match self.common() {
            Some(frame) => frame.turn_block(block),
            None => self.at(row).turn_between(block, self.at(column)),
        }
    }
}
