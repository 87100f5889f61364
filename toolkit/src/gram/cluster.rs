//! A binary tree of clusters of consecutive elements, and the pairs of clusters into which the square of the
//! interval is divided.
//!
//! Two clusters are *admissible* if neither is longer than the distance between them: there t^{-1-2ν} is
//! interpolated in both variables with the relative error ρ^{-m}, ρ = 3 + √8, at m Chebyshev points each. All
//! lengths and distances are sums of element lengths, so that the construction holds for any grading.

use crate::mesh::Mesh;
use crate::numeric::sum::RunningSum;

/// Largest number of elements of a leaf.
pub(crate) const LEAF: usize = 16;

/// The consecutive elements first..end.
#[derive(Debug, Clone)]
pub(crate) struct Cluster {
    pub(crate) first: usize,
    pub(crate) end: usize,
    pub(crate) length: f64,
    /// index of the left child; the right child follows the subtree of the left one
    pub(crate) children: Option<[usize; 2]>,
}

/// The clusters, parents before children.
pub(crate) struct ClusterTree {
    pub(crate) clusters: Vec<Cluster>,
}

/// Pairs of clusters that contain each unordered pair of elements exactly once.
#[derive(Default)]
pub(crate) struct Blocks {
    /// for each cluster its admissible partners and the distances to them
    pub(crate) far: Vec<Vec<(usize, f64)>>,
    /// pairs of leaves (left, right), including a leaf with itself
    pub(crate) near: Vec<(usize, usize)>,
}

impl ClusterTree {
    pub(crate) fn new(partition: &Mesh) -> Self {
        Self::with_leaves(partition, LEAF, |_| true)
    }

    /// The tree with leaves of at most `leaf` elements in which clusters end only at nodes that `may_cut`
    /// admits.
    pub(crate) fn with_leaves(
        partition: &Mesh,
        leaf: usize,
        may_cut: impl Fn(usize) -> bool,
    ) -> Self {
        let mut tree = Self { clusters: Vec::new() };
        tree.grow(partition.lengths(), 0, partition.len(), leaf, &may_cut);
        tree
    }

    fn grow(
        &mut self,
        lengths: &[f64],
        first: usize,
        end: usize,
        leaf: usize,
        may_cut: &impl Fn(usize) -> bool,
    ) -> usize {
        let index = self.clusters.len();
        self.clusters.push(Cluster { first, end, length: 0.0, children: None });
        let middle = first + (end - first) / 2;
        let cut = if end - first <= leaf {
            None
        } else {
            (middle..end)
                .find(|&k| may_cut(k))
                .or_else(|| (first + 1..middle).rev().find(|&k| may_cut(k)))
        };
        if let Some(cut) = cut {
            let mut child = |from, to| self.grow(lengths, from, to, leaf, may_cut);
            let children = [child(first, cut), child(cut, end)];
            self.clusters[index].length = children.iter().map(|&c| self.clusters[c].length).sum();
            self.clusters[index].children = Some(children);
        } else {
            let mut sum = RunningSum::default();
            lengths[first..end].iter().for_each(|&h| sum.add(h));
            self.clusters[index].length = sum.value();
        }
        index
    }

    /// The sum of the lengths of the elements first..end.
    pub(crate) fn distance(&self, lengths: &[f64], first: usize, end: usize) -> f64 {
        let mut sum = RunningSum::default();
        let mut stack = vec![0];
        while let Some(index) = stack.pop() {
            let cluster = &self.clusters[index];
            if cluster.end <= first || cluster.first >= end {
                continue;
            }
            match cluster.children {
                _ if first <= cluster.first && cluster.end <= end => sum.add(cluster.length),
                Some([left, right]) => stack.extend([right, left]),
                None => {
                    let range = cluster.first.max(first)..cluster.end.min(end);
                    lengths[range].iter().for_each(|&h| sum.add(h));
                }
            }
        }
        sum.value()
    }

    /// The far and near pairs into which the square is divided.
    pub(crate) fn blocks(&self, partition: &Mesh) -> Blocks {
        let mut blocks = Blocks { far: vec![Vec::new(); self.clusters.len()], near: Vec::new() };
        let mut stack = vec![(0, 0)];
        while let Some((a, b)) = stack.pop() {
            let (left, right) = (&self.clusters[a], &self.clusters[b]);
            if a != b {
                let gap = self.distance(partition.lengths(), left.end, right.first);
                if left.length.max(right.length) <= gap {
                    blocks.far[a].push((b, gap));
                    blocks.far[b].push((a, gap));
                    continue;
                }
            }
            match (left.children, right.children) {
                (None, None) => blocks.near.push((a, b)),
                (Some([l, r]), _) if a == b => stack.extend([(l, l), (l, r), (r, r)]),
                (Some(children), None) => stack.extend(children.map(|c| (c, b))),
                (None, Some(children)) => stack.extend(children.map(|c| (a, c))),
                (Some(mine), Some(other)) => {
                    if left.length >= right.length {
                        stack.extend(mine.map(|c| (c, b)));
                    } else {
                        stack.extend(other.map(|c| (a, c)));
                    }
                }
            }
        }
        blocks
    }
}
