//! Norms of a function of the point on the boundary of a polygon, with the distance in the plane.
//!
//! |u|²_ν = ∫_Γ ∫_Γ (u(x) − u(y))² / |x − y|^{1+2ν} is summed over the pairs of elements of a mesh graded by the
//! factor 0.3 towards every vertex, with n Gauss points on an element:
//!
//! - an element of length h with itself: 2 h^{1−2ν} ∫₀¹ z^{1−2ν} (1 − z) ∫₀¹ ((u(t + hz) − u(t))/z)² ds dz,
//!   t = h (1 − z) s;
//! - neighbours of lengths p, q, on one side or across a corner, with points at the distances σ, τ from the
//!   common node: twice the integral over the triangles σ = ξp, τ = ξqη and σ = ξpη, τ = ξq (Duffy) of
//!   pq ξ^{2−2ν} ((u(x) − u(y))/ξ)² / ρ(η)^{1+2ν}, |x − y| = ξρ; subdivided in η about the zeros of ρ;
//! - other pairs, counted twice: subdivided until no piece is longer than its distance to the other.
//!
//! Where u is smooth except at the vertices, the error decreases exponentially in n and in the number of
//! layers.
//!
//! # The derivative along the boundary
//!
//! u′ = du/ds, s the arc length, is that of the polynomials through 2n Gauss points x_i of every element, of length h,
//!
//! ```text
//! h p′(x_i) = Σ_{j≠i} (w_j/w_i) (u_j − u_i) / (x_i − x_j),    w_j barycentric weights,
//! ```
//!
//! and its norms are those above. Rounding errors ε of the values of u are estimated to change it by 2 (2n)² ε/h. This is
//! Markov's inequality for a polynomial of size ε; it is no bound, since ε is known at the Gauss points only. Next to a
//! vertex, where differences of u between two layers have no digits, one polynomial therefore serves all layers, and the
//! derivatives of those through n and through 2n points are compared. A function in H¹ changes by at most √δ ‖u′‖ over a
//! distance δ: where values on both sides of a vertex, or of the middle of a side, differ by more, u jumps.

use super::curve::{Curve, Relation};
use super::pairs::{OF_CUT, Part, cut, split};
use crate::energy::PairSum;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::numeric::budget::Budget;
use crate::numeric::check::require_finite_at;
use crate::numeric::parallel;
use crate::numeric::scale::{power_of_two, unit_of};
use crate::order::Order;
use crate::quadrature::Rule;
use crate::root::{ENTRY_ROUNDING, accept, root_of_squares};
use rayon::prelude::*;
use std::borrow::Cow;

/// Ratio of the length of an element to that of its neighbour farther from the vertex.
const RATIO: f64 = 0.3;
/// Gauss points of an element and layers at a vertex, from coarse to fine: 0.3^160 is 1e-84 of a side.
const STEPS: [(usize, usize); 5] = [(8, 10), (12, 20), (16, 40), (20, 80), (24, 160)];
/// Bound of the contribution below the last layer at a vertex where x is rounded, relative to that of its element.
const BELOW: f64 = 10.0;
/// Ratio of changes above which a slower decrease is not assumed.
const SLOWEST: f64 = 0.95;
/// Ratio of the increments of the squares for twice as many layers: 2 − O(w) for contributions e^{−wt}, t =
/// ln(1/distance).
const DOUBLES: f64 = 1.9999;
/// Share of a square above which its growth is not attributed to rounding.
const GROWTH: f64 = 1e-6;
/// Relative size of the differences of u between two layers down to which its derivative has digits.
const DIGITS: f64 = 1e-7;
/// Distance from a node at which u is compared on both sides, in units of the element and of the rounding of x.
const BESIDE: f64 = 1e-12;
const ROUNDED: f64 = 16.0;
/// Factor by which such differences exceed those of a function in H¹.
const JUMP: f64 = 4.0;
/// Message: the function jumps.
const JUMPS: &str = "a function that jumps has no derivative in L^2";
/// Message: the layers at a vertex do not decrease.
const ENDLESS: &str = "the contributions near a vertex do not decay";
/// Message: what limits the accuracy.
const LIMIT: &str = "rules graded towards the vertices do not converge: declare kinks and jumps as vertices, \
     move a singular vertex to the origin, where x is exact, and stay away from the order at which the norm is infinite";

