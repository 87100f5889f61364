//! The observed order of convergence, with its uncertainty and the range of levels.
//!
//! # Definition of the uncertainty
//!
//! The slope of a pre-asymptotic sequence e = C h^p (1 + c h^q + ...) approaches p as slowly as h^q; near τ = 2,
//! where e² = h² ∫_h r^{2τ−5} dr, as slowly as 1/|ln h|; and the errors for one transition depend on its position
//! within its cell. The difference of the slopes on two sets of levels is therefore not a reliable error estimate.
//! Instead, the likelihood of every order p is computed for models with unknown terms in addition to the leading one,
//! none of which is much larger than the leading one on the coarsest level, and with unknown scatter
//! ([`super::posterior`]). The order is the posterior mean of min(p, 1), the uncertainty the distance from it
//! within which 96 % of the probability lies: it is small only if no other order fits.
//!
//! Calibrated on errors of discrete solutions with known order, and tested on others (`tests/beyond/orders.rs`):
//! strips with one or more transitions or Cantor sets, 3/2 < τ ≤ 5/2, both cones, 5 to 10 levels, and corners. The
//! true order lies within the uncertainty in at least 95 % of the cases.

use super::posterior::{ErrorModel, Posterior};
use std::fmt;

/// The order p of errors e ~ h^p with its uncertainty, and the mesh sizes from which it was determined.
///
/// The uncertainty means that the order as h → 0 differs from p by at most this amount, for all lower-order terms
/// that are consistent with the levels. It is not a bound: on strips and corners with known order and 5 to 10 levels,
/// the interval contains the true order in at least 95 of 100 cases. Few levels, scatter, or a slope that still
/// changes make it large; compare it with the difference between the orders in question. Cost: a few milliseconds.
///
/// ```
/// use signorini::rates::ConvergenceOrder;
/// let errors: Vec<(f64, f64)> = (3..12)
///     .map(|k| 0.5f64.powi(k))
///     .map(|h| (h, (h.powf(1.5) + 2.0 * h * h).sqrt()))
///     .collect();
/// let order = ConvergenceOrder::of(&errors).ok_or("too few levels")?;
/// assert!((order.order - 0.75).abs() <= order.uncertainty.max(1e-6));
/// # Ok::<(), &str>(())
/// ```
#[doc(alias("rate of convergence", "EOC", "slope"))]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConvergenceOrder {
    /// The order p.
    pub order: f64,
    /// The uncertainty of p.
    pub uncertainty: f64,
    /// The most likely model of the terms in addition to the leading one.
    pub model: ErrorModel,
    /// The coarsest and the finest mesh size used.
    pub regime: (f64, f64),
}

impl fmt::Display for ConvergenceOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = [self.regime.0, self.regime.1].map(f64::log2);
        write!(
            f,
            "{:.3} ± {:.3} (orders {}; h = 2^{from:.0} ... 2^{to:.0})",
            self.order, self.uncertainty, self.model
        )
    }
}

/// Smallest number of levels; four levels do not determine three unknowns and the scatter.
const LEVELS: usize = 5;
/// Probability within the uncertainty: slightly more than the 95 % that are stated.
const WITHIN: f64 = 0.96;
impl ConvergenceOrder {
    /// The order of errors (h, e) of linear elements in the energy norm, coarsest first; `None` for fewer than five
    /// levels, from which no uncertainty can be stated, or a mesh size or an error that is not positive.
    ///
    /// The smooth part of the solution has order one: e² = A h^{2p} + B h² + C h² ln h + D h³, or more
    /// general terms if the levels require them. For p > 1 the order is one.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        Self::against(points, None)
    }

    /// The order as in [`ConvergenceOrder::of`], for distances to a discrete solution of mesh size `reference`.
    ///
    /// The measured square is e(h)² − e(h_r)², h_r = `reference`, so that every term h^q of the model becomes
    /// h^q − h_r^q.
    ///
    /// ```
    /// use signorini::rates::ConvergenceOrder;
    /// let (square, finest) = (|h: f64| h.powf(1.5) + h * h, 0.5f64.powi(12));
    /// let distance = |h: f64| (square(h) - square(finest)).sqrt();
    /// let levels: Vec<(f64, f64)> = (2..11).map(|k| 0.5f64.powi(k)).map(|h| (h, distance(h))).collect();
    /// let found = ConvergenceOrder::against(&levels, Some(finest)).ok_or("too few levels")?;
    /// assert!((found.order - 0.75).abs() <= found.uncertainty.max(1e-5));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn against(points: &[(f64, f64)], reference: Option<f64>) -> Option<Self> {
        let is_positive = points.iter().all(|&(h, e)| h > 0.0 && e > 0.0 && e.is_finite());
        if points.len() < LEVELS || !is_positive {
            return None;
        }
        let found = Posterior::of(points, reference.unwrap_or(0.0));
        let (order, uncertainty) = found.interval(WITHIN);
        let regime = (points[0].0, points[points.len() - 1].0);
        Some(Self { order, uncertainty, model: found.model, regime })
    }
}

