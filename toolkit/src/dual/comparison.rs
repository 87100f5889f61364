//! Comparison forms that approximate the regional form locally and are known both exactly and discretely.
//!
//! On short waves at x, the form m ∫ u v + a (u, v)_ν of (1.1) on (0, 1) acts like b(x) + ac |ξ|^{2ν},
//!   b(x) = m - a (x^{-2ν} + (1-x)^{-2ν}) / ν:
//! since it differs from c A^ν of [`super::cosines`] by twice the integral of the kernel over the exterior.
//! With nodes β_j ≥ 0 and the Lagrange polynomials θ_j in b(x),
//!   R = Σ_j ⟨f, (β_j + acA^ν)^{-1} θ_j f⟩
//! interpolates 1/(b(x) + ac |ξ|^{2ν}): on waves of length h the relative difference is of the size Π_j
//! |b(x) - β_j| h^{2ν}/(ac), with one factor for one node. Since b < 0 nearly everywhere, the θ_j are large
//! if there are many of them. θ_j is constant on each element of f, so that θ_j f has the same form as f; at
//! distances below `NEAR` from an end, b is replaced by b(NEAR), and the windows of [`super::missed`] account
//! for the remainder. For the exact R, with G = (β_j + acA^ν)^{-1} and θ = θ_j,
//!   ⟨f, Gθf⟩ = (t/4) (⟨f + θf/t, G(f + θf/t)⟩ - ⟨f - θf/t, G(f - θf/t)⟩),   t = max |θ|.

use super::cells::Cells;
use super::cosines::exact_form;
use crate::error::Result;
use crate::kernel::power::symbol_constant;
use crate::mesh::Mesh;
use crate::order::Order;
use std::f64::consts::PI;
use std::ops::Range;

/// Distance from an end below which b is held constant.
const NEAR: f64 = 0.003;
/// Largest number of nodes; smallest number of elements and largest order for which more than one node is
/// used.
const MOST_NODES: usize = 8;
const MANY: usize = 1000;
const LARGEST_ORDER: f64 = 0.8;
/// Number of equal elements for whose waves the nodes are counted.
const SHORT: f64 = 262_144.0;
/// Error that remains at the ends with one node, relative to Q.
const ENDS: f64 = 1e-6;
/// Value of b h^{2ν} from which more nodes have no advantage.
const TOO_SLOW: f64 = 0.5;

/// An interval of length ℓ in (0, 1), scaled to (0, 1): the elements of f that count there, m and a.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub(super) start: f64,
    pub(super) length: f64,
    pub(super) elements: Range<usize>,
    pub(super) weights: [f64; 2],
    /// distances from the ends below which b is held constant
    near: [f64; 2],
}

impl Part {
    pub(super) fn whole(partition: &Mesh, weights: [f64; 2]) -> Self {
        Self { start: 0.0, length: 1.0, elements: 0..partition.len(), weights, near: [NEAR, NEAR] }
    }

    /// The part of f within ℓ/2 of an end. With m + a (ℓ^{-2ν} - 1)/ν and a ℓ^{-2ν} as weights, b is unchanged
    /// there.
    pub(super) fn window(&self, partition: &Mesh, order: Order, length: f64, right: bool) -> Self {
        let (nu, [m, a]) = (order.value(), self.weights);
        let half = 0.5 * length * partition.total();
        let elements = if right {
            partition.from_right().partition_point(|&distance| distance > half)..partition.len()
        } else {
            0..partition.from_left().partition_point(|&distance| distance <= half).saturating_sub(1)
        };
        let power = length.powf(-2.0 * nu);
        Self {
            start: if right { 1.0 - length } else { 0.0 },
            length,
            elements,
            weights: [m + a * (power - 1.0) / nu, a * power],
            near: if right { [0.0, NEAR / length] } else { [NEAR / length, 0.0] },
        }
    }
}

