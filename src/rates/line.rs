//! The regression line y = a + s x, and slopes in doubly logarithmic coordinates.

/// Slope of the regression line and its standard error; 0 for the latter with two points.
#[doc(alias("linear regression", "least squares"))]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    /// s.
    pub slope: f64,
    /// a.
    pub intercept: f64,
    /// √(Σ residual² / (n − 2) / Σ (x − mean)²): what scatter alone does to the slope.
    pub error: f64,
}

impl Line {
    /// Through points (x, y) with at least two different x; otherwise the slope is not a number.
    pub(super) fn through(points: &[(f64, f64)]) -> Self {
        let count = points.len() as f64;
        let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
        let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
        let spread: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
        let slope = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread;
        let residual: f64 = points.iter().map(|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sum();
        let error = if points.len() > 2 { (residual / (count - 2.0) / spread).sqrt() } else { 0.0 };
        Self { slope, intercept: y - slope * x, error }
    }

    /// Through (ln x, ln y): the slope is the exponent of a power law. All coordinates must be positive.
    pub(super) fn through_logarithms(points: &[(f64, f64)]) -> Self {
        Self::through(&points.iter().map(|(x, y)| (x.ln(), y.ln())).collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_and_a_power_are_found() {
        let line = Line::through(&[(0.0, 1.0), (1.0, 3.0), (3.0, 7.0)]);
        assert!(
            (line.slope - 2.0).abs() < 1e-15 && (line.intercept - 1.0).abs() < 1e-15 && line.error < 1e-15
        );
        let power = Line::through_logarithms(&[
            (1.0, 5.0),
            (0.5, 5.0 * 0.5f64.powf(1.3)),
            (0.1, 5.0 * 0.1f64.powf(1.3)),
        ]);
        assert!((power.slope - 1.3).abs() < 1e-14);
    }
}
