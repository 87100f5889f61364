//! Products y = A x on any mesh in O(N log(1/ε)²) operations: an H²-matrix by interpolation.
//!
//! Hackbusch & Börm, Computing 69 (2002) 1-35. On admissible pairs of clusters ([`super::cluster`]) the kernel
//! is interpolated at m Chebyshev points in each variable; moments ∫ u ℓ_a are passed up and potentials down
//! the tree. Moments are divided by the length of the cluster and kernels multiplied by both lengths, so that
//! all numbers remain in the range of binary64. Near pairs of leaves are stored entry by entry, as accurately
//! as in the dense matrix. Memory: about 60 N numbers.

use super::cluster::{Blocks, ClusterTree};
use crate::error::Result;
use crate::kernel::cells::CellPairs;
use crate::kernel::chebyshev::Chebyshev;
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::numeric::parallel;
use crate::numeric::sum::RunningSum;
use crate::quadrature::Rule;

/// A dense block between the unknowns of two leaves, or of one leaf with itself; it is applied from both sides.
struct NearBlock {
    row: usize,
    column: usize,
    columns: usize,
    entries: Vec<f64>,
}

/// The part of a Gram matrix outside its band: −2 ∫∫ over separate cells.
pub(crate) struct Hierarchical {
    tree: ClusterTree,
    blocks: Blocks,
    near: Vec<NearBlock>,
    /// for each leaf the moments of its unknowns, (unknown, a), divided by the length of the leaf
    leaf_moments: Vec<Vec<f64>>,
    chebyshev: Chebyshev,
    kernel: PowerKernel,
}

impl Hierarchical {
    /// The part outside the band with `points` = m Chebyshev points per cluster.
    pub(crate) fn new(
        partition: &Mesh,
        cells: &CellPairs,
        kernel: PowerKernel,
        linears: bool,
        points: usize,
    ) -> Result<Self> {
        let tree = ClusterTree::new(partition);
        let blocks = tree.blocks(partition);
        let chebyshev = Chebyshev::new(points);
        let near = parallel::over(&blocks.near, |&(a, b)| {
            near_block(partition, cells, &tree, a, b, linears)
        });
        // Polynomials of degree m − 1 times a hat.
        let rule = Rule::gauss_legendre(points / 2 + 1)?;
        let leaf_moments = parallel::over(&tree.clusters, |cluster| match cluster.children {
            Some(_) => Vec::new(),
            None => moments(
                &partition.lengths()[cluster.first..cluster.end],
                cluster.length,
                &chebyshev,
                &rule,
                linears,
            ),
        });
        Ok(Self { tree, blocks, near, leaf_moments, chebyshev, kernel })
    }

    /// Adds the part of A x outside the band to y.
    pub(crate) fn add(&self, x: &[f64], y: &mut [f64]) {
        let moments = self.upward(x);
        let mut potentials = self.interact(&moments);
        self.downward(&mut potentials, y);
        self.add_near(x, y);
    }

    /// The moments of all clusters, children before parents.
    fn upward(&self, x: &[f64]) -> Vec<f64> {
        let m = self.chebyshev.points.len();
        let clusters = &self.tree.clusters;
        let mut moments = vec![0.0; m * clusters.len()];
        parallel::pieces(&mut moments, m, &|c, values| {
            let first = clusters[c].first;
            for (i, row) in self.leaf_moments[c].chunks_exact(m).enumerate() {
                for (value, entry) in values.iter_mut().zip(row) {
                    *value += entry * x[first + i];
                }
            }
        });
        let mut lagrange = vec![0.0; m];
        for c in (0..clusters.len()).rev() {
            let Some(children) = clusters[c].children else { continue };
            let (parents, below) = moments.split_at_mut(m * (c + 1));
            let parent = &mut parents[m * c..];
            for (child, start, scale) in self.placed(c, children) {
                for b in 0..m {
                    self.chebyshev
                        .lagrange(start + scale * self.chebyshev.points[b], &mut lagrange);
                    let value = scale * below[m * (child - c - 1) + b];
                    for (sum, l) in parent.iter_mut().zip(&lagrange) {
                        *sum += l * value;
                    }
                }
            }
        }
        moments
    }

    /// The children, each with its left end and its length in units of the parent.
    fn placed(&self, parent: usize, children: [usize; 2]) -> [(usize, f64, f64); 2] {
        let total = self.tree.clusters[parent].length;
        let share = children.map(|child| self.tree.clusters[child].length / total);
        [(children[0], 0.0, share[0]), (children[1], share[0], share[1])]
    }

