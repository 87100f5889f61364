//! max |u| of a function with breakpoints, by samples in the logarithm of the distance to the breakpoints.
//!
//! Along a side |u| is sampled at equal steps of t = ln(R/δ) and every local maximum is refined by
//! golden-section search; steps are halved until two agree. Beyond the depth of the side the supremum is
//! the limit of the values at depth/4, depth/2 and depth if their differences decrease, and infinite
//! otherwise. Cost: 700 values per side and unit of 1/step.

use super::arm::Arm;
use super::function::SingularFunction;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};
use crate::numeric::search::golden_section;
use crate::root::accept;

/// Successive numbers of samples per unit of t.
const DENSITIES: [f64; 4] = [4.0, 8.0, 16.0, 32.0];
/// Width to which a maximum is located; the error of u is of the order of its square.
const WIDTH: f64 = 1e-8;
/// Ratio of differences above which they count as not decreasing: ln t grows by equal amounts when t doubles.
const FALLS: f64 = 1.0 - 1e-9;
/// Relative rounding error of a value of u.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The largest value on one or several sides, with its uncertainty.
#[derive(Debug, Clone, Copy, Default)]
struct Peak {
    value: f64,
    error: f64,
    points: u64,
}

impl SingularFunction<'_> {
    /// max |u|, the essential supremum where u is continuous between its breakpoints.
    pub(super) fn largest(&self, tolerance: Tolerance) -> Result<Estimate> {
        let mut work = Work::default();
        let mut best: Option<Estimate> = None;
        let mut coarse: Option<f64> = None;
        for density in DENSITIES {
            let mut whole = Peak::default();
            for arm in self.arms() {
                let peak = match self.peak(&arm, density) {
                    Err(_) if self.work_left() == 0 => {
                        return Err(Error::best_of("L^inf norm", tolerance.relative(), best, SPENT));
                    }
                    other => other?,
                };
                whole.value = whole.value.max(peak.value);
                whole.error = whole.error.max(peak.error);
                whole.points += peak.points;
            }
            work.points += whole.points;
            if let Some(coarse) = coarse {
                let error = (whole.value - coarse).abs() + whole.error + ROUNDING * whole.value;
                let estimate = Estimate::new(whole.value, error, work)?;
                if estimate.relative_error() <= tolerance.relative() {
                    return Ok(estimate);
                }
                best = Some(estimate);
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

    fn peak(&self, arm: &Arm, density: f64) -> Result<Peak> {
        let count = (density * arm.depth).ceil().max(3.0) as usize;
        let at = |k: usize| arm.depth * k as f64 / count as f64;
        let size = |t: f64| self.at(arm, arm.delta(t)).map(f64::abs);
        let values = (0..=count).map(|k| size(at(k))).collect::<Result<Vec<f64>>>()?;
        let mut peak = Peak { points: values.len() as u64, ..Peak::default() };
        for k in 0..=count {
            let inside = k > 0 && k < count;
            if inside && values[k] > values[k - 1] && values[k] >= values[k + 1] {
                // A value that is not finite was reported above; between samples it loses the comparison.
                let t = golden_section(at(k - 1), at(k + 1), WIDTH, |t| -size(t).unwrap_or(0.0));
                peak.value = peak.value.max(size(t)?);
            }
            peak.value = peak.value.max(values[k]);
        }
        if values[count] == peak.value && values[count] > values[count / 2] {
            let (limit, error) = beyond([values[count / 4], values[count / 2], values[count]])?;
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
            SingularFunction::new(&[0.0, 1.0], f).unwrap().lq_norm(f64::INFINITY, Tolerance::balanced())
        };
        let parabola = largest(|x| 4.0 * x * (1.0 - x)).unwrap();
        assert!((parabola.value - 1.0).abs() <= parabola.error && parabola.error < 1e-12, "{parabola}");
        let root = largest(|x| 1.0 - x.sqrt()).unwrap();
        assert!((root.value - 1.0).abs() <= root.error, "{root}");
        let steep = largest(|x| (7.0 * x).sin()).unwrap();
        assert!((steep.value - 1.0).abs() <= steep.error, "{steep}");
        for unbounded in [(|x: f64| x.powf(-0.01)) as fn(f64) -> f64, |x| (-x.ln()).powf(0.25)] {
            assert!(matches!(largest(unbounded), Err(Error::InfiniteNorm { .. })));
        }
    }
}
