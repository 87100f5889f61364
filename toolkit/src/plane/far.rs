//! Separated pairs of clusters: |x−y|^{-2-2s} interpolated in both variables.
//!
//! With Lagrange polynomials ℓ_k on q × q Chebyshev points x_k of the box of a cluster and the moments M^j_k
//! = ∫ ℓ_k (w − c)^j, j = 0, 1, 2, of a cluster, c its first value, and a = c − c',
//! ∫∫ (w(x)−w(y))² |x−y|^{-2-2s} ≈ Σ_kl |x_k−y_l|^{-2-2s} (M̃²_k N⁰_l − 2 M̃¹_k N¹_l + M̃⁰_k N²_l), c' the
//! first value and N the moments of the other cluster, M̃ the moments of w − c + a = w − c'. The moments of a
//! parent follow exactly from those of its children. If a box is no longer than its distance, the error is
//! about ρ^{-q}, ρ = 2.83 + 3 for equal sides. Cost: q⁴ kernel values for a pair.

use super::geometry::Point;
use super::kernel::InversePower;
use super::leaves::points;
use super::tree::{Cluster, Tree};
use crate::error::Result;
use crate::numeric::parallel;
use crate::numeric::scale::power_of_two;
use std::f64::consts::PI;

/// Triangles with the values at their corners, from which the moments are computed.
pub(super) struct Source<'a> {
    pub(super) triangles: &'a [[Point; 3]],
    pub(super) values: &'a [[f64; 3]],
    pub(super) areas: &'a [f64],
}

/// Chebyshev points of (−1, 1).
pub(super) struct Nodes {
    pub(super) at: Vec<f64>,
}

impl Nodes {
    pub(super) fn new(q: usize) -> Self {
        Self { at: (0..q).map(|k| (PI * (k as f64 + 0.5) / q as f64).cos()).collect() }
    }

    /// The values of all Lagrange polynomials at t: ℓ_k = (1 + 2 Σ T_m(t_k) T_m(t))/q.
    pub(super) fn lagrange(&self, t: f64) -> Vec<f64> {
        let q = self.at.len();
        let one = |&node: &f64| {
            let (mut before, mut now, mut other_before, mut other) = (1.0, t, 1.0, node);
            let mut sum = 0.5;
            for _ in 1..q {
                sum += now * other;
                (before, now) = (now, 2.0 * t * now - before);
                (other_before, other) = (other, 2.0 * node * other - other_before);
            }
            2.0 * sum / q as f64
        };
        self.at.iter().map(one).collect()
    }
}

/// The moments of a cluster.
struct Moments {
    centre: f64,
    of: [Vec<f64>; 3],
}

/// The moments of all clusters.
pub(super) struct FarField<'a> {
    tree: &'a Tree,
    nodes: Nodes,
    moments: Vec<Moments>,
    /// 1 + s
    power: f64,
    kernel: InversePower,
}

fn from_box(cluster: &Cluster, k: usize, x: f64) -> f64 {
    2.0 * (x - cluster.low[k]) / cluster.size(k) - 1.0
}

impl<'a> FarField<'a> {
    pub(super) fn new(tree: &'a Tree, source: &Source<'_>, q: usize, s: f64) -> Result<Self> {
        let mut field = Self {
            tree,
            nodes: Nodes::new(q),
            moments: Vec::new(),
            power: 1.0 + s,
            kernel: InversePower::new(1.0 + s),
        };
        let leaf = |cluster: &Cluster| -> Result<Option<Moments>> {
            if cluster.children.is_none() {
                field.of_leaf(cluster, source).map(Some)
            } else {
                Ok(None)
            }
        };
        let mut moments =
            parallel::over(&tree.clusters, leaf).into_iter().collect::<Result<Vec<_>>>()?;
        for (index, cluster) in tree.clusters.iter().enumerate().rev() {
            if let Some(children) = cluster.children {
                let parts = children.map(|child| (child, moments[child].as_ref()));
                moments[index] = Some(field.of_parent(cluster, &parts));
            }
        }
        field.moments = moments.into_iter().flatten().collect();
        Ok(field)
    }

