//! Interpolation of kernels at Chebyshev points.

/// Chebyshev points of (0, 1) and their barycentric weights.
pub(crate) struct Chebyshev {
    pub(crate) points: Vec<f64>,
    weights: Vec<f64>,
}

impl Chebyshev {
    pub(crate) fn new(m: usize) -> Self {
        let angle = |k: usize| (k as f64 + 0.5) * std::f64::consts::PI / m as f64;
        Self {
            points: (0..m).map(|k| (0.5 * angle(k)).sin().powi(2)).collect(),
            weights: (0..m).map(|k| if k % 2 == 0 { angle(k).sin() } else { -angle(k).sin() }).collect(),
        }
    }

    /// The Lagrange polynomials at t.
    pub(crate) fn lagrange(&self, t: f64, values: &mut [f64]) {
        let mut sum = 0.0;
        for (k, (&point, &weight)) in self.points.iter().zip(&self.weights).enumerate() {
            let distance = t - point;
            if distance == 0.0 {
                values.fill(0.0);
                values[k] = 1.0;
                return;
            }
            values[k] = weight / distance;
            sum += values[k];
        }
        values.iter_mut().for_each(|value| *value /= sum);
    }
}
