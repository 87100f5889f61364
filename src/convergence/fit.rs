//! An order of convergence with its uncertainty and the regime it was seen in.
//!
//! Three models are fitted to the levels h₁ > h₂ > ...:
//!
//! * one power, e = C h^p: least squares in ln e against ln h over the finer half;
//! * a power beside the order one of the smooth part, e² = A h^{2p} + B h², B of either sign: for a singularity r^p
//!   the sum over the cells at distance r gives h² ∫_h r^{2p−3} dr, that is both terms with opposite signs;
//! * the same with D h³, what a transition r^{3/2} and the next terms of the smooth part leave.
//!
//! Relative least squares in A, B, D for each p, then in p (golden section). Each model is fitted on several windows of levels. The
//! half-width of one power is four times the difference between the two halves of its window (an order that creeps to its limit by
//! a factor 4/5 per half still moves by that) or twice the standard error; that of the others is twice the largest difference
//! between windows, and of the third at least half its difference to the second. The model with the smallest half-width is
//! reported, and which one it was. Where e is the distance to a solution of mesh size h_r on the same family of meshes, e² is that of
//! h less that of h_r, every h^q becomes h^q − h_r^q, and one power is fitted only where nothing else can be. Cost: O(levels) per value of p.

use std::fmt;

/// How the errors depend on h.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Model {
    /// e = C h^p.
    Power,
    /// e² = A h^{2p} + B h².
    PowerAndSmooth,
    /// e² = A h^{2p} + B h² + D h³.
    PowerAndSeries,
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Model::Power => "p",
            Model::PowerAndSmooth => "p, 1",
            Model::PowerAndSeries => "p, 1, 3/2",
        })
    }
}

/// An order p ± half-width, the model it belongs to, and the mesh sizes it was seen on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// p.
    pub order: f64,
    /// What p may be off by.
    pub half_width: f64,
    /// Which model.
    pub model: Model,
    /// Coarsest and finest mesh size used.
    pub regime: (f64, f64),
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = [self.regime.0, self.regime.1].map(f64::log2);
        write!(
            f,
            "{:.3} ± {:.3} (orders {}; h = 2^{from:.0} ... 2^{to:.0})",
            self.order, self.half_width, self.model
        )
    }
}

/// Fewest levels a window may have.
const WINDOW: usize = 4;

impl Fit {
    /// The best of all models for (h, e), coarsest first; `None` for fewer than five levels or an error that is not positive.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        Self::against(points, None)
    }

    /// As [`Fit::of`] for distances to a solution of mesh size `reference`.
    pub fn against(points: &[(f64, f64)], reference: Option<f64>) -> Option<Self> {
        let one = Self::power(points)?;
        let two = Self::with_model(points, Model::PowerAndSmooth, reference);
        let mut three = Self::with_model(points, Model::PowerAndSeries, reference);
        if let Some(three) = &mut three {
            // What the next term of the series may still change.
            let before = two.map_or(POWERS.1, |two| two.order);
            three.half_width = three.half_width.max(0.5 * (three.order - before).abs());
        }
        // A difference to a discrete reference is no power: one is fitted only where nothing else can be.
        let one = if reference.is_some() { two.or(three).unwrap_or(one) } else { one };
        let others = [two, three].into_iter().flatten();
        Some(others.fold(one, |best, fit| if fit.half_width < best.half_width { fit } else { best }))
    }

    /// One power.
    pub fn power(points: &[(f64, f64)]) -> Option<Self> {
        if points.len() <= WINDOW || !is_positive(points) {
            return None;
        }
        let half = &points[(points.len() / 2).min(points.len() - WINDOW)..];
        let (order, error) = slope(half);
        let (first, second) = half.split_at(half.len() / 2);
        let drift = (slope(&half[..=first.len()]).0 - slope(second).0).abs();
        let half_width = (4.0 * drift).max(2.0 * error);
        Some(Self { order, half_width, model: Model::Power, regime: (half[0].0, half[half.len() - 1].0) })
    }

    /// A power beside the smooth part; `None` also where no power below one fits.
    fn with_model(points: &[(f64, f64)], model: Model, reference: Option<f64>) -> Option<Self> {
        let count = points.len();
        if count < WINDOW + 3 || !is_positive(points) {
            return None;
        }
        let exponents: &[f64] = if model == Model::PowerAndSmooth { &[2.0] } else { &[2.0, 3.0] };
        let first = (count / 4).min(count - WINDOW - 3);
        let windows = [(first, count), (first + 1, count), (first + 2, count), (first, count - 1)];
        let order = |&(a, b): &(usize, usize)| {
            Series { points: &points[a..b], exponents, reference: reference.unwrap_or(0.0) }.power()
        };
        let orders: Vec<f64> = windows.iter().map(order).collect::<Option<_>>()?;
        let order = orders[0];
        let half_width = 2.0 * orders.iter().fold(0.0, |w: f64, p| w.max((p - order).abs()));
        Some(Self { order, half_width, model, regime: (points[first].0, points[count - 1].0) })
    }
}

fn is_positive(points: &[(f64, f64)]) -> bool {
    points.iter().all(|&(h, e)| h > 0.0 && e > 0.0 && e.is_finite())
}

