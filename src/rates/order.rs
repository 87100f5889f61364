//! An order of convergence with its uncertainty and the regime it was seen in.
//!
//! Three models are fitted to the levels h₁ > h₂ > ...:
//!
//! * one power, e = C h^p: least squares in ln e against ln h over the finer half;
//! * a power beside the order one of the smooth part, e² = A h^{2p} + B h², B of either sign: for a
//!   singularity r^p the sum over the cells at distance r gives h² ∫_h r^{2p−3} dr, that is both terms with
//!   opposite signs;
//! * the same with D h³, what a transition r^{3/2} and the next terms of the smooth part leave
//!   ([`super::series`]).
//!
//! Of the two with a smooth part the one whose order moves least between windows of levels is reported; one
//! power alone only where neither can be fitted (few levels, or no power below one) or both are lost in noise
//! (uncertainty above 0.1 and above that of one power, the difference of the two orders included), since two
//! halves of a series may agree by chance and both be off. That covers the orders of both: above 0.1 noise
//! has fitted B, and the union of both intervals would only be wider (no order is missed in the tests below).
//!
//! # What the uncertainty is
//!
//! The largest of four numbers, each of which has been seen to be the one that counts:
//!
//! * *windows*: three times the largest change when levels are left out at one end, twice the one when they
//!   are at both ends. For one power four times the difference between the two halves of its window: an order
//!   that creeps to its limit by a factor 4/5 per half still moves by that;
//! * *scatter*: three standard errors of p from the residuals;
//! * *the next model*: the change when the next term is allowed; for the last model half of what it changed
//!   itself;
//! * *the smooth part*: a quarter of what the smooth part changes, since its exponents are assumed and not
//!   fitted.
//!
//! Series that scatter ([`ConvergenceOrder::of_scattered`]) and values with an error on few levels
//! ([`ConvergenceOrder::of_last`]) are read by one power; the uncertainty answers the same question there. It is no bound. On synthetic series with a smooth part, log-periodic terms and noise the true order lies
//! within it in at least 95 % of the cases (tested below). A series that has not begun to behave like its
//! model can deceive any fit.

use super::line::Line;
use super::series::Series;
use fractional_sobolev::Estimate;
use std::f64::consts::LN_2;
use std::fmt;

/// How the errors depend on h.
///
/// p < 1 in the models with a smooth part, whose order one is assumed; A > 0, B and D of either sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorModel {
    /// e = C h^p.
    Power,
    /// e² = A h^{2p} + B h².
    PowerAndSmooth,
    /// e² = A h^{2p} + B h² + D h³.
    PowerAndSeries,
}

impl fmt::Display for ErrorModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ErrorModel::Power => "p",
            ErrorModel::PowerAndSmooth => "p, 1",
            ErrorModel::PowerAndSeries => "p, 1, 3/2",
        })
    }
}

/// The order p of errors e ~ h^p with its uncertainty, and the mesh sizes it was read on.
///
/// The uncertainty has one meaning: p differs from the limit order by at most this, as far as the levels tell.
/// It is the largest of four numbers: the change of p when levels are left out, three standard errors from the
/// residuals, the change under the next model (e = C h^p; e² = A h^{2p} + B h²; the same with D h³), and a quarter of what the smooth part O(h)
/// changes. It is no bound: on synthetic series with a smooth part, log-periodic terms and noise the true order
/// lies within it in at least 95 % of the cases. A factor |ln h|^q is read as a power: the uncertainty does not
/// cover it. Cost: a few hundred least squares problems of the size of the series.
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
    /// p.
    pub order: f64,
    /// What p may be off by: windows, scatter, the next model and the smooth part, whichever is largest.
    pub uncertainty: f64,
    /// Which model.
    pub model: ErrorModel,
    /// Coarsest and finest mesh size used.
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

/// Fewest levels a window may have.
const WINDOW: usize = 4;
/// Fewest levels of a series that scatters: a line and what it leaves.
const FEWEST: usize = 3;
/// Times the change of a series that scatters when a level is left out at an end: two may change twice.
const ENDS: f64 = 2.0;
/// An order whose own error falls by two ninths or more from one pair of meshes to the next is off by at most three and
/// a half times its last change: beside the leading term one with another factor h^{1/2} and no larger a coefficient, or
/// h^{3/4} and twice the coefficient, from eight elements on.
const CHANGES: f64 = 3.5;
/// Standard errors that count as scatter: few levels are left over, and the 97.5 % quantile of Student's t
/// with four is 2.8.
const SCATTER: f64 = 3.0;
/// Share of what the smooth part changes that counts as uncertain.
const SMOOTH: f64 = 0.25;
/// Share of what the last term of the series changed that the term after it may still change.
const NEXT: f64 = 0.5;
/// A uncertainty above this is that of a series in which the smooth part cannot be told from noise.
const HIDDEN: f64 = 0.1;
/// The order of the smooth part: what a power that is no longer below one is taken for.
const ONE: f64 = 1.0;

