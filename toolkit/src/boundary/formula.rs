//! A function of the place on the boundary of a polygon, and its norms with the distance in the plane.
//!
//! |u|²_ν = ∫_Γ ∫_Γ (u(x) − u(y))² / |x − y|^{1+2ν} over the pairs of elements of a mesh graded by the factor 0.3 to every
//! vertex, with n Gauss points on an element:
//!
//! - one element twice: 2 h^{1−2ν} ∫ z^{1−2ν} (1 − z) ∫ ((u(t + hz) − u(t))/z)², t = h (1 − z) s, s in (0, 1);
//! - neighbours of lengths p, q, straight on or over a corner: over the triangles σ = ξp, τ = ξqη and σ = ξpη, τ = ξq
//!   (Duffy), pq ξ^{2−2ν} ((u(x) − u(y))/ξ)² / ρ(η)^{1+2ν}, ξρ the distance; cut in η about the singularity of ρ;
//! - others: cut until no piece is longer than the distance to the other.
//!
//! Where u is smooth but for the vertices, the error falls exponentially in n and in the number of layers.

use super::curve::{Curve, Relation};
use super::pairs::cut;
use crate::energy::PairSum;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::numeric::scale::{power_of_two, unit_of};
use crate::order::Order;
use crate::quadrature::{PowerWeightRule, Rule};
use crate::root::{ENTRY_ROUNDING, accept, root_of_squares};
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Length of an element over that of its neighbour farther from the vertex.
const RATIO: f64 = 0.3;
/// Gauss points of an element and layers at a vertex, from coarse to fine: 0.3^160 is 1e-84 of a side.
const STEPS: [(usize, usize); 5] = [(8, 10), (12, 20), (16, 40), (20, 80), (24, 160)];
/// Message: what limits the accuracy.
const LIMIT: &str = "rules graded to the vertices do not settle: declare kinks and jumps as vertices, and stay away from the \
     order at which the norm is infinite";

/// A function on the boundary of a polygon.
pub(crate) struct CurveFormula<'a> {
    /// in units of `unit`, a power of two
    vertices: Vec<[f64; 2]>,
    unit: f64,
    f: Box<dyn Fn([f64; 2]) -> f64 + Sync + 'a>,
}

impl std::fmt::Debug for CurveFormula<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CurveFormula").field("vertices", &self.vertices).finish_non_exhaustive()
    }
}

/// |u|²_ν and ‖u‖², both over the square of `size`, with what rounding leaves in the first.
struct Squares {
    seminorm: f64,
    rounding: f64,
    l2: f64,
    size: f64,
    points: u64,
}

impl<'a> CurveFormula<'a> {
    /// # Errors
    /// As [`Curve::closed`].
    pub(crate) fn new(vertices: &[[f64; 2]], f: impl Fn([f64; 2]) -> f64 + Sync + 'a) -> Result<Self> {
        let one = Mesh::uniform(1, 1.0)?;
        let largest = vertices.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        let unit = if largest.is_finite() { power_of_two(largest) } else { 1.0 };
        let vertices: Vec<[f64; 2]> = vertices.iter().map(|vertex| vertex.map(|x| x / unit)).collect();
        Curve::closed(&vertices, &vec![one; vertices.len()])?;
        Ok(Self { vertices, unit, f: Box::new(f) })
    }