/// The order p of e ~ h^p between two points (h, e): ln(e/e') / ln(h/h'), without an uncertainty. NaN or
/// infinite if an error vanishes.
///
/// ```
/// use signorini::rates::order_between;
/// assert_eq!(order_between((0.5, 3.0), (0.25, 0.75)), 2.0);
/// ```
pub fn order_between(coarse: (f64, f64), fine: (f64, f64)) -> f64 {
    (coarse.1 / fine.1).log2() / (coarse.0 / fine.0).log2()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(e: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        (3..14).map(|k| 0.5f64.powi(k)).map(|h| (h, e(h))).collect()
    }

    #[test]
    fn a_power_is_found_exactly() {
        let fit = ConvergenceOrder::of(&levels(|h| 3.0 * h.powf(0.75))).unwrap();
        assert!((fit.order - 0.75).abs() < 1e-6 && fit.uncertainty < 1e-6, "{fit}");
        assert!(
            ConvergenceOrder::of(&levels(|_| 0.0)).is_none()
                && ConvergenceOrder::of(&levels(|h| h)[..4]).is_none()
        );
    }

    #[test]
    fn a_power_close_to_one_is_told_from_its_smooth_part() {
        // h² ∫_h^1 r^{2p−3} dr with p = 0.95, where the slope itself stays 0.02 below
        let points = levels(|h| (h.powf(1.9) - h * h).sqrt());
        let slope = order_between(points[points.len() - 2], points[points.len() - 1]);
        let fit = ConvergenceOrder::of(&points).unwrap();
        assert!(0.95 - slope > 0.02, "{slope}");
        assert!((fit.order - 0.95).abs() < 1e-5 && fit.model != ErrorModel::Power, "{fit}");
    }

    #[test]
    fn a_reference_on_the_same_family_of_meshes_is_accounted_for() {
        let square = |h: f64| 0.1 * h.powf(1.2) + 2.0 * h * h - h.powi(3);
        let reference = 0.5f64.powi(14);
        let points = levels(|h| (square(h) - square(reference)).sqrt());
        let fit = ConvergenceOrder::against(&points, Some(reference)).unwrap();
        assert!((fit.order - 0.6).abs() < 1e-4 && fit.model == ErrorModel::PowerAndSmooth, "{fit}");
    }

    /// A generator with a fixed seed, uniform on (low, high).
    struct Random(u64);

    impl Random {
        fn within(&mut self, low: f64, high: f64) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    #[test]
    fn the_true_order_lies_within_the_half_width_of_known_series() {
        const CASES: usize = 100;
        // Amplitude of a log-periodic term in e², relative noise in e.
        for (name, periodic, noise) in
            [("smooth", 0.0, 0.0), ("periodic", 0.05, 0.0), ("noisy", 0.0, 0.005), ("both", 0.03, 0.003)]
        {
            let mut random = Random(88_172_645_463_325_252);
            let mut found = 0;
            for _ in 0..CASES {
                let (p, from) = (random.within(0.35, 0.97), random.within(3.0, 5.0) as i32);
                let levels = random.within(9.0, 15.0) as i32;
                let (b, d) = (random.within(-0.9, 3.0), random.within(-1.0, 1.0));
                let (period, phase) = (random.within(1.2, 4.0), random.within(0.0, std::f64::consts::TAU));
                let (wave, noise) = (random.within(0.0, periodic), random.within(0.0, noise));
                let points: Vec<(f64, f64)> = (from..from + levels)
                    .map(|k| {
                        let h = 0.5f64.powi(k);
                        let turn = (std::f64::consts::TAU * f64::from(k) / period + phase).cos();
                        let square = h.powf(2.0 * p) * (1.0 + wave * turn) + b * h * h + d * h.powi(3);
                        // Sum of four: nearly normal, of variance one.
                        let normal = (0..4).map(|_| random.within(-0.866, 0.866)).sum::<f64>();
                        (h, square.sqrt() * (1.0 + noise * normal))
                    })
                    .collect();
                let fit = ConvergenceOrder::of(&points).unwrap();
                found += usize::from((fit.order - p).abs() <= fit.uncertainty + RESOLVED);
            }
            assert!(100 * found >= 95 * CASES, "{name}: {found} of {CASES}");
        }
    }

    #[test]
    fn short_and_alternating_series_with_a_smooth_part_lie_within() {
        for case in 0..4 * 7 * 5 {
            let alternation = [0.0, 0.02, 0.05, 0.1][case % 4];
            let (p, c) =
                ([0.4, 0.5, 0.6, 0.7, 0.75, 0.9, 0.95][case / 4 % 7], [-0.5, 0.5, 0.75, 1.0, 2.0][case / 28]);
            let points = levels(|h| h.powf(p) * (1.0 + c * h) * (1.0 + alternation * (-1f64).powf(h.log2())));
            for count in 5..=points.len() {
                let fit = ConvergenceOrder::of(&points[..count]).unwrap();
                assert!((fit.order - p).abs() <= fit.uncertainty + RESOLVED, "{p} {c} {alternation}: {fit}");
            }
        }
    }

    /// The minimum over p is located to 1e-7; the misfit is flat about it to the root of rounding.
    const RESOLVED: f64 = 1e-6;

    #[test]
    fn noise_widens_the_bar() {
        let noisy = levels(|h| h.powf(0.7) * (1.0 + 0.2 * (4.0 * h.ln()).sin()));
        let fit = ConvergenceOrder::of(&noisy).unwrap();
        assert!(fit.uncertainty > 0.005 && (fit.order - 0.7).abs() < 0.05, "{fit}");
    }

    #[test]
    fn a_logarithm_beside_the_power_is_left_possible() {
        // The local slope of h |ln h|^q is 1 − q/|ln h|: a line through the finer half reads 0.93 to 0.98.
        for q in [0.25, 0.5] {
            let points = levels(|h| h * h.ln().abs().powf(q));
            for count in 5..=points.len() {
                let read = ConvergenceOrder::of(&points[..count]).unwrap();
                assert!((read.order - 1.0).abs() <= read.uncertainty, "{q}: {read}");
                assert!(count < 9 || read.uncertainty < 0.1, "{q}: {read}");
            }
        }
    }

    #[test]
    fn units_of_length_and_size_do_not_count() {
        let points = levels(|h| h.powf(0.7) * (1.0 + 0.3 * h.sqrt()) * (1.0 + 0.05 * (5.0 * h.ln()).sin()));
        let read = ConvergenceOrder::of(&points).unwrap();
        for (length, size) in [(1e-100, 1e90), (1e80, 1e-120)] {
            let points: Vec<(f64, f64)> = points.iter().map(|(h, e)| (h * length, e * size)).collect();
            let scaled = ConvergenceOrder::of(&points).unwrap();
            let apart = (scaled.order - read.order).abs().max((scaled.uncertainty - read.uncertainty).abs());
            assert!(apart < 1e-9, "{scaled} {read}");
        }
    }
}
