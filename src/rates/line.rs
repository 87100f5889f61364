//! The regression line ln y = a + s ln x.

/// The line ln y = a + s ln x, by least squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    /// The slope s: the exponent of a power law.
    pub slope: f64,
    /// The intercept a.
    pub intercept: f64,
}

impl Line {
    /// The line through the points (ln x, ln y): all coordinates must be positive, and at least two x different.
    pub(super) fn through_logarithms(points: &[(f64, f64)]) -> Self {
        let count = points.len() as f64;
        let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
        let (x, y) = (mean(&|p| p.0.ln()), mean(&|p| p.1.ln()));
        let spread: f64 = points.iter().map(|p| (p.0.ln() - x).powi(2)).sum();
        let slope = points.iter().map(|p| (p.0.ln() - x) * (p.1.ln() - y)).sum::<f64>() / spread;
        Self { slope, intercept: y - slope * x }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_is_found() {
        let power = |x: f64| (x, 5.0 * x.powf(1.3));
        let line = Line::through_logarithms(&[power(1.0), power(0.5), power(0.1)]);
        assert!((line.slope - 1.3).abs() < 1e-14 && (line.intercept - 5f64.ln()).abs() < 1e-14);
    }
}
