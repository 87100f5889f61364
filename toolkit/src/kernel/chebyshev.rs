//! Interpolation of kernels at Chebyshev points.

use super::power::PowerKernel;

/// Chebyshev points of (0, 1) and their barycentric weights.
pub(crate) struct Chebyshev {
    pub(crate) points: Vec<f64>,
    weights: Vec<f64>,
}

/// Largest number of points, at which the error is at rounding level.
const MOST: usize = 28;
/// Number of points in each variable at which the interpolation error is measured.
const PLACES: usize = 23;

impl Chebyshev {
    pub(crate) fn new(m: usize) -> Self {
        let angle = |k: usize| (k as f64 + 0.5) * std::f64::consts::PI / m as f64;
        Self {
            points: (0..m).map(|k| (0.5 * angle(k)).sin().powi(2)).collect(),
            weights: (0..m)
                .map(|k| if k % 2 == 0 { angle(k).sin() } else { -angle(k).sin() })
                .collect(),
        }
    }

    /// The interpolation with the fewest points for which the error of a kernel k(s, t) on the unit square,
    /// relative to its value, is at most `target`, and the measured error.
    pub(crate) fn to(target: f64, kernel: impl Fn(f64, f64) -> f64) -> (Self, f64) {
        let mut m = 3;
        loop {
            let found = Self::new(m);
            let error = found.error(&kernel);
            if error <= target || m == MOST {
                return (found, error);
            }
            m += 1;
        }
    }

    /// As [`Chebyshev::to`] for the power of the distance of two intervals of length one at distance one: the
    /// worst of all pairs whose gap is no shorter than either of them.
    pub(crate) fn for_power(target: f64, kernel: PowerKernel) -> (Self, f64) {
        Self::to(target, |s, t| kernel.at(1.0 + s + t))
    }

    /// The largest relative error on a grid of points.
    fn error(&self, kernel: &impl Fn(f64, f64) -> f64) -> f64 {
        let m = self.points.len();
        let place = |k: usize| k as f64 / (PLACES - 1) as f64;
        let values: Vec<Vec<f64>> = self
            .points
            .iter()
            .map(|&s| self.points.iter().map(|&t| kernel(s, t)).collect())
            .collect();
        let mut lagrange = vec![vec![0.0; m]; PLACES];
        lagrange.iter_mut().enumerate().for_each(|(k, row)| self.lagrange(place(k), row));
        let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let mut largest = 0.0_f64;
        for (k, along_s) in lagrange.iter().enumerate() {
            let row: Vec<f64> = (0..m)
                .map(|b| along_s.iter().zip(&values).map(|(l, row)| l * row[b]).sum())
                .collect();
            for (j, along_t) in lagrange.iter().enumerate() {
                let exact = kernel(place(k), place(j));
                largest = largest.max((dot(&row, along_t) / exact - 1.0).abs());
            }
        }
        largest
    }

    /// The values of the Lagrange polynomials at t.
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
