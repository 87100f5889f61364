//! Orders so small that ν|u|_ν², a difference of terms of order one, has no digits left: γ from larger orders.
//!
//! γ_θ(ν) is the largest eigenvalue of a form that is analytic in ν through ν = 0 (where 1/|x−y| takes the place of the kernel), so
//! ln γ is interpolated by a polynomial in Chebyshev points ν_k ∈ [h/40, h] and evaluated at ν < h/40. On that interval ln γ varies
//! like e^{−2ν ln(1/θ)} at most: h = 0.04, or 0.9 / ln(1/θ) for short lengths, where truncation and rounding weigh alike.
//! The error estimate adds those of the points, each times the modulus of its Lagrange polynomial, to the change when a point is left out.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::sobolev::FractionalOrder;
use rayon::prelude::*;

/// Orders below this may be continued.
pub(crate) const SMALL: f64 = 1e-3;
/// Largest order used, and the share of it that is left out below.
const LARGEST: f64 = 0.04;
const LEAST_SHARE: f64 = 1.0 / 40.0;

/// γ at a small order, `value` being γ at other orders; `shortest` is the shortest length of the zone and the parts beside it.
pub(crate) fn continued(
    order: FractionalOrder,
    shortest: f64,
    tolerance: Tolerance,
    value: impl Fn(FractionalOrder, Tolerance) -> Result<Estimate> + Sync,
) -> Result<Estimate> {
    let high = LARGEST.min(-0.9 / shortest.min(0.5).ln());
    let low = LEAST_SHARE * high;
    let asked = tolerance.relative();
    let count = (4.0 - 0.6 * asked.log10()).ceil().clamp(5.0, 12.0) as usize;
    let nodes: Vec<f64> = (0..count)
        .map(|k| {
            let angle = (k as f64 + 0.5) / count as f64 * std::f64::consts::PI;
            0.5 * (high + low) - 0.5 * (high - low) * angle.cos()
        })
        .collect();
    // The points contribute about ten times their errors together; rounding sets a limit.
    let sharper = Tolerance::new((0.05 * asked).max(1e-11))?;
    let at = |&nu: &f64| {
        let order = FractionalOrder::new(nu)?;
        value(order, sharper).or_else(|_| value(order, tolerance))
    };
    let values = nodes.par_iter().map(at).collect::<Result<Vec<Estimate>>>()?;
    let logarithm = |count: usize| -> (f64, f64) {
        (0..count).fold((0.0, 0.0), |(sum, error), k| {
            let weight = lagrange(&nodes[..count], k, order.value());
            (sum + weight * values[k].value.ln(), error + weight.abs() * values[k].relative_error())
        })
    };
    let ((all, error), (fewer, _)) = (logarithm(count), logarithm(count - 1));
    let reached = error + (all - fewer).abs();
    if reached > asked {
        return Err(Error::ToleranceNotMet { what: "Poincare constant", asked, reached });
    }
    let work = values.iter().fold(Work::default(), |sum, value| sum + value.work);
    Estimate::new(all.exp(), reached * all.exp(), work)
}

/// The Lagrange polynomial of node k at x.
fn lagrange(nodes: &[f64], k: usize, x: f64) -> f64 {
    let factor = |j: usize| (x - nodes[j]) / (nodes[k] - nodes[j]);
    (0..nodes.len()).filter(|&j| j != k).map(factor).product()
}
