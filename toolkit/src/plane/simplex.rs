//! Points, segments and triangles with node numbers and values at their corners.

use super::geometry::{Point, distance_from_segment, length, minus};

/// The number of a corner of a piece that is not a node of the mesh.
pub(super) const NO_NODE: usize = usize::MAX;

/// A corner with the values of K linear functions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner<const K: usize> {
    pub(super) node: usize,
    pub(super) at: Point,
    pub(super) values: [f64; K],
}

impl<const K: usize> Corner<K> {
    fn middle(self, other: Self) -> Self {
        let mean = |a: f64, b: f64| 0.5 * (a + b);
        Self {
            node: NO_NODE,
            at: [mean(self.at[0], other.at[0]), mean(self.at[1], other.at[1])],
            values: std::array::from_fn(|k| mean(self.values[k], other.values[k])),
        }
    }
}

/// The convex hull of one, two or three corners.
#[derive(Debug, Clone, Copy)]
pub(super) struct Simplex<const K: usize> {
    corners: [Corner<K>; 3],
    count: usize,
}

impl<const K: usize> Simplex<K> {
    pub(super) fn triangle(corners: [Corner<K>; 3]) -> Self {
        Self { corners, count: 3 }
    }

    pub(super) fn corners(&self) -> &[Corner<K>] {
        &self.corners[..self.count]
    }

    pub(super) fn dimension(&self) -> usize {
        self.count - 1
    }

    /// The face opposite a corner of a simplex that is not a point.
    pub(super) fn face(&self, corner: usize) -> Self {
        let mut face = *self;
        face.corners.copy_within(corner + 1.., corner);
        face.count -= 1;
        face
    }

    /// The positions in both simplices of a common node.
    pub(super) fn shared(&self, other: &Self) -> Option<(usize, usize)> {
        self.corners().iter().enumerate().find_map(|(i, a)| {
            let same = |b: &Corner<K>| b.node == a.node && a.node != NO_NODE;
            other.corners().iter().position(same).map(|j| (i, j))
        })
    }

    /// The longest edge, given by the positions of its ends, and its length; 0 for a point.
    pub(super) fn longest(&self) -> ([usize; 2], f64) {
        let mut longest = ([0, 0], 0.0);
        for i in 0..self.count {
            for j in 0..i {
                let size = length(minus(self.corners[i].at, self.corners[j].at));
                if size > longest.1 {
                    longest = ([j, i], size);
                }
            }
        }
        longest
    }

    /// The two halves of a simplex that is cut through the midpoint of an edge.
    pub(super) fn halves(&self, edge: [usize; 2]) -> [Self; 2] {
        let middle = self.corners[edge[0]].middle(self.corners[edge[1]]);
        edge.map(|replaced| {
            let mut half = *self;
            half.corners[replaced] = middle;
            half
        })
    }

    /// The distance to a simplex that does not cross this one.
    pub(super) fn distance(&self, other: &Self) -> f64 {
        self.corner_distance(other).min(other.corner_distance(self))
    }

    /// The smallest distance of a corner from the boundary of another simplex.
    fn corner_distance(&self, other: &Self) -> f64 {
        let (count, points) = (other.count, &other.corners);
        let mut least = f64::INFINITY;
        for p in self.corners() {
            for i in 0..count.max(2) - 1 {
                for j in (i + 1).min(count - 1)..count {
                    least = least.min(distance_from_segment(p.at, points[i].at, points[j].at));
                }
            }
        }
        least
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(points: [Point; 3], nodes: [usize; 3]) -> Simplex<1> {
        Simplex::triangle(std::array::from_fn(|k| Corner {
            node: nodes[k],
            at: points[k],
            values: [k as f64],
        }))
    }

    #[test]
    fn faces_halves_and_distances() {
        let a = triangle([[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]], [0, 1, 2]);
        let b = triangle([[2.0, 0.0], [3.0, 0.0], [2.0, 1.0]], [3, 4, 5]);
        assert_eq!(a.distance(&b), 1.0);
        assert_eq!(a.face(1).face(0).distance(&b), 5f64.sqrt());
        assert_eq!(a.longest(), ([1, 2], 5f64.sqrt()));
        let [left, right] = a.halves([1, 2]);
        assert_eq!((left.corners()[1].at, left.corners()[1].values), ([0.5, 1.0], [1.5]));
        assert_eq!((right.corners()[2].at, right.corners()[1].node), ([0.5, 1.0], 1));
        assert_eq!(a.shared(&b), None);
        assert_eq!(a.face(0).shared(&left), Some((1, 2)));
    }
}
