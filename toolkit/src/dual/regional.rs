//! The dual of the norm (1.1): the supremum over piecewise linear functions on equal elements, corrected by a
//! comparison form that is known exactly and discretely.
//!
//! Let Q = ⟨f, (1 + A)^{-1} f⟩ with A of |·|²_ν, Q_h the same over the piecewise linear functions on M equal
//! elements, and R, R_h the same for the forms of [`super::comparison`], R exact and R_h by transforms. At a
//! jump of f both representers have the same singularity x^{2ν}, and near it both meshes are the same: the
//! discretisation errors of R_h and Q_h agree up to the next singularity x^{4ν} and the effect of the ends. So
//!   Q ≈ Q_h + R - R_h,
//! whose error decreases like h^{min(1+4ν, 4-2ν)} per jump (that of Q_h like h^{1+2ν}), with a small factor far
//! from the ends if R has several nodes. The jumps need not be nodes of the mesh. M is doubled; the error
//! estimate is the change at the last doubling or, if all elements of f are divided alike and three
//! successive values converge at the known rate, that of the extrapolated limit. Q_h is computed by conjugate
//! gradients with the form of R_h as preconditioner (5 to 15 steps). The mean is treated separately, because
//! it is its own representer. The rounding error of the product grows like M^{2ν} and limits the doubling.
//! Lengths are in units of the interval: 1 + A becomes L^{2ν} + A, divided by L^{2ν} (L ≤ 1), or 1 + L^{-2ν}
//! A.

use super::cells::Cells;
use super::comparison::Comparison;
use super::missed::Rough;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::kernel::power::symbol_constant;
use crate::order::Order;
use crate::piecewise::PiecewisePolynomial;

/// First and largest number of equal elements.
const FIRST: usize = 64;
const MOST: usize = 1 << 20;
/// Number of elements from which a mesh is refined only if the tolerance can be met within SPARE
/// bisections.
const LARGE: usize = 1 << 18;
const SPARE: f64 = 0.0;
/// Ratio of A to 1 on the shortest element; its square root, the share of the layers, is below rounding.
const NOTHING: f64 = 1e-40;
/// Largest relative deviation from the known factor at which the values are extrapolated.
const SAME_RATE: f64 = 0.35;

/// One mesh: Q_h + R - R_h, and whether every element of f is divided into the same number of equal elements.
#[derive(Debug, Clone, Copy)]
struct Level {
    value: f64,
    error: f64,
    alike: bool,
}

impl Rough<'_> {
    /// The factor by which the difference of two levels decreases at the next level.
    fn rate(&self) -> f64 {
        let nu = self.order.value();
        (1.0 + 4.0 * nu).min(4.0 - 2.0 * nu).exp2()
    }

    /// The limit of the last levels, and its error.
    fn limit(&self, levels: &[Level]) -> Option<(f64, f64)> {
        let [.., a, b, c] = levels else { return None };
        let (before, last) = (b.value - a.value, c.value - b.value);
        let own = c.error + b.error;
        // Where jumps lie between the nodes one difference may be small by chance.
        let plain = (c.value, (2.0 * last.abs()).max(before.abs()) + own);
        let rate = self.rate();
        if !a.alike
            || self.comparison.nodes.len() > 1
            || ((before / last) / rate - 1.0).abs() > SAME_RATE
        {
            return Some(plain);
        }
        let corrections = [before, last].map(|difference| difference / (rate - 1.0));
        let limits = [b.value + corrections[0], c.value + corrections[1]];
        let error = (limits[1] - limits[0]).abs().max(0.1 * corrections[1].abs());
        Some(if error + own < plain.1 { (limits[1], error + own) } else { plain })
    }
}

impl PiecewisePolynomial {
    pub(super) fn dual_of_regional(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let unit = self.unit_of_load();
        if unit == 0.0 {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        let (total, nu) = (self.mesh().total(), order.value());
        let cells = Cells::new(self, unit)?;
        let mean = cells.mean();
        let rest = cells.minus(mean)?;
        let ulps = 8.0 * f64::EPSILON * mean.abs();
        let finish = |value: f64, error: f64, work: Work| {
            Estimate::new(
                mean * mean + value,
                error + ulps * (mean.abs() + value.max(0.0).sqrt()),
                work,
            )?
            .sqrt()?
            .times(unit)?
            .times(total.sqrt())
        };
        let square = rest.square();
        // Q is at most ∥f∥²: what is left of a constant is its rounding
        if square <= ulps * ulps {
            return finish(
                0.0,
                square,
                Work { points: self.mesh().len() as u64, ..Work::default() },
            );
        }
        // 1 + A = (m + a A) / factor in units of the interval
        let scale = total.powf(2.0 * nu);
        let (weights, factor) =
            if total <= 1.0 { ([scale, 1.0], scale) } else { ([1.0, 1.0 / scale], 1.0) };
        // Layers far thinner than every element: u is f.
        if symbol_constant(order) * weights[1] * rest.shortest().powf(-2.0 * nu) < NOTHING {
            return finish(square, 4.0 * f64::EPSILON * square, Work::default());
        }
        let goal = (1e-2 * tolerance.relative()).max(f64::EPSILON);
        let comparison = Comparison::new(order, weights, self.mesh().len(), tolerance.relative());
        let rough = Rough { u: self, unit, mean, order, weights, comparison };
        let (exact, exact_error) =
            rough.comparison.exact(self.mesh(), &rough.whole(), rest, goal)?;
        let mut first = match self.mesh().uniform_length() {
            Some(_) => self.mesh().len(),
            None => (2 * self.mesh().len()).next_power_of_two(),
        };
        // Above order 1/2 meshes coarser than that of f will often do.
        let coarser = if nu >= 0.5 { 64 } else { 4 };
        let least = (first / coarser).max(FIRST);
        while first > least && first.is_multiple_of(2) {
            first /= 2;
        }
        while first < FIRST {
            first *= 2;
        }
        while first > MOST {
            first = first.div_ceil(2);
        }
        let (mut levels, mut best, mut work): (Vec<Level>, Option<Estimate>, Work) =
            (Vec::new(), None, Work::default());
        let mut count = first;
        while count <= MOST {
            let missed = rough.missed(count, goal)?;
            work += Work { points: count as u64, iterations: missed.steps, ..Work::default() };
            let (value, alike) = (exact + missed.value, rough.cuts_alike(count));
            levels.push(Level { value, error: missed.error, alike });
            if let Some((value, error)) = rough.limit(&levels) {
                let found = finish(factor * value, factor * (error + exact_error), work)?;
                if found.relative_error() <= tolerance.relative() {
                    return Ok(found);
                }
                if best.is_none_or(|best| found.error < best.error) {
                    best = Some(found);
                } else if best.is_some_and(|best| found.error > 4.0 * best.error) {
                    break;
                }
                // Rounding only grows.
                let rounded = finish(factor * value, factor * missed.error, work)?;
                if rounded.relative_error() > tolerance.relative() {
                    break;
                }
                // Large meshes are for those that may reach it.
                let gain = rough.rate().powf((MOST as f64 / count as f64).log2() + SPARE);
                if count >= LARGE && found.relative_error() > gain * tolerance.relative() {
                    break;
                }
            }
            count *= 2;
        }
        let why = "2^20 elements do not resolve the jumps, or rounding of the form dominates";
        Err(Error::best_of("dual norm", tolerance.relative(), best, why))
    }
}
