//! ∫∫ f(x, y) |x−y|^{-1-2ν} over two elements of a polygonal curve, for f = (u(x)−u(y))², u piecewise
//! linear or piecewise constant.
//!
//! - an element with itself: 2 h^{1-2ν} / ((2−2ν)(3−2ν)) times the squared difference of its end values;
//! - neighbours of lengths p, q, on one side or across a corner, with points at the distances σ, τ from the
//!   common node: the integrand is homogeneous about it, so that over the triangles σ = ξp, τ = ξqη and
//!   σ = ξpη, τ = ξq (Duffy) the integral in ξ is 1/(3−2ν), or 1/(1−2ν) for constants, and pq times an
//!   integral in η remains. Its integrand is singular only at qη = p e^{±iω} or pη = q e^{±iω}, ω the angle;
//!   it is subdivided until no piece is longer than its distance to these points;
//! - other pairs: subdivided until no piece is longer than its distance to the other, then Gauss rules whose
//!   order depends on the ratio of length to distance.

use super::curve::{Curve, Relation};
use crate::error::Result;
use crate::kernel::power::PowerKernel;
use crate::numeric::budget::Budget;
use crate::order::Order;
use crate::quadrature::Rule;

/// Largest number of points of a rule: enough for pieces as long as their distance.
const MOST_POINTS: usize = 16;

/// Number of kernel evaluations counted for one subdivision.
pub(super) const OF_CUT: u64 = 4;
/// Message: the work limit is exceeded.
const NEEDLES: &str = "the work limit is reached: two sides without a common corner, or at a small angle, are so close to \
     each other that elements are subdivided down to their distance; grade the mesh towards that place, or raise \
     the limit with Tolerance::with_work";

/// The rules for one order.
pub(super) struct CurvePairs<'a> {
    curve: &'a Curve,
    kernel: PowerKernel,
    rules: Vec<Rule>,
    digits: f64,
    /// 3 − 2ν, or 1 − 2ν for constants
    radial: f64,
    /// kernel evaluations for subdivided elements
    budget: Budget,
}

/// A part (start, length) of an element.
pub(super) type Part = (f64, f64);

impl<'a> CurvePairs<'a> {
    /// The rules for the relative accuracy `target`, with at most this many kernel evaluations for subdivided
    /// elements.
    pub(super) fn new(
        curve: &'a Curve,
        order: Order,
        constants: bool,
        target: f64,
        most: u64,
    ) -> Result<Self> {
        let kernel = PowerKernel::new(order);
        Ok(Self {
            curve,
            kernel,
            rules: (1..=MOST_POINTS).map(Rule::gauss_legendre).collect::<Result<_>>()?,
            digits: (1.0 - target.log10()).clamp(3.0, 17.0),
            radial: if constants { kernel.one_minus } else { kernel.three_minus },
            budget: Budget::new(most, target),
        })
    }

    /// Checks that all pairs were visited.
    ///
    /// # Errors
    /// [`ToleranceNotMet`](crate::Error::ToleranceNotMet) if not all pairs were visited.
    pub(super) fn require_all(&self) -> Result<()> {
        if self.budget.left() > 0 {
            Ok(())
        } else {
            Err(self.budget.spent("norm on a curve", NEEDLES))
        }
    }

    /// The form of one element of length h for a linear function whose end values differ by one.
    pub(super) fn own(&self, h: f64) -> f64 {
        self.kernel.own(h)
    }

    /// Calls `visit` with (w, s, t), s and t local coordinates on e ≠ f; w counts both orders of x and y.
    pub(super) fn visit(&self, e: usize, f: usize, visit: &mut impl FnMut(f64, f64, f64)) {
        if self.curve.follows(e, f) {
            self.touching(e, f, visit);
        } else if self.curve.follows(f, e) {
            self.touching(f, e, &mut |w, s, t| visit(w, t, s));
        } else {
            let lengths = [e, f].map(|k| self.curve.element_length(k));
            let relation = self.curve.relation_of(e, f);
            self.separate(
                [e, f],
                relation,
                [(0.0, lengths[0]), (0.0, lengths[1])],
                &mut |w, s, t| {
                    visit(w, s / lengths[0], t / lengths[1]);
                },
            );
        }
    }

