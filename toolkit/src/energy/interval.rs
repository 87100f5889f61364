//! ∫∫ (u(x)−u(y))² |x−y|^{-1-2ν} over the square of an interval: near cells pair by pair, far clusters by
//! moments.
//!
//! The square is divided as for the operators ([`crate::gram::cluster`]). Far pairs are as accurate as the
//! interpolated kernel, whose error is measured for the worst pair; near pairs are supplied by the caller.
//! Cost: O(N) near pairs and about 3N/n pairs of clusters, n the number of cells of a leaf, with m² kernel
//! values each, m ≈ 1.3 times the number of digits.

use super::moments::{MomentTree, Samples};
use super::pair_sum::PairSum;
use crate::error::Result;
use crate::estimate::{Estimate, Work};
use crate::gram::cluster::ClusterTree;
use crate::kernel::chebyshev::Chebyshev;
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::order::Order;
use crate::root::ENTRY_ROUNDING;
use rayon::prelude::*;

/// A function on the cells of a mesh whose near pairs are known.
pub(crate) trait CellEnergies: Samples {
    /// ∫∫ over the cells e ≤ f in both orders: one cell with itself, two neighbours, or two cells with the
    /// distance `gap` between them.
    fn near(&self, e: usize, f: usize, gap: f64) -> PairSum;

    /// The largest number of elements of a leaf cluster.
    fn leaf(&self) -> usize;

    /// True if clusters may end at this node.
    fn may_cut(&self, _node: usize) -> bool {
        true
    }
}

/// The squared seminorm, with far and near pairs to the relative accuracy `target`.
pub(crate) fn energy(
    partition: &Mesh,
    function: &impl CellEnergies,
    order: Order,
    target: f64,
) -> Result<Estimate> {
    let kernel = PowerKernel::new(order);
    let (chebyshev, interpolation) = Chebyshev::for_power(target, kernel);
    let tree = ClusterTree::with_leaves(partition, function.leaf(), |node| function.may_cut(node));
    let blocks = tree.blocks(partition);
    let near = blocks
        .near
        .par_iter()
        .map(|&(a, b)| near_pair(partition, function, &tree, a, b))
        .reduce(PairSum::default, |a, b| a + b);
    let moments = MomentTree::new(tree, partition, function, &chebyshev);
    let far = (0..blocks.far.len())
        .into_par_iter()
        .map(|a| {
            let later = blocks.far[a]
                .iter()
                .filter(|&&(b, _)| moments.tree.clusters[b].first >= moments.tree.clusters[a].end);
            later.fold(PairSum::default(), |sum, &(b, gap)| {
                sum + far_pair(&moments, &chebyshev, kernel, a, b, gap)
            })
        })
        .reduce(PairSum::default, |a, b| a + b);
    let rounding = ENTRY_ROUNDING * (near.value + far.value) + near.rounding + far.rounding;
    let error = interpolation * far.value + target * near.value + rounding;
    let work = Work { points: near.points + far.points, ..Work::default() };
    Estimate::new(near.value + far.value, error, work)
}

fn near_pair(
    partition: &Mesh,
    function: &impl CellEnergies,
    tree: &ClusterTree,
    a: usize,
    b: usize,
) -> PairSum {
    let (left, right) = (&tree.clusters[a], &tree.clusters[b]);
    let lengths = partition.lengths();
    let mut sum = PairSum::default();
    for e in left.first..left.end {
        let begin = right.first.max(e);
        let mut gap = if begin > e + 1 { tree.distance(lengths, e + 1, begin) } else { 0.0 };
        for f in begin..right.end {
            sum = sum + function.near(e, f, gap);
            if f > e {
                gap += lengths[f];
            }
        }
    }
    sum
}

/// The sum over the points of two clusters, a to the left of b: the first point of a is the farthest one from
/// b.
fn far_pair(
    moments: &MomentTree,
    chebyshev: &Chebyshev,
    kernel: PowerKernel,
    a: usize,
    b: usize,
    gap: f64,
) -> PairSum {
    let points = &chebyshev.points;
    let last = points.len() - 1;
    let [here, there] = [a, b].map(|c| moments.tree.clusters[c].length);
    moments.pair(a, moments, b, |k, j| {
        let t = gap + here * points[last - k] + there * points[j];
        kernel.scaling(t) * ((here / t) * (there / t))
    })
}
