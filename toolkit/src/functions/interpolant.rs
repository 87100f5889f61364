//! Chebyshev interpolants of a function along a side, in τ = ln t, and their divided differences.

use super::arm::Arm;
use super::function::SingularFunction;
use crate::error::Result;
use std::f64::consts::PI;

/// Share of the largest varying coefficient at which the last ones are negligible.
const SHARE: f64 = 1e-12;

/// A Chebyshev interpolant on (from, from + width) of τ.
pub(super) struct Interpolant {
    pub(super) coefficients: Vec<f64>,
    pub(super) largest: f64,
}

impl Interpolant {
    /// The interpolant through n points on (from, from + width).
    pub(super) fn new(
        u: &SingularFunction,
        arm: &Arm,
        from: f64,
        width: f64,
        n: usize,
    ) -> Result<Self> {
        let angles: Vec<f64> = (0..n).map(|j| PI * (j as f64 + 0.5) / n as f64).collect();
        let values = angles
            .iter()
            .map(|angle| u.at_depth(arm, (from + 0.5 * width * (1.0 + angle.cos())).exp()))
            .collect::<Result<Vec<f64>>>()?;
        let coefficients = (0..n)
            .map(|k| {
                let sum: f64 =
                    angles.iter().zip(&values).map(|(a, v)| v * (k as f64 * a).cos()).sum();
                sum * if k == 0 { 1.0 } else { 2.0 } / n as f64
            })
            .collect();
        Ok(Self { coefficients, largest: values.iter().fold(0.0, |m, v| v.abs().max(m)) })
    }

    /// True if the last coefficients, in the derivative, are below rounding or below `SHARE` of the largest one.
    pub(super) fn is_resolved(&self) -> bool {
        let Some((_, varying)) = self.coefficients.split_first() else { return true };
        let terms = varying.len() as f64;
        let size =
            |coefficients: &[f64]| coefficients.iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let last = terms * size(&varying[varying.len().saturating_sub(2)..]);
        last <= SHARE * size(varying) || last <= f64::EPSILON * terms.powf(1.5) * self.largest
    }

    /// The divided difference (p(x) − p(y))/(x − y).
    pub(super) fn divided_difference(&self, x: f64, y: f64) -> f64 {
        let (mut before, mut current) = (0.0, 1.0);
        let (mut chebyshev_before, mut chebyshev) = (1.0, y);
        let mut sum = 0.0;
        for c in &self.coefficients[1..] {
            sum += c * current;
            (before, current) = (current, 2.0 * (x * current + chebyshev) - before);
            (chebyshev_before, chebyshev) = (chebyshev, 2.0 * y * chebyshev - chebyshev_before);
        }
        sum
    }

    /// The difference p(x) − q(x), exactly zero for equal p and q.
    pub(super) fn minus(&self, other: &Self, x: f64) -> f64 {
        let (mut before, mut current, mut sum) = (x, 1.0, 0.0);
        for (a, b) in self.coefficients.iter().zip(&other.coefficients) {
            sum += (a - b) * current;
            (before, current) = (current, 2.0 * x * current - before);
        }
        sum
    }
}
