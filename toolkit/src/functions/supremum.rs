//! max |u| of a function with breakpoints, by samples in the logarithm of the distance to the breakpoints.
//!
//! Along a side |u| is sampled at equal steps of t = ln(R/δ) and on every cell of [`super::look`]; every local maximum is refined by
//! golden-section search; steps are halved until two agree. Beyond the depth of the side the supremum is
//! the limit of the values at depth/4, depth/2 and depth if their differences decrease, and infinite
//! otherwise. Cost: 700 values per side and unit of 1/step.

use super::arm::Arm;
use super::function::SingularFunction;
use super::look::Look;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};
use crate::numeric::search::golden_section;
use crate::root::accept;
use std::sync::OnceLock;

/// Successive numbers of samples per unit of t, and per cell.
const DENSITIES: [f64; 4] = [4.0, 8.0, 16.0, 32.0];
/// Fourth difference of samples of a function of size 1 above which it is not smooth on their scale.
const ROUGH: f64 = 1e-5;
/// Width to which a smooth maximum is located, and the relative change over it from which it is located to less.
const WIDTH: f64 = 1e-8;
const FLAT: f64 = 1e-14;
/// Ratio of differences above which they count as not decreasing: ln t grows by equal amounts when t doubles.
const FALLS: f64 = 1.0 - 1e-9;
/// Relative rounding error of a value of u.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The largest value on one or several sides, with its uncertainty.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Peak {
    value: f64,
    error: f64,
    points: u64,
}

impl SingularFunction<'_> {
    /// max |u|, the essential supremum where u is continuous between its breakpoints.
    pub(super) fn largest(&self, tolerance: Tolerance) -> Result<Estimate> {
        let mut work = Work::default();
        let mut best: Option<Estimate> = None;
        let is_rough = self.is_rough();
        let look = if is_rough { self.looked(tolerance)? } else { Look::default() };
        let is_unresolved = is_rough && look.is_unresolved();
        let mut coarse: Option<f64> = None;
        for density in std::iter::once(None).chain(DENSITIES.map(Some)) {
            let whole = match self.highest(density, &look, tolerance) {
                Err(_) if self.work_left() == 0 => {
                    return Err(Error::best_of("L^inf norm", tolerance.relative(), best, SPENT));
                }
                other => other?,
            };
            work.points += whole.points;
            if let Some(coarse) = coarse {
                let error = (whole.value - coarse).abs() + whole.error + ROUNDING * whole.value;
                let estimate = Estimate::new(whole.value, error, work)?;
                if is_unresolved {
                    // Of a function with more maxima than samples only a value is known.
                    best = Some(Estimate { error: estimate.error.max(whole.value), ..estimate });
                } else if estimate.relative_error() <= tolerance.relative() {
                    return Ok(estimate);
                } else {
                    best = Some(estimate);
                }
            }
            coarse = Some(whole.value);
        }
        let best = best.map_or_else(|| Estimate::new(0.0, 0.0, work), Ok)?;
        accept(
            "L^inf norm",
            best,
            tolerance,
            "samples do not converge: there is a narrow peak between breakpoints",
        )
    }

    /// The largest value on all sides by samples of one density. Those of the coarsest ones are kept: a later call to at most
    /// the same accuracy takes no values, but counts them in the work limit.
    fn highest(&self, density: Option<f64>, look: &Look, tolerance: Tolerance) -> Result<Peak> {
        let kept = match density {
            _ if !self.is_normalized() => None,
            None => Some(&self.seen().peaks[0]),
            Some(density) => (density == DENSITIES[0]).then(|| &self.seen().peaks[1]),
        };
        if let Some((accuracy, peak, work)) = kept.and_then(OnceLock::get)
            && *accuracy <= tolerance.relative()
        {
            return self.spend(*work).map(|()| *peak);
        }
        let before = self.work_left();
        let mut whole = Peak::default();
        for arm in self.arms() {
            let peak = self.peak(&arm, density, look)?;
            whole.value = whole.value.max(peak.value);
            whole.error = whole.error.max(peak.error);
            whole.points += peak.points;
        }
        if let Some(kept) = kept {
            kept.get_or_init(|| (tolerance.relative(), whole, before - self.work_left()));
        }
        Ok(whole)
    }

    /// The largest value between two depths, of which the function has one.
    fn refined(&self, arm: &Arm, [from, to]: [f64; 2]) -> Result<Peak> {
        // A value that is not finite was reported before; between samples it loses the comparison.
        let size = |t: f64| self.evaluated(arm, arm.delta(t)).map(f64::abs);
        let around = |width: f64| -> Result<[f64; 3]> {
            let t = golden_section(from, to, width, |t| -size(t).unwrap_or(0.0));
            let beside = |t: f64| size(t.clamp(from, to)).unwrap_or(0.0);
            let mut found = [beside(t - width), size(t)?, beside(t + width)];
            found.sort_by(f64::total_cmp);
            Ok(found)
        };
        let mut found = around(WIDTH)?;
        if found[2] - found[0] > FLAT * found[2] {
            // A kink, a step, or a peak much narrower than the side is located to rounding.
            found = around(FLAT.max(16.0 * f64::EPSILON * to))?;
        }
        // Of three values at a step, two lie on its upper side.
        Ok(Peak { value: found[2], error: found[2] - found[1], points: 0 })
    }

    /// True if some of the samples at equal distances differ from cubic polynomials through their neighbours.
    fn is_rough(&self) -> bool {
        let fourth = |u: &[f64]| (u[0] - 4.0 * u[1] + 6.0 * u[2] - 4.0 * u[3] + u[4]).abs();
        let mut arms = (0..self.arms().len()).map(|arm| self.samples_of(arm));
        arms.any(|samples| samples.windows(5).any(|u| fourth(u) > ROUGH))
    }

    /// The largest value on a side, by samples of the given density, or by those that all norms have in common.
    fn peak(&self, arm: &Arm, density: Option<f64>, look: &Look) -> Result<Peak> {
        let size = |t: f64| self.evaluated(arm, arm.delta(t)).map(f64::abs);
        let depth_of = |delta: f64| (arm.length / delta).ln();
        let (mut places, mut values) = (vec![0.0], vec![size(0.0)?]);
        match density {
            None => {
                for (delta, value) in self.seen_within(arm, 0.0, arm.length) {
                    places.push(depth_of(delta));
                    values.push(value.abs());
                }
                places[1..].reverse();
                values[1..].reverse();
                places.push(arm.depth);
                values.push(size(arm.depth)?);
            }
            Some(density) => {
                let count = (density * arm.depth).ceil().max(3.0) as usize;
                places.extend((1..=count).map(|k| arm.depth * k as f64 / count as f64));
                let mut near = 0.0;
                for &far in look.cuts(arm, 0.0, arm.length).iter().chain([&arm.length]) {
                    let inside = (0..density as usize)
                        .map(|k| near + (far - near) * (k as f64 + 0.5) / density);
                    places.extend(inside.map(depth_of).filter(|&t| t < arm.depth));
                    near = far;
                }
                places.sort_by(f64::total_cmp);
                for &t in &places[1..] {
                    values.push(size(t)?);
                }
            }
        }
        let (at, count) = (|k: usize| places[k], places.len() - 1);
        let mut peak = Peak { points: values.len() as u64, ..Peak::default() };
        for k in 0..=count {
            let inside = k > 0 && k < count;
            if inside && values[k] > values[k - 1] && values[k] >= values[k + 1] {
                let found = self.refined(arm, [at(k - 1), at(k + 1)])?;
                // A search that ends below its start has met several maxima.
                let (largest, missed) =
                    (found.value.max(values[k]), (values[k] - found.value).max(0.0));
                if largest >= peak.value {
                    (peak.value, peak.error) = (largest, found.error + missed);
                }
            }
            if values[k] > peak.value {
                (peak.value, peak.error) = (values[k], 0.0);
            }
        }
        let [first, middle] = [size(0.25 * arm.depth)?, size(0.5 * arm.depth)?];
        if values[count] == peak.value && values[count] > middle {
            let (limit, error) = beyond([first, middle, values[count]])?;
            peak = Peak { value: limit, error, ..peak };
        }
        Ok(peak)
    }
}

