//! Rules in the distance ρ in (0, 1) from a corner, for squares of differences and for functions.
//!
//! Near a corner a difference of two values on the ray from it is ρ^a times an analytic function D of ρ. A
//! Gauss-Jacobi rule with the weight ρ^{2(a+1−s)−1} therefore integrates ρ^{1−2s} (ρ^a D)² over all of (0, 1),
//! however close a is to s − 1. If D is not analytic at 0, cells [e^{-w(k+1)}, e^{-wk}] with Gauss rules in ln
//! ρ are used first, and the weighted rule for the remainder.

use crate::error::Result;
use crate::order::Order;
use crate::quadrature::Rule;

/// Points and weights.
pub(super) type Points = Vec<(f64, f64)>;

/// Width of a cell in ln ρ.
pub(super) const CELL: f64 = 2.5;
/// Smallest β + 1 for which no Gauss-Jacobi point rounds to 0.
const CLOSE: f64 = 0.3;

/// Largest depth: e^{-640} and its square root times 1e-100 are in the range of binary64.
const DEEPEST: f64 = 640.0;

/// The radial rule at a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Approach {
    /// Number of cells in ln ρ before the weighted rule.
    pub(super) cells: usize,
    /// Number of points of every rule.
    pub(super) points: usize,
}

/// A rule for the weight t^{(β+1)−1}, given β + 1 > 0; with twice the points if they are extrapolated to 0.
pub(super) fn weighted(n: usize, beta_plus_one: f64) -> Result<Points> {
    Ok(if beta_plus_one < CLOSE {
        Rule::power_weight(2 * n, beta_plus_one)?.iter().collect()
    } else {
        Rule::gauss_jacobi(n, 0.0, beta_plus_one - 1.0)?.iter().collect()
    })
}

/// A rule for ∫₀¹ ρ^{p−1} f dρ, f = ρ^{e} times an analytic function, p + e > 0: `power` is p, `extra` e.
pub(super) fn rule(power: f64, extra: f64, approach: Approach) -> Result<Points> {
    let mut points = cells(power, CELL * approach.cells as f64, approach.points)?;
    let end = (-CELL * approach.cells as f64).exp();
    let last = end.powf(power);
    points.extend(
        weighted(approach.points, power + extra)?
            .into_iter()
            .map(|(t, w)| (end * t, last * w * t.powf(-extra))),
    );
    Ok(points)
}

/// A rule for ∫ ρ^{p−1} f dρ over e^{-depth} < ρ < 1, by cells of ln ρ.
pub(super) fn cells(power: f64, depth: f64, points: usize) -> Result<Points> {
    let count = (depth / CELL).ceil();
    let width = depth / count.max(1.0);
    let rule = Rule::gauss_legendre(points.max(1))?;
    let cell = |k: usize| {
        rule.iter().map(move |(t, w)| {
            let depth = width * (k as f64 + t);
            ((-depth).exp(), w * width * (-power * depth).exp())
        })
    };
    Ok((0..count as usize).flat_map(cell).collect())
}

/// The depth −ln ρ down to which cells are needed, where ρ² and ρ^{2+2a} fall below e^{-digits}; limited by the
/// range of binary64 for ρ and ρ^a.
pub(super) fn depth(digits: f64, exponent: f64) -> f64 {
    let a = exponent.min(0.0);
    (digits / (2.0 + 2.0 * a)).min(DEEPEST / (1.0 - a))
}

/// The truncation error beyond that depth, relative to the whole integral.
pub(super) fn left_out(digits: f64, exponent: f64) -> f64 {
    (-depth(digits, exponent) * (2.0 + 2.0 * exponent.min(0.0))).exp()
}

/// The rule for squares of differences at a corner with exponent a: ∫₀¹ ρ^{1−2s} Δ(ρ)² dρ.
pub(super) fn for_differences(order: Order, exponent: f64, approach: Approach) -> Result<Points> {
    rule(2.0 * order.complement(), 2.0 * exponent, approach)
}
