//! Pairs of triangles with a common corner P: one is {P + ρ e(t)}, the other {P + ρτ e'(t')}, ρ, τ, t, t' in
//! (0, 1).
//!
//! The integral over the pairs in which y is nearer to P than x, on the scale of its edge, is
//!
//! J J' ∫∫∫ τ² |e(t) − τ e'(t')|^{-2-2s} (∫₀¹ ρ^{1−2s} (w(P + ρ e(t)) − w(P + ρτ e'(t')))² dρ) dt dt' du,
//!
//! τ = e^{-u}, J and J' twice the areas: the kernel depends on ρ only by a power, so that the radial rule
//! ([`super::radial`]) integrates over the whole corner. The integrand is singular at u = 0, t = t' for a
//! common edge, or at u = t = t' = 0 if the edges e and e' begin at one point: Duffy's coordinates are used
//! with a rule for ξ^{1−2s}, or for ξ^{2−2s} (ξ^{−2s} if the function jumps there). Elsewhere tensor rules are
//! used on boxes no longer than twice their distance; e(t) − τ e'(t') is computed from 1 − τ without
//! cancellation.

use super::radial::{self, Points};
use super::side::Side;
use crate::error::{Error, Result};
use crate::order::Order;
use crate::plane::geometry::{dot, length, minus};
use crate::plane::kernel::InversePower;
use crate::quadrature::Rule;

/// Smallest ratio of distance to length of an admissible box.
const ADMISSIBLE: f64 = 0.5;
/// Length of the first interval of u beyond the singular part.
const STEP: f64 = 1.0;
/// Largest number of boxes into which one pair is subdivided.
const PATIENCE: usize = 20_000;

/// Parameters of the integrals at one corner.
pub(super) struct Fan<'a> {
    pub(super) order: Order,
    pub(super) kernel: &'a InversePower,
    /// Number of points of every rule except the radial one.
    pub(super) points: usize,
    pub(super) radial: &'a Points,
    /// Value of u up to which cells are needed; `None` if w is smooth in τ.
    pub(super) depth: Option<f64>,
    /// True if the function may jump across the common edge.
    pub(super) jumps: bool,
}

/// A box: τ between e^{-to} and e^{-from}, and intervals of t and t'.
#[derive(Debug, Clone, Copy)]
struct Region {
    from: f64,
    to: f64,
    t: [f64; 2],
    other: [f64; 2],
}