/// A fit by one model before the others are asked.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    order: f64,
    /// Largest change between windows, doubled: the models are compared by it.
    spread: f64,
    /// What the windows say the order may be off by.
    drift: f64,
    scatter: f64,
    model: ErrorModel,
    regime: (f64, f64),
}

impl ConvergenceOrder {
    /// The best of all models for (h, e), coarsest first; `None` for fewer than five levels or an error that
    /// is not positive.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        Self::against(points, None)
    }

    /// As [`ConvergenceOrder::of`] for distances to a solution of mesh size `reference`.
    ///
    /// With e(h)² − e(h_r)² as the measured square, h_r = `reference`, every term h^q of the model becomes h^q − h_r^q.
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
        let one = one_power(points)?;
        let two = beside(points, ErrorModel::PowerAndSmooth, reference);
        let mut three = beside(points, ErrorModel::PowerAndSeries, reference);
        if let Some(three) = &mut three {
            let before = two.map_or(ONE, |two| two.order);
            three.spread = three.spread.max(NEXT * (three.order - before).abs());
        }
        let best = match (two, three) {
            (Some(two), Some(three)) if three.spread < two.spread => three,
            (Some(two), _) => two,
            (None, Some(three)) => three,
            (None, None) => one,
        };
        let next = match best.model {
            ErrorModel::Power => (best.order - ONE).abs(),
            ErrorModel::PowerAndSmooth => three.map_or(0.0, |three| (best.order - three.order).abs()),
            ErrorModel::PowerAndSeries => 0.0,
        };
        // One power is no model of a difference to a discrete reference.
        let smooth = if reference.is_some() { 0.0 } else { SMOOTH * (best.order - one.order).abs() };
        let uncertainty = best.spread.max(best.drift).max(SCATTER * best.scatter).max(next).max(smooth);
        // Where noise hides the smooth part one power says more, and where it is off is where the two differ.
        let power = one.drift.max(SCATTER * one.scatter).max((best.order - one.order).abs());
        if reference.is_none() && uncertainty > HIDDEN && power < uncertainty {
            let Candidate { order, model, regime, .. } = one;
            return Some(Self { order, uncertainty: power, model, regime });
        }
        Some(Self { order: best.order, uncertainty, model: best.model, regime: best.regime })
    }

    /// One power and nothing beside it, as the consistency term is, over the finer half of the levels; its uncertainty
    /// from the two halves and the scatter. `None` for fewer than five levels or a value that is not positive.
    ///
    /// e = C h^p in the least squares sense of ln e against ln h.
    ///
    /// ```
    /// use signorini::rates::ConvergenceOrder;
    /// let levels: Vec<(f64, f64)> = (2..10).map(|k| 0.5f64.powi(k)).map(|h| (h, 3.0 * h.powf(1.25))).collect();
    /// let found = ConvergenceOrder::of_power(&levels).ok_or("too few levels")?;
    /// assert!((found.order - 1.25).abs() < 1e-12 && found.uncertainty < 1e-12);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn of_power(points: &[(f64, f64)]) -> Option<Self> {
        let Candidate { order, drift, scatter, model, regime, .. } = one_power(points)?;
        Some(Self { order, uncertainty: drift.max(SCATTER * scatter), model, regime })
    }

    /// One power about which the values scatter or alternate, as errors of one transition do, which lies at another
    /// place of its cell on every level; over the finer half of the levels, three at least.
    ///
    /// The uncertainty is the larger of three standard errors (the alternation as scatter) and twice the largest
    /// change when a level is left out at either end (a series that has not settled): two halves of such a series
    /// say little of it. `None` for fewer than three levels or a value that is not positive.
    ///
    /// ```
    /// use signorini::rates::ConvergenceOrder;
    /// let term = |k: i32| 0.5f64.powf(1.5 * f64::from(k)) * if k % 2 == 0 { 1.1 } else { 0.9 };
    /// let levels: Vec<(f64, f64)> = (3..12).map(|k| (0.5f64.powi(k), term(k))).collect();
    /// let found = ConvergenceOrder::of_scattered(&levels).ok_or("too few levels")?;
    /// assert!((found.order - 1.5).abs() <= found.uncertainty);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn of_scattered(points: &[(f64, f64)]) -> Option<Self> {
        if points.len() < FEWEST || !is_positive(points) {
            return None;
        }
        let finer = &points[(points.len() / 2).min(points.len() - FEWEST)..];
        let last = finer.len() - 1;
        let Line { slope: order, error, .. } = Line::through_logarithms(finer);
        let mut uncertainty = SCATTER * error;
        if finer.len() > FEWEST {
            for part in [&finer[1..], &finer[..last]] {
                let change = Line::through_logarithms(part).slope - order;
                uncertainty = uncertainty.max(ENDS * change.abs());
            }
        }
        Some(Self { order, uncertainty, model: ErrorModel::Power, regime: (finer[0].0, finer[last].0) })
    }

    /// The order between the last two of the levels (h, e), coarsest first, for values that are known with an error.
    ///
    /// Its uncertainty is 3.5 times its change from the pair before, plus what the errors of the values leave; of the
    /// first order nothing else is known, and its uncertainty is the order itself. `None` for fewer than two levels,
    /// mesh sizes that do not decrease and values that are not positive.
    ///
    /// ```
    /// use fractional_sobolev::{Estimate, Work};
    /// use signorini::rates::ConvergenceOrder;
    /// let level = |h: f64| Estimate::new(h * h + h.powi(3), 1e-12, Work::default()).map(|norm| (h, norm));
    /// let levels = [level(0.125)?, level(0.0625)?, level(0.03125)?];
    /// let found = ConvergenceOrder::of_last(&levels).ok_or("too few levels")?;
    /// assert!((found.order - 2.0).abs() <= found.uncertainty);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_last(points: &[(f64, Estimate)]) -> Option<Self> {
        let [.., coarse, fine] = points else { return None };
        let values: Vec<(f64, f64)> = points.iter().map(|(h, e)| (*h, e.value)).collect();
        if !is_positive(&values) || values.windows(2).any(|pair| pair[0].0 <= pair[1].0) {
            return None;
        }
        let mut orders = values.windows(2).rev().map(|pair| order_between(pair[0], pair[1]));
        let order = orders.next()?;
        let change = orders.next().map_or(order.abs(), |before| CHANGES * (order - before).abs());
        let noise = (coarse.1.relative_error() + fine.1.relative_error()) / LN_2 / (coarse.0 / fine.0).log2();
        let uncertainty = change + noise;
        Some(Self { order, uncertainty, model: ErrorModel::Power, regime: (coarse.0, fine.0) })
    }
}