    /// |u|_ν, 0 < ν < 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a value that is not finite; [`Error::ToleranceNotMet`] with the best value where the
    /// rules do not settle: kinks inside a side, narrow angles, an infinite norm.
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let [seminorm, _] = self.settle(order, tolerance, [1.0, 0.0])?;
        accept("seminorm", seminorm, tolerance, LIMIT)
    }

    /// ‖u‖_ν, 0 < ν < 1.
    ///
    /// # Errors
    /// As [`CurveFormula::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let parts = self.settle(order, tolerance, [1.0, 1.0])?;
        accept("norm", root_of_squares(&parts)?, tolerance, LIMIT)
    }

    /// ‖u‖ in L².
    ///
    /// # Errors
    /// As [`CurveFormula::seminorm`].
    pub(crate) fn l2_norm(&self, tolerance: Tolerance) -> Result<Estimate> {
        let [_, norm] = self.settle(None, tolerance, [0.0, 1.0])?;
        accept("norm", norm, tolerance, LIMIT)
    }

    /// Seminorm (0 without an order) and L² norm, refined until the weighted sum of their squares changes little enough.
    fn settle(
        &self,
        order: impl Into<Option<Order>>,
        tolerance: Tolerance,
        weights: [f64; 2],
    ) -> Result<[Estimate; 2]> {
        let kernel = order.into().map(PowerKernel::new);
        let one_minus = kernel.as_ref().map_or(1.0, |kernel| kernel.one_minus);
        let units = [self.unit.powf(0.5 * one_minus), self.unit.sqrt()];
        let (mut work, mut before) = (Work::default(), None::<[f64; 2]>);
        let mut found = [Estimate::new(0.0, 0.0, work)?; 2];
        for (n, layers) in STEPS {
            let squares = self.squares(kernel.as_ref(), n, layers, tolerance.work())?;
            work.points += squares.points;
            let rounding = 0.5 * squares.rounding / squares.seminorm.max(f64::MIN_POSITIVE) + ENTRY_ROUNDING;
            let roots = [squares.seminorm.sqrt(), squares.l2.sqrt()];
            let values = [0, 1].map(|k| squares.size * units[k] * roots[k]);
            for k in 0..2 {
                let change = before.map_or(values[k], |before| (before[k] - values[k]).abs());
                found[k] = Estimate::new(values[k], change + rounding * values[k], work)?;
            }
            before = Some(values);
            let largest = values[0].max(values[1]).max(f64::MIN_POSITIVE);
            let sum = |of: fn(&Estimate) -> f64| -> f64 {
                let parts = found.iter().zip(weights);
                parts.map(|(part, weight)| weight * (part.value / largest) * (of(part) / largest)).sum()
            };
            let is_settled = sum(|part| part.error) <= tolerance.relative() * sum(|part| part.value);
            if is_settled || work.points > tolerance.work() {
                break;
            }
        }
        Ok(found)
    }

    fn squares(&self, kernel: Option<&PowerKernel>, n: usize, layers: usize, most: u64) -> Result<Squares> {
        let mesh = Mesh::graded(&[0.0, 1.0], layers, RATIO)?;
        let curve = Curve::closed(&self.vertices, &vec![mesh; self.vertices.len()])?;
        let rule = Rule::gauss_legendre(n)?;
        let value = |e: usize, t: f64| (self.f)(curve.point(curve.place(e, t)).map(|x| self.unit * x));
        let at_points = |e: usize| -> Vec<f64> {
            let h = curve.element_length(e);
            rule.iter().map(|(s, _)| value(e, s * h)).collect()
        };
        let mut values: Vec<Vec<f64>> = (0..curve.len()).into_par_iter().map(at_points).collect();
        if let Some((index, &value)) = values.iter().flatten().enumerate().find(|(_, v)| !v.is_finite()) {
            return Err(Error::NotFinite { name: "value of the function", index, value });
        }
        let size = unit_of(values.iter().flatten());
        values.iter_mut().flatten().for_each(|v| *v /= size);
        let square = |e: usize| {
            let squares = rule.iter().zip(&values[e]).map(|((_, w), v)| w * v * v);
            curve.element_length(e) * squares.sum::<f64>()
        };
        let l2 = (0..curve.len()).map(square).sum();
        let first = values[0][0];
        let is_constant = values.iter().flatten().all(|v| *v == first);
        let Some(kernel) = kernel.filter(|_| !is_constant) else {
            let points = (n * curve.len()) as u64;
            return Ok(Squares { seminorm: 0.0, rounding: 0.0, l2, size, points });
        };
        let pairs = Pairs {
            curve: &curve,
            kernel,
            value: &|e, t| value(e, t) / size,
            values: &values,
            rule,
            own: PowerWeightRule::new(2 * n, kernel.two_minus)?,
            radial: PowerWeightRule::new(2 * n, kernel.three_minus)?,
            left: AtomicU64::new(most),
        };
        let sum =
            (0..curve.len()).into_par_iter().map(|e| pairs.row(e)).reduce(PairSum::default, |a, b| a + b);
        let rounding = 8.0 * f64::EPSILON * sum.rounding;
        Ok(Squares { seminorm: sum.value, rounding, l2, size, points: sum.points })
    }
}

/// The sum over pairs of elements.
struct Pairs<'a> {
    curve: &'a Curve,
    kernel: &'a PowerKernel,
    value: &'a (dyn Fn(usize, f64) -> f64 + Sync),
    values: &'a [Vec<f64>],
    rule: Rule,
    /// for the weights z^{1−2ν} and ξ^{2−2ν}
    own: PowerWeightRule,
    radial: PowerWeightRule,
    /// evaluations that elements cut in pieces may still take
    left: AtomicU64,
}

fn add(sum: &mut PairSum, weight: f64, difference: f64) {
    sum.value += weight * difference * difference;
    sum.rounding += (weight * difference).abs();
    sum.points += 1;
}