    fn interact(&self, moments: &[f64]) -> Vec<f64> {
        let m = self.chebyshev.points.len();
        let clusters = &self.tree.clusters;
        let points = &self.chebyshev.points;
        let mut potentials = vec![0.0; m * clusters.len()];
        parallel::pieces(&mut potentials, m, &|target, potential| {
            let here = &clusters[target];
            for &(source, gap) in &self.blocks.far[target] {
                let there = &clusters[source];
                let moment = &moments[m * source..m * (source + 1)];
                // Distances run away from the facing ends.
                let mirrored = here.first < there.first;
                for (a, value) in potential.iter_mut().enumerate() {
                    let from_end = gap + here.length * points[if mirrored { m - 1 - a } else { a }];
                    let mut sum = 0.0;
                    for (b, q) in moment.iter().enumerate() {
                        let t =
                            from_end + there.length * points[if mirrored { b } else { m - 1 - b }];
                        sum +=
                            q * self.kernel.scaling(t) * ((here.length / t) * (there.length / t));
                    }
                    *value -= 2.0 * sum;
                }
            }
        });
        potentials
    }

    fn downward(&self, potentials: &mut [f64], y: &mut [f64]) {
        let m = self.chebyshev.points.len();
        let clusters = &self.tree.clusters;
        let mut lagrange = vec![0.0; m];
        for c in 0..clusters.len() {
            let (parents, below) = potentials.split_at_mut(m * (c + 1));
            let parent = &parents[m * c..];
            if let Some(children) = clusters[c].children {
                for (child, start, scale) in self.placed(c, children) {
                    for b in 0..m {
                        self.chebyshev
                            .lagrange(start + scale * self.chebyshev.points[b], &mut lagrange);
                        let sum: f64 = parent.iter().zip(&lagrange).map(|(p, l)| p * l).sum();
                        below[m * (child - c - 1) + b] += scale * sum;
                    }
                }
            } else {
                for (i, row) in self.leaf_moments[c].chunks_exact(m).enumerate() {
                    y[clusters[c].first + i] +=
                        row.iter().zip(parent).map(|(v, p)| v * p).sum::<f64>();
                }
            }
        }
    }

    fn add_near(&self, x: &[f64], y: &mut [f64]) {
        for block in &self.near {
            for (i, row) in block.entries.chunks_exact(block.columns).enumerate() {
                let i = block.row + i;
                let mut sum = 0.0;
                for (j, entry) in row.iter().enumerate() {
                    let j = block.column + j;
                    sum += entry * x[j];
                    y[j] += entry * x[i];
                }
                y[i] += sum;
            }
        }
    }
}

/// The moments (1/D) ∫ φ ℓ_a over the leaf, for every (unknown, a).
fn moments(
    lengths: &[f64],
    total: f64,
    chebyshev: &Chebyshev,
    rule: &Rule,
    linears: bool,
) -> Vec<f64> {
    let m = chebyshev.points.len();
    let unknowns = lengths.len() + usize::from(linears);
    let mut values = vec![0.0; unknowns * m];
    let mut lagrange = vec![0.0; m];
    let mut start = RunningSum::default();
    for (e, &h) in lengths.iter().enumerate() {
        for (t, w) in rule.iter() {
            chebyshev.lagrange((start.value() + h * t) / total, &mut lagrange);
            let weight = w * h / total;
            for (a, l) in lagrange.iter().enumerate() {
                if linears {
                    values[e * m + a] += weight * (1.0 - t) * l;
                    values[(e + 1) * m + a] += weight * t * l;
                } else {
                    values[e * m + a] += weight * l;
                }
            }
        }
        start.add(h);
    }
    values
}

/// The entries of the unknowns of leaf a with those of leaf b from their separate cells; a lies left of b or
/// equals b.
fn near_block(
    partition: &Mesh,
    cells: &CellPairs,
    tree: &ClusterTree,
    a: usize,
    b: usize,
    linears: bool,
) -> NearBlock {
    let (left, right) = (&tree.clusters[a], &tree.clusters[b]);
    let extra = usize::from(linears);
    let rows = left.end - left.first + extra;
    let columns = right.end - right.first + extra;
    let mut entries = vec![0.0; rows * columns];
    let lengths = partition.lengths();
    for e in left.first..left.end {
        let begin = right.first.max(e + 2);
        let mut gap = RunningSum::default();
        (e + 1..begin.min(right.end)).for_each(|k| gap.add(lengths[k]));
        for f in begin..right.end {
            let (i, j) = (e - left.first, f - right.first);
            if linears {
                let [near, far] = cells.separate(lengths[e], lengths[f], gap.value());
                for k in 0..2 {
                    entries[(i + 1) * columns + j + k] -= 2.0 * near[k];
                    entries[i * columns + j + k] -= 2.0 * far[k];
                }
            } else {
                entries[i * columns + j] -=
                    2.0 * cells.separate_constants(lengths[e], lengths[f], gap.value());
            }
            gap.add(lengths[f]);
        }
    }
    NearBlock { row: left.first, column: right.first, columns, entries }
}