/// The order p of e ~ h^p between two points (h, e): ln(e/e') / ln(h/h'), without an uncertainty. Not a number, or
/// infinite, where an error vanishes.
///
/// ```
/// use signorini::rates::order_between;
/// assert_eq!(order_between((0.5, 3.0), (0.25, 0.75)), 2.0);
/// ```
pub fn order_between(coarse: (f64, f64), fine: (f64, f64)) -> f64 {
    (coarse.1 / fine.1).log2() / (coarse.0 / fine.0).log2()
}

/// ln e = ln C + p ln h by least squares over the finer half of the levels.
fn one_power(points: &[(f64, f64)]) -> Option<Candidate> {
    if points.len() <= WINDOW || !is_positive(points) {
        return None;
    }
    let half = &points[(points.len() / 2).min(points.len() - WINDOW)..];
    let Line { slope: order, error: scatter, .. } = Line::through_logarithms(half);
    let (first, second) = half.split_at(half.len() / 2);
    let slope = |part: &[(f64, f64)]| Line::through_logarithms(part).slope;
    let drift = (slope(&half[..=first.len()]) - slope(second)).abs();
    let regime = (half[0].0, half[half.len() - 1].0);
    let drift = 4.0 * drift;
    Some(Candidate { order, spread: drift, drift, scatter, model: ErrorModel::Power, regime })
}

/// A power beside the smooth part; `None` also where no power below one fits.
fn beside(points: &[(f64, f64)], model: ErrorModel, reference: Option<f64>) -> Option<Candidate> {
    let count = points.len();
    if count < WINDOW + 3 || !is_positive(points) {
        return None;
    }
    let exponents: &[f64] = if model == ErrorModel::PowerAndSmooth { &[2.0] } else { &[2.0, 3.0] };
    let first = (count / 4).min(count - WINDOW - 3);
    let windows = [(first, count), (first + 1, count), (first + 2, count), (first, count - 1)];
    let fit = |&(a, b): &(usize, usize)| {
        Series { points: &points[a..b], exponents, reference: reference.unwrap_or(0.0) }.power()
    };
    let fits: Vec<(f64, f64)> = windows.iter().map(fit).collect::<Option<_>>()?;
    let (order, scatter) = fits[0];
    let change = |fits: &[(f64, f64)]| fits.iter().fold(0.0, |w: f64, fit| w.max((fit.0 - order).abs()));
    let both_ends = [(first + 1, count - 1), (first, count - 2)];
    let enough = |window: &&(usize, usize)| window.1 - window.0 >= exponents.len() + WINDOW;
    let shorter: Vec<(f64, f64)> = both_ends.iter().filter(enough).filter_map(fit).collect();
    let (spread, drift) = (2.0 * change(&fits), (3.0 * change(&fits)).max(2.0 * change(&shorter)));
    let regime = (points[first].0, points[count - 1].0);
    Some(Candidate { order, spread, drift, scatter, model, regime })
}