impl Pairs<'_> {
    /// All pairs with a first element and itself or a later one.
    fn row(&self, e: usize) -> PairSum {
        let mut sum = PairSum::default();
        self.same(e, &mut sum);
        for f in e + 1..self.curve.len() {
            if self.curve.follows(e, f) {
                self.touching(e, f, &mut sum);
            } else if self.curve.follows(f, e) {
                self.touching(f, e, &mut sum);
            } else {
                let lengths = [e, f].map(|k| self.curve.element_length(k));
                let relation = self.curve.relation_of(e, f);
                self.separate([e, f], relation, lengths.map(|h| (0.0, h)), &mut sum);
            }
        }
        sum
    }

    fn same(&self, e: usize, sum: &mut PairSum) {
        let h = self.curve.element_length(e);
        let front = 2.0 * self.kernel.scaling(h);
        for (z, v) in self.own.iter() {
            for (s, w) in self.rule.iter() {
                let t = h * (1.0 - z) * s;
                let difference = (self.value)(e, t + h * z) - (self.value)(e, t);
                add(sum, front * v * w * (1.0 - z) / (z * z), difference);
            }
        }
    }

    /// e ends where f begins.
    fn touching(&self, e: usize, f: usize, sum: &mut PairSum) {
        let (p, q) = (self.curve.element_length(e), self.curve.element_length(f));
        let bend = match self.curve.relation_of(e, f) {
            Relation::Before(bend) => bend,
            _ => 4.0,
        };
        // cos ω = 1 − |a−b|²/2
        let (cosine, sine) = (1.0 - 0.5 * bend, (bend * (1.0 - 0.25 * bend)).max(0.0).sqrt());
        for (fixed, moving, is_first) in [(p, q, true), (q, p, false)] {
            cut(0.0, moving, [fixed * cosine, fixed * sine], &mut |start, length| {
                for (x, w) in self.rule.iter() {
                    let moved = start + length * x;
                    let distance = (fixed - moved).hypot((fixed * moved * bend).sqrt());
                    let weight = 2.0 * w * length * (fixed / distance) * distance.powf(-self.kernel.twice);
                    for (xi, v) in self.radial.iter() {
                        let (sigma, tau) =
                            if is_first { (xi * fixed, xi * moved) } else { (xi * moved, xi * fixed) };
                        let difference = (self.value)(e, p - sigma) - (self.value)(f, tau);
                        add(sum, weight * v / (xi * xi), difference);
                    }
                }
            });
        }
    }

    fn separate(&self, pair: [usize; 2], relation: Relation, parts: [(f64, f64); 2], sum: &mut PairSum) {
        let place = |k: usize, t: f64| self.curve.place(pair[k], t);
        let middle = |k: usize| place(k, parts[k].0 + 0.5 * parts[k].1);
        let (p, q) = (parts[0].1, parts[1].1);
        let gap = self.curve.apart(relation, middle(0), middle(1)) - 0.5 * (p + q);
        if p.max(q) > 1.0001 * gap {
            let left = self.left.load(Ordering::Relaxed);
            self.left.store(left.saturating_sub(4), Ordering::Relaxed);
            if left == 0 {
                sum.points += Tolerance::WORK; // the count refuses it
                return;
            }
            let longer = usize::from(q > p);
            let (start, half) = (parts[longer].0, 0.5 * parts[longer].1);
            for start in [start, start + half] {
                let mut parts = parts;
                parts[longer] = (start, half);
                self.separate(pair, relation, parts, sum);
            }
            return;
        }
        let values = |k: usize| -> std::borrow::Cow<'_, [f64]> {
            let (start, length) = parts[k];
            if length == self.curve.element_length(pair[k]) {
                return self.values[pair[k]].as_slice().into();
            }
            self.rule
                .iter()
                .map(|(s, _)| (self.value)(pair[k], start + s * length))
                .collect::<Vec<_>>()
                .into()
        };
        let (us, vs) = (values(0), values(1));
        let there: Vec<_> = self.rule.iter().map(|(y, w)| (place(1, parts[1].0 + q * y), w)).collect();
        for ((x, v), u) in self.rule.iter().zip(us.iter()) {
            let here = place(0, parts[0].0 + p * x);
            for ((there, w), other) in there.iter().zip(vs.iter()) {
                let distance = self.curve.apart(relation, here, *there);
                let kernel = (p / distance) * q * distance.powf(-self.kernel.twice);
                add(sum, 2.0 * v * w * kernel, u - other);
            }
        }
    }
}