/// A function on the boundary of a polygon.
pub(crate) struct CurveFormula<'a> {
    /// in units of `unit`, a power of two
    pub(super) vertices: Vec<[f64; 2]>,
    pub(super) unit: f64,
    pub(super) f: Box<dyn Fn([f64; 2]) -> f64 + Sync + 'a>,
    /// whether it is the derivative of f along the boundary
    is_slope: bool,
}

impl std::fmt::Debug for CurveFormula<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CurveFormula").field("vertices", &self.vertices).finish_non_exhaustive()
    }
}

/// The end of a side to which an element belongs: the rounding error of its points away from the vertex, and
/// whether the element lies at the vertex with fewer layers than requested.
#[derive(Clone, Copy)]
struct End {
    blur: f64,
    is_cut: bool,
    /// whether the element begins or ends at the vertex
    at_vertex: bool,
    /// the last elements at this vertex, if differences of u have no digits on them
    last: Option<Last>,
}

/// The points of a side nearer to its first (0) or last vertex (1) than a length.
#[derive(Clone, Copy)]
struct Last {
    side: usize,
    end: usize,
    length: f64,
}

/// |u|²_ν and ‖u‖², both divided by the square of `size`, with the rounding errors of the first, and of the second for a
/// derivative.
struct Squares {
    seminorm: f64,
    rounding: f64,
    l2: f64,
    l2_rounding: f64,
    size: f64,
    points: u64,
}

impl<'a> CurveFormula<'a> {
    /// # Errors
    /// As [`Curve::closed`].
    pub(crate) fn new(
        vertices: &[[f64; 2]],
        f: impl Fn([f64; 2]) -> f64 + Sync + 'a,
    ) -> Result<Self> {
        let one = Mesh::uniform(1, 1.0)?;
        let largest = vertices.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        let unit = if largest.is_finite() { power_of_two(largest) } else { 1.0 };
        let vertices: Vec<[f64; 2]> =
            vertices.iter().map(|vertex| vertex.map(|x| x / unit)).collect();
        Curve::closed(&vertices, &vec![one; vertices.len()])?;
        Ok(Self { vertices, unit, f: Box::new(f), is_slope: false })
    }