fn is_positive(points: &[(f64, f64)]) -> bool {
    points.iter().all(|&(h, e)| h > 0.0 && e > 0.0 && e.is_finite())
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
        let slope = ConvergenceOrder::of_power(&points).unwrap();
        let fit = ConvergenceOrder::of(&points).unwrap();
        assert!(0.95 - slope.order > 0.02, "{slope}");
        assert!((fit.order - 0.95).abs() < 1e-5 && fit.model != ErrorModel::Power, "{fit}");
    }

    #[test]
    fn a_reference_on_the_same_family_of_meshes_is_accounted_for() {
        let square = |h: f64| 0.1 * h.powf(1.2) + 2.0 * h * h - h.powi(3);
        let reference = 0.5f64.powi(14);
        let points = levels(|h| (square(h) - square(reference)).sqrt());
        let fit = ConvergenceOrder::against(&points, Some(reference)).unwrap();
        assert!((fit.order - 0.6).abs() < 1e-4 && fit.model == ErrorModel::PowerAndSeries, "{fit}");
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
    fn a_logarithm_is_read_as_a_power_below_the_true_one_by_its_local_slope() {
        // d ln e / d ln h = 1 − q / |ln h| between the coarsest and the finest level.
        for q in [0.25, 0.5] {
            let points = levels(|h| h * h.ln().abs().powf(q));
            let read = ConvergenceOrder::of_power(&points).unwrap();
            let slope = |h: f64| 1.0 - q / h.ln().abs();
            assert!(slope(points[0].0) < read.order && read.order < slope(points[10].0), "{q}: {read}");
        }
    }

    #[test]
    fn an_alternating_series_lies_within_the_uncertainty_of_one_power() {
        for (p, alternation) in [(0.5, 0.01), (0.75, 0.05), (1.5, 0.1)] {
            let points = levels(|h| h.powf(p) * (1.0 + alternation * (-1f64).powf(h.log2())));
            let read = ConvergenceOrder::of_power(&points).unwrap();
            assert!((read.order - p).abs() <= read.uncertainty, "{p} {alternation}: {read}");
        }
    }

    #[test]
    fn the_rate_of_a_slow_sequence_is_not_claimed_to_be_better_known_than_it_is() {
        use fractional_sobolev::Work;
        let cases =
            [0.5, 0.75, 1.0, 2.0].into_iter().flat_map(|c| [0.5, 0.75, 1.0, 2.0].map(|tail| (c, tail)));
        // 2 h^{1/2} falls by less than assumed at N = 8.
        for (c, tail) in cases.filter(|&case| case != (2.0, 0.5)) {
            let error = |n: usize| {
                let h = 1.0 / n as f64;
                (h, Estimate::new(h.powf(0.7) * (1.0 + c * h.powf(tail)), 0.0, Work::default()).unwrap())
            };
            for n in [8, 64, 512] {
                let rate = ConvergenceOrder::of_last(&[error(n), error(2 * n), error(4 * n)]).unwrap();
                assert!((rate.order - 0.7).abs() <= rate.uncertainty, "{c} h^{tail} N {n}: {rate}");
            }
            assert!(ConvergenceOrder::of_last(&[error(8), error(8), error(16)]).is_none());
            let first = ConvergenceOrder::of_last(&[error(8), error(16)]).unwrap();
            assert!(first.uncertainty >= first.order, "{first:?}");
            assert!(ConvergenceOrder::of_last(&[error(8)]).is_none());
        }
    }

    #[test]
    fn the_order_of_a_series_that_scatters_lies_within_its_uncertainty() {
        let place = |k: i32| f64::from(k * k % 7) / 3.0 - 1.0;
        for p in [-0.1, 0.0, 0.75, 1.5] {
            for alternation in [0.03, 0.1] {
                for levels in [6, 9, 12] {
                    let points: Vec<(f64, f64)> = (3..3 + levels)
                        .map(|k| {
                            (0.5f64.powi(k), 0.5f64.powf(f64::from(k) * p) * (1.0 + alternation * place(k)))
                        })
                        .collect();
                    let read = ConvergenceOrder::of_scattered(&points).unwrap();
                    assert!((read.order - p).abs() <= read.uncertainty, "{p} {alternation} {levels}: {read}");
                }
            }
        }
        assert!(ConvergenceOrder::of_scattered(&levels(|h| h)[..2]).is_none());
        assert!(ConvergenceOrder::of_scattered(&[(0.5, 1.0), (0.25, 1.0), (0.125, 0.0)]).is_none());
    }
}
