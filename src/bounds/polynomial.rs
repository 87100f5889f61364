//! A stress with the given load, exactly: antiderivatives along the axes of a polynomial in both
//! coordinates.
//!
//! ```text
//! elastic: q = diag(−∫_{x₀}^x f_x dx, −∫_{y₀}^y f_y dy),       scalar: q = (−∫_{x₀}^x f dx, 0),
//! div q + f = 0
//! ```
//!
//! with (x₀, y₀) the lower left corner of the bounding box of the body. The load is interpolated on
//! the box in products of Chebyshev polynomials and truncated where the coefficients are rounding;
//! a load that is not resolved by [`DEGREE`] has no such stress. q is continuous on the box, so it
//! needs no condition between triangles.

use super::element::Value;
use crate::mesh::Point;
use std::f64::consts::PI;

/// Largest degree in each coordinate.
const DEGREE: usize = 28;

/// Points that are evaluated together: few enough for the recurrences to stay in registers.
pub(super) const LANES: usize = 4;

/// Largest number of points in each direction of a rule.
pub(super) const MOST: usize = 10;

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
    /// By number of points in each direction, see [`remainders`].
    remainders: Vec<f64>,
}

impl Particular {
    /// The stress for a load on the box, or `None` if the load is not a polynomial of moderate
    /// degree to rounding.
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
        let remainders = remainders(&parts, half);
        Some(Self { low, half, parts, remainders })
    }

    /// The fewest of 2, 3, .., [`MOST`] points in each direction with which squares of the stress
    /// are integrated on a triangle of the given diameter to the relative tolerance.
    pub(super) fn points(&self, diameter: f64, tolerance: f64) -> usize {
        // A triangle lies in a circle of this radius (H. Jung).
        let radius = diameter / 3.0_f64.sqrt() / self.half[0].min(self.half[1]);
        let is_enough = |&n: &usize| self.remainders[n] * radius.powi(2 * n as i32) <= tolerance;
        (2..MOST).find(is_enough).unwrap_or(MOST)
    }

    /// The stress at some points.
    pub(super) fn at(&self, points: &[Point; LANES]) -> [Value; LANES] {
        let local = |axis: usize| {
            points.map(|point| (point[axis] - self.low[axis]) / self.half[axis] - 1.0)
        };
        let (x, y) = (local(0), local(1));
        let mut values = [[0.0; 3]; LANES];
        for (component, part) in self.parts.iter().enumerate() {
            let found = part.at(&x, &y);
            (0..LANES).for_each(|j| values[j][component] = found[j]);
        }
        values
    }
}