    /// The derivative with respect to the arc length, in the order of the vertices. Its norms return
    /// [`Error::InfiniteNorm`] if the function jumps.
    pub(crate) fn derivative(&self) -> CurveFormula<'_> {
        CurveFormula {
            vertices: self.vertices.clone(),
            unit: self.unit,
            f: Box::new(|x| (self.f)(x)),
            is_slope: true,
        }
    }

    /// The seminorm |u|_ν, 0 < ν < 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a value that is not finite; [`Error::InfiniteNorm`]; [`Error::ToleranceNotMet`] with
    /// the best value if the rules do not converge: for kinks inside a side, or strong singularities at vertices
    /// where x is rounded.
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let ([seminorm, _], why) = self.settle(order, tolerance, [1.0, 0.0])?;
        accept("seminorm", seminorm, tolerance, why)
    }

    /// The norm ‖u‖_ν, 0 < ν < 1.
    ///
    /// # Errors
    /// As [`CurveFormula::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let (parts, why) = self.settle(order, tolerance, [1.0, 1.0])?;
        accept("norm", root_of_squares(&parts)?, tolerance, why)
    }

    /// The L² norm ‖u‖.
    ///
    /// # Errors
    /// As [`CurveFormula::seminorm`].
    pub(crate) fn l2_norm(&self, tolerance: Tolerance) -> Result<Estimate> {
        let ([_, norm], why) = self.settle(None, tolerance, [0.0, 1.0])?;
        accept("norm", norm, tolerance, why)
    }

    /// Seminorm (0 without an order) and L² norm, refined until the weighted sum of their squares meets the
    /// tolerance; otherwise the most accurate pair. With what limits their accuracy.
    fn settle(
        &self,
        order: impl Into<Option<Order>>,
        tolerance: Tolerance,
        weights: [f64; 2],
    ) -> Result<([Estimate; 2], &'static str)> {
        let order = order.into();
        let kernel = order.map(PowerKernel::new);
        let one_minus = kernel.as_ref().map_or(1.0, |kernel| kernel.one_minus);
        let per_length = if self.is_slope { self.unit.recip() } else { 1.0 };
        let units =
            [self.unit.powf(0.5 * one_minus), self.unit.sqrt()].map(|unit| unit * per_length);
        let (mut work, mut squared, mut unit) = (Work::default(), Vec::new(), None);
        let mut found: Vec<[Estimate; 2]> = Vec::new();
        let mut why = LIMIT;
        for (n, layers) in STEPS {
            let squares = self.squares(kernel.as_ref(), n, layers, tolerance.work())?;
            work.points += squares.points;
            let rounding =
                0.5 * squares.rounding / squares.seminorm.max(f64::MIN_POSITIVE) + ENTRY_ROUNDING;
            let roots = [squares.seminorm.sqrt(), squares.l2.sqrt()];
            let share = squares.size / *unit.get_or_insert(squares.size);
            let watched = if order.is_some() { squares.seminorm } else { squares.l2 };
            squared.push(watched * share * share);
            let l2_rounding = if self.is_slope {
                0.5 * squares.l2_rounding / squares.l2.max(f64::MIN_POSITIVE) + ENTRY_ROUNDING
            } else {
                rounding
            };
            let mut now = [0.0; 2].map(|_| Estimate { value: 0.0, error: 0.0, work });
            for k in 0..2 {
                let value = squares.size * units[k] * roots[k];
                let floor = [rounding, l2_rounding][k] * value;
                let steps: Vec<f64> =
                    found.iter().map(|before| before[k].value).chain([value]).collect();
                now[k] = Estimate::new(value, distance_to_limit(&steps, floor) + floor, work)?;
            }
            found.push(now);
            if relative(&now, weights) <= tolerance.relative() {
                return Ok((now, LIMIT));
            }
            if work.points > tolerance.work() && found.len() < STEPS.len() {
                why = SPENT;
                break;
            }
        }
        // Noise of values grows with the layers, noise of derivatives does not.
        let grows = if self.is_slope { 1 } else { 3 };
        if (order.is_some() || self.is_slope) && diverges(&squared, grows) {
            return Err(Error::InfiniteNorm {
                order: order.map_or(0.0, Order::value),
                why: ENDLESS,
            });
        }
        // Two steps may agree by accident: the later ones count.
        let last = found.len().saturating_sub(1);
        for early in 0..last {
            let later = found[early + 1..].to_vec();
            for (k, part) in found[early].iter_mut().enumerate() {
                part.error = later
                    .iter()
                    .map(|after| (after[k].value - part.value).abs())
                    .fold(part.error, f64::max);
            }
        }
        let best =
            found.iter().min_by(|a, b| relative(a, weights).total_cmp(&relative(b, weights)));
        let nothing = [Estimate::new(0.0, 0.0, work)?; 2];
        Ok((best.map_or(nothing, |best| best.map(|part| Estimate { work, ..part })), why))
    }

    /// The mesh with this many layers at every vertex, or fewer if the elements reach the rounding of the
    /// coordinates.
    fn graded(&self, layers: usize) -> Result<(Curve, Vec<End>)> {
        let count = self.vertices.len();
        let plain = Curve::closed(&self.vertices, &vec![Mesh::uniform(1, 1.0)?; count])?;
        let (mut meshes, mut ends) = (Vec::with_capacity(count), Vec::new());
        for side in 0..count {
            let (half, blurs) = (0.5 * plain.element_length(side), plain.blurs(side));
            let resolved = blurs
                .map(|blur| ((blur / half).ln() / RATIO.ln()).max(1.0).min(layers as f64) as usize);
            let (resolved, digits) = if self.is_slope {
                let digits = [0, 1].map(|end| {
                    resolved[end].min(self.layers_with_digits(&plain, side, end, layers))
                });
                ([layers; 2], digits)
            } else {
                (resolved, resolved)
            };
            let [first, last] = resolved.map(|layers| Mesh::geometric(layers, RATIO, half));
            let mut lengths = first?.lengths().to_vec();
            lengths.extend(last?.lengths().iter().rev());
            // Element j from the vertex reaches to 0.3^{layers − j} of half a side.
            let end = |k: usize| {
                let (end, j) = match k.checked_sub(resolved[0] + 1) {
                    None => (0, k),
                    Some(k) => (1, resolved[1] - k),
                };
                let digits = digits[end];
                let is_last = digits < resolved[end] && j + digits <= resolved[end];
                let length = half * RATIO.powi(digits as i32);
                End {
                    blur: if end == 0 { blurs[0] } else { -blurs[1] },
                    is_cut: j == 0 && resolved[end] < layers,
                    at_vertex: j == 0,
                    last: is_last.then_some(Last { side, end, length }),
                }
            };
            ends.extend((0..lengths.len()).map(end));
            meshes.push(Mesh::from_lengths(&lengths)?);
        }
        Ok((Curve::closed(&self.vertices, &meshes)?, ends))
    }

    /// f at a distance from the first or the last vertex of a side.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    fn near(&self, curve: &Curve, side: usize, end: usize, distance: f64) -> Result<f64> {
        let value =
            (self.f)(curve.point(curve.place_near(side, end, distance)).map(|x| self.unit * x));
        require_finite_at("value of the function", side, value)?;
        Ok(value)
    }

    /// The number of layers at an end of a side between which the differences of u have digits.
    fn layers_with_digits(&self, plain: &Curve, side: usize, end: usize, most: usize) -> usize {
        let half = 0.5 * plain.element_length(side);
        // Where rounding makes a point the vertex the function may have no value: then there are no digits.
        let at = |layer: usize| {
            self.near(plain, side, end, half * RATIO.powi(layer as i32)).unwrap_or(f64::NAN)
        };
        let (mut before, mut failed) = (at(0), 0);
        for layer in 1..=most {
            let value = at(layer);
            let counts = (value - before).abs() >= DIGITS * value.abs().max(before.abs());
            failed = if counts && value != before { 0 } else { failed + 1 };
            if failed == 2 {
                return (layer - 1).max(1);
            }
            before = value;
        }
        most
    }

    fn squares(
        &self,
        kernel: Option<&PowerKernel>,
        n: usize,
        layers: usize,
        most: u64,
    ) -> Result<Squares> {
        let (curve, ends) = self.graded(layers)?;
        let rule = Rule::gauss_legendre(n)?;
        let value =
            |e: usize, t: f64| (self.f)(curve.point(curve.place(e, t)).map(|x| self.unit * x));
        let sampled = |rule: &Rule| -> Result<Vec<Vec<f64>>> {
            let at_points = |e: usize| -> Vec<f64> {
                let h = curve.element_length(e);
                rule.iter().map(|(s, _)| value(e, s * h)).collect()
            };
            let values: Vec<Vec<f64>> = parallel::map(curve.len(), &at_points);
            let flat = values.iter().flatten().enumerate();
            match flat.clone().find(|(_, v)| !v.is_finite()) {
                Some((index, &value)) => {
                    Err(Error::NotFinite { name: "value of the function", index, value })
                }
                None => Ok(values),
            }
        };
        let fine = Rule::gauss_legendre(2 * n)?;
        let slopes = if self.is_slope {
            let near =
                |Last { side, end, length }: Last, s: f64| self.near(&curve, side, end, s * length);
            Some(Slopes::new(&curve, &ends, [&rule, &fine], &sampled(&fine)?, &near)?)
        } else {
            None
        };
        let mut values = match &slopes {
            Some(slopes) => slopes.at(&rule),
            None => sampled(&rule)?,
        };
        let size = unit_of(values.iter().flatten());
        values.iter_mut().flatten().for_each(|v| *v /= size);
        let square = |e: usize| {
            let squares = rule.iter().zip(&values[e]).map(|((_, w), v)| w * v * v);
            curve.element_length(e) * squares.sum::<f64>()
        };
        let l2: f64 = (0..curve.len()).map(square).sum();
        let mut l2_rounding = 0.0;
        if let Some(slopes) = &slopes {
            let largest = |e: usize| values[e].iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            let of = |(e, noise): (usize, &f64)| {
                let noise = noise / size;
                curve.element_length(e) * noise * (2.0 * largest(e) + noise)
            };
            l2_rounding = slopes.noise.iter().enumerate().map(of).sum();
            let whole = size * l2.sqrt();
            let is_jump = |left: f64, right: f64, apart: f64| {
                let rounding = ROUNDED * f64::EPSILON * left.abs().max(right.abs());
                (left - right).abs() > JUMP * (whole * apart.sqrt() + rounding)
            };
            let sides = self.vertices.len();
            let at_vertex = |side: usize| -> Result<bool> {
                let next = (side + 1) % sides;
                let reach = |side: usize, end: usize| {
                    (BESIDE * curve.side_length(side)).max(ROUNDED * curve.blurs(side)[end])
                };
                let apart = [reach(side, 1), reach(next, 0)];
                let left = self.near(&curve, side, 1, apart[0])?;
                let right = self.near(&curve, next, 0, apart[1])?;
                Ok(is_jump(left, right, apart[0] + apart[1]))
            };
            let in_middle = |side: usize| -> Result<bool> {
                let (half, blurs) = (0.5 * curve.side_length(side), curve.blurs(side));
                let apart = (BESIDE * half).max(ROUNDED * blurs[0].max(blurs[1]));
                let left = self.near(&curve, side, 0, half - apart)?;
                let right = self.near(&curve, side, 1, half - apart)?;
                Ok(is_jump(left, right, 2.0 * apart))
            };
            for side in 0..sides {
                if at_vertex(side)? || in_middle(side)? {
                    let order = kernel.map_or(0.0, |kernel| 0.5 * kernel.twice);
                    return Err(Error::InfiniteNorm { order, why: JUMPS });
                }
            }
        }
        let first = values[0][0];
        let is_constant = values.iter().flatten().all(|v| *v == first);
        let Some(kernel) = kernel.filter(|_| !is_constant) else {
            let points = (n * curve.len()) as u64;
            return Ok(Squares { seminorm: 0.0, rounding: 0.0, l2, l2_rounding, size, points });
        };
        // The largest change of the values by the rounding of coordinates, on the half of a side that begins or ends here.
        let noise = |e: usize| {
            let End { blur, .. } = ends[e];
            if blur == 0.0 {
                return 0.0;
            }
            let change = |((s, _), before): ((f64, f64), &f64)| {
                let moved = value(e, s * curve.element_length(e) + blur) / size - before;
                if moved.is_finite() { moved.abs() } else { 1.0 }
            };
            rule.iter().zip(&values[e]).map(change).fold(0.0, f64::max)
        };
        let noise: Vec<f64> = match &slopes {
            Some(slopes) => slopes.noise.iter().map(|noise| noise / size).collect(),
            None => parallel::map(curve.len(), &noise),
        };
        // u away from vertices by interpolation in 2n Gauss points of the element, few values of a function that may be slow
        let samples = |e: usize| -> Vec<f64> {
            let h = curve.element_length(e);
            match &slopes {
                Some(slopes) => slopes.values[e].iter().map(|v| v / size).collect(),
                None if ends[e].at_vertex => Vec::new(),
                None => fine.iter().map(|(s, _)| value(e, s * h) / size).collect(),
            }
        };
        let samples: Vec<Vec<f64>> = parallel::map(curve.len(), &samples);
        let weights = barycentric_weights(&fine);
        let interpolated = |e: usize, t: f64| {
            if samples[e].is_empty() {
                return value(e, t) / size;
            }
            interpolate(&fine, &weights, &samples[e], t / curve.element_length(e))
        };
        let pairs = Pairs {
            curve: &curve,
            kernel,
            value: &interpolated,
            values: &values,
            noise: &noise,
            ends: &ends,
            rule: rule.clone(),
            own: Rule::power_weight(2 * n, kernel.two_minus)?,
            radial: Rule::power_weight(2 * n, kernel.three_minus)?,
            budget: Budget::new(most, 0.0),
        };
        let sum = (0..curve.len())
            .into_par_iter()
            .map(|e| pairs.row(e))
            .reduce(PairSum::default, |a, b| a + b);
        let (seminorm, rounding, points) = (sum.value, sum.rounding, sum.points);
        Ok(Squares { seminorm, rounding, l2, l2_rounding, size, points })
    }
}

