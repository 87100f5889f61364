//! Pairs of panels with a gap between them: tensor Gauss rules for the kernel.
//!
//! With s < t, x and y the distances of a point from the two ends and d = t − s, the kernel of
//! [`super::kernel`] is, for x(s) ≤ y(t),
//!
//! ν K = (x(t)^p − d^p)/p − (ℓ^p − y(s)^p)/p,  the first term = x(t)^p (1 − e^{−pL})/p,  L = ln(1 + x(s)/d),
//!
//! and its mirror image for x(s) > y(t): one logarithm and one exponential per pair of points, without
//! cancellation as long as d is not the largest of the three lengths. In that case, and where e^{−pL} would
//! overflow, the general formula is used.

use super::adjacent::{Block, EMPTY};
use super::gram::Assembly;
use super::kernel::{exp_quotient, kernel, ln_one_plus_ratio};
use super::local::Local;
use super::nodes::Node;
use super::space::MOST_FUNCTIONS;
use crate::estimate::Work;

/// Interactions below this fraction of the self energies do not change any digit of the quotient.
const NEGLIGIBLE: f64 = 1e-18;

/// Exponent beyond which e^{−pL} exceeds the range of f64 (p near −1, the shortest distances).
const LARGEST_EXPONENT: f64 = 600.0;

/// Number of additional digits where steps are subtracted to form hat functions.
const SPARE_DIGITS: f64 = 2.0;

impl Assembly<'_> {
    /// The block of panels i and j > i + 1, `gap` apart; `None` if it is negligible.
    pub(super) fn separated(&self, i: usize, j: usize, gap: f64, work: &mut Work) -> Option<Block> {
        let space = self.space;
        let (s, t) = (&space.panels[i], &space.panels[j]);
        let classes = self.classes(i, j);
        let digits = 0.5 * (self.digits(i) + self.digits(j))
            + match (self.local, classes) {
                (Some(local), (true, _) | (_, true)) => {
                    if local.is_negligible(space, s.cell, t.cell) {
                        return None;
                    }
                    let reach = gap + s.length + t.length;
                    let largest = local.inside(gap).abs().max(local.inside(reach).abs());
                    let of_hats = (s.length.powf(self.p) * t.length.powf(self.p)).sqrt();
                    let excess = if classes == (true, true) { largest / of_hats } else { 1.0 };
                    SPARE_DIGITS + excess.log10().max(0.0)
                }
                _ => {
                    let (alpha, beta) =
                        (space.panel_left[i] + s.length, space.panel_right[j] + t.length);
                    let scale = self.scale[i].sqrt() * self.scale[j].sqrt();
                    let share = kernel(self.p, alpha, gap, beta) / scale;
                    if share < NEGLIGIBLE {
                        return None;
                    }
                    share.log10().min(0.0)
                }
            };
        if let Some(local) = self.local
            && local.contains(s.cell)
            && local.contains(t.cell)
            && let Some(first_is_nearer) = local.is_nearer(space, i, j)
        {
            return Some(self.seen_from_origin(i, j, first_is_nearer));
        }
        let rule_s = self.nodes.choose(i, s.outside(gap, false), digits);
        let rule_t = self.nodes.choose(j, t.outside(gap, true), digits);
        let of_s = self.nodes.get(space, self.local, self.p, (i, rule_s));
        let of_t = self.nodes.get(space, self.local, self.p, (j, rule_t));
        work.points += (of_s.len() * of_t.len()) as u64;
        Some(self.tensor((of_s, of_t), (space.functions(i), space.functions(j)), gap, classes))
    }

    fn tensor(
        &self,
        (of_s, of_t): (&[Node], &[Node]),
        (rows, columns): (usize, usize),
        gap: f64,
        classes: (bool, bool),
    ) -> Block {
        let mut block = EMPTY;
        for s in of_s {
            let to_gap = s.from_right + gap;
            let mut sums = [0.0; MOST_FUNCTIONS];
            for t in of_t {
                let distance = to_gap + t.from_left;
                let value = match self.local {
                    Some(local) if classes != (false, false) => {
                        shifted(self.p, local, classes, s, t, distance)
                    }
                    _ => self.between(s, t, distance),
                };
                for (sum, weighted) in sums.iter_mut().zip(&t.weighted).take(columns) {
                    *sum += value * weighted;
                }
            }
            for (row, weighted) in block.iter_mut().zip(&s.weighted).take(rows) {
                for (entry, sum) in row.iter_mut().zip(&sums).take(columns) {
                    *entry += weighted * sum;
                }
            }
        }
        block
    }

    /// The value of ν K for two points at distance d.
    fn between(&self, s: &Node, t: &Node, d: f64) -> f64 {
        let is_left = s.x <= t.y;
        let logarithm = ln_one_plus_ratio(if is_left { s.x } else { t.y }, d);
        if s.x.max(t.y) <= d || -self.p * logarithm > LARGEST_EXPONENT {
            return kernel(self.p, s.x, d, t.y);
        }
        let increment = exp_quotient(-self.p, logarithm);
        if is_left {
            t.x_power * increment - s.beyond_y
        } else {
            s.y_power * increment - t.beyond_x
        }
    }

    /// The block of two panels of the local group, one of which is so much nearer to P that the kernel is that
    /// of P: a product of two integrals.
    fn seen_from_origin(&self, i: usize, j: usize, first_is_nearer: bool) -> Block {
        let (of_i, of_j) = if first_is_nearer {
            (&self.from_origin[i].0, &self.from_origin[j].1)
        } else {
            (&self.from_origin[i].1, &self.from_origin[j].0)
        };
        let mut block = EMPTY;
        for k in 0..self.space.functions(i) {
            for l in 0..self.space.functions(j) {
                block[k][l] = of_i[k] * of_j[l];
            }
        }
        block
    }
}

/// The shifted kernel for two points at distance d, at least one of them in the local group.
fn shifted(p: f64, local: &Local, classes: (bool, bool), s: &Node, t: &Node, d: f64) -> f64 {
    match classes {
        (true, true) => s.nearer + t.further + local.inside(d),
        (true, false) => s.nearer + approach(p, t, d, s.position),
        _ => t.further + approach(p, s, d, -t.position),
    }
}

/// (D^p − d^p)/p for a point at distance D from P and d from the point at `shift` from P towards it: ν
/// (K(s,t) − K(P,t)) for s in the group, t outside, without the term of s alone, and its mirror image.
fn approach(p: f64, outside: &Node, d: f64, shift: f64) -> f64 {
    let exponent = if shift > 0.0 {
        exp_quotient(-p, ln_one_plus_ratio(shift, d))
    } else {
        -exp_quotient(p, (-shift / outside.position.abs()).ln_1p())
    };
    outside.position_power * exponent
}
