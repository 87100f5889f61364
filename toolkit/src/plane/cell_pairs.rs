//! Integrals of products of the four hat functions of two squares of side 1 at an offset Δ, each cut from
//! bottom left to top right.
//!
//! S_ab = ∫∫ φ_a(x) φ_b(x) k, C_ab = ∫∫ φ_a(x) φ_b(y) k, k = |x−y|^{-2-2s}, x in the square at 0, y in the
//! square at Δ. Near squares are treated by [`super::means`]. For the others k is interpolated at q × q
//! Chebyshev points of both squares: on a uniform grid this takes only (2q−1)² values, and the moments of hat
//! functions and of their products are computed only once.

use super::far::Nodes;
use super::kernel::InversePower;
use super::leaves::{LEVELS, points};
use super::means::{Means, Shape};
use super::simplex::{Corner, NO_NODE, Simplex};
use crate::error::Result;
use crate::order::Order;

/// Number of hat functions of a square, counterclockwise from bottom left.
pub(super) const HATS: usize = 4;
/// The corners at which they are 1.
pub(super) const CORNERS: [[usize; 2]; HATS] = [[0, 0], [1, 0], [1, 1], [0, 1]];
/// The hat functions of the two triangles.
const HALVES: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
/// Largest offset in both coordinates for which the integrals are computed by subdivision.
const NEAR: usize = 4;
/// Smallest and largest number of Chebyshev points.
const POINTS: (usize, usize) = (3, 12);

pub(super) type Square = [[f64; HATS]; HATS];

/// S and C of one offset.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CellPair {
    pub(super) same: Square,
    pub(super) cross: Square,
}

/// ∫ ℓ_i φ_a φ_b, ∫ ℓ_i φ_a and ∫ ℓ_i over a square, for one q.
struct Moments {
    nodes: Nodes,
    products: Vec<Square>,
    hats: Vec<[f64; HATS]>,
    ones: Vec<f64>,
}

/// The integrals over pairs of squares for one order and one accuracy.
pub(super) struct CellPairs {
    means: Means,
    kernel: InversePower,
    digits: f64,
    moments: Vec<Moments>,
}

impl CellPairs {
    pub(super) fn new(order: Order, accuracy: f64) -> Result<Self> {
        let moments = (0..=POINTS.1).map(|q| Moments::new(q.max(1))).collect::<Result<_>>()?;
        Ok(Self {
            means: Means::new(order, Shape::Linears, accuracy, u64::MAX),
            kernel: InversePower::new(1.0 + order.value()),
            digits: -accuracy.ln(),
            moments,
        })
    }

    /// The forms for an offset without a common node.
    pub(super) fn apart(&self, offset: [i64; 2]) -> Result<CellPair> {
        let reach = offset[0].unsigned_abs().max(offset[1].unsigned_abs()) as usize;
        if reach > NEAR {
            return Ok(self.interpolated(offset, reach));
        }
        let mut pair = CellPair::default();
        for (first, second) in HALVES.iter().flat_map(|a| HALVES.iter().map(move |b| (a, b))) {
            // Functions 0..4 are the hats of the first square, 4..8 those of the second.
            let piece = |corners: &[usize; 3], at: [i64; 2], from: usize| {
                Simplex::triangle(corners.map(|a| {
                    let place = [0, 1].map(|k| (CORNERS[a][k] as i64 + at[k]) as f64);
                    Corner { node: NO_NODE, at: place, values: unit::<8>(from + a) }
                }))
            };
            let (x, y) = (piece(first, [0, 0], 0), piece(second, offset, HATS));
            let found = self.means.mean(&x, &y, [0.5, 0.5], &mut 0)?[LEVELS - 1];
            for a in 0..HATS {
                for b in 0..HATS {
                    pair.same[a][b] += found[a.max(b)][a.min(b)];
                    pair.cross[a][b] -= found[HATS + b][a];
                }
            }
        }
        Ok(pair)
    }

    fn interpolated(&self, offset: [i64; 2], reach: usize) -> CellPair {
        let gain = (4.0 * (reach as f64 - 1.0)).ln();
        let q = ((self.digits / gain).ceil() as usize + 1).clamp(POINTS.0, POINTS.1);
        let Moments { nodes, products, hats, ones } = &self.moments[q];
        let place = |k: usize| 0.5 * (1.0 + nodes.at[k]);
        let mut pair = CellPair::default();
        for i in 0..q * q {
            let (mut whole, mut row) = (0.0, [0.0; HATS]);
            for j in 0..q * q {
                let dx = place(i / q) - place(j / q) - offset[0] as f64;
                let dy = place(i % q) - place(j % q) - offset[1] as f64;
                let kernel = self.kernel.at(dx * dx + dy * dy);
                whole += kernel * ones[j];
                (0..HATS).for_each(|b| row[b] += kernel * hats[j][b]);
            }
            for a in 0..HATS {
                for b in 0..HATS {
                    pair.same[a][b] += products[i][a][b] * whole;
                    pair.cross[a][b] += hats[i][a] * row[b];
                }
            }
        }
        pair
    }

    /// The whole form of two squares that share nodes, on the nodes of a patch of 3 × 3 nodes: the first square
    /// at `origin`, the second at origin + offset, both inside the patch.
    pub(super) fn touching(&self, origin: [usize; 2], offset: [i64; 2]) -> Result<[[f64; 9]; 9]> {
        let other = [0, 1].map(|k| (origin[k] as i64 + offset[k]) as usize);
        let piece = |corners: &[usize; 3], at: [usize; 2]| {
            Simplex::triangle(corners.map(|a| {
                let place = [0, 1].map(|k| CORNERS[a][k] + at[k]);
                let node = 3 * place[1] + place[0];
                Corner { node, at: place.map(|x| x as f64), values: unit::<9>(node) }
            }))
        };
        let mut sum = [[0.0; 9]; 9];
        for (first, second) in HALVES.iter().flat_map(|a| HALVES.iter().map(move |b| (a, b))) {
            let (x, y) = (piece(first, origin), piece(second, other));
            let found = self.means.mean(&x, &y, [0.5, 0.5], &mut 0)?[LEVELS - 1];
            for i in 0..9 {
                (0..9).for_each(|j| sum[i][j] += found[i.max(j)][i.min(j)]);
            }
        }
        Ok(sum)
    }
}

fn unit<const K: usize>(k: usize) -> [f64; K] {
    std::array::from_fn(|i| f64::from(u8::from(i == k)))
}

impl Moments {
    fn new(q: usize) -> Result<Self> {
        let nodes = Nodes::new(q);
        let mut products = vec![[[0.0; HATS]; HATS]; q * q];
        let (mut hats, mut ones) = (vec![[0.0; HATS]; q * q], vec![0.0; q * q]);
        for corners in HALVES {
            for &([u, v], weight) in points(2, q + 2)? {
                let shares = [1.0 - u - v, u, v];
                let mut hat = [0.0; HATS];
                corners.iter().zip(shares).for_each(|(&corner, share)| hat[corner] = share);
                let at = [0, 1].map(|k| (0..HATS).map(|a| hat[a] * CORNERS[a][k] as f64).sum::<f64>());
                let [x, y] = at.map(|x| nodes.lagrange(2.0 * x - 1.0));
                for i in 0..q * q {
                    let value = 0.5 * weight * x[i / q] * y[i % q];
                    ones[i] += value;
                    for a in 0..HATS {
                        hats[i][a] += value * hat[a];
                        (0..HATS).for_each(|b| products[i][a][b] += value * hat[a] * hat[b]);
                    }
                }
            }
        }
        Ok(Self { nodes, products, hats, ones })
    }
}