/// The derivative of a function on every element.
struct Slopes<'a> {
    rule: &'a Rule,
    /// at the points of the rule
    values: Vec<Vec<f64>>,
    /// largest error of the values
    noise: Vec<f64>,
}

impl<'a> Slopes<'a> {
    /// The derivatives of the polynomials through the points of the second rule, from the values of the function there, or
    /// on the last elements at a vertex of one polynomial through `near(last, s)`, s in units of their length, which is
    /// compared with the one through the points of the first rule.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a value of `near`.
    fn new(
        curve: &Curve,
        ends: &[End],
        [coarse, rule]: [&'a Rule; 2],
        of: &[Vec<f64>],
        near: &dyn Fn(Last, f64) -> Result<f64>,
    ) -> Result<Self> {
        let weights = barycentric_weights(rule);
        let steep = 2.0 * (rule.points().len() as f64).powi(2);
        let largest = |all: &[f64]| all.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        // The derivative of a polynomial through values u on a length h, and its rounding error.
        let slopes_of = |u: &[f64], h: f64, blur: f64| {
            let slopes: Vec<f64> =
                differentiate(rule, &weights, u).iter().map(|slope| slope / h).collect();
            let moved = largest(&slopes) * blur.abs();
            let off = (4.0 * f64::EPSILON * largest(u) + moved) * steep / h;
            (slopes, if largest(u) == 0.0 { 0.0 } else { off })
        };
        let (mut values, mut noise) = (Vec::with_capacity(of.len()), Vec::with_capacity(of.len()));
        let mut kept: Vec<Option<(Vec<f64>, f64)>> = vec![None; 2 * of.len()];
        for (e, u) in of.iter().enumerate() {
            let h = curve.element_length(e);
            let Some(last) = ends[e].last else {
                let (slopes, off) = slopes_of(u, h, ends[e].blur);
                values.push(slopes);
                noise.push(off);
                continue;
            };
            let one_polynomial = || -> Result<(Vec<f64>, f64)> {
                let at = |rule: &Rule| -> Result<Vec<f64>> {
                    rule.points().iter().map(|s| near(last, *s)).collect()
                };
                let (mut slopes, off) = slopes_of(&at(rule)?, last.length, ends[e].blur);
                let other = barycentric_weights(coarse);
                let fewer = differentiate(coarse, &other, &at(coarse)?);
                let apart = rule.points().iter().zip(&slopes).map(|(s, slope)| {
                    (interpolate(coarse, &other, &fewer, *s) / last.length - slope).abs()
                });
                let off = off + BELOW * apart.fold(0.0, f64::max);
                if last.end == 1 {
                    slopes.iter_mut().for_each(|slope| *slope = -*slope);
                }
                Ok((slopes, off))
            };
            let kept = &mut kept[2 * last.side + last.end];
            let (polynomial, off) = match kept {
                Some(found) => found,
                None => kept.insert(one_polynomial()?),
            };
            let at = |s: &f64| {
                let distance = Curve::distance_to_vertex(curve.place(e, s * h), last.end);
                interpolate(rule, &weights, polynomial, distance / last.length)
            };
            values.push(rule.points().iter().map(at).collect());
            noise.push(*off);
        }
        Ok(Self { rule, values, noise })
    }

    /// The values at the points of another rule.
    fn at(&self, rule: &Rule) -> Vec<Vec<f64>> {
        let weights = barycentric_weights(self.rule);
        let of = |values: &Vec<f64>| {
            rule.points().iter().map(|s| interpolate(self.rule, &weights, values, *s)).collect()
        };
        self.values.iter().map(of).collect()
    }
}

/// The barycentric weights of the points of a Gauss rule.
fn barycentric_weights(rule: &Rule) -> Vec<f64> {
    let signs = [1.0, -1.0].into_iter().cycle();
    rule.iter().zip(signs).map(|((s, w), sign)| sign * (s * (1.0 - s) * w).sqrt()).collect()
}

/// The value at s of the polynomial through the values at the points of a rule.
fn interpolate(rule: &Rule, weights: &[f64], values: &[f64], s: f64) -> f64 {
    let [mut above, mut below] = [0.0; 2];
    for ((x, weight), value) in rule.points().iter().zip(weights).zip(values) {
        if s == *x {
            return *value;
        }
        let share = weight / (s - x);
        above += share * value;
        below += share;
    }
    above / below
}

/// The derivative at the points of a rule of the polynomial through values there.
fn differentiate(rule: &Rule, weights: &[f64], values: &[f64]) -> Vec<f64> {
    let points = rule.points();
    let at = |i: usize| -> f64 {
        let others = (0..points.len()).filter(|&j| j != i);
        let term =
            |j: usize| weights[j] / weights[i] * (values[j] - values[i]) / (points[i] - points[j]);
        others.map(term).sum()
    };
    (0..points.len()).map(at).collect()
}

/// The sum over pairs of elements.
struct Pairs<'a> {
    curve: &'a Curve,
    kernel: &'a PowerKernel,
    value: &'a (dyn Fn(usize, f64) -> f64 + Sync),
    values: &'a [Vec<f64>],
    /// rounding error of the values on an element, from the rounding of the coordinates
    noise: &'a [f64],
    ends: &'a [End],
    rule: Rule,
    /// rules for the weights z^{1−2ν} and ξ^{2−2ν}
    own: Rule,
    radial: Rule,
    /// evaluations for subdivided elements
    budget: Budget,
}

