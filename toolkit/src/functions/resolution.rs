//! Estimates of the variation of a function between its sample points.
//!
//! Let e = u − p on cells K of lengths h of an interval of length L, p a polynomial of degree d, and ε =
//! ε_K = max |e| sampled between the points of p. With D = 2(d+2)², Markov's bound for the slope of a
//! polynomial of degree d + 2 of size 1 on an interval of length 1, pairs with |x−y| < h/D have |e(x)−e(y)| ≤
//! ε D |x−y|/h if e is such a polynomial, and all others (e(x)−e(y))² ≤ 2e(x)² + 2e(y)². So
//!
//! |e|²_ν ≤ Σ_K h ε² h^{-2ν} D^{2ν} (2/(2−2ν) + 8 (1 − (h/(DL))^{2ν})/(2ν)).
//!
//! A rule of d + 1 Gauss points integrates p² exactly, and ∫ pe nearly so, e being orthogonal to low
//! degrees: its error in |u|²_ν is of the size |e|²_ν. Two rules that both miss most of an oscillation may
//! agree by accident, but their ε is as large as the oscillation.

use super::function::SingularFunction;
use super::level::Level;
use crate::error::Result;
use crate::kernel::power::{PowerKernel, expm1_over};
use crate::numeric::legendre;
use crate::quadrature::Rule;

/// Depth down to which cells are examined: oscillations in ln δ are expected to begin above it.
const DEEPEST: f64 = 45.0;

/// Rounding error of the projection of a smooth function, in ulps of the largest value per point of a rule.
const ROUNDING: f64 = 3.0;

/// Ratio of the residual at the samples to that between the points of a rule, from which it is not due to the position
/// of these points.
const UNSEEN: f64 = 8.0;

/// The contribution of one cell to the bound of |e|²_ν.
pub(crate) fn of_residual(
    kernel: PowerKernel,
    degree: usize,
    residual: f64,
    length: f64,
    total: f64,
) -> f64 {
    let steep = 2.0 * ((degree + 2) as f64).powi(2);
    let beyond = expm1_over(-kernel.twice, (steep * total / length).ln());
    let near = residual * residual * kernel.scaling(length) * steep.powf(kernel.twice);
    near * (2.0 / kernel.two_minus + 8.0 * beyond)
}

/// The error of the rules of a level in |u|²_ν, in the unit of u, with the number of evaluations.
pub(super) fn missed(
    u: &SingularFunction,
    level: Level,
    kernel: PowerKernel,
) -> Result<(f64, u64)> {
    let n = level.points;
    let (rule, between) = (Rule::gauss_legendre(n)?, Rule::gauss_legendre(n + 1)?);
    let polynomials = |rule: &Rule| -> Vec<Vec<f64>> {
        let at = |t: &f64| {
            let mut values = vec![0.0; n];
            legendre::fill(&mut values, 2.0 * t - 1.0);
            values
        };
        rule.points().iter().map(at).collect()
    };
    let (at_points, at_others) = (polynomials(&rule), polynomials(&between));
    let (mut sum, mut points) = (0.0, 0);
    for arm in u.arms() {
        // Closer to a break that is not 0, x is rounded to less than half its digits.
        let cells = (DEEPEST.min(0.5 * arm.depth) / level.width).ceil().max(1.0) as usize;
        for cell in 0..cells {
            let start = cell as f64 * level.width;
            let value = |t: &f64| {
                let t = start + level.width * t;
                u.along(&arm, t, arm.delta(t))
            };
            let (mut coefficients, mut largest) = (vec![0.0; n], 0.0_f64);
            for ((t, w), row) in rule.iter().zip(&at_points) {
                let value = value(&t)?;
                largest = largest.max(value.abs());
                let weighted = w * value;
                for (k, (coefficient, p)) in coefficients.iter_mut().zip(row).enumerate() {
                    *coefficient += (2 * k + 1) as f64 * weighted * p;
                }
            }
            let mut residual = 0.0_f64;
            for (t, row) in between.points().iter().zip(&at_others) {
                let p: f64 = coefficients.iter().zip(row).map(|(c, p)| c * p).sum();
                residual = residual.max((value(t)? - p).abs());
            }
            // What no point of the rules meets.
            let (near, far) = (arm.delta(start + level.width), arm.delta(start));
            let mut row = vec![0.0; n];
            let off = |(delta, value): (f64, f64)| {
                let t = ((arm.length / delta).ln() - start) / level.width;
                legendre::fill(&mut row, 2.0 * t - 1.0);
                (value - coefficients.iter().zip(&row).map(|(c, p)| c * p).sum::<f64>()).abs()
            };
            let unseen = u.seen_within(&arm, near, far).map(off).fold(0.0, f64::max);
            if unseen > UNSEEN * residual {
                residual = unseen;
            }
            // Rounding is no wave, and counted where the rules are; here h^{1−2ν} would blow it up.
            residual = (residual - ROUNDING * n as f64 * f64::EPSILON * largest).max(0.0);
            let length = arm.delta(start) - arm.delta(start + level.width);
            sum += of_residual(kernel, n - 1, residual, length, u.length());
            points += (2 * n + 1) as u64;
        }
    }
    Ok((sum, points))
}

/// The error of the rules of a level in ∫ f(u): on every cell the difference from a rule with one more point.
pub(super) fn missed_of_integral(
    u: &SingularFunction,
    level: Level,
    f: impl Fn(f64) -> f64,
) -> Result<f64> {
    let rules = [Rule::gauss_legendre(level.points)?, Rule::gauss_legendre(level.points + 1)?];
    let mut missed = 0.0;
    for arm in u.arms() {
        let cells = (DEEPEST.min(0.5 * arm.depth) / level.width).ceil().max(1.0) as usize;
        for cell in 0..cells {
            let mut sums = [0.0; 2];
            for (sum, rule) in sums.iter_mut().zip(&rules) {
                for (t, w) in rule.iter() {
                    let t = level.width * (cell as f64 + t);
                    let delta = arm.delta(t);
                    *sum += w * delta * f(u.along(&arm, t, delta)?);
                }
            }
            missed += level.width * (sums[1] - sums[0]).abs();
        }
    }
    Ok(missed)
}
