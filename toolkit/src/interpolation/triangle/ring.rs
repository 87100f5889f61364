//! The part of the double integral over directions: for x = (τ, a), y = (τq, b) seen from a corner A,
//!
//! |x − y|² = τ² κ, κ = ε² |f|² + 2 ε c f·t + c² |t|², ε = 1 − q, c = ε b − (b − a), f = B − A, t = C − B.
//!
//! w = R(τ) P(a) has w(x) − w(y) = (R(τ) − R(τq)) P(a) + R(τq) (P(a) − P(b)): with the matrices of
//! P_k(a)P_l(a), P_k(a)(P_l(a) − P_l(b)) and (P_k(a) − P_k(b))(P_l(a) − P_l(b)) over a and b with the
//! weight κ^{-1-s} the integral over τ and q remains, without cancellation. Near ε = 0 the kernel is
//! concentrated on |a − b| of size ε, so that the cells grow away from 0. Gauss rules: geometric
//! convergence in the number of points.

use super::shape::{TriangleShape, dot};
use crate::Order;
use crate::error::Result;
use crate::numeric::dense::times_transpose;
use crate::numeric::legendre;
use crate::quadrature::Rule;
use nalgebra::DMatrix;

/// Ratio of neighbouring cells in ε.
const SHRINK: f64 = 0.15;
/// Number of cells towards ε = 0 and towards q = 0.
const TOWARDS_ONE: i32 = 9;
const TOWARDS_ZERO: i32 = 6;
/// Number of points on each cell.
const POINTS: usize = 10;
/// Cells in |a − b| grow by this, beyond the first of length ε.
const GROWTH: f64 = 3.0;
/// Points in |a − b| on each, and in a beyond the number of polynomials.
const ACROSS: usize = 14;
const MORE: usize = 5;

/// Nodes ε = 1 − q and weights of ∫₀¹ dq for integrands ε^{1−2s} times a smooth one near ε = 0.
///
/// # Errors
/// None for an order in (0, 1).
pub(super) fn nodes(order: Order) -> Result<Vec<(f64, f64)>> {
    let plain = Rule::gauss_legendre(POINTS)?;
    let cut = |k: i32| 0.5 * SHRINK.powi(k);
    let mut nodes = Vec::new();
    for (count, is_one) in [(TOWARDS_ONE, true), (TOWARDS_ZERO, false)] {
        let at = |x: f64| if is_one { x } else { 1.0 - x };
        for k in 0..count {
            let (low, width) = (cut(k + 1), cut(k) - cut(k + 1));
            nodes.extend(plain.iter().map(|(t, w)| (at(low + width * t), w * width)));
        }
        let last = cut(count);
        if is_one {
            let power = 2.0 * order.complement() - 1.0;
            let weighted = Rule::gauss_jacobi(POINTS, 0.0, power)?;
            nodes.extend(weighted.iter().map(|(t, w)| (last * t, w * last * t.powf(-power))));
        } else {
            nodes.extend(plain.iter().map(|(t, w)| (at(last * t), w * last)));
        }
    }
    Ok(nodes)
}

/// The matrix over (P_0(a) ..., P_0(a) − P_0(b) ...), `count` of each.
///
/// # Errors
/// None.
pub(super) fn directions(
    shape: &TriangleShape,
    apex: usize,
    order: Order,
    count: usize,
    epsilon: f64,
) -> Result<DMatrix<f64>> {
    let [f, t] = shape.frame(apex);
    let (ff, ft, tt) = (dot(f, f), dot(f, t), dot(t, t));
    let (across, along) =
        (Rule::gauss_legendre(ACROSS.max(count + 2))?, Rule::gauss_legendre(count + MORE)?);
    let mut cuts = vec![0.0, epsilon.min(1.0)];
    while cuts[cuts.len() - 1] < 1.0 {
        let next = GROWTH * cuts[cuts.len() - 1];
        cuts.push(if next < 0.9 { next } else { 1.0 });
    }
    let size = 2 * (cuts.len() - 1) * across.points().len() * along.points().len();
    let mut rows = DMatrix::<f64>::zeros(2 * count, size);
    let (mut here, mut quotients) = (vec![0.0; count], vec![0.0; count]);
    let mut at = 0;
    for cell in cuts.windows(2) {
        for (x, v) in across.iter() {
            let distance = cell[0] + (cell[1] - cell[0]) * x;
            let rest = 1.0 - distance;
            for (y, w) in along.iter() {
                let weight = v * (cell[1] - cell[0]) * w * rest;
                for sign in [1.0, -1.0] {
                    let low = rest * y;
                    let (a, b) =
                        if sign > 0.0 { (low, low + distance) } else { (low + distance, low) };
                    let c = epsilon * b - sign * distance;
                    let kappa = epsilon * epsilon * ff + 2.0 * epsilon * c * ft + c * c * tt;
                    let root = (weight * (-(1.0 + order.value()) * kappa.ln()).exp()).sqrt();
                    legendre::fill_with_quotients(
                        &mut here,
                        &mut quotients,
                        2.0 * a - 1.0,
                        2.0 * b - 1.0,
                    );
                    let (values, differences) = rows.as_mut_slice()
                        [2 * count * at..2 * count * (at + 1)]
                        .split_at_mut(count);
                    let across = -2.0 * sign * distance * root;
                    values.iter_mut().zip(&here).for_each(|(row, p)| *row = root * p);
                    differences.iter_mut().zip(&quotients).for_each(|(row, q)| *row = across * q);
                    at += 1;
                }
            }
        }
    }
    let product = times_transpose(&rows, &rows);
    let unit = |k: usize| (2.0 * (k % count) as f64 + 1.0).sqrt();
    Ok(DMatrix::from_fn(2 * count, 2 * count, |i, j| unit(i) * unit(j) * product[(i, j)]))
}