    fn of_leaf(&self, cluster: &Cluster, source: &Source<'_>) -> Result<Moments> {
        let q = self.nodes.at.len();
        let inside = &self.tree.order[cluster.first..cluster.end];
        let centre = source.values[inside[0]][0];
        let mut of = [vec![0.0; q * q], vec![0.0; q * q], vec![0.0; q * q]];
        for &t in inside {
            let ([a, b, c], [u, v, w]) = (source.triangles[t], source.values[t]);
            for &(r, weight) in points(2, q + 1)? {
                let mix = |a: f64, b: f64, c: f64| a + (r[0] * (b - a) + r[1] * (c - a));
                let [x, y] = [0, 1]
                    .map(|k| self.nodes.lagrange(from_box(cluster, k, mix(a[k], b[k], c[k]))));
                let value = mix(u - centre, v - centre, w - centre);
                let weights =
                    [1.0, value, value * value].map(|power| power * weight * source.areas[t]);
                for (of, weight) in of.iter_mut().zip(weights) {
                    for (row, x) in of.chunks_mut(q).zip(&x) {
                        row.iter_mut().zip(&y).for_each(|(entry, y)| *entry += weight * x * y);
                    }
                }
            }
        }
        Ok(Moments { centre, of })
    }

    fn of_parent(&self, cluster: &Cluster, children: &[(usize, Option<&Moments>); 2]) -> Moments {
        let q = self.nodes.at.len();
        let centre = children[0].1.map_or(0.0, |moments| moments.centre);
        let mut of = [vec![0.0; q * q], vec![0.0; q * q], vec![0.0; q * q]];
        for (child, moments) in children.iter().filter_map(|(child, m)| m.map(|m| (*child, m))) {
            let places = |k: usize| self.places(&self.tree.clusters[child], k);
            let [x, y] = [0, 1].map(|k| -> Vec<Vec<f64>> {
                places(k).iter().map(|&x| self.nodes.lagrange(from_box(cluster, k, x))).collect()
            });
            for (of, part) in of.iter_mut().zip(shifted(moments, moments.centre - centre)) {
                let mut half = vec![0.0; q * q];
                for c in 0..q {
                    for d in 0..q {
                        (0..q).for_each(|b| half[c * q + b] += y[d][b] * part[c * q + d]);
                    }
                }
                for c in 0..q {
                    for a in 0..q {
                        (0..q).for_each(|b| of[a * q + b] += x[c][a] * half[c * q + b]);
                    }
                }
            }
        }
        Moments { centre, of }
    }

    /// The Chebyshev points of a box in one coordinate.
    fn places(&self, cluster: &Cluster, k: usize) -> Vec<f64> {
        self.nodes.at.iter().map(|t| cluster.low[k] + 0.5 * (1.0 + t) * cluster.size(k)).collect()
    }

    /// The integral over x in a and y in b, and the number of kernel values.
    pub(super) fn pair(&self, a: usize, b: usize) -> (f64, u64) {
        let (left, right) = (&self.tree.clusters[a], &self.tree.clusters[b]);
        let (first, second) = (&self.moments[a], &self.moments[b]);
        let unit = power_of_two(left.distance(right));
        let half = unit.powf(-self.power);
        let scaled = |parts: [Vec<f64>; 3]| {
            parts.map(|part| part.iter().map(|m| m * half).collect::<Vec<f64>>())
        };
        let m = scaled(shifted(first, first.centre - second.centre));
        let n = scaled(second.of.clone());
        let grid = |cluster: &Cluster| -> Vec<Point> {
            let (x, y) = (self.places(cluster, 0), self.places(cluster, 1));
            let scale = |v: f64, k: usize| (v - left.low[k]) / unit;
            x.iter().flat_map(|&x| y.iter().map(move |&y| [scale(x, 0), scale(y, 1)])).collect()
        };
        let (from, to) = (grid(left), grid(right));
        let mut sum = 0.0;
        for (k, x) in from.iter().enumerate() {
            let mut rows = [0.0; 3];
            for (l, y) in to.iter().enumerate() {
                let (dx, dy) = (x[0] - y[0], x[1] - y[1]);
                let kernel = self.kernel.at(dx * dx + dy * dy);
                (0..3).for_each(|j| rows[j] += kernel * n[j][l]);
            }
            sum += m[2][k] * rows[0] - 2.0 * m[1][k] * rows[1] + m[0][k] * rows[2];
        }
        (sum, (from.len() * to.len()) as u64)
    }
}

/// The moments of w − c + a.
fn shifted(moments: &Moments, a: f64) -> [Vec<f64>; 3] {
    let [zero, one, two] = &moments.of;
    let first = zero.iter().zip(one).map(|(z, o)| o + a * z).collect();
    let both = zero.iter().zip(one).zip(two);
    let second = both.map(|((z, o), t)| t + 2.0 * a * o + a * a * z).collect();
    [zero.clone(), first, second]
}
