//! Faces of the two cones: which nodes move freely and which move as one.
//!
//! An active set divides the edge into gaps (free nodes) and contact runs. On a run the nodal cone holds w = 0; the midpoint
//! cone holds w_i + w_{i+1} = 0, which leaves one amplitude c, w_i = ±c. The orthogonal projector Π onto the face
//! keeps the gaps, and replaces a run by zero or by its alternating mean. Cost O(n).

use super::edge::EdgeOperator;
use super::sides::Sides;
use crate::contact::Cone;

/// Consecutive nodes start, ..., start + len − 1, modulo the number of nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Block {
    pub(crate) start: usize,
    pub(crate) len: usize,
}

impl Block {
    pub(crate) fn nodes(self, modulus: usize) -> impl Iterator<Item = usize> {
        (self.start..self.start + self.len).map(move |i| if i < modulus { i } else { i - modulus })
    }
}

/// A face of the cone: its gaps and contact runs in the order of the edge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Face {
    cone: Cone,
    nodes: usize,
    pub(crate) gaps: Vec<Block>,
    pub(crate) runs: Vec<Block>,
}

impl Face {
    /// The face on which exactly the given constraints hold with equality (one flag per node, or per segment).
    pub(crate) fn new(cone: Cone, operator: &EdgeOperator, active: &[bool]) -> Self {
        let nodes = operator.nodes();
        let periodic = operator.sides() == Sides::Periodic;
        let closed: Vec<bool> = match cone {
            Cone::Nodal => active.to_vec(),
            Cone::Midpoint => (0..nodes)
                .map(|i| {
                    let left = if i > 0 { active[i - 1] } else { periodic && active[nodes - 1] };
                    left || active.get(i).copied().unwrap_or(false)
                })
                .collect(),
        };
        // Are node i and its right neighbour in the same block?
        let linked = |i: usize| {
            let next = (i + 1) % nodes;
            closed[i] == closed[next] && (cone == Cone::Nodal || !closed[i] || active[i])
        };
        let mut face = Self { cone, nodes, gaps: Vec::new(), runs: Vec::new() };
        let first = if periodic { (0..nodes).find(|&i| !linked(i)).map_or(0, |i| i + 1) } else { 0 };
        let mut start = first;
        for i in first..first + nodes {
            if i + 1 == first + nodes || !linked(i % nodes) {
                let block = Block { start: start % nodes, len: i + 1 - start };
                if closed[start % nodes] {
                    face.runs.push(block);
                } else {
                    face.gaps.push(block);
                }
                start = i + 1;
            }
        }
        face
    }

    /// x ← Π x.
    pub(crate) fn project(&self, x: &mut [f64]) {
        for run in &self.runs {
            match self.cone {
                Cone::Nodal => run.nodes(self.nodes).for_each(|i| x[i] = 0.0),
                Cone::Midpoint => {
                    let mut sign = 1.0;
                    let mut sum = 0.0;
                    for i in run.nodes(self.nodes) {
                        sum += sign * x[i];
                        sign = -sign;
                    }
                    let mut value = sum / run.len as f64;
                    for i in run.nodes(self.nodes) {
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
    use crate::strip::ScalarStrip;

    #[test]
    fn blocks_cover_the_edge_and_wrap_round() {
        let natural = ScalarStrip::new(6, 6).unwrap();
        let active = [true, true, false, false, true, false];
        let face = Face::new(Cone::Midpoint, natural.operator(), &active);
        assert_eq!(face.runs, vec![Block { start: 0, len: 3 }, Block { start: 4, len: 2 }]);
        assert_eq!(face.gaps, vec![Block { start: 3, len: 1 }, Block { start: 6, len: 1 }]);
        let periodic = EdgeOperator::new(6, Sides::Periodic, vec![1.0; 4]).unwrap();
        let face = Face::new(Cone::Nodal, &periodic, &[true, false, false, true, true, true]);
        assert_eq!(face.runs, vec![Block { start: 3, len: 4 }]);
        assert_eq!(face.gaps, vec![Block { start: 1, len: 2 }]);
        let whole = Face::new(Cone::Midpoint, &periodic, &[true; 6]);
        assert_eq!(whole.runs, vec![Block { start: 0, len: 6 }]);
        let mut x = vec![1.0, 0.0, 3.0, 0.0, 2.0, 0.0];
        whole.project(&mut x);
        assert_eq!(x, vec![1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
    }

    #[test]
    fn two_runs_may_meet_at_an_inactive_segment() {
        let periodic = EdgeOperator::new(4, Sides::Periodic, vec![1.0; 3]).unwrap();
        let face = Face::new(Cone::Midpoint, &periodic, &[true, false, true, false]);
        assert_eq!(face.runs, vec![Block { start: 2, len: 2 }, Block { start: 0, len: 2 }]);
        assert!(face.gaps.is_empty());
    }
}
