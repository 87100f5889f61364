//! Extrapolation of γ from larger orders to orders so small that ν|u|_ν², a difference of terms of order one,
//! loses all digits.
//!
//! γ_θ(ν)² is the largest eigenvalue of a pencil that is analytic in ν through ν = 0 (where the kernel is
//! 1/|x−y|), so ln γ is interpolated by a polynomial at Chebyshev points ν_k ∈ [h/40, h] and evaluated at ν <
//! h/40, and the dual norm and the extremal function likewise. On that interval ln γ varies at most like
//! e^{−2ν ln(1/θ)}, θ the shortest length: h is the smaller of 0.04 and 0.9 / ln(1/θ), for which truncation
//! and rounding errors are of the same size. The error estimate is the sum of the errors of the points, each
//! multiplied by the modulus of its Lagrange polynomial, and of the change when one point is omitted.

use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::parallel;

/// Largest order to which values are extrapolated.
const SMALL: f64 = 1e-3;
/// Largest order used for the extrapolation, and the fraction of it that is the smallest one.
const LARGEST: f64 = 0.04;
const LEAST_SHARE: f64 = 1.0 / 40.0;
/// The errors of the points together contribute about ten times the error of one point: the share of the
/// tolerance for each point, and the smallest tolerance that rounding permits.
const SHARE_OF_POINT: f64 = 0.05;
const SHARPEST: f64 = 1e-11;

/// The points from which quantities are extrapolated to one order.
#[derive(Debug, Clone)]
pub(crate) struct Continuation {
    order: f64,
    nodes: Vec<f64>,
    tolerance: Tolerance,
}

impl Continuation {
    /// The extrapolation for zones and gaps of length at least `shortest`; `None` for orders that are not
    /// small.
    pub(crate) fn to(order: Order, shortest: f64, tolerance: Tolerance) -> Option<Self> {
        let order = order.value();
        if order >= SMALL {
            return None;
        }
        let high = LARGEST.min(-0.9 / shortest.min(0.5).ln());
        let low = LEAST_SHARE * high;
        let count = (4.0 - 0.6 * tolerance.relative().log10()).ceil().clamp(5.0, 12.0) as usize;
        let node = |k: usize| {
            let angle = (k as f64 + 0.5) / count as f64 * std::f64::consts::PI;
            0.5 * (high + low) - 0.5 * (high - low) * angle.cos()
        };
        Some(Self { order, nodes: (0..count).map(node).collect(), tolerance })
    }

    /// The results of `solve` at the points, to a smaller tolerance, or to the given one if rounding does not
    /// permit that.
    pub(crate) fn at_points<T: Send>(
        &self,
        solve: impl Fn(Order, Tolerance) -> Result<T> + Sync,
    ) -> Result<Vec<T>> {
        let sharper = Tolerance::new((SHARE_OF_POINT * self.tolerance.relative()).max(SHARPEST))?;
        let at = |&nu: &f64| {
            let order = Order::new(nu)?;
            match solve(order, sharper) {
                Err(Error::ToleranceNotMet { .. }) => solve(order, self.tolerance),
                result => result,
            }
        };
        parallel::over(&self.nodes, at).into_iter().collect()
    }

    /// The value of a positive quantity at the order, from its values at the points.
    pub(crate) fn value(&self, points: &[Estimate]) -> Result<Estimate> {
        let logarithm = |count: usize| -> (f64, f64) {
            self.weights(count).iter().zip(points).fold(
                (0.0, 0.0),
                |(sum, error), (weight, point)| {
                    (sum + weight * point.value.ln(), error + weight.abs() * point.relative_error())
                },
            )
        };
        let ((all, error), (fewer, _)) = (logarithm(points.len()), logarithm(points.len() - 1));
        let (asked, reached) = (self.tolerance.relative(), error + (all - fewer).abs());
        let work = points.iter().fold(Work::default(), |sum, point| sum + point.work);
        let found = Estimate::new(all.exp(), reached * all.exp(), work)?;
        if reached > asked {
            let why = "rounding of the constants at larger orders, from which the value is extrapolated, limits the accuracy";
            return Err(Error::not_met("Poincare constant", asked, found, why));
        }
        Ok(found)
    }

    /// The weights of all points, for functions that depend on the order.
    pub(crate) fn all_weights(&self) -> Vec<f64> {
        self.weights(self.nodes.len())
    }

    /// The values at the order of the Lagrange polynomials of the first `count` points.
    fn weights(&self, count: usize) -> Vec<f64> {
        let nodes = &self.nodes[..count];
        let factor = |k: usize, j: usize| (self.order - nodes[j]) / (nodes[k] - nodes[j]);
        let weight = |k: usize| (0..count).filter(|&j| j != k).map(|j| factor(k, j)).product();
        (0..count).map(weight).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    fn continuation() -> Continuation {
        let order = Order::new(1e-9).unwrap();
        Continuation::to(order, 1e-3, Tolerance::balanced()).unwrap()
    }

    #[test]
    fn an_analytic_function_is_continued_to_its_value() {
        let exact = |nu: f64| (1.0 + nu).recip() * (3.0 * nu).exp();
        let solve = |order: Order, _| Estimate::new(exact(order.value()), 1e-14, Work::default());
        let (points, at) = (continuation().at_points(solve).unwrap(), continuation().order);
        let found = continuation().value(&points).unwrap();
        assert!((found.value - exact(at)).abs() <= found.error, "{found} against {}", exact(at));
    }

    #[test]
    fn only_a_tolerance_that_is_not_met_is_passed_over() {
        let calls = AtomicUsize::new(0);
        let refused = Error::out_of_reach("test", 1e-9, 1e-8, "planted");
        let broken = Error::NotPositiveDefinite { what: "test", pivot: 3 };
        for (error, solves) in [(refused, 2), (broken, 1)] {
            calls.store(0, Ordering::Relaxed);
            let one = Continuation { nodes: vec![0.01], ..continuation() };
            let outcome: Result<Vec<Estimate>> = one.at_points(|_, _| {
                calls.fetch_add(1, Ordering::Relaxed);
                Err(error.clone())
            });
            assert_eq!(outcome, Err(error));
            assert_eq!(calls.load(Ordering::Relaxed), solves);
        }
    }
}
