//! Functions on a triangle: orthonormal polynomials, and powers at the corners.
//!
//! Polynomials (Koornwinder 1975, Dubiner 1991), from a corner with τ, a of [`super::shape`]:
//! w_km = (2|T|)^{-1/2} P_k(a) R_km(τ), P_k Legendre's polynomials orthonormal on (0, 1) and R_km =
//! (2m+2k+2)^{1/2} τ^k P_m^{(0,2k+1)}(2τ − 1) orthonormal with the weight τ. Degree k + m, orthonormal in L².
//!
//! Powers: τ^μ P_k(a), k = 0, 1, ..., μ = 2s (moved away from 1 and 2). Their gradients are τ^{μ−1} (μ P_k
//! ∇τ + P_k' (∇β_C − a ∇τ)), β_C the barycentric coordinate of the corner C, again polynomials of degree k in
//! a times τ^{μ−1}.

use super::shape::{Barycentric, TriangleShape, collapsed};
use crate::error::Result;
use crate::quadrature::Rule;

/// Distances up to which differences are integrals of slopes, and the points of those: degrees up to 40 leave
/// (CLOSE k²)^{2 SLOPES} / (2 SLOPES)!.
const CLOSE: f64 = 5e-3;
const SLOPES: usize = 8;

/// Values P_0 ... and slopes of the orthonormal Legendre polynomials on (0, 1), with room for other points.
#[derive(Debug, Clone)]
pub(super) struct Angular {
    pub(super) values: Vec<f64>,
    pub(super) slopes: Vec<f64>,
}

impl Angular {
    /// The polynomials of degrees below `count`, at a.
    pub(super) fn new(count: usize, a: f64) -> Self {
        let mut angular = Self { values: vec![0.0; count], slopes: vec![0.0; count] };
        angular.at(a);
        angular
    }

    /// Takes the values and slopes at a: P_k' = (k+1)/2 P_{k−1}^{(1,1)} in 2a − 1, twice that in a.
    pub(super) fn at(&mut self, a: f64) {
        let x = 2.0 * a - 1.0;
        fill_jacobi(0.0, 0.0, x, &mut self.values);
        if let Some((first, inner)) = self.slopes.split_first_mut() {
            *first = 0.0;
            fill_jacobi(1.0, 1.0, x, inner);
        }
        for (k, (value, slope)) in self.values.iter_mut().zip(&mut self.slopes).enumerate() {
            let unit = (2.0 * k as f64 + 1.0).sqrt();
            *value *= unit;
            *slope *= unit * (k as f64 + 1.0);
        }
    }
}

/// values\[m\] ← P_m^{(α,β)}(x), by the recurrence.
fn fill_jacobi(alpha: f64, beta: f64, x: f64, values: &mut [f64]) {
    let (mut before, mut last) = (0.0, 1.0);
    for (m, value) in values.iter_mut().enumerate() {
        let n = m as f64;
        let sum = 2.0 * n + alpha + beta;
        let next = match m {
            0 => 1.0,
            1 => 0.5 * (alpha - beta + (alpha + beta + 2.0) * x),
            _ => {
                // The quotient first: it need not wait for the terms before.
                let over = 1.0 / (2.0 * n * (n + alpha + beta) * (sum - 2.0));
                let first = (sum - 1.0) * (sum * (sum - 2.0) * x + alpha * alpha - beta * beta);
                let second = 2.0 * (n + alpha - 1.0) * (n + beta - 1.0) * sum;
                (first * over) * last - (second * over) * before
            }
        };
        (before, last) = (last, next);
        *value = next;
    }
}

/// values\[m\] ← R_km(τ).
fn fill_radial(k: usize, tau: f64, values: &mut [f64]) {
    fill_jacobi(0.0, 2.0 * k as f64 + 1.0, 2.0 * tau - 1.0, values);
    let power = tau.powi(k as i32);
    values.iter_mut().enumerate().for_each(|(m, value)| *value *= unit(k, m) * power);
}