impl Fan<'_> {
    /// The integral, in units, over all pairs of points of two lists of sides that form two triangles or the
    /// same one; `begins` states that both lists begin at a common second corner. Values of the function are
    /// counted in `work`.
    pub(super) fn pair(
        &self,
        first: &[Side<'_>],
        second: &[Side<'_>],
        begins: Contact,
        work: &mut u64,
    ) -> Result<f64> {
        let mut sum = 0.0;
        for (i, x) in first.iter().enumerate() {
            for (j, y) in second.iter().enumerate() {
                let found = match begins {
                    Contact::Same if i == j => self.same(x, work)?,
                    Contact::Same if j == i + 1 => {
                        2.0 * self.adjacent(&x.turned(), y, false, work)?
                    }
                    Contact::Same if j > i => 2.0 * self.both(x, y, work)?,
                    Contact::Same => 0.0,
                    Contact::Edge if i + j == 0 => self.adjacent(x, y, self.jumps, work)?,
                    Contact::Edge | Contact::Corner => self.both(x, y, work)?,
                };
                let areas = x.twice_area() * y.twice_area();
                sum += areas * found;
            }
        }
        Ok(sum)
    }

    /// The integral for sides whose edges do not touch.
    fn both(&self, x: &Side<'_>, y: &Side<'_>, work: &mut u64) -> Result<f64> {
        Ok(self.boxes(x, y, 0.0, work)? + self.boxes(y, x, 0.0, work)?)
    }

    /// The integral for one side with itself.
    fn same(&self, side: &Side<'_>, work: &mut u64) -> Result<f64> {
        let power = 2.0 * self.order.complement();
        let reach = length(side.along) / length(side.edge(0.5));
        let (singular, plain) =
            (radial::weighted(self.points, power)?, Rule::gauss_legendre(self.points)?);
        let mut sum = 0.0;
        for &(xi, v) in &singular {
            for (eta, w) in plain.iter() {
                for (u, gap) in [(reach * xi, xi * eta), (reach * xi * eta, xi)] {
                    let weight =
                        v * w * xi.powf(2.0 - power) * reach * (-2.0 * u).exp() * (1.0 - gap);
                    for (sigma, m) in plain.iter() {
                        let t = sigma * (1.0 - gap);
                        let both =
                            self.at(side, side, u, t, t + gap) + self.at(side, side, u, t + gap, t);
                        sum += weight * m * both;
                    }
                }
            }
        }
        *work += (8 * singular.len() * plain.points().len().pow(2) * self.radial.len()) as u64;
        Ok(2.0 * (sum + self.boxes(side, side, reach, work)?))
    }

    /// The integral for sides whose edges begin at the same point, in both orders.
    fn adjacent(&self, x: &Side<'_>, y: &Side<'_>, jumps: bool, work: &mut u64) -> Result<f64> {
        let twice = 2.0 * self.order.complement();
        let power = if jumps { self.order.one_minus_twice() } else { 1.0 + twice };
        let reach = length(x.along).max(length(y.along)) / length(x.edge(0.0));
        let (singular, plain) =
            (radial::weighted(self.points, power)?, Rule::gauss_legendre(self.points)?);
        let mut sum = 0.0;
        for &(xi, v) in &singular {
            for (eta, w) in plain.iter() {
                for (zeta, m) in plain.iter() {
                    let weight = v * w * m * xi.powf(3.0 - power) * reach;
                    for [p, t, r] in [
                        [xi, xi * eta, xi * zeta],
                        [xi * eta, xi, xi * zeta],
                        [xi * eta, xi * zeta, xi],
                    ] {
                        let u = reach * p;
                        let both = self.at(x, y, u, t, r) + self.at(y, x, u, r, t);
                        sum += weight * (-2.0 * u).exp() * both;
                    }
                }
            }
        }
        *work += (12 * singular.len() * plain.points().len().pow(2) * self.radial.len()) as u64;
        Ok(sum + self.boxes(x, y, reach, work)? + self.boxes(y, x, reach, work)?)
    }

    /// |e(t) − τ e'(t')|^{-2-2s} times the radial integral, for edges that begin at one point.
    #[inline]
    fn at(&self, x: &Side<'_>, y: &Side<'_>, u: f64, t: f64, other: f64) -> f64 {
        let (tau, rest) = ((-u).exp(), -(-u).exp_m1());
        let apart = |k: usize| rest * x.from[k] + (t * x.along[k] - tau * (other * y.along[k]));
        let z = [apart(0), apart(1)];
        self.kernel.at(dot(z, z)) * x.radial(y, self.radial, [t, other, tau])
    }

    /// The part beyond u = `from`, with x farther from P than y.
    fn boxes(&self, x: &Side<'_>, y: &Side<'_>, from: f64, work: &mut u64) -> Result<f64> {
        let whole = [0.0, 1.0];
        let mut open = vec![Region { from, to: from + STEP, t: whole, other: whole }];
        let mut start = from + STEP;
        if let Some(depth) = self.depth {
            while start < depth {
                open.push(Region { from: start, to: start + radial::CELL, t: whole, other: whole });
                start += radial::CELL;
            }
        } else {
            open.push(Region { from: start, to: f64::INFINITY, t: whole, other: whole });
        }
        let (mut sum, mut patience) = (0.0, PATIENCE);
        while let Some(region) = open.pop() {
            let parts = self.cut(x, y, &region);
            if patience == 0 {
                return Err(Error::OutOfRange {
                    name: "relative distance of the edges opposite a common corner",
                    value: 0.0,
                    range: "the range that the quadrature resolves",
                });
            }
            patience -= 1;
            match parts {
                Some(parts) => open.extend(parts),
                None => sum += self.tensor(x, y, &region, work)?,
            }
        }
        Ok(sum)
    }

    /// The two halves of a box, cut in its longest direction; `None` if the box is small enough.
    fn cut(&self, x: &Side<'_>, y: &Side<'_>, region: &Region) -> Option<[Region; 2]> {
        let Region { from, to, t, other } = *region;
        let (near, deep) = ((-from).exp(), (-to).exp());
        let centre = y.edge(0.5 * (other[0] + other[1])).map(|v| 0.5 * (near + deep) * v);
        let lengths = [
            (t[1] - t[0]) * length(x.along),
            near * (other[1] - other[0]) * length(y.along),
            (near - deep) * length(y.edge(0.5 * (other[0] + other[1]))),
        ];
        let size = lengths[0].max(lengths[1] + lengths[2]);
        let apart = length(minus(x.edge(0.5 * (t[0] + t[1])), centre));
        let distance = apart - 0.5 * (lengths[0] + lengths[1].hypot(lengths[2]));
        if ADMISSIBLE * size <= distance {
            return None;
        }
        let longest = (1..3).fold(0, |best, k| if lengths[k] > lengths[best] { k } else { best });
        let halves = |[a, b]: [f64; 2]| [[a, 0.5 * (a + b)], [0.5 * (a + b), b]];
        Some(match longest {
            0 => halves(t).map(|t| Region { t, ..*region }),
            1 => halves(other).map(|other| Region { other, ..*region }),
            _ => {
                let middle = if to.is_finite() { 0.5 * (from + to) } else { from + STEP };
                [Region { to: middle, ..*region }, Region { from: middle, ..*region }]
            }
        })
    }

    fn tensor(&self, x: &Side<'_>, y: &Side<'_>, region: &Region, work: &mut u64) -> Result<f64> {
        let Region { from, to, t, other } = *region;
        let plain = Rule::gauss_legendre(self.points)?;
        // τ and the root of its weight, τ² in it: r^a may be so large that its square is no number.
        let taus: Points = if to.is_finite() {
            let at = |v: f64| (-(from + (to - from) * v)).exp();
            plain.iter().map(|(v, w)| (at(v), (w * (to - from)).sqrt() * at(v))).collect()
        } else {
            let near = (-from).exp();
            radial::weighted(self.points, 2.0)?
                .iter()
                .map(|(v, w)| (near * v, near * w.sqrt()))
                .collect()
        };
        let scaled = |[a, b]: [f64; 2]| -> Points {
            plain.iter().map(|(v, w)| (a + (b - a) * v, (b - a) * w)).collect()
        };
        let (ts, others) = (scaled(t), scaled(other));
        let column = |side: &Side<'_>, scale: f64, t: f64| -> Vec<f64> {
            self.radial.iter().map(|(rho, _)| side.value(scale * rho, t)).collect()
        };
        let values: Vec<Vec<f64>> = ts.iter().map(|(t, _)| column(x, 1.0, *t)).collect();
        let mut sum = 0.0;
        for &(tau, root) in &taus {
            for &(r, w) in &others {
                let (at, mut second) = (y.edge(r).map(|z| tau * z), column(y, tau, r));
                second.iter_mut().for_each(|value| *value *= root);
                for (&(t, m), first) in ts.iter().zip(&values) {
                    let z = minus(x.edge(t), at);
                    let pairs = first.iter().zip(&second).zip(self.radial);
                    let square = |((a, b), (_, weight)): ((&f64, &f64), &(f64, f64))| {
                        let difference = root * a - b;
                        weight * difference * difference
                    };
                    sum += w * m * self.kernel.at(dot(z, z)) * pairs.map(square).sum::<f64>();
                }
            }
        }
        *work += (self.radial.len() * (ts.len() + taus.len() * others.len())) as u64;
        Ok(sum)
    }
}

/// The relative position of the edges opposite to the common corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Contact {
    /// The two triangles are the same.
    Same,
    /// They begin at a second common corner.
    Edge,
    /// They do not touch.
    Corner,
}
