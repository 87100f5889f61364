//! Norms of order s and 1 + s of piecewise constant and piecewise linear functions in the plane.

use super::function::PlaneFunction;
use super::means::{Means, Shape};
use super::sums::PairSum;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::scale::{power_of_two, unit_of};
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use crate::root::{ENTRY_ROUNDING, accept, root_of_squares};

/// Largest number of times the accuracy of the integrals is raised.
const ATTEMPTS: usize = 3;
/// Ratio of the first accuracy of the integrals to the tolerance.
const FIRST: f64 = 0.4;
/// Factor in addition to the ratio of requested to reached accuracy, and its smallest value.
const SHARPER: f64 = 0.04;
const LEAST_SHARPER: f64 = 1e-4;
/// Default limit of kernel evaluations per triangle.
const PER_TRIANGLE: u64 = 1 << 26;
/// Message: what limits the accuracy of a sum over pairs.
const LIMIT: &str = "rounding limits the accuracy: more quadrature points do not reduce the error";

impl PlaneFunction {
    /// The seminorm |w|_s.
    ///
    /// # Method
    ///
    /// ```text
    /// |w|²_s = ∫∫ (w(x)−w(y))² / |x−y|^{2+2s},  ||w||²_s = ||w||² + |w|²_s,
    /// ||w||²_{1+s} = ||w||² + ||∇w||² + |∂₁w|²_s + |∂₂w|²_s.
    /// ```
    ///
    /// The sum over all pairs of triangles of |T||T'| m(T, T'), m the mean of `means`. Piecewise constant
    /// functions have a finite seminorm only for s < 1/2, and so do gradients of piecewise linear functions.
    /// Every integral is computed by three rules: the second gives the value, the first and the third its
    /// error. Limits: (1−s)|w|²_s → (π/2)||∇w||² as s → 1; on a polygon |w|_s converges as s → 0 to the
    /// integral with s = 0. |w(·/l)|_s = l^{1−s}|w|_s. Up to 200 triangles all pairs are integrated; for more
    /// triangles, separated clusters are compressed, and the error includes that of the compression: cost O(N
    /// log N).
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for a function with a jump and s ≥ 1/2; [`Error::OutOfRange`] for triangles that
    /// touch without a common node or whose distance is too small for their length; [`Error::ToleranceNotMet`].
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let (found, why) = self.seminorm_as_it_is(order, tolerance)?;
        accept("seminorm", found, tolerance, why)
    }

    /// The norm of order s: ||w||²_s = ||w||² + |w|²_s.
    ///
    /// # Errors
    /// As [`PlaneFunction::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let (found, why) = self.seminorm_as_it_is(order, tolerance)?;
        accept("norm", root_of_squares(&[found, self.l2_norm()?])?, tolerance, why)
    }

    /// The norm of order 1 + s, s < 1/2, of a continuous piecewise linear function, the square of which is
    /// ||w||² + ||∇w||² + |∂₁w|²_s + |∂₂w|²_s.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for s ≥ 1/2 unless the gradient is constant, and for a function that jumps; else
    /// as [`PlaneFunction::seminorm`].
    pub(crate) fn norm_with_gradient(
        &self,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        if self.is_piecewise_constant() && !self.is_constant() {
            let why = "a function that jumps has no gradient in L^2";
            return Err(Error::InfiniteNorm { order: 1.0 + order.value(), why });
        }
        let (mut parts, mut limit) = (vec![self.l2_norm()?], LIMIT);
        for part in self.gradient()? {
            let (found, why) = part.seminorm_as_it_is(order, tolerance)?;
            parts.extend([part.l2_norm()?, found]);
            limit = if why == LIMIT { limit } else { why };
        }
        accept("norm", root_of_squares(&parts)?, tolerance, limit)
    }

    /// The L² norm, exact to rounding, so that it meets every tolerance: on a triangle the mean of w² is (Σ
    /// w_i² + (Σ w_i)²)/12, w_i the values at its corners.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub(crate) fn l2_norm(&self) -> Result<Estimate> {
        let (unit, area) = (unit_of(self.values()), self.mesh().area());
        let mut sum = RunningSum::default();
        for (triangle, part) in self.mesh().areas().iter().enumerate() {
            let values = self.on(triangle).map(|value| value / unit);
            let squares: f64 = values.iter().map(|v| v * v).sum();
            sum.add(part / area * (squares + values.iter().sum::<f64>().powi(2)) / 12.0);
        }
        let value = unit * (area.sqrt() * sum.value().sqrt());
        Estimate::new(value, ENTRY_ROUNDING * value, Work::default())
    }

    fn is_constant(&self) -> bool {
        let used: Vec<f64> = (0..self.mesh().triangles().len()).flat_map(|t| self.on(t)).collect();
        used.iter().all(|value| *value == used[0])
    }

    /// |w|_s with its error, which may exceed the tolerance, and what limits it; computed in units of the size of the
    /// polygon and of the values.
    fn seminorm_as_it_is(
        &self,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<(Estimate, &'static str)> {
        if self.is_constant() {
            return Ok((Estimate::new(0.0, 0.0, Work::default())?, LIMIT));
        }
        if self.shape() == Shape::Constants && !order.is_below_half() {
            let why = "a function that jumps across an edge is not in H^s for s >= 1/2";
            return Err(Error::InfiniteNorm { order: order.value(), why });
        }
        let (unit, extent) = (unit_of(self.values()), power_of_two(self.mesh().extent()));
        let (square, why) = self.squared(order, tolerance, unit, extent)?;
        Ok((square.sqrt()?.times(unit)?.times(extent.powf(order.complement()))?, why))
    }

    /// The limit of kernel evaluations for one sum: the requested one, by default proportional to the
    /// number of triangles.
    fn allowed(&self, tolerance: Tolerance) -> u64 {
        let count = self.mesh().triangles().len() as u64;
        match tolerance.work() {
            Tolerance::WORK => Tolerance::WORK.max(count * PER_TRIANGLE),
            work => work,
        }
    }

    /// |w|²_s for w divided by `unit` on the polygon divided by `extent`, and what limits its accuracy.
    fn squared(
        &self,
        order: Order,
        tolerance: Tolerance,
        unit: f64,
        extent: f64,
    ) -> Result<(Estimate, &'static str)> {
        let sum = PairSum::new(self, unit, extent);
        let mut accuracy = FIRST * tolerance.relative().max(ENTRY_ROUNDING);
        let (mut best, mut work, mut limit) = (None::<Estimate>, Work::default(), LIMIT);
        let allowed = self.allowed(tolerance);
        for _ in 0..ATTEMPTS {
            let means = Means::new(order, self.shape(), accuracy, allowed);
            let found = match sum.squared(&means, order.value(), accuracy) {
                Err(Error::ToleranceNotMet { why, .. }) if best.is_some() => {
                    limit = why;
                    break;
                }
                other => other?,
            };
            work += found.work;
            let is_better = best.is_none_or(|best| found.error < best.error);
            best = if is_better { Some(found) } else { best };
            // The root halves the relative error.
            let goal = 2.0 * tolerance.relative().max(ENTRY_ROUNDING);
            if found.relative_error() <= goal {
                break;
            }
            accuracy *= (SHARPER * goal / found.relative_error()).max(LEAST_SHARPER);
        }
        let why = "no quadrature rule gave a finite value";
        let best =
            best.ok_or(Error::out_of_reach("seminorm", tolerance.relative(), f64::INFINITY, why))?;
        Ok((Estimate::new(best.value, best.error, work)?, limit))
    }
}