/// Slope of ln e against ln h and its standard error.
fn slope(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let logs = || points.iter().map(|&(h, e)| (h.ln(), e.ln()));
    let (x, y) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / count, b + y / count));
    let (xy, xx) = logs().fold((0.0, 0.0), |(a, b), (u, v)| (a + (u - x) * (v - y), b + (u - x).powi(2)));
    let order = xy / xx;
    let residual: f64 = logs().map(|(u, v)| (v - y - order * (u - x)).powi(2)).sum();
    let error = if count > 2.0 { (residual / (count - 2.0) / xx).sqrt() } else { 0.0 };
    (order, error)
}

/// Orders tried for the power beside h.
const POWERS: (f64, f64) = (0.05, 0.995);

/// e² = A h^{2p} + Σ B_q h^q on some levels.
struct Series<'a> {
    points: &'a [(f64, f64)],
    exponents: &'a [f64],
    reference: f64,
}

impl Series<'_> {
    /// The best p, A > 0; `None` where it is an end of the range.
    fn power(&self) -> Option<f64> {
        const STEPS: usize = 190;
        let (low, high) = POWERS;
        let at = |k: usize| low + (high - low) * k as f64 / STEPS as f64;
        let best = (0..=STEPS).min_by(|&a, &b| self.misfit(at(a)).0.total_cmp(&self.misfit(at(b)).0))?;
        if best == 0 || best == STEPS {
            return None;
        }
        let (mut a, mut b) = (at(best - 1), at(best + 1));
        let ratio = 0.5 * (5f64.sqrt() - 1.0);
        while b - a > 1e-7 {
            let (c, d) = (b - ratio * (b - a), a + ratio * (b - a));
            if self.misfit(c).0 < self.misfit(d).0 { b = d } else { a = c }
        }
        let order = 0.5 * (a + b);
        (self.misfit(order).1 > 0.0).then_some(order)
    }

    /// Smallest Σ (model/e² − 1)² over the coefficients, and A: orthogonalisation, h^{2p} last.
    fn misfit(&self, p: f64) -> (f64, f64) {
        let largest = self.points[0].0;
        let column = |q: f64| -> Vec<f64> {
            let term = |h: f64| (h / largest).powf(q) - (self.reference / largest).powf(q);
            self.points.iter().map(|&(h, e)| term(h) / (e * e)).collect()
        };
        let mut rest = vec![1.0; self.points.len()];
        let mut basis: Vec<Vec<f64>> = Vec::new();
        let mut coefficient = 0.0;
        for q in self.exponents.iter().copied().chain([2.0 * p]) {
            let mut v = column(q);
            let before = dot(&v, &v).sqrt();
            // Twice is enough.
            for _ in 0..2 {
                for b in &basis {
                    let share = dot(b, &v);
                    subtract(&mut v, share, b);
                }
            }
            let length = dot(&v, &v).sqrt();
            if length <= 1e-9 * before {
                return (f64::INFINITY, 0.0);
            }
            v.iter_mut().for_each(|x| *x /= length);
            let share = dot(&v, &rest);
            subtract(&mut rest, share, &v);
            coefficient = share / length;
            basis.push(v);
        }
        (dot(&rest, &rest), coefficient)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// a ← a − t b.
fn subtract(a: &mut [f64], t: f64, b: &[f64]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= t * b);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(e: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        (3..14).map(|k| 0.5f64.powi(k)).map(|h| (h, e(h))).collect()
    }

    #[test]
    fn a_power_is_found_exactly() {
        let fit = Fit::of(&levels(|h| 3.0 * h.powf(0.75))).unwrap();
        assert!((fit.order - 0.75).abs() < 1e-6 && fit.half_width < 1e-6, "{fit}");
        assert!(Fit::of(&levels(|_| 0.0)).is_none() && Fit::of(&levels(|h| h)[..4]).is_none());
    }

    #[test]
    fn a_power_close_to_one_is_told_from_its_smooth_part() {
        // h² ∫_h^1 r^{2p−3} dr with p = 0.95, where the slope itself stays 0.02 below
        let points = levels(|h| (h.powf(1.9) - h * h).sqrt());
        let slope = Fit::power(&points).unwrap();
        let fit = Fit::of(&points).unwrap();
        assert!(0.95 - slope.order > 0.02, "{slope}");
        assert!((fit.order - 0.95).abs() < 1e-5 && fit.model != Model::Power, "{fit}");
    }

    #[test]
    fn a_reference_on_the_same_family_of_meshes_is_accounted_for() {
        let square = |h: f64| 0.1 * h.powf(1.2) + 2.0 * h * h - h.powi(3);
        let reference = 0.5f64.powi(14);
        let points = levels(|h| (square(h) - square(reference)).sqrt());
        let fit = Fit::against(&points, Some(reference)).unwrap();
        assert!((fit.order - 0.6).abs() < 1e-4 && fit.model == Model::PowerAndSeries, "{fit}");
    }

    #[test]
    fn noise_widens_the_bar() {
        let noisy = levels(|h| h.powf(0.7) * (1.0 + 0.2 * (4.0 * h.ln()).sin()));
        let fit = Fit::of(&noisy).unwrap();
        assert!(fit.half_width > 0.005 && (fit.order - 0.7).abs() < 0.05, "{fit}");
    }
}
