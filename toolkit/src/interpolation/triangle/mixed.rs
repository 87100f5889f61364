//! Integrals of powers about two different corners A and B.
//!
//! Seen from A, with x farther away: τ, a as in [`super::shape`], ε = 1 − q and a distance |a − b|, the
//! larger of which is ξ: the kernel times dq db is ξ^{1−2s} times a smooth factor. Singularities at B (τ = 1,
//! a = 0, ξ = 0) are smoothed by the substitutions 1 − τ = t³, a = t³ and one of third order for ξ, those at
//! A (q = 0) by the third order of 1 − ξ. With 14 points in each direction the relative error is 1e-9.

use super::basis::{Angular, Powers};
use super::shape::{TriangleShape, barycentric, dot};
use crate::Order;
use crate::error::Result;
use crate::quadrature::Rule;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// Number of points in each direction.
const POINTS: usize = 14;
/// m.
const GRADE: i32 = 3;

/// Nodes t^m on (0, 1) with their weights.
fn graded(count: usize) -> Result<Vec<(f64, f64)>> {
    let slope = |t: f64| f64::from(GRADE) * t.powi(GRADE - 1);
    Ok(Rule::gauss_legendre(count)?.iter().map(|(t, w)| (t.powi(GRADE), w * slope(t))).collect())
}

/// A rule for ∫_T, graded to all corners: barycentric coordinates and weights.
///
/// # Errors
/// None.
pub(super) fn corner_rule(
    shape: &TriangleShape,
    apex: usize,
    count: usize,
) -> Result<Vec<([f64; 3], f64)>> {
    let half = graded(count)?;
    let both: Vec<[f64; 3]> = half
        .iter()
        .flat_map(|(t, w)| [[0.5 * t, 1.0 - 0.5 * t, 0.5 * w], [1.0 - 0.5 * t, 0.5 * t, 0.5 * w]])
        .collect();
    let point = |&[tau, rest, v]: &[f64; 3], &[a, b, w]: &[f64; 3]| {
        let mut beta = [rest; 3];
        beta[(apex + 1) % 3] = tau * b;
        beta[(apex + 2) % 3] = tau * a;
        (beta, shape.twice() * tau * v * w)
    };
    Ok(both.iter().flat_map(|x| both.iter().map(move |y| point(x, y))).collect())
}

/// ∫∫ (∇v(x)−∇v(y))·(∇w(x)−∇w(y)) |x−y|^{-2-2s} for powers v about `apex` and w about the next corner.
///
/// # Errors
/// As the rules.
pub(super) fn between(
    shape: &TriangleShape,
    apex: usize,
    order: Order,
    powers: Powers,
) -> Result<DMatrix<f64>> {
    let [f, t] = shape.frame(apex);
    let (ff, ft, tt) = (dot(f, f), dot(f, t), dot(t, t));
    let (s, other) = (order.value(), (apex + 1) % 3);
    let weight_power = 2.0 * order.complement() - 1.0;
    let power = 3.0 * weight_power + 2.0;
    let (weighted, plain) =
        (Rule::gauss_jacobi(POINTS, 0.0, power)?, Rule::gauss_legendre(POINTS)?);
    let graded = graded(POINTS)?;
    let outer: Vec<[f64; 4]> = weighted
        .iter()
        .flat_map(|(x, v)| {
            // ξ = x³ (10 − 15 x + 6 x²), and 1 − ξ is the same in 1 − x.
            let step = |x: f64| x.powi(3) * (10.0 - 15.0 * x + 6.0 * x * x);
            let (xi, rest, slope) = (step(x), step(1.0 - x), 30.0 * (x * (1.0 - x)).powi(2));
            let v = v * slope * x.powf(-power) * xi;
            plain.iter().map(move |(c, w)| [xi, rest, c, v * w]).collect::<Vec<_>>()
        })
        .collect();
    // τ and its weight
    let radial: Vec<(f64, f64)> = graded
        .iter()
        .map(|&(rest, along)| {
            (1.0 - rest, along * (1.0 - rest).powf(weight_power + powers.exponent - 1.0))
        })
        .collect();
    let part = |&[xi, last, c, w]: &[f64; 4]| -> DMatrix<f64> {
        let mut sum = DMatrix::<f64>::zeros(powers.count, powers.count);
        let mut room = Angular::new(powers.count, 0.5);
        let (mut here, mut far) = (vec![[0.0; 2]; powers.count], vec![[0.0; 2]; powers.count]);
        // ε, q and the distance
        for (epsilon, q, distance) in [(xi, last, xi * c), (xi * c, 1.0 - xi * c, xi)] {
            let first = w * 2.0 * shape.twice().powi(2) * q;
            let there = q.powf(powers.exponent - 1.0);
            for &(low, across) in &graded {
                let low = (1.0 - distance) * low;
                for sign in [1.0, -1.0] {
                    let (a, b) =
                        if sign > 0.0 { (low, low + distance) } else { (low + distance, low) };
                    let c = epsilon * b - sign * distance;
                    let kappa = epsilon * epsilon * ff + 2.0 * epsilon * c * ft + c * c * tt;
                    let weight = first * across * (1.0 - distance) * kappa.powf(-1.0 - s);
                    let angular = |a: f64| powers.angular_gradients(shape, apex, a);
                    // τ^{1−μ} times the difference of a power about the first corner.
                    let mine: Vec<[f64; 2]> = angular(a)
                        .iter()
                        .zip(angular(b))
                        .map(|(u, v)| [u[0] - there * v[0], u[1] - there * v[1]])
                        .collect();
                    for &(tau, along) in &radial {
                        let weight = weight * along;
                        let (x, y) = (barycentric(apex, tau, a), barycentric(apex, tau * q, b));
                        powers.fill_gradients(shape, other, x, &mut room, &mut here);
                        powers.fill_gradients(shape, other, y, &mut room, &mut far);
                        for (j, (u, v)) in here.iter().zip(&far).enumerate() {
                            let difference = [weight * (u[0] - v[0]), weight * (u[1] - v[1])];
                            for (sum, mine) in sum.column_mut(j).iter_mut().zip(&mine) {
                                *sum += dot(*mine, difference);
                            }
                        }
                    }
                }
            }
        }
        sum
    };
    let zero = || DMatrix::zeros(powers.count, powers.count);
    Ok(outer.par_iter().map(part).reduce(zero, |a, b| a + b))
}
