//! Nested dissection by coordinates: the point set is bisected at the median of the coordinate with the
//! larger extent, and the separating layer is eliminated last.
//!
//! The recursion ends at small leaves. On quasi-uniform meshes the separators of a domain with N nodes have
//! O(√N) nodes, the factor O(N log N) entries and the factorization O(N^{3/2}) operations (A. George, SIAM J.
//! Numer. Anal. 10 (1973)). Cost of the ordering: O(N log N).

use super::matrix::BlockMatrix;
use crate::mesh::Point;

/// An elimination tree: children first (if any), then the own pivots, which separate them.
#[derive(Debug, Default)]
pub(super) struct Tree {
    pub(super) pivots: Vec<u32>,
    pub(super) children: Vec<Tree>,
    /// Nodes in the whole subtree.
    pub(super) size: usize,
}

/// Dissects the subgraph of `nodes` down to sets of at most `leaf` nodes.
pub(super) fn dissect(graph: &BlockMatrix, points: &[Point], nodes: Vec<u32>, leaf: usize) -> Tree {
    let mut halves = Halves { graph, points, leaf, label: vec![0; graph.nodes()], used: 0 };
    halves.tree(nodes)
}

struct Halves<'a> {
    graph: &'a BlockMatrix,
    points: &'a [Point],
    /// Largest node set that is eliminated at once.
    leaf: usize,
    /// Every set that was cut off has its own label.
    label: Vec<u32>,
    used: u32,
}

impl Halves<'_> {
    fn tree(&mut self, nodes: Vec<u32>) -> Tree {
        let size = nodes.len();
        if size > self.leaf
            && let Some((left, right)) = self.halve(nodes.clone())
        {
            let (left, right, pivots) = self.separate(left, right);
            let children = [left, right].into_iter().filter(|half| !half.is_empty());
            let children: Vec<Tree> = children.map(|half| self.tree(half)).collect();
            return Tree { pivots, children, size };
        }
        Tree { pivots: nodes, children: Vec::new(), size }
    }

    /// Two nonempty halves on either side of a coordinate; `None` when all points coincide.
    fn halve(&self, mut nodes: Vec<u32>) -> Option<(Vec<u32>, Vec<u32>)> {
        let extent = |axis: usize| {
            let along = nodes.iter().map(|&node| self.points[node as usize][axis]);
            let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
            high - low
        };
        let axis = usize::from(extent(1) > extent(0));
        let at = |node: u32| self.points[node as usize][axis];
        let middle = nodes.len() / 2;
        let (_, &mut median, _) =
            nodes.select_nth_unstable_by(middle, |&a, &b| at(a).total_cmp(&at(b)));
        let cut = at(median);
        let (left, right): (Vec<u32>, Vec<u32>) = nodes.iter().partition(|&&node| at(node) <= cut);
        if !right.is_empty() {
            return Some((left, right));
        }
        let (left, right): (Vec<u32>, Vec<u32>) = nodes.iter().partition(|&&node| at(node) < cut);
        (!left.is_empty()).then_some((left, right))
    }

    /// Moves the smaller of the two layers along the cut into the separator.
    fn separate(&mut self, left: Vec<u32>, right: Vec<u32>) -> (Vec<u32>, Vec<u32>, Vec<u32>) {
        let mark = self.used + 1;
        self.used += 2;
        left.iter().for_each(|&node| self.label[node as usize] = mark);
        right.iter().for_each(|&node| self.label[node as usize] = mark + 1);
        let touches = |node: &u32, other: u32| {
            let neighbours = self.graph.neighbours(*node as usize);
            neighbours.iter().any(|&n| self.label[n as usize] == other)
        };
        let (left_layer, left_rest): (Vec<u32>, Vec<u32>) =
            left.iter().partition(|&node| touches(node, mark + 1));
        let (right_layer, right_rest): (Vec<u32>, Vec<u32>) =
            right.iter().partition(|&node| touches(node, mark));
        if left_layer.len() <= right_layer.len() {
            (left_rest, right, left_layer)
        } else {
            (left, right_rest, right_layer)
        }
    }
}
