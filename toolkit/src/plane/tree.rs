//! A binary tree of clusters of triangles, and the pairs of clusters into which the square of the polygon is
//! divided.

use super::geometry::{Point, length};

/// Largest number of triangles in a leaf.
const LEAF: usize = 4;
/// Two clusters are separated if neither box has a diagonal longer than this multiple of their distance.
const APART: f64 = 1.0;

/// The triangles first..end in the order of the tree, in the box from `low` to `high`.
#[derive(Debug, Clone)]
pub(super) struct Cluster {
    pub(super) first: usize,
    pub(super) end: usize,
    pub(super) low: Point,
    pub(super) high: Point,
    pub(super) children: Option<[usize; 2]>,
}

/// The clusters, parents before children.
pub(super) struct Tree {
    pub(super) order: Vec<usize>,
    pub(super) clusters: Vec<Cluster>,
}

/// Pairs of clusters that contain each unordered pair of triangles exactly once.
#[derive(Default)]
pub(super) struct Pairs {
    pub(super) far: Vec<[usize; 2]>,
    /// pairs of leaves, including a leaf with itself
    pub(super) near: Vec<[usize; 2]>,
}

impl Tree {
    pub(super) fn new(triangles: &[[Point; 3]]) -> Self {
        let mut tree = Self { order: (0..triangles.len()).collect(), clusters: Vec::new() };
        tree.grow(triangles, 0, triangles.len());
        tree
    }

    fn grow(&mut self, triangles: &[[Point; 3]], first: usize, end: usize) -> usize {
        let index = self.clusters.len();
        let places = || self.order[first..end].iter().flat_map(|&t| triangles[t]);
        let low = places().fold([f64::INFINITY; 2], |low, p| [low[0].min(p[0]), low[1].min(p[1])]);
        let high =
            places().fold([f64::NEG_INFINITY; 2], |high, p| [high[0].max(p[0]), high[1].max(p[1])]);
        self.clusters.push(Cluster { first, end, low, high, children: None });
        if end - first > LEAF {
            let k = usize::from(high[1] - low[1] > high[0] - low[0]);
            let middle = first + (end - first) / 2;
            let centre = |t: usize| triangles[t].iter().map(|p| p[k] / 3.0).sum::<f64>();
            let by_centre = |a: &usize, b: &usize| centre(*a).total_cmp(&centre(*b));
            self.order[first..end].select_nth_unstable_by(middle - first, by_centre);
            let children = [self.grow(triangles, first, middle), self.grow(triangles, middle, end)];
            self.clusters[index].children = Some(children);
        }
        index
    }

    /// The pairs of clusters, obtained by bisecting the larger of two clusters until they are separated or
    /// leaves.
    pub(super) fn pairs(&self) -> Pairs {
        let mut pairs = Pairs::default();
        let mut open = vec![[0, 0]];
        while let Some([a, b]) = open.pop() {
            let (left, right) = (&self.clusters[a], &self.clusters[b]);
            if a != b && left.diagonal().max(right.diagonal()) <= APART * left.distance(right) {
                pairs.far.push([a, b]);
                continue;
            }
            match (left.children, right.children) {
                (None, None) => pairs.near.push([a, b]),
                (Some([c, d]), _) if a == b => open.extend([[c, c], [c, d], [d, d]]),
                (Some(children), other)
                    if other.is_none() || left.diagonal() >= right.diagonal() =>
                {
                    open.extend(children.map(|child| [child, b]));
                }
                (_, Some(children)) => open.extend(children.map(|child| [a, child])),
                (Some(children), None) => open.extend(children.map(|child| [child, b])),
            }
        }
        pairs
    }
}

impl Cluster {
    pub(super) fn size(&self, k: usize) -> f64 {
        self.high[k] - self.low[k]
    }

    fn diagonal(&self) -> f64 {
        length([self.size(0), self.size(1)])
    }

    /// The distance between the boxes.
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let gap =
            |k: usize| (self.low[k] - other.high[k]).max(other.low[k] - self.high[k]).max(0.0);
        length([gap(0), gap(1)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_of_triangles_is_in_one_pair_of_clusters() {
        let triangles: Vec<[Point; 3]> = (0..300)
            .map(|k| {
                let (x, y) = (f64::from(k % 20), f64::from(k / 20));
                [[x, y], [x + 1.0, y], [x, y + 1.0]]
            })
            .collect();
        let tree = Tree::new(&triangles);
        let pairs = tree.pairs();
        let mut count = vec![0; 300 * 300];
        let all = pairs.far.iter().chain(&pairs.near);
        for [a, b] in all {
            let (a, b) = (&tree.clusters[*a], &tree.clusters[*b]);
            for i in a.first..a.end {
                for j in b.first..b.end {
                    let (i, j) = (tree.order[i], tree.order[j]);
                    count[300 * i.min(j) + i.max(j)] +=
                        if a.first == b.first && i > j { 0 } else { 1 };
                }
            }
        }
        assert!(!pairs.far.is_empty());
        assert!((0..300).all(|i| (i..300).all(|j| count[300 * i + j] == 1)));
    }
}