/// R_n, n = 0, 1, .., [`MOST`], with |∫ G − Q_n G| ≤ R_n r^{2n} M_0² |T| on a triangle T in a
/// circle of radius r, in units of the smaller half of the box, for the rule Q_n of n × n points
/// and G the square of a function whose k-th derivatives in any direction are bounded by M_k, as
/// those of the stress are.
///
/// The rule is exact for degree 2n − 1, its weights are positive, and the remainder of Taylor's
/// polynomial about the centre is r^d/d! times a derivative of order d = 2n, so that
///
/// ```text
/// R_n = 2/d! Σ_k C(d, k) M_k M_{d−k}/M_0²,
/// M_k = Σ_{a+b=k} C(k, a) Σ |c_ml| T_m^{(a)}(1) T_l^{(b)}(1) / (half_x^a half_y^b),
/// ```
///
/// where T_m^{(a)}(1) = Π_{j<a} (m² − j²)/(2j + 1) is the largest value on (−1, 1).
fn remainders(parts: &[Series], half: [f64; 2]) -> Vec<f64> {
    let half = half.map(|own| own / half[0].min(half[1]));
    let binomials = |n: usize| {
        let next = move |(k, value): (usize, f64)| (k + 1, value * (n - k) as f64 / (k + 1) as f64);
        std::iter::successors(Some((0, 1.0)), move |&last| (last.0 < n).then(|| next(last)))
    };
    let derivatives = |degree: usize, half: f64| -> Vec<f64> {
        let mut values = vec![1.0];
        for j in 0..2 * MOST {
            let factor = (degree * degree) as f64 - (j * j) as f64;
            values.push(values[j] * factor.max(0.0) / (half * (2 * j + 1) as f64));
        }
        values
    };
    let mut bounds = [0.0; 2 * MOST + 1];
    for part in parts {
        let columns: Vec<Vec<f64>> =
            (0..part.coefficients[0].len()).map(|l| derivatives(l, half[1])).collect();
        for (m, row) in part.coefficients.iter().enumerate() {
            let own = derivatives(m, half[0]);
            for (c, column) in row.iter().zip(&columns) {
                for (k, bound) in bounds.iter_mut().enumerate() {
                    let mixed = binomials(k).map(|(a, times)| times * own[a] * column[k - a]);
                    *bound += c.abs() * mixed.sum::<f64>();
                }
            }
        }
    }
    let size = bounds[0] * bounds[0];
    let of_square = |n: usize| {
        let d = 2 * n;
        let sum: f64 = binomials(d).map(|(k, times)| times * bounds[k] * bounds[d - k]).sum();
        let factorial: f64 = (1..=d).map(|k| k as f64).product();
        if size > 0.0 { 2.0 * sum / size / factorial } else { 0.0 }
    };
    (0..=MOST).map(of_square).collect()
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
    /// ∫ T_0 = T_1, ∫ T_1 = T_2/4, ∫ T_k = T_{k+1}/(2(k + 1)) − T_{k−1}/(2(k − 1)), up to
    /// constants.
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

    /// Clenshaw's recurrence in both coordinates: b_k = c_k + 2x b_{k+1} − b_{k+2}, and the sum is
    /// b_0 − x b_1.
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
    use super::super::element::combine;
    use super::super::rule::TriangleRule;
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
            let [value, ..] = found.at(&[point; LANES]);
            assert!((value[0] - exact[0]).abs() < 1e-13, "{value:?} {exact:?}");
            assert!((value[1] - exact[1]).abs() < 1e-13, "{value:?} {exact:?}");
        }
        assert!(Particular::new(1, bounds, |[x, _]| [(x - 0.3).abs(), 0.0]).is_none());
    }

    /// Squares of the stress, and of its difference to its linear interpolant, within the tolerance
    /// on triangles of many sizes.
    #[test]
    fn rules_are_as_accurate_as_required() {
        let bounds = [[-1.0, 0.5], [2.0, 1.5]];
        let load = |[x, y]: Point| [(4.0 * x).cos() * y, (2.0 * x - 3.0 * y).sin()];
        let found = Particular::new(2, bounds, load).unwrap();
        let finest = TriangleRule::new(MOST + 4).unwrap();
        let mut fewest = MOST;
        for k in 0..12 {
            let size = 0.8 * 0.5f64.powi(k);
            let corners =
                [[-0.9, 0.6], [-0.9 + size, 0.6 + 0.1 * size], [-0.9 + 0.3 * size, 0.6 + size]];
            let ends = corners.map(|corner| found.at(&[corner; LANES])[0]);
            let squares = |rule: &TriangleRule| {
                let mut sums = [0.0; 2];
                for (shares, weight) in &rule.points {
                    let value = found.at(&[combine(shares, &corners); LANES])[0];
                    let linear = combine(shares, &ends);
                    for c in 0..3 {
                        sums[0] += weight * value[c].powi(2);
                        sums[1] += weight * (value[c] - linear[c]).powi(2);
                    }
                }
                sums
            };
            let points = found.points(1.2 * size, 1e-10);
            let (own, exact) = (squares(&TriangleRule::new(points).unwrap()), squares(&finest));
            println!("{size:.4}: {points} points, {own:?} {exact:?}");
            if k == 0 {
                let [few, _] = squares(&TriangleRule::new(3).unwrap());
                assert!((few - exact[0]).abs() > 1e-10);
            }
            for (own, square) in own.iter().zip(exact) {
                assert!((own - square).abs() <= 1e-10, "{size}: {own} {square}");
            }
            fewest = fewest.min(points);
        }
        assert_eq!(fewest, 2);
        // A polynomial: the stress of a linear load is quadratic, its square of degree four.
        let quadratic = Particular::new(1, bounds, |[x, y]| [1.0 + x - y, 0.0]).unwrap();
        assert_eq!(quadratic.points(2.0, 1e-10), 3);
    }
}