    /// The pair of elements e and f, where e ends at the first node of f.
    fn touching(&self, e: usize, f: usize, visit: &mut impl FnMut(f64, f64, f64)) {
        let (p, q) = (self.curve.element_length(e), self.curve.element_length(f));
        let bend = match self.curve.relation_of(e, f) {
            Relation::Before(bend) => bend,
            _ => 4.0,
        };
        // cos ω = 1 − |a−b|²/2
        let cosine = 1.0 - 0.5 * bend;
        let sine = (bend * (1.0 - 0.25 * bend)).max(0.0).sqrt();
        for (fixed, moving, is_first) in [(p, q, true), (q, p, false)] {
            let singular = [fixed * cosine, fixed * sine];
            cut(0.0, moving, singular, &mut |start, length| {
                let nearest = singular[0].clamp(start, start + length);
                let rule = self.rule(length / (singular[0] - nearest).hypot(singular[1]));
                for (x, w) in rule.iter() {
                    let moved = start + length * x;
                    let distance = (fixed - moved).hypot((fixed * moved * bend).sqrt());
                    let weight =
                        2.0 * w * length * (fixed / distance) * distance.powf(-self.kernel.twice)
                            / self.radial;
                    let share = moved / moving;
                    if is_first {
                        visit(weight, 0.0, share)
                    } else {
                        visit(weight, 1.0 - share, 1.0)
                    }
                }
            });
        }
    }

    fn separate(
        &self,
        pair: [usize; 2],
        relation: Relation,
        parts: [Part; 2],
        visit: &mut impl FnMut(f64, f64, f64),
    ) {
        split(
            self.curve,
            pair,
            relation,
            parts,
            &|| self.budget.spend(OF_CUT),
            &mut |parts, gap| {
                let (p, q) = (parts[0].1, parts[1].1);
                let (first, second) = (self.rule(p / gap), self.rule(q / gap));
                let is_cut =
                    [0, 1].iter().any(|&k| parts[k].1 < self.curve.element_length(pair[k]));
                if is_cut
                    && !self.budget.spend((first.points().len() * second.points().len()) as u64)
                {
                    return;
                }
                for (x, v) in first.iter() {
                    let s = parts[0].0 + p * x;
                    let here = self.curve.place(pair[0], s);
                    for (y, w) in second.iter() {
                        let t = parts[1].0 + q * y;
                        let distance =
                            self.curve.apart(relation, here, self.curve.place(pair[1], t));
                        let kernel = (p / distance) * q * distance.powf(-self.kernel.twice);
                        visit(2.0 * v * w * kernel, s, t);
                    }
                }
            },
        );
    }

    /// The rule for pieces with this ratio of length to distance: error ρ^{-2n} with ρ = 2/r + √(1 + 4/r²), and
    /// one more point for the linear functions.
    fn rule(&self, ratio: f64) -> &Rule {
        let z = 2.0 / ratio.max(1e-8);
        let rho = z + z.hypot(1.0);
        let points = (self.digits / (2.0 * rho.log10())).ceil() as usize + 1;
        &self.rules[points.min(MOST_POINTS) - 1]
    }
}

/// Parts of two elements no longer than the distance between them, with that distance: the longer part is bisected
/// as long as `may_cut` allows; false if it did not.
pub(super) fn split(
    curve: &Curve,
    pair: [usize; 2],
    relation: Relation,
    parts: [Part; 2],
    may_cut: &impl Fn() -> bool,
    with: &mut impl FnMut([Part; 2], f64),
) -> bool {
    let middle = |k: usize| curve.place(pair[k], parts[k].0 + 0.5 * parts[k].1);
    let (p, q) = (parts[0].1, parts[1].1);
    let gap = curve.apart(relation, middle(0), middle(1)) - 0.5 * (p + q);
    if p.max(q) <= 1.0001 * gap {
        with(parts, gap);
        return true;
    }
    if !may_cut() {
        return false;
    }
    let longer = usize::from(q > p);
    let (start, half) = (parts[longer].0, 0.5 * parts[longer].1);
    [start, start + half].into_iter().fold(true, |is_whole, start| {
        let mut parts = parts;
        parts[longer] = (start, half);
        split(curve, pair, relation, parts, may_cut, with) && is_whole
    })
}

/// Pieces no longer than their distance to a point of the plane.
pub(super) fn cut(start: f64, length: f64, singular: [f64; 2], with: &mut impl FnMut(f64, f64)) {
    let nearest = singular[0].clamp(start, start + length);
    if length <= (singular[0] - nearest).hypot(singular[1]) {
        with(start, length);
    } else {
        let half = 0.5 * length;
        cut(start, half, singular, with);
        cut(start + half, half, singular, with);
    }
}
