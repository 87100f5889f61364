//! Dual norms of functions with declared breakpoints: the dual norm of a piecewise polynomial approximation,
//! and a bound of the remainder.
//!
//! Every half of an interval between breakpoints (a side, of length R) is cut at the distances R/2^k from its
//! breakpoint, and f is interpolated by a polynomial of degree p at Gauss points on each piece: if the piece
//! is no longer than its distance from a singularity at the breakpoint, the difference decreases like (3 +
//! √8)^{-p}. In all three norms ||v|| ≥ ∥v∥_0, so that the dual norm of the difference is at most its L²
//! norm. This is integrated at other points; on the last piece it is integrated layer by layer as far as f
//! can be evaluated, and continued by a geometric series. Where one polynomial is not sufficient, pieces are cut at
//! the cells that all norms of f have in common ([`Look`]).

use super::functional::DualOf;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance};
use crate::functions::{Arm, Look, Normalized, SingularFunction, Units};
use crate::mesh::Mesh;
use crate::numeric::legendre;
use crate::order::Order;
use crate::piecewise::{PiecewisePolynomial, bubbles_of};
use crate::quadrature::Rule;

/// Successive degrees, until the difference is small enough.
const DEGREES: [usize; 3] = [6, 12, 18];
/// Number of layers of the last piece that are evaluated.
const LOOKED_AT: usize = 24;

/// A piecewise polynomial and the square of the L² norm of the remainder.
#[derive(Default)]
pub(crate) struct Interpolant {
    lengths: Vec<f64>,
    ends: Vec<[f64; 2]>,
    bubbles: Vec<Vec<f64>>,
    left: f64,
}

impl SingularFunction<'_> {
    /// The dual norm sup ∫ u v / ||v|| of the functional v ↦ ∫ u v, as [`PiecewisePolynomial::dual_norm`]; the
    /// norm of v is that of [`SingularFunction::norm`] for (1.1).
    ///
    /// The function is replaced by a piecewise polynomial on a mesh graded towards its breakpoints; the L² norm
    /// of the difference bounds the dual norm of the difference and is part of the error. Functions of
    /// [`SingularFunction::from_positions`] are evaluated accurately at singularities; those of
    /// [`SingularFunction::new`] are not. Cost: some dozens of pieces per breakpoint, and the dual norm of the
    /// piecewise polynomial.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] with the best value; [`Error::NotFinite`] if a value of the function is not
    /// finite.
    pub(crate) fn dual_norm(
        &self,
        of: DualOf,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let Normalized { units: Units { length, size: scale }, u: unit } =
            self.normalized(tolerance)?;
        let size =
            Estimate::or_best(unit.l2_norm(Tolerance::fast().with_work(tolerance.work())))?.value;
        let inner =
            Tolerance::new((0.5 * tolerance.relative()).max(1e-15))?.with_work(tolerance.work());
        let look = unit.looked(tolerance)?;
        let mut best: Option<Estimate> = None;
        for degree in DEGREES {
            // A dual norm much smaller than the L² norm needs more of its digits.
            let small = best.map_or(f64::INFINITY, |best| 0.1 * tolerance.relative() * best.value);
            let small = small / length.sqrt();
            let goal = (1e-4 * tolerance.relative() * size).min(small);
            let mut pieces = Interpolant::default();
            for arm in unit.arms() {
                match pieces.add(&unit, &arm, &look, degree, goal * goal) {
                    Err(_) if best.is_some() && unit.work_left() == 0 => {
                        let best = best.map(|best| best.times(scale)).transpose()?;
                        return Err(Error::best_of("dual norm", tolerance.relative(), best, SPENT));
                    }
                    other => other?,
                }
            }
            let (u, left) = pieces.finish(length)?;
            let found = Estimate::or_best(u.dual_norm(of, order, inner))?;
            let found = Estimate::new(found.value, found.error + left, found.work)?;
            if found.relative_error() <= tolerance.relative() || found.value == 0.0 {
                return found.times(scale);
            }
            // What is left no longer falls, or is not what limits.
            let stuck = best.is_some_and(|best| found.error > 0.5 * best.error);
            if best.is_none_or(|best| found.error < best.error) {
                best = Some(found);
            }
            if stuck {
                break;
            }
        }
        let best = best.map(|best| best.times(scale)).transpose()?;
        let why = "the error of the piecewise polynomial approximation or of its dual norm exceeds the tolerance";
        Err(Error::best_of("dual norm", tolerance.relative(), best, why))
    }
}