/// Adds a term with the error `noise` of its difference, in addition to the rounding of the values.
fn add(sum: &mut PairSum, weight: f64, difference: f64, noise: f64) {
    sum.value += weight * difference * difference;
    let twice = 2.0 * (noise + 4.0 * f64::EPSILON);
    sum.rounding += weight.abs() * (difference.abs() * twice + noise * noise);
    sum.points += 1;
}

/// The relative error of the square root of the weighted sum of squares.
fn relative(found: &[Estimate; 2], weights: [f64; 2]) -> f64 {
    let largest = found.iter().fold(f64::MIN_POSITIVE, |most, part| part.value.max(most));
    let sum = |of: fn(&Estimate) -> f64| -> f64 {
        let parts = found.iter().zip(weights);
        parts.map(|(part, weight)| weight * (part.value / largest) * (of(part) / largest)).sum()
    };
    let (error, value) = (sum(|part| part.error), sum(|part| part.value));
    if error == 0.0 { 0.0 } else { error / value }
}

/// The distance of the last value from its limit: the value itself if it is the only one, the change from the
/// previous one if there are two, and the remainder of a geometric series where the changes decrease slowly.
fn distance_to_limit(values: &[f64], floor: f64) -> f64 {
    let change = |k: usize| (values[k] - values[k - 1]).abs();
    match values.len() - 1 {
        0 => values[0],
        1 => change(1),
        k if change(k) <= floor => change(k),
        k => {
            let ratio = (change(k) / change(k - 1)).min(SLOWEST);
            change(k) * (ratio / (1.0 - ratio)).max(1.0)
        }
    }
}

