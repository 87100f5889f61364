//! The edges of a triangulation, numbered.
//!
//! Edges (a, b), a < b, are stored in buckets by a; buckets are short, so a search in one costs a few
//! comparisons. Cost: O(triangles).

use crate::error::{Error, Result, ToolkitError};

pub(crate) struct Edges {
    offsets: Vec<usize>,
    partners: Vec<usize>,
}

impl Edges {
    pub(crate) fn new(nodes: usize, triangles: &[[usize; 3]]) -> Self {
        let sides = || triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let mut offsets = vec![0; nodes + 1];
        sides().for_each(|[a, b]| offsets[a.min(b) + 1] += 1);
        (0..nodes).for_each(|i| offsets[i + 1] += offsets[i]);
        let mut next = offsets.clone();
        let mut partners = vec![0; offsets[nodes]];
        for [a, b] in sides() {
            partners[next[a.min(b)]] = a.max(b);
            next[a.min(b)] += 1;
        }
        Self::without_doubles(offsets, partners)
    }

    /// The edges without duplicates; inner edges are entered twice.
    fn without_doubles(mut offsets: Vec<usize>, mut partners: Vec<usize>) -> Self {
        let mut kept = 0;
        for a in 0..offsets.len() - 1 {
            let bucket = offsets[a]..offsets[a + 1];
            partners[bucket.clone()].sort_unstable();
            offsets[a] = kept;
            for k in bucket {
                if kept == offsets[a] || partners[kept - 1] != partners[k] {
                    partners[kept] = partners[k];
                    kept += 1;
                }
            }
        }
        partners.truncate(kept);
        if let Some(last) = offsets.last_mut() {
            *last = kept;
        }
        Self { offsets, partners }
    }

    /// The number of the edge between two nodes.
    pub(crate) fn find(&self, a: usize, b: usize) -> Result<usize> {
        let start = self.offsets[a.min(b)];
        self.partners[start..self.offsets[a.min(b) + 1]]
            .iter()
            .position(|&partner| partner == a.max(b))
            .map(|k| start + k)
            .ok_or(Error::Toolkit(ToolkitError::Edge {
                nodes: [a, b],
                reason: "belongs to no triangle",
            }))
    }

    /// The ends of every edge, in order.
    pub(crate) fn pairs(&self) -> Vec<[usize; 2]> {
        (0..self.offsets.len() - 1)
            .flat_map(|a| {
                self.partners[self.offsets[a]..self.offsets[a + 1]].iter().map(move |&b| [a, b])
            })
            .collect()
    }
}
