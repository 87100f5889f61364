//! The case τ = 2, (3.2) and (4.3): which power of |ln h| does the error need?
//!
//! Near a transition whose slopes behave like |ln r|^{−α} ([`signorini::problems::TransitionPowers`]; in H² exactly
//! for α > 1/2) the cells at distance r add up to e² ≈ h² ∫_h ℓ(r)^{−2α} dr/r = h² (c ± ℓ(h)^{1−2α}), ℓ(r) =
//! 2 + |ln r|, so the model is
//!
//! e²/h² = B + A (ℓ^q − 1)/q,  ℓ = ℓ(h),  q = 1 − 2α.
//!
//! q ≤ 0: e/h is bounded, the bound h holds and is met; q > 0: e ~ h |ln h|^{q/2}. B, A and q by relative
//! least squares on several windows of levels. The half-width is the larger of twice the largest difference
//! between windows and three standard errors of q from the residuals; what a wrong model would change is not
//! in it.

use crate::search::{golden_section, smallest_on_grid};

/// q of e²/h² = B + A (ℓ^q − 1)/q with its half-width, ℓ = 2 + |ln h|.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogarithmFit {
    /// q.
    pub power: f64,
    /// What q may be off by if the model is right: windows of levels and scatter, whichever is larger.
    pub half_width: f64,
}

impl LogarithmFit {
    /// From (h, e), coarsest first; `None` for fewer than eight levels or an error that is not positive.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        let count = points.len();
        if count < 8 || !points.iter().all(|&(h, e)| h > 0.0 && h < 1.0 && e > 0.0 && e.is_finite()) {
            return None;
        }
        let first = (count / 4).min(count - 7);
        let windows = [(first, count), (first + 1, count), (first + 2, count), (first, count - 1)];
        let powers: Vec<f64> = windows.iter().map(|&(a, b)| best_power(&points[a..b])).collect();
        let spread = 2.0 * powers.iter().fold(0.0, |w: f64, q| w.max((q - powers[0]).abs()));
        let half_width = spread.max(SCATTER * standard_error(&points[first..], powers[0]));
        Some(Self { power: powers[0], half_width })
    }

    /// The power of |ln h| in the error that follows: q/2, or none for q ≤ 0.
    pub fn exponent(&self) -> f64 {
        0.5 * self.power.max(0.0)
    }
}

/// Powers q tried: α from −1/2 to 5/2.
const RANGE: (f64, f64) = (-4.0, 2.0);
/// Standard errors that count as scatter, as for orders.
const SCATTER: f64 = 3.0;
/// Step in q of the second difference of the misfit: small against the width of its minimum, large against
/// rounding.
const STEP: f64 = 0.05;

/// From residual variance and curvature of the misfit; ten points leave seven degrees of freedom.
fn standard_error(points: &[(f64, f64)], q: f64) -> f64 {
    let free = points.len() as f64 - 3.0;
    let [low, best, high] = [q - STEP, q, q + STEP].map(|q| misfit(points, q));
    let curvature = (low - 2.0 * best + high) / (STEP * STEP);
    if free > 0.0 && curvature > 0.0 { (2.0 * best / free / curvature).sqrt() } else { f64::INFINITY }
}

/// The q of the smallest misfit: a grid, then golden section.
fn best_power(points: &[(f64, f64)]) -> f64 {
    const STEPS: usize = 120;
    let (_, (a, b)) = smallest_on_grid(RANGE.0, RANGE.1, STEPS, |q| misfit(points, q));
    golden_section(a, b, 1e-6, |q| misfit(points, q))
}

/// Smallest Σ (model/e² − 1)² over B and A.
fn misfit(points: &[(f64, f64)], q: f64) -> f64 {
    let rows = points.iter().map(|&(h, e)| {
        let (size, log) = (h * h / (e * e), (2.0 + h.ln().abs()).ln());
        // (ℓ^q − 1)/q, ln ℓ at q = 0.
        let grown = if q == 0.0 { log } else { (q * log).exp_m1() / q };
        (size, size * grown)
    });
    let [mut uu, mut uv, mut vv, mut u1, mut v1] = [0.0; 5];
    for (u, v) in rows.clone() {
        uu += u * u;
        uv += u * v;
        vv += v * v;
        u1 += u;
        v1 += v;
    }
    let determinant = uu * vv - uv * uv;
    if determinant <= 1e-12 * uu * vv {
        return f64::INFINITY;
    }
    let (b, a) = ((vv * u1 - uv * v1) / determinant, (uu * v1 - uv * u1) / determinant);
    rows.map(|(u, v)| (b * u + a * v - 1.0).powi(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_the_logarithm_are_told_apart() {
        let levels = |e: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            (3..17).map(|k| 0.5f64.powi(k)).map(|h| (h, e(h))).collect()
        };
        for (q, b) in [(1.0, 3.0), (-0.5, 2.0), (-2.0, 1.0)] {
            let points = levels(&|h: f64| h * (b + 0.3 * (2.0 + h.ln().abs()).powf(q)).sqrt());
            let fit = LogarithmFit::of(&points).unwrap();
            assert!((fit.power - q).abs() < 1e-3 && fit.half_width < 1e-2, "{q}: {fit:?}");
        }
        assert!(LogarithmFit::of(&levels(&|h| h)[..5]).is_none());
    }
}
