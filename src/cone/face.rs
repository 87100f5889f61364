//! Faces of the two cones: free nodes, and nodes that move together.
//!
//! An active set divides the edge into non-contact intervals (free nodes) and contact intervals. On a
//! contact interval w = 0 in the nodal cone; in the midpoint cone w_i + w_{i+1} = 0, which leaves one
//! amplitude c, w_i = ±c. The orthogonal projector Π onto the face is the identity on non-contact intervals
//! and replaces the values on a contact interval by zero or by their alternating mean. Cost O(n).

use super::edge_cone::{EdgeCone, Ends};
use super::kind::Cone;

/// Consecutive nodes start, ..., start + len − 1, modulo the number of nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Block {
    pub(crate) start: usize,
    pub(crate) len: usize,
    /// True for a contact interval.
    pub(super) is_run: bool,
}

impl Block {
    pub(crate) fn nodes(
        self,
        modulus: usize,
    ) -> impl DoubleEndedIterator<Item = usize> + ExactSizeIterator {
        (self.start..self.start + self.len).map(move |i| if i < modulus { i } else { i - modulus })
    }
}

/// A face of the cone: its contact and non-contact intervals in the order of the edge.
///
/// As a linear space (for g = 0): V = { w : (B w)_i = 0 for the active i }. Nodal: dim V = n − (active
/// nodes); midpoint: dim V = (free nodes) + (contact intervals), one sawtooth amplitude for each (none on a
/// closed edge with an odd number of nodes that is entirely in contact).
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Face {
    cone: EdgeCone,
    blocks: Vec<Block>,
}

impl Face {
    /// The face on which exactly the constraints in `active` hold with equality; `active` has one flag per
    /// constraint.
    pub(crate) fn new(cone: EdgeCone, active: &[bool]) -> Self {
        let nodes = cone.nodes();
        let joined = cone.ends() == Ends::Joined;
        let midpoint = cone.kind() == Cone::Midpoint;
        let closed: Vec<bool> = match cone.kind() {
            Cone::Nodal => active.to_vec(),
            Cone::Midpoint => (0..nodes)
                .map(|i| {
                    let left = if i > 0 { active[i - 1] } else { joined && active[nodes - 1] };
                    left || active.get(i).copied().unwrap_or(false)
                })
                .collect(),
        };
        // Are node i and its right neighbour in the same block?
        let linked = |i: usize| {
            let next = (i + 1) % nodes;
            closed[i] == closed[next] && (!midpoint || !closed[i] || active[i])
        };
        let mut face = Self { cone, blocks: Vec::new() };
        let first = if joined { (0..nodes).find(|&i| !linked(i)).map_or(0, |i| i + 1) } else { 0 };
        let mut start = first;
        for i in first..first + nodes {
            if i + 1 == first + nodes || !linked(i % nodes) {
                let is_run = closed[start % nodes];
                face.blocks.push(Block { start: start % nodes, len: i + 1 - start, is_run });
                start = i + 1;
            }
        }
        face
    }

    /// Contact and non-contact intervals, in the order of the edge.
    pub(super) fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    pub(crate) fn runs(&self) -> impl Iterator<Item = Block> {
        self.blocks.iter().copied().filter(|block| block.is_run)
    }

    pub(crate) fn gaps(&self) -> impl Iterator<Item = Block> {
        self.blocks.iter().copied().filter(|block| !block.is_run)
    }

    /// x ← Π x.
    ///
    /// Π is orthogonal in the Euclidean product: on a contact interval of m nodes i_0 < ... < i_{m−1} of
    /// the midpoint cone (Π x)_{i_k} = (−1)^k c, c = (1/m) Σ_j (−1)^j x_{i_j}; in the nodal cone (Π
    /// x)_{i_k} = 0; Π² = Π = Π'.
    pub(crate) fn project(&self, x: &mut [f64]) {
        let nodes = self.cone.nodes();
        for run in self.runs() {
            match self.cone.kind() {
                Cone::Nodal => run.nodes(nodes).for_each(|i| x[i] = 0.0),
                Cone::Midpoint => {
                    let mut sign = 1.0;
                    let mut sum = 0.0;
                    for i in run.nodes(nodes) {
                        sum += sign * x[i];
                        sign = -sign;
                    }
                    let mut value = sum / run.len as f64;
                    for i in run.nodes(nodes) {
                        x[i] = value;
                        value = -value;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn blocks(face: &Face, run: bool) -> Vec<(usize, usize)> {
        face.blocks().iter().filter(|b| b.is_run == run).map(|b| (b.start, b.len)).collect()
    }

    #[test]
    fn blocks_cover_the_edge_and_wrap_round() {
        let active = [true, true, false, false, true, false];
        let face = Face::new(Cone::Midpoint.on(7, Ends::Open), &active);
        assert_eq!(blocks(&face, true), [(0, 3), (4, 2)]);
        assert_eq!(blocks(&face, false), [(3, 1), (6, 1)]);
        let face =
            Face::new(Cone::Nodal.on(6, Ends::Joined), &[true, false, false, true, true, true]);
        assert_eq!(blocks(&face, true), [(3, 4)]);
        assert_eq!(blocks(&face, false), [(1, 2)]);
        let whole = Face::new(Cone::Midpoint.on(6, Ends::Joined), &[true; 6]);
        assert_eq!(blocks(&whole, true), [(0, 6)]);
        let mut x = vec![1.0, 0.0, 3.0, 0.0, 2.0, 0.0];
        whole.project(&mut x);
        assert_eq!(x, vec![1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
    }

    #[test]
    fn two_runs_may_meet_at_an_inactive_segment() {
        let face = Face::new(Cone::Midpoint.on(4, Ends::Joined), &[true, false, true, false]);
        assert_eq!(blocks(&face, true), [(2, 2), (0, 2)]);
        assert!(blocks(&face, false).is_empty());
    }
}