/// slopes\[m\] ← R_km'(τ); values\[m\] ← R_km(τ).
fn fill_radial_slopes(k: usize, tau: f64, values: &mut [f64], slopes: &mut [f64]) {
    let beta = 2.0 * k as f64 + 1.0;
    if let Some((first, inner)) = slopes.split_first_mut() {
        *first = 0.0;
        fill_jacobi(1.0, beta + 1.0, 2.0 * tau - 1.0, inner);
    }
    fill_jacobi(0.0, beta, 2.0 * tau - 1.0, values);
    let power = tau.powi(k as i32);
    let slope_of_power = if k == 0 { 0.0 } else { k as f64 * tau.powi(k as i32 - 1) };
    for (m, (value, slope)) in values.iter_mut().zip(slopes).enumerate() {
        *slope = unit(k, m) * (slope_of_power * *value + power * (m as f64 + beta + 1.0) * *slope);
        *value *= unit(k, m) * power;
    }
}

/// The factor of R_km.
fn unit(k: usize, m: usize) -> f64 {
    (2.0 * (m + k) as f64 + 2.0).sqrt()
}

/// The polynomials of a degree, in the order of [`Polynomials::index`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Polynomials(pub(super) usize);

impl Polynomials {
    /// Pairs (k, m) with k + m at most the degree.
    pub(super) fn index(self) -> Vec<(usize, usize)> {
        (0..=self.0).flat_map(|k| (0..=self.0 - k).map(move |m| (k, m))).collect()
    }

    /// R_km(τ) in that order.
    pub(super) fn radials(self, tau: f64) -> Vec<f64> {
        let mut values = vec![0.0; self.count()];
        let mut rest = &mut values[..];
        for k in 0..=self.0 {
            let (these, others) = rest.split_at_mut(self.0 + 1 - k);
            fill_radial(k, tau, these);
            rest = others;
        }
        values
    }

    /// R_km(τ) and R_km'(τ) in that order.
    fn radials_with_slopes(self, tau: f64) -> [Vec<f64>; 2] {
        let (mut values, mut slopes) = (vec![0.0; self.count()], vec![0.0; self.count()]);
        let mut rest = (&mut values[..], &mut slopes[..]);
        for k in 0..=self.0 {
            let (these, others) = rest.0.split_at_mut(self.0 + 1 - k);
            let (their, other_slopes) = rest.1.split_at_mut(self.0 + 1 - k);
            fill_radial_slopes(k, tau, these, their);
            rest = (others, other_slopes);
        }
        [values, slopes]
    }

    fn count(self) -> usize {
        (self.0 + 1) * (self.0 + 2) / 2
    }

    /// R_km(τ) − R_km(τ(1−ε)) without cancellation: where the two are close, the integral of the slope.
    pub(super) fn radial_differences(self, tau: f64, epsilon: f64) -> Result<Vec<f64>> {
        if epsilon > CLOSE {
            let (here, there) = (self.radials(tau), self.radials(tau * (1.0 - epsilon)));
            return Ok(here.iter().zip(there).map(|(a, b)| a - b).collect());
        }
        let mut sum = vec![0.0; self.count()];
        for (t, w) in Rule::gauss_legendre(SLOPES)?.iter() {
            let [_, slopes] = self.radials_with_slopes(tau * (1.0 - epsilon * t));
            sum.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += tau * epsilon * w * slope);
        }
        Ok(sum)
    }

    /// All values at a point, seen from a corner.
    pub(super) fn values(self, shape: &TriangleShape, apex: usize, beta: Barycentric) -> Vec<f64> {
        let (tau, a) = collapsed(apex, beta);
        let p = Angular::new(self.0 + 1, a).values;
        let unit = shape.twice().sqrt();
        self.index().iter().zip(self.radials(tau)).map(|((k, _), r)| p[*k] * r / unit).collect()
    }

    /// All gradients at a point other than the first corner, seen from that corner.
    pub(super) fn gradients(self, shape: &TriangleShape, beta: Barycentric) -> Vec<[f64; 2]> {
        let (tau, a) = collapsed(0, beta);
        let Angular { values: p, slopes } = Angular::new(self.0 + 1, a);
        let unit = shape.twice().sqrt();
        let [along, across] = directions(shape, 0, a);
        let [radials, radial_slopes] = self.radials_with_slopes(tau);
        self.index()
            .iter()
            .zip(radials.iter().zip(&radial_slopes))
            .map(|((k, _), (r, slope))| {
                let (first, second) = (slope * p[*k] / unit, r / tau * slopes[*k] / unit);
                [0, 1].map(|c| first * along[c] + second * across[c])
            })
            .collect()
    }
}

