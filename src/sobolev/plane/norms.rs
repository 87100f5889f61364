//! Norms of order s and 1 + s of piecewise constants and linears in the plane.
//!
//! |w|²_s = ∫∫ (w(x)−w(y))² / |x−y|^{2+2s},  ||w||²_s = ||w||² + |w|²_s,  ||w||²_{1+s} = ||w||² + ||∇w||² + |∂₁w|²_s
//! + |∂₂w|²_s.
//!
//! The sum over all pairs of triangles of |T||T'| m(T, T'), m the mean of [`super::means`]. Piecewise constants have
//! a finite seminorm for s < 1/2 only, and so do gradients of piecewise linears. Every integral is computed by three
//! rules: the second gives the value, the third and the first judge it. Limits: (1−s)|w|²_s → (π/2)||∇w||² as s → 1; s|w|²_s stays below π ||w||² times a constant as
//! s → 0, and |w|_s itself has a limit on a bounded set. |w(·/l)|_s = l^{1−s}|w|_s. Cost O(N²) integrals for N
//! triangles.

use super::function::PlaneFunction;
use super::leaves::{LEVELS, Levels};
use super::means::{Means, Shape};
use super::simplex::{Corner, Simplex};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::scale::{power_of_two, unit_of};
use crate::numeric::sum::{RunningSum, compensated};
use crate::sobolev::order::FractionalOrder;
use crate::sobolev::root::{ENTRY_ROUNDING, accept, root_of_squares, scaled, scaled_root};
use rayon::prelude::*;

/// How often the accuracy of every integral is raised.
const ATTEMPTS: usize = 3;
/// By how much.
const SHARPER: f64 = 0.01;
/// What is off over its change by the next rule, which is off less.
const SAFETY: f64 = 3.0;
/// A change is not believed below this part of the one before.
const LEAST_CHANGE: f64 = 0.05;