/// The limit of values that grow from depth/4 to depth/2 to depth, and its uncertainty.
fn beyond([first, middle, last]: [f64; 3]) -> Result<(f64, f64)> {
    let (before, after) = (middle - first, last - middle);
    if after <= ROUNDING * last {
        return Ok((last, after));
    }
    let ratio = after / before;
    if !(ratio > 0.0 && ratio < FALLS) {
        return Err(Error::InfiniteNorm {
            order: 0.0,
            why: "the function grows without bound near a breakpoint",
        });
    }
    let rest = after * ratio / (1.0 - ratio);
    Ok((last + rest, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maxima_inside_at_breaks_and_infinite_ones() {
        let largest = |f: fn(f64) -> f64| {
            SingularFunction::new(&[0.0, 1.0], f)
                .unwrap()
                .lq_norm(f64::INFINITY, Tolerance::balanced())
        };
        let parabola = largest(|x| 4.0 * x * (1.0 - x)).unwrap();
        assert!(
            (parabola.value - 1.0).abs() <= parabola.error && parabola.error < 1e-12,
            "{parabola}"
        );
        let root = largest(|x| 1.0 - x.sqrt()).unwrap();
        assert!((root.value - 1.0).abs() <= root.error, "{root}");
        let steep = largest(|x| (7.0 * x).sin()).unwrap();
        assert!((steep.value - 1.0).abs() <= steep.error, "{steep}");
        for unbounded in [(|x: f64| x.powf(-0.01)) as fn(f64) -> f64, |x| (-x.ln()).powf(0.25)] {
            assert!(matches!(largest(unbounded), Err(Error::InfiniteNorm { .. })));
        }
    }
}