/// ∇τ and τ∇a.
fn directions(shape: &TriangleShape, apex: usize, a: f64) -> [[f64; 2]; 2] {
    let (b, c) = (shape.gradients()[(apex + 1) % 3], shape.gradients()[(apex + 2) % 3]);
    let along = [b[0] + c[0], b[1] + c[1]];
    [along, [c[0] - a * along[0], c[1] - a * along[1]]]
}

/// τ^μ P_k(a) for k < count, about every corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Powers {
    pub(super) exponent: f64,
    pub(super) count: usize,
}

impl Powers {
    pub(super) fn values(self, apex: usize, beta: Barycentric) -> Vec<f64> {
        let (tau, a) = collapsed(apex, beta);
        let power = tau.powf(self.exponent);
        Angular::new(self.count, a).values.into_iter().map(|p| power * p).collect()
    }

    pub(super) fn gradients(
        self,
        shape: &TriangleShape,
        apex: usize,
        beta: Barycentric,
    ) -> Vec<[f64; 2]> {
        let mut out = vec![[0.0; 2]; self.count];
        self.fill_gradients(shape, apex, beta, &mut Angular::new(self.count, 0.5), &mut out);
        out
    }

    /// As [`Powers::gradients`], without new room.
    pub(super) fn fill_gradients(
        self,
        shape: &TriangleShape,
        apex: usize,
        beta: Barycentric,
        angular: &mut Angular,
        out: &mut [[f64; 2]],
    ) {
        let (tau, a) = collapsed(apex, beta);
        let power = tau.powf(self.exponent - 1.0);
        self.fill_angular_gradients(shape, apex, a, angular, out);
        out.iter_mut().for_each(|g| *g = g.map(|x| power * x));
    }

    /// τ^{1−μ} times the gradients.
    pub(super) fn angular_gradients(
        self,
        shape: &TriangleShape,
        apex: usize,
        a: f64,
    ) -> Vec<[f64; 2]> {
        let mut out = vec![[0.0; 2]; self.count];
        self.fill_angular_gradients(shape, apex, a, &mut Angular::new(self.count, a), &mut out);
        out
    }

    fn fill_angular_gradients(
        self,
        shape: &TriangleShape,
        apex: usize,
        a: f64,
        angular: &mut Angular,
        out: &mut [[f64; 2]],
    ) {
        angular.at(a);
        let [along, across] = directions(shape, apex, a);
        for (out, (p, slope)) in out.iter_mut().zip(angular.values.iter().zip(&angular.slopes)) {
            *out = [0, 1].map(|c| self.exponent * p * along[c] + slope * across[c]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::shape::barycentric;
    use super::*;
    use crate::quadrature::Rule;

    #[test]
    fn orthonormal_with_slopes_that_are_slopes() {
        let shape = TriangleShape::new([[0.0, 0.0], [2.0, 0.3], [0.4, 1.1]]).unwrap().unit();
        let (set, apex) = (Polynomials(5), 1);
        let (radial, across) =
            (Rule::gauss_jacobi(8, 0.0, 1.0).unwrap(), Rule::gauss_legendre(8).unwrap());
        let count = set.index().len();
        let mut gram = vec![0.0; count * count];
        for (tau, v) in radial.iter() {
            for (a, w) in across.iter() {
                let values = set.values(&shape, apex, barycentric(apex, tau, a));
                for i in 0..count {
                    for j in 0..count {
                        gram[i * count + j] += shape.twice() * v * w * values[i] * values[j];
                    }
                }
            }
        }
        for i in 0..count {
            for j in 0..count {
                let exact = if i == j { 1.0 } else { 0.0 };
                assert!((gram[i * count + j] - exact).abs() < 1e-13, "{i} {j}");
            }
        }
        let (beta, step) = ([0.3, 0.25, 0.45], 1e-6);
        let powers = Powers { exponent: 0.7, count: 4 };
        let moved = |c: usize, h: f64| [0, 1, 2].map(|k| beta[k] + h * shape.gradients()[k][c]);
        for c in 0..2 {
            let (up, down) = (moved(c, step), moved(c, -step));
            let of = |beta| [set.values(&shape, 0, beta), powers.values(2, beta)].concat();
            let slopes = [set.gradients(&shape, beta), powers.gradients(&shape, 2, beta)].concat();
            for ((up, down), slope) in of(up).iter().zip(of(down)).zip(slopes) {
                assert!(((up - down) / (2.0 * step) - slope[c]).abs() < 1e-8);
            }
        }
    }
}