/// True if the increments of the squares for doubled numbers of layers at least double twice in a row: every layer
/// then contributes as much as the previous one. The first increment must exceed a share of one of the four squares, by
/// its number.
fn diverges(squares: &[f64], of: usize) -> bool {
    let &[.., a, b, c, d] = squares else { return false };
    let (first, second, third) = (b - a, c - b, d - c);
    first > GROWTH * [a, b, c, d][of] && second >= DOUBLES * first && third >= DOUBLES * second
}

impl Pairs<'_> {
    /// The sum over the pairs of element e with itself and with all later elements.
    fn row(&self, e: usize) -> PairSum {
        let mut sum = PairSum::default();
        let mut add_part = |pair: &[usize], part: PairSum| {
            let is_cut = pair.iter().any(|&k| self.ends[k].is_cut);
            let rest = if is_cut { BELOW * part.value } else { 0.0 };
            sum = sum + PairSum { rounding: part.rounding + rest, ..part };
        };
        add_part(&[e], self.same(e));
        for f in e + 1..self.curve.len() {
            if self.curve.follows(e, f) {
                add_part(&[e, f], self.touching(e, f));
            } else if self.curve.follows(f, e) {
                add_part(&[e, f], self.touching(f, e));
            } else {
                let mut part = PairSum::default();
                self.separate([e, f], self.curve.relation_of(e, f), &mut part);
                add_part(&[], part);
            }
        }
        sum
    }

    fn same(&self, e: usize) -> PairSum {
        let mut sum = PairSum::default();
        let h = self.curve.element_length(e);
        let front = 2.0 * self.kernel.scaling(h);
        for (z, v) in self.own.iter() {
            for (s, w) in self.rule.iter() {
                let t = h * (1.0 - z) * s;
                let difference = (self.value)(e, t + h * z) - (self.value)(e, t);
                add(&mut sum, front * v * w * (1.0 - z) / (z * z), difference, 2.0 * self.noise[e]);
            }
        }
        sum
    }

    /// The pair of elements e and f, where e ends at the first node of f.
    fn touching(&self, e: usize, f: usize) -> PairSum {
        let mut sum = PairSum::default();
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
                    let weight =
                        2.0 * w * length * (fixed / distance) * distance.powf(-self.kernel.twice);
                    for (xi, v) in self.radial.iter() {
                        let (sigma, tau) = if is_first {
                            (xi * fixed, xi * moved)
                        } else {
                            (xi * moved, xi * fixed)
                        };
                        let difference = (self.value)(e, p - sigma) - (self.value)(f, tau);
                        add(
                            &mut sum,
                            weight * v / (xi * xi),
                            difference,
                            self.noise[e] + self.noise[f],
                        );
                    }
                }
            });
        }
        sum
    }

    fn separate(&self, pair: [usize; 2], relation: Relation, sum: &mut PairSum) {
        let whole = pair.map(|k| (0.0, self.curve.element_length(k)));
        let may_cut = || {
            let may_cut = self.budget.left() > 0;
            self.budget.spend(OF_CUT);
            may_cut
        };
        let noise = self.noise[pair[0]] + self.noise[pair[1]];
        let is_whole = split(self.curve, pair, relation, whole, &may_cut, &mut |parts, _| {
            let (p, q) = (parts[0].1, parts[1].1);
            let [us, vs] = [0, 1].map(|k| self.at_points(pair[k], parts[k]));
            let place = |k: usize, s: f64| self.curve.place(pair[k], parts[k].0 + s * parts[k].1);
            let there: Vec<_> = self.rule.iter().map(|(y, w)| (place(1, y), w)).collect();
            for ((x, v), u) in self.rule.iter().zip(us.iter()) {
                let here = place(0, x);
                for ((there, w), other) in there.iter().zip(vs.iter()) {
                    let distance = self.curve.apart(relation, here, *there);
                    let kernel = (p / distance) * q * distance.powf(-self.kernel.twice);
                    add(sum, 2.0 * v * w * kernel, u - other, noise);
                }
            }
        });
        if !is_whole {
            sum.points += Tolerance::WORK; // beyond every limit, so that no further step is tried
        }
    }

    /// The values of u at the points of the rule on a part of an element.
    fn at_points(&self, e: usize, (start, length): Part) -> Cow<'_, [f64]> {
        if length == self.curve.element_length(e) {
            return self.values[e].as_slice().into();
        }
        self.rule
            .iter()
            .map(|(s, _)| (self.value)(e, start + s * length))
            .collect::<Vec<_>>()
            .into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_derivative_needs_finite_values_at_the_points_of_either_rule() {
        // The polynomial that serves the last layers at (0, 0) is compared with that through 8 points.
        let length = 0.5 * RATIO.powi(8);
        let place = length * Rule::gauss_legendre(8).unwrap().points()[3];
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let u = CurveFormula::new(&square, |[x, y]| {
            if y == 0.0 && (x / place - 1.0).abs() < 1e-9 { f64::NAN } else { 1.0 + x * x }
        });
        let found = u.unwrap().derivative().l2_norm(Tolerance::new(0.1).unwrap());
        assert!(matches!(found, Err(Error::NotFinite { .. })), "{found:?}");
    }
}
