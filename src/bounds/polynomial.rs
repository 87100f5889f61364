//! A stress with the given load, exactly: antiderivatives along the axes of a polynomial in both coordinates.
//!
//! ```text
//! elastic: q = diag(−∫_{x₀}^x f_x dx, −∫_{y₀}^y f_y dy),       scalar: q = (−∫_{x₀}^x f dx, 0),       div q + f = 0
//! ```
//!
//! with (x₀, y₀) the lower left corner of the bounding box of the body. The load is interpolated on the box in products
//! of Chebyshev polynomials and truncated where the coefficients are rounding; a load that is not resolved by
//! [`DEGREE`] has no such stress. q is continuous on the box, so it needs no condition between triangles.

use super::element::Value;
use crate::mesh::Point;
use std::f64::consts::PI;

/// Largest degree in each coordinate.
const DEGREE: usize = 28;

/// Points that are evaluated together.
const LANES: usize = 8;

/// Coefficients below this multiple of the largest value are rounding.
const RESOLVED: f64 = 1e-14;

/// A polynomial on a box: coefficients of T_k(x) T_l(y), mapped to (−1, 1)².
#[derive(Debug, Clone)]
struct Series {
    /// Rows k, columns l; all rows have the same length.
    coefficients: Vec<Vec<f64>>,
}

/// The stress.
#[derive(Debug, Clone)]
pub(super) struct Particular {
    low: Point,
    half: Point,
    /// The antiderivatives, one per component of the load.
    parts: Vec<Series>,
}

impl Particular {
    /// The stress for a load on the box, or `None` if the load is not a polynomial of moderate degree to rounding.
    pub(super) fn new(
        components: usize,
        [low, high]: [Point; 2],
        load: impl Fn(Point) -> Point,
    ) -> Option<Self> {
        let half = [0, 1].map(|axis| 0.5 * (high[axis] - low[axis]));
        let count = DEGREE + 5;
        let node = |j: usize| -(PI * (j as f64 + 0.5) / count as f64).cos();
        let place = |i: usize, j: usize| {
            [low[0] + half[0] * (1.0 + node(i)), low[1] + half[1] * (1.0 + node(j))]
        };
        let samples: Vec<Vec<Point>> =
            (0..count).map(|i| (0..count).map(|j| load(place(i, j))).collect()).collect();
        let mut parts = Vec::new();
        for component in 0..components {
            let values: Vec<Vec<f64>> = samples
                .iter()
                .map(|row| row.iter().map(|value| value[component]).collect())
                .collect();
            let series = Series::through(&values)?;
            parts.push(series.minus_antiderivative(component, half[component]));
        }
        Some(Self { low, half, parts })
    }

    /// The largest degree, in units that make it comparable with the box: a triangle of diameter h meets a part of it.
    pub(super) fn waves(&self, diameter: f64) -> f64 {
        let relative = diameter / (2.0 * self.half[0].min(self.half[1]));
        let degree = |part: &Series| part.coefficients.len().max(part.coefficients[0].len());
        self.parts.iter().map(degree).max().unwrap_or(0) as f64 * relative
    }

    /// The largest degree in a coordinate.
    pub(super) fn degree(&self) -> usize {
        let degree = |part: &Series| part.coefficients.len() + part.coefficients[0].len() - 2;
        self.parts.iter().map(degree).max().unwrap_or(0)
    }

    /// The stress at many points.
    pub(super) fn at(&self, points: &[Point], values: &mut [Value]) {
        for (points, values) in points.chunks(LANES).zip(values.chunks_mut(LANES)) {
            let local = |axis: usize| -> [f64; LANES] {
                std::array::from_fn(|j| {
                    let point = points[j.min(points.len() - 1)];
                    (point[axis] - self.low[axis]) / self.half[axis] - 1.0
                })
            };
            let (x, y) = (local(0), local(1));
            for (component, part) in self.parts.iter().enumerate() {
                let found = part.at(&x, &y);
                for (value, found) in values.iter_mut().zip(found) {
                    value[component] = found;
                }
            }
        }
    }
}

impl Series {
    /// The series through values at Chebyshev points of the first kind.
    fn through(values: &[Vec<f64>]) -> Option<Self> {
        let count = values.len();
        let largest = values.iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
        if !largest.is_finite() || values.iter().flatten().any(|v| !v.is_finite()) {
            return None;
        }
        let wave: Vec<Vec<f64>> = (0..count)
            .map(|k| {
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                let scale = sign * if k == 0 { 1.0 } else { 2.0 } / count as f64;
                (0..count)
                    .map(|j| scale * (PI * (k as f64) * (j as f64 + 0.5) / count as f64).cos())
                    .collect()
            })
            .collect();
        let transform = |rows: &[Vec<f64>]| -> Vec<Vec<f64>> {
            // Rows are transformed and become columns.
            (0..count)
                .map(|k| {
                    rows.iter()
                        .map(|row| row.iter().zip(&wave[k]).map(|(v, w)| v * w).sum())
                        .collect()
                })
                .collect()
        };
        let mut coefficients = transform(&transform(values));
        let small = RESOLVED * largest;
        let is_small = |values: &[f64]| values.iter().all(|v| v.abs() <= small);
        while coefficients.len() > 1 && is_small(&coefficients[coefficients.len() - 1]) {
            coefficients.pop();
        }
        let width = (1..count)
            .rev()
            .find(|&l| coefficients.iter().any(|row| row[l].abs() > small))
            .map_or(1, |last| last + 1);
        coefficients.iter_mut().for_each(|row| row.truncate(width));
        let resolved = coefficients.len() <= DEGREE + 1 && width <= DEGREE + 1;
        resolved.then_some(Self { coefficients })
    }