/// The nodes β_j and the factor c.
#[derive(Debug, Clone)]
pub(super) struct Comparison {
    order: Order,
    pub(super) nodes: Vec<f64>,
    pub(super) constant: f64,
}

impl Comparison {
    /// The comparison forms for f with `count` elements, for a relative `tolerance`.
    pub(super) fn new(order: Order, [m, a]: [f64; 2], count: usize, tolerance: f64) -> Self {
        let (nu, constant) = (order.value(), symbol_constant(order));
        let at = |x: f64| m - a * (x.powf(-2.0 * nu) + (1.0 - x).powf(-2.0 * nu)) / nu;
        let (least, most) = (at(NEAR), at(0.5));
        let beside = (2.0 * most.abs() / (a * constant * (PI * SHORT).powf(2.0 * nu))).max(ENDS);
        let nodes = if count < MANY || nu > LARGEST_ORDER || beside > TOO_SLOW {
            1
        } else {
            ((0.1 * tolerance).ln() / beside.ln()).ceil().clamp(1.0, MOST_NODES as f64) as usize
        };
        let nodes = if nodes > 1 {
            let (first, last) = if least > 0.0 { (least, most) } else { (0.0, most.max(-least)) };
            (0..nodes).map(|j| first + (last - first) * j as f64 / (nodes - 1) as f64).collect()
        } else if order.complement() > 0.02 {
            vec![most.max(0.0)]
        } else {
            // Near order 1 the exact form with β takes too many passes.
            vec![0.0]
        };
        Self { order, nodes, constant }
    }

    /// The values of θ_j on the elements of f in a part, for every node; empty for one node.
    pub(super) fn shares(&self, partition: &Mesh, part: &Part) -> Vec<Vec<f64>> {
        let mut shares = vec![Vec::with_capacity(part.elements.len()); self.nodes.len()];
        if self.nodes.len() == 1 {
            return Vec::new();
        }
        let (nu, [m, a]) = (self.order.value(), part.weights);
        let scale = 0.5 / (partition.total() * part.length);
        let shifts =
            [part.start, 1.0 - part.start - part.length].map(|outside| outside / part.length);
        for i in part.elements.clone() {
            let [left, right] =
                [partition.from_left(), partition.from_right()].map(|d| scale * (d[i] + d[i + 1]));
            let [left, right] =
                [(left - shifts[0]).max(part.near[0]), (right - shifts[1]).max(part.near[1])];
            let b = m - a * (left.powf(-2.0 * nu) + right.powf(-2.0 * nu)) / nu;
            for (j, (node, share)) in self.nodes.iter().zip(&mut shares).enumerate() {
                let others = self.nodes.iter().enumerate().filter(|&(k, _)| k != j);
                share.push(others.map(|(_, other)| (b - other) / (node - other)).product());
            }
        }
        shares
    }

    /// R and its error, for f with mean zero on the whole interval.
    pub(super) fn exact(
        &self,
        partition: &Mesh,
        part: &Part,
        f: Cells,
        goal: f64,
    ) -> Result<(f64, f64)> {
        let symbol = part.weights[1] * self.constant;
        let shares = self.shares(partition, part);
        if shares.is_empty() {
            return exact_form(f, self.order, [self.nodes[0], symbol], goal);
        }
        let largest =
            |share: &Vec<f64>| share.iter().fold(1.0, |size: f64, theta| size.max(theta.abs()));
        let goal = (goal / shares.iter().map(largest).sum::<f64>()).max(f64::EPSILON);
        let (mut sum, mut error) = (0.0, 0.0);
        for (&beta, share) in self.nodes.iter().zip(&shares) {
            let size = largest(share);
            for sign in [1.0, -1.0] {
                let load = f.times(|i| 1.0 + sign * share[i] / size)?;
                let load = load.minus(load.mean())?;
                let (value, own) = exact_form(load, self.order, [beta, symbol], goal)?;
                sum += sign * 0.25 * size * value;
                error += 0.25 * size * own;
            }
        }
        Ok((sum, error))
    }
}
