//! An upper bound of both constants in closed form up to one integral for every corner.
//!
//! T has longest edge 1, g = ∇u, γ = g − mean g, L the linear function with the mean and mean gradient of u.
//! - ‖γ‖² = ∫∫|g(x) − g(y)|²/(2|T|) ≤ P² |g|_s², P² = 1/(2|T|), as |x − y| ≤ 1.
//! - T_k = A + 2^{-k}(T − A), φ_k the value at A of the function L of T_k: φ_0 = L(A), φ_k → u(A). With z, τ
//!   as in [`super::shape`] and c the centre of T, φ_0 − φ_1 = ∫_T γ·k, k = (z − A)(max(τ, 1/2)^{-2} −
//!   1)/(2|T|) + 1_{τ<1/2} 2(c − A)/|T|: for ℓ = u − L average ℓ(x) − ℓ(A + (x−A)/2) = ∫_{1/2}^1 γ(A +
//!   t(x−A))·(x−A) dt over x. So |φ_0 − φ_1| ≤ N P |g|_s, N = ‖k − mean k‖, and scaled, |φ_k − φ_{k+1}| ≤
//!   2^{-ks} N P |g|_s: |u(A) − L(A)| ≤ E_A |g|_s, E_A = N P/(1 − 2^{-s}).
//! - u − Iu = (u − L) − I(u − L); γ has mean 0, so that the squared gradients add up: ‖∇(u − Iu)‖² ≤ (P² +
//!   |T| max |Σ ±E_A ∇β_A|²) |g|_s². In L²: ‖u − L‖ ≤ P/π |g|_s (Payne & Weinberger 1960) and ‖Σ e_A β_A‖² =
//!   |T|/12 (Σ e² + (Σ e)²), largest for e = E.
//!
//! Finite for every s > 0, growing like 1/s as s → 0; near s = 1 it does not account for the growth of
//! |g|_s.

use super::shape::TriangleShape;
use crate::Order;
use crate::error::Result;
use crate::quadrature::Rule;
use std::f64::consts::PI;

/// k is a polynomial over τ²: analytic on both halves.
const POINTS: usize = 20;
/// Relative rounding error of the result.
const ROUNDING: f64 = 1e-12;

/// Upper bounds of sup ‖∇(u − Iu)‖/|∇u|_s and sup ‖u − Iu‖/|∇u|_s for a triangle with longest edge 1.
///
/// # Errors
/// None.
pub(super) fn bounds(shape: &TriangleShape, order: Order) -> Result<[f64; 2]> {
    let area = 0.5 * shape.twice();
    let poincare = (0.5 / area).sqrt();
    let series = -(-std::f64::consts::LN_2 * order.value()).exp_m1();
    let mut at = [0.0; 3];
    for (apex, at) in at.iter_mut().enumerate() {
        *at = kernel(shape, apex)? * poincare / series;
    }
    let mut slope = 0f64;
    for signs in [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0]] {
        let of = |c: usize| (0..3).map(|k| signs[k] * at[k] * shape.gradients()[k][c]).sum::<f64>();
        slope = slope.max(of(0).powi(2) + of(1).powi(2));
    }
    let (sum, squares): (f64, f64) = (at.iter().sum(), at.iter().map(|e| e * e).sum());
    let derivative = (poincare * poincare + area * slope).sqrt();
    let l2 = poincare / PI + (area / 12.0 * (squares + sum * sum)).sqrt();
    Ok([derivative, l2].map(|bound| bound * (1.0 + ROUNDING)))
}

/// The norm N for a corner.
fn kernel(shape: &TriangleShape, apex: usize) -> Result<f64> {
    let area = 0.5 * shape.twice();
    let [f, t] = shape.frame(apex);
    let centre = [0, 1].map(|c| (2.0 * f[c] + t[c]) / 3.0);
    let rule = Rule::gauss_legendre(POINTS)?;
    let (mut mean, mut square) = ([0.0; 2], 0.0);
    for half in [0.0, 0.5] {
        for (x, v) in rule.iter() {
            let tau = half + 0.5 * x;
            for (a, w) in rule.iter() {
                let weight = shape.twice() * tau * 0.5 * v * w;
                let along = (tau.max(0.5).powi(-2) - 1.0) / (2.0 * area);
                let inner = if half == 0.0 { 2.0 / area } else { 0.0 };
                let k = [0, 1].map(|c| along * tau * (f[c] + a * t[c]) + inner * centre[c]);
                mean = [mean[0] + weight * k[0], mean[1] + weight * k[1]];
                square += weight * (k[0] * k[0] + k[1] * k[1]);
            }
        }
    }
    Ok((square - (mean[0] * mean[0] + mean[1] * mean[1]) / area).sqrt())
}