    /// −∫ from the lower end of the box along an axis, whose half length is given.
    ///
    /// ∫ T_0 = T_1, ∫ T_1 = T_2/4, ∫ T_k = T_{k+1}/(2(k + 1)) − T_{k−1}/(2(k − 1)), up to constants.
    fn minus_antiderivative(&self, axis: usize, half: f64) -> Self {
        let turned = |rows: &[Vec<f64>]| -> Vec<Vec<f64>> {
            (0..rows[0].len()).map(|l| rows.iter().map(|row| row[l]).collect()).collect()
        };
        let rows = if axis == 0 { turned(&self.coefficients) } else { self.coefficients.clone() };
        // Every row is now a series in the coordinate of the axis.
        let integrated: Vec<Vec<f64>> = rows
            .iter()
            .map(|row| {
                let mut sum = vec![0.0; row.len() + 1];
                for (k, &c) in row.iter().enumerate() {
                    let c = -half * c;
                    match k {
                        0 => sum[1] += c,
                        1 => add_at(&mut sum, 2, 0.25 * c),
                        _ => {
                            add_at(&mut sum, k + 1, c / (2.0 * (k as f64 + 1.0)));
                            sum[k - 1] -= c / (2.0 * (k as f64 - 1.0));
                        }
                    }
                }
                // T_k(−1) = (−1)^k.
                let at_low: f64 =
                    sum.iter().enumerate().map(|(k, c)| if k % 2 == 0 { *c } else { -*c }).sum();
                sum[0] -= at_low;
                sum
            })
            .collect();
        Self { coefficients: if axis == 0 { turned(&integrated) } else { integrated } }
    }

    /// Clenshaw's recurrence in both coordinates: b_k = c_k + 2x b_{k+1} − b_{k+2}, and the sum is b_0 − x b_1.
    fn at(&self, x: &[f64; LANES], y: &[f64; LANES]) -> [f64; LANES] {
        let (mut next, mut after) = ([0.0; LANES], [0.0; LANES]);
        for row in self.coefficients.iter().rev() {
            let (mut inner, mut beyond) = ([0.0; LANES], [0.0; LANES]);
            for c in row.iter().rev() {
                for j in 0..LANES {
                    (inner[j], beyond[j]) = (c + 2.0 * y[j] * inner[j] - beyond[j], inner[j]);
                }
            }
            for j in 0..LANES {
                let value = inner[j] - y[j] * beyond[j];
                (next[j], after[j]) = (value + 2.0 * x[j] * next[j] - after[j], next[j]);
            }
        }
        std::array::from_fn(|j| next[j] - x[j] * after[j])
    }
}

fn add_at(sum: &mut [f64], k: usize, value: f64) {
    if let Some(entry) = sum.get_mut(k) {
        *entry += value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn antiderivatives_of_smooth_loads_are_exact() {
        let bounds = [[-1.0, 0.5], [2.0, 1.5]];
        let load = |[x, y]: Point| [(1.3 * x).cos() * y * y, (x - 0.7 * y).exp()];
        let found = Particular::new(2, bounds, load).unwrap();
        for point in [[-1.0_f64, 0.5_f64], [0.3, 0.9], [1.9, 1.4]] {
            let [x, y] = point;
            let exact = [
                -((1.3 * x).sin() - (-1.3_f64).sin()) / 1.3 * y * y,
                (x.exp() * ((-0.7 * y).exp() - (-0.35_f64).exp())) / 0.7,
            ];
            let mut values = [[0.0; 3]];
            found.at(&[point], &mut values);
            let [value] = values;
            assert!((value[0] - exact[0]).abs() < 1e-13, "{value:?} {exact:?}");
            assert!((value[1] - exact[1]).abs() < 1e-13, "{value:?} {exact:?}");
        }
        let quadratic = Particular::new(1, bounds, |[x, y]| [1.0 + x * y - y * y, 0.0]).unwrap();
        assert!(quadratic.degree() <= 4, "{}", quadratic.degree());
        assert!(Particular::new(1, bounds, |[x, _]| [(x - 0.3).abs(), 0.0]).is_none());
    }
}
