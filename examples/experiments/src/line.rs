//! The regression line y = a + s x, and slopes in doubly logarithmic coordinates.

/// Slope of the regression line and its standard error; 0 for the latter with two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Line {
    /// s.
    pub slope: f64,
    /// a.
    pub intercept: f64,
    /// √(Σ residual² / (n − 2) / Σ (x − mean)²): what scatter alone does to the slope.
    pub error: f64,
}

impl Line {
    /// Through points (x, y) with at least two different x; otherwise the slope is not a number.
    pub(crate) fn through(points: &[(f64, f64)]) -> Self {
        let count = points.len() as f64;
        let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
        let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
        let spread: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
        let slope = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread;
        let residual: f64 = points.iter().map(|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sum();
        let error = if points.len() > 2 { (residual / (count - 2.0) / spread).sqrt() } else { 0.0 };
        Self { slope, intercept: y - slope * x, error }
    }
}