impl PlaneFunction {
    /// The seminorm |w|_s.
    ///
    /// ```
    /// use signorini::sobolev::{FractionalOrder, PlaneFunction, Triangles};
    /// use signorini::Tolerance;
    /// let triangle = Triangles::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], vec![[0, 1, 2]])?;
    /// let x = PlaneFunction::linears(triangle, vec![0.0, 1.0, 0.0])?;
    /// let norm = x.seminorm(FractionalOrder::HALF, Tolerance::reference())?;
    /// assert!((norm.value.powi(2) - 0.501_532_942_386_591_2).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for a function that jumps and s ≥ 1/2; [`Error::OutOfRange`] for triangles that touch
    /// without a common node or are too close for their length; [`Error::ToleranceNotMet`].
    pub fn seminorm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        accept("seminorm", self.seminorm_as_it_is(order, tolerance)?, tolerance)
    }

    /// The norm of order s.
    ///
    /// # Errors
    /// As [`PlaneFunction::seminorm`].
    pub fn norm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        let parts = [self.seminorm_as_it_is(order, tolerance)?, self.l2_norm()?];
        accept("norm", root_of_squares(&parts)?, tolerance)
    }

    /// The norm of order 1 + s, s < 1/2, of a continuous piecewise linear function.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for s ≥ 1/2 unless the gradient is constant, and for a function that jumps; as
    /// [`PlaneFunction::seminorm`].
    pub fn norm_with_gradient(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        if self.is_piecewise_constant() && !self.is_constant() {
            let why = "a function that jumps has no gradient in L^2";
            return Err(Error::InfiniteNorm { order: 1.0 + order.value(), why });
        }
        let mut parts = vec![self.l2_norm()?];
        for part in self.gradient()? {
            parts.push(part.l2_norm()?);
            parts.push(part.seminorm_as_it_is(order, tolerance)?);
        }
        accept("norm", root_of_squares(&parts)?, tolerance)
    }

    /// The L² norm, exact to rounding: on a triangle the mean of w² is (Σ w_i² + (Σ w_i)²)/12.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn l2_norm(&self) -> Result<Estimate> {
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

    /// |w|_s with whatever error it has; computed in units of the size of the polygon and of the values.
    fn seminorm_as_it_is(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        if self.is_constant() {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        if self.shape() == Shape::Constants && !order.is_below_half() {
            let why = "a function that jumps across an edge is not in H^s for s >= 1/2";
            return Err(Error::InfiniteNorm { order: order.value(), why });
        }
        let (unit, extent) = (unit_of(self.values()), power_of_two(self.mesh().extent()));
        let root = scaled_root(unit, self.squared(order, tolerance, unit, extent)?)?;
        scaled(extent.powf(order.complement()), root)
    }

    /// |w|²_s of w over a unit on the polygon over its extent.
    fn squared(
        &self,
        order: FractionalOrder,
        tolerance: Tolerance,
        unit: f64,
        extent: f64,
    ) -> Result<Estimate> {
        let mut accuracy = tolerance.relative().max(ENTRY_ROUNDING);
        let (mut best, mut work) = (None::<Estimate>, Work::default());
        for _ in 0..ATTEMPTS {
            let found = self.all_pairs(&Means::new(order, self.shape(), accuracy), unit, extent)?;
            work += found.work;
            let is_better = best.is_none_or(|best| found.error < best.error);
            best = if is_better { Some(found) } else { best };
            // The root halves the relative error.
            if best
                .is_some_and(|best| best.relative_error() <= 2.0 * tolerance.relative().max(ENTRY_ROUNDING))
            {
                break;
            }
            accuracy *= SHARPER;
        }
        let best = best.ok_or(Error::ToleranceNotMet {
            what: "seminorm",
            asked: tolerance.relative(),
            reached: f64::INFINITY,
        })?;
        Estimate::new(best.value, best.error, work)
    }

    fn all_pairs(&self, means: &Means, unit: f64, extent: f64) -> Result<Estimate> {
        let count = self.mesh().triangles().len();
        let simplices: Vec<Simplex<1>> = (0..count).map(|t| self.simplex(t, unit, extent)).collect();
        let areas: Vec<f64> = self.mesh().areas().iter().map(|area| area / extent / extent).collect();
        let row = |i: usize| -> Result<([f64; LEVELS], Work)> {
            let (mut sums, mut work) = ([RunningSum::default(); LEVELS], Work::default());
            for j in i..count {
                let twice = if i == j { 1.0 } else { 2.0 };
                if self.shape() == Shape::Constants && self.values()[i] == self.values()[j] {
                    continue;
                }
                let weight = [twice * areas[i], areas[j]];
                let mean: Levels<1> = means.mean(&simplices[i], &simplices[j], weight, &mut work.points)?;
                work.pairs += 1;
                sums.iter_mut().zip(mean).for_each(|(sum, [[part]])| sum.add(part));
            }
            Ok((sums.map(|sum| sum.value()), work))
        };
        let rows = (0..count).into_par_iter().map(row).collect::<Result<Vec<_>>>()?;
        let sums: [f64; LEVELS] = std::array::from_fn(|k| compensated(rows.iter().map(|row| row.0[k])));
        let work = rows.iter().fold(Work::default(), |work, row| work + row.1);
        settled(sums, work)
    }

    fn simplex(&self, triangle: usize, unit: f64, extent: f64) -> Simplex<1> {
        let (nodes, places, values) =
            (self.mesh().triangles()[triangle], self.mesh().corners(triangle), self.on(triangle));
        Simplex::triangle(std::array::from_fn(|k| Corner {
            node: nodes[k],
            at: places[k].map(|x| x / extent),
            values: [values[k] / unit],
        }))
    }
}

/// The second of three sums that settle, judged by the third; a last change is not believed when it is far below the
/// one before.
fn settled(sums: [f64; LEVELS], work: Work) -> Result<Estimate> {
    let [first, value, judge] = sums;
    let (before, after) = ((value - first).abs(), (judge - value).abs());
    Estimate::new(value, SAFETY * after.max(LEAST_CHANGE * before) + ENTRY_ROUNDING * value, work)
}
