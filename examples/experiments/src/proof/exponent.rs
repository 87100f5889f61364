//! Exponents of h with their uncertainty.

use crate::line::Line;
use signorini::{Error, Result, ToolkitError};

/// An exponent of h by least squares, with its uncertainty.
///
/// The uncertainty is the larger of twice the standard error of the slope and half the difference of the
/// slopes over the coarser and the finer half of the meshes: scatter and curvature (logarithms) both count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponent {
    /// Slope of ln(value) against ln h.
    pub value: f64,
    /// Its uncertainty.
    pub uncertainty: f64,
}

impl Exponent {
    /// From pairs (h, value); pairs with a value that is not positive are left out.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) with fewer than three positive values.
    pub fn fit(points: &[(f64, f64)]) -> Result<Self> {
        let logs: Vec<(f64, f64)> =
            points.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0).map(|p| (p.0.ln(), p.1.ln())).collect();
        if logs.len() < 3 {
            let range = "[3, inf)";
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "positive values of a fit",
                value: logs.len(),
                range,
            }));
        }
        let Line { slope: value, error, .. } = Line::through(&logs);
        let half = logs.len() / 2;
        // Both halves share the middle.
        let (coarse, fine) =
            (Line::through(&logs[..=half]).slope, Line::through(&logs[half.min(logs.len() - 2)..]).slope);
        Ok(Self { value, uncertainty: (2.0 * error).max(0.5 * (coarse - fine).abs()) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_has_no_uncertainty_and_a_logarithm_has_some() {
        let h: Vec<f64> = (3..12).map(|k| 0.5f64.powi(k)).collect();
        let fit = |f: &dyn Fn(f64) -> f64| {
            Exponent::fit(&h.iter().map(|&h| (h, f(h))).collect::<Vec<_>>()).unwrap()
        };
        let power = fit(&|h| 3.0 * h.powf(1.375));
        assert!((power.value - 1.375).abs() < 1e-12 && power.uncertainty < 1e-12);
        let logarithm = fit(&|h| h * -h.ln());
        assert!((logarithm.value - 1.0).abs() < 0.3 && logarithm.uncertainty > 0.05, "{logarithm:?}");
        assert!(Exponent::fit(&[(0.5, 1.0), (0.25, 1.0), (0.125, 0.0)]).is_err());
    }
}