impl Interpolant {
    /// The polynomial and the L² norm of the remainder, on an interval multiplied by `unit`.
    pub(crate) fn finish(self, unit: f64) -> Result<(PiecewisePolynomial, f64)> {
        let partition = Mesh::from_lengths(
            &self.lengths.iter().map(|length| length * unit).collect::<Vec<_>>(),
        )?;
        let left = self.left.sqrt() * unit.sqrt();
        Ok((PiecewisePolynomial::with_bubbles(partition, &self.ends, self.bubbles)?, left))
    }

    /// Adds the integral of the squared remainder on a piece.
    pub(crate) fn leave(&mut self, square: f64) {
        self.left += square;
    }

    /// Appends a side, from left to right.
    pub(crate) fn add(
        &mut self,
        u: &SingularFunction,
        arm: &Arm,
        look: &Look,
        degree: usize,
        goal: f64,
    ) -> Result<()> {
        let radius = |k: usize| arm.length * 0.5f64.powi(k as i32);
        let deepest = ((arm.depth / std::f64::consts::LN_2) as usize).max(2) - 1;
        let middles = u.middles(arm);
        let middle = |k: usize| match middles.get(k) {
            Some(value) => Ok(*value),
            None => u.evaluated(arm, 0.75 * radius(k)),
        };
        // Until no layer below varies by more than counts: all of them are looked at, down to the smallest distance.
        let mut layers = 1;
        let mut before = middle(1)?;
        for k in 1..deepest {
            let Ok(value) = middle(k + 1) else { break };
            let variation = value - before;
            if radius(k) * variation * variation > goal {
                layers = k + 1;
            }
            before = value;
        }
        let nearest = look.nearest(arm.anchor, arm.sign > 0.0);
        while layers + 1 < deepest && radius(layers) > nearest {
            layers += 1;
        }
        layers = (layers + 2).min(deepest);
        let mut cells: Vec<[f64; 2]> = Vec::with_capacity(layers + 1);
        for k in 0..layers {
            let (near, mut far) = (radius(k + 1), radius(k));
            for &cut in look.cuts(arm, near, far).iter().rev() {
                cells.push([cut, far]);
                far = cut;
            }
            cells.push([near, far]);
        }
        cells.push([0.0, radius(layers)]);
        if arm.sign > 0.0 {
            cells.reverse();
        }
        for [from, to] in cells {
            let length = to - from;
            let at = |t: f64| {
                u.at(arm, if arm.sign > 0.0 { from + length * t } else { to - length * t })
            };
            if from == 0.0 {
                let value = middle(layers)?;
                self.push(length, [value, value], Vec::new());
                self.left += within(arm, layers, value, &middle)?;
            } else {
                self.interpolate(length, degree, &at)?;
            }
        }
        Ok(())
    }

    pub(crate) fn push(&mut self, length: f64, ends: [f64; 2], bubbles: Vec<f64>) {
        self.lengths.push(length);
        self.ends.push(ends);
        self.bubbles.push(bubbles);
    }

    fn interpolate(
        &mut self,
        length: f64,
        degree: usize,
        f: &impl Fn(f64) -> Result<f64>,
    ) -> Result<()> {
        let mut coefficients = vec![0.0; degree + 1];
        let mut values = vec![0.0; degree + 1];
        for (t, w) in Rule::gauss_legendre(degree + 1)?.iter() {
            let value = f(t)?;
            legendre::fill(&mut values, 2.0 * t - 1.0);
            for (k, (sum, p)) in coefficients.iter_mut().zip(&values).enumerate() {
                *sum += (2 * k + 1) as f64 * w * value * p;
            }
        }
        let at = |t: f64| legendre::series(coefficients.iter().copied(), 2.0 * t - 1.0);
        let ends = [at(0.0), at(1.0)];
        for (t, w) in Rule::gauss_legendre(degree + 4)?.iter() {
            self.left += w * length * (f(t)? - at(t)).powi(2);
        }
        self.push(length, ends, bubbles_of(degree, ends, at)?);
        Ok(())
    }
}

/// ∫ (f - value)² on the last piece of a side.
fn within(
    arm: &Arm,
    layers: usize,
    value: f64,
    middle: &impl Fn(usize) -> Result<f64>,
) -> Result<f64> {
    let deepest = ((arm.depth / std::f64::consts::LN_2) as usize).max(2) - 1;
    let (mut sum, mut last, mut ratio) = (0.0, 0.0, 0.0f64);
    for k in layers..(layers + LOOKED_AT).min(deepest + 1).max(layers + 1) {
        let share = arm.length * 0.5f64.powi(k as i32 + 1) * (middle(k)? - value).powi(2);
        ratio = if last > 0.0 { share / last } else { 0.5 };
        (sum, last) = (sum + share, share);
    }
    // the rules of one point are doubled for safety
    Ok(2.0 * (sum + last * ratio / (1.0 - ratio.min(0.999))))
}
