//! Moments of a function on a cluster tree, and the contribution of two separated clusters to a squared
//! seminorm.
//!
//! On a cluster A of length L with points x_a = L ξ_a (ξ_a Chebyshev) and Lagrange polynomials ℓ_a,
//!
//! M⁰_a = (1/L) ∫ ℓ_a,  M¹_a = (1/L) ∫ f ℓ_a,  M²_a = (1/L) ∫ f² ℓ_a,  f = u − c_A,
//!
//! with a constant c_A near the values of u. The kernel interpolated in both variables, D = c_A − c_B:
//!
//! ∫_A ∫_B (u(x)−u(y))² k = L_A L_B Σ_ab k(x_a, y_b) [D² M⁰M⁰ + 2D (M¹M⁰ − M⁰M¹) + M²M⁰ + M⁰M² − 2 M¹M¹],
//!
//! all of the size of the variation of u on A ∪ B: no digits are lost where u is nearly constant, since c_A is
//! a number of binary64 and u − c_A is formed before anything is summed. Since (u(x)−u(y))² ≥ 0, the relative
//! error of the sum is at most that of the interpolated kernel. From child to parent c changes by δ: M¹ += δ
//! M⁰, M² += 2δ M¹ + δ² M⁰. Cost: O(m²) per cluster and per pair.

use super::pair_sum::PairSum;
use crate::gram::cluster::ClusterTree;
use crate::kernel::chebyshev::Chebyshev;
use crate::mesh::Mesh;
use crate::numeric::parallel;
use crate::numeric::sum::RunningSum;

/// Rounding error of a pair, relative to its terms: the sums have some dozen terms each.
const PAIR_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Ratio of lengths beyond which the values on the shorter cluster do not represent those on the whole.
const UNEQUAL: f64 = 16.0;

/// A function on the cells of a mesh, known at the points of a rule.
pub(crate) trait Samples: Sync {
    /// A value of the function on the cell.
    fn level(&self, cell: usize) -> f64;

    /// Calls the function with (t, w, u − shift) at all points of the rule, t and w on the unit cell.
    fn sample(&self, cell: usize, shift: f64, visit: &mut dyn FnMut(f64, f64, f64));
}

/// The moments of all clusters.
pub(crate) struct MomentTree<'a> {
    pub(crate) tree: ClusterTree,
    chebyshev: &'a Chebyshev,
    /// c_A
    levels: Vec<f64>,
    /// M⁰, M¹, M² of one cluster after the other
    moments: Vec<f64>,
}

impl<'a> MomentTree<'a> {
    pub(crate) fn new(
        tree: ClusterTree,
        partition: &Mesh,
        function: &impl Samples,
        chebyshev: &'a Chebyshev,
    ) -> Self {
        let count = tree.clusters.len();
        let m = chebyshev.points.len();
        let mut levels = vec![0.0; count];
        for c in (0..count).rev() {
            let cluster = &tree.clusters[c];
            levels[c] = match cluster.children {
                Some([a, b]) => {
                    let [p, q] = [a, b].map(|child| tree.clusters[child].length);
                    // Beside a layer a function is often constant: then its moments are exactly zero.
                    if p > UNEQUAL * q {
                        levels[a]
                    } else if q > UNEQUAL * p {
                        levels[b]
                    } else {
                        0.5 * levels[a] + 0.5 * levels[b]
                    }
                }
                None => function.level(cluster.first + (cluster.end - cluster.first) / 2),
            };
        }
        let mut found = Self { tree, chebyshev, levels, moments: vec![0.0; 3 * m * count] };
        let mut moments = std::mem::take(&mut found.moments);
        parallel::pieces(&mut moments, 3 * m, &|c, moments| {
            found.of_leaf(c, partition, function, moments)
        });
        for c in (0..count).rev() {
            found.of_parent(c, &mut moments);
        }
        found.moments = moments;
        found
    }

    fn of_leaf(&self, c: usize, partition: &Mesh, function: &impl Samples, moments: &mut [f64]) {
        let cluster = &self.tree.clusters[c];
        if cluster.children.is_some() {
            return;
        }
        let m = self.chebyshev.points.len();
        let mut lagrange = vec![0.0; m];
        let mut start = RunningSum::default();
        for cell in cluster.first..cluster.end {
            let h = partition.lengths()[cell];
            function.sample(cell, self.levels[c], &mut |t, w, value| {
                self.chebyshev.lagrange((start.value() + h * t) / cluster.length, &mut lagrange);
                let weight = w * (h / cluster.length);
                for (a, l) in lagrange.iter().enumerate() {
                    let term = weight * l;
                    moments[a] += term;
                    moments[m + a] += term * value;
                    moments[2 * m + a] += term * value * value;
                }
            });
            start.add(h);
        }
    }

    fn of_parent(&self, c: usize, moments: &mut [f64]) {
        let m = self.chebyshev.points.len();
        let Some(children) = self.tree.clusters[c].children else { return };
        let (parents, below) = moments.split_at_mut(3 * m * (c + 1));
        let parent = &mut parents[3 * m * c..];
        let total = self.tree.clusters[c].length;
        let mut start = 0.0;
        let mut lagrange = vec![0.0; m];
        for child in children {
            let share = self.tree.clusters[child].length / total;
            let delta = self.levels[child] - self.levels[c];
            let from = &below[3 * m * (child - c - 1)..];
            for (b, point) in self.chebyshev.points.iter().enumerate() {
                self.chebyshev.lagrange(start + share * point, &mut lagrange);
                let [zeroth, first, second] = [0, 1, 2].map(|k| share * from[k * m + b]);
                let squared = second + delta * (2.0 * first + delta * zeroth);
                let first = first + delta * zeroth;
                for (a, l) in lagrange.iter().enumerate() {
                    parent[a] += l * zeroth;
                    parent[m + a] += l * first;
                    parent[2 * m + a] += l * squared;
                }
            }
            start += share;
        }
    }

    fn of(&self, c: usize) -> [&[f64]; 3] {
        let m = self.chebyshev.points.len();
        [0, 1, 2].map(|k| &self.moments[(3 * c + k) * m..(3 * c + k + 1) * m])
    }

    /// ∫∫ over cluster a of this tree and cluster b of another one, in both orders; `kernel` is L_A L_B k at
    /// the points of the two clusters.
    pub(crate) fn pair(
        &self,
        a: usize,
        other: &Self,
        b: usize,
        kernel: impl Fn(usize, usize) -> f64,
    ) -> PairSum {
        let (here, there) = (self.of(a), other.of(b));
        let gap = self.levels[a] - other.levels[b];
        let (mut value, mut size) = (0.0, 0.0);
        for k in 0..here[0].len() {
            let mut sums = [0.0; 3];
            for (j, ((zeroth, first), second)) in
                there[0].iter().zip(there[1]).zip(there[2]).enumerate()
            {
                let weight = kernel(k, j);
                sums[0] += weight * zeroth;
                sums[1] += weight * first;
                sums[2] += weight * second;
            }
            let mine = here.map(|moments| moments[k]);
            let squares = gap * gap * mine[0] * sums[0] + mine[2] * sums[0] + mine[0] * sums[2];
            let mixed = gap * (mine[1] * sums[0] - mine[0] * sums[1]) - mine[1] * sums[1];
            value += squares + 2.0 * mixed;
            size += squares;
        }
        let points = (here[0].len() * there[0].len()) as u64;
        PairSum { value: 2.0 * value, rounding: 2.0 * PAIR_ROUNDING * size.abs(), points }
    }
}
