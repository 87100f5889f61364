//! The exponent of a quantity that alternates about a power of h: errors of one transition, at another place
//! of its cell on every level.
//!
//! The regression line of ln q against ln h over the finer half of the levels (at least three). Its
//! uncertainty is the larger of three standard errors (the alternation as scatter) and twice the largest
//! change when a level is left out at either end (a series that has not settled). [`signorini::rates::ConvergenceOrder`] asks more:
//! it is for series without alternation, or averaged over it.

use crate::line::Line;

/// Fewest levels that show a trend.
const FEWEST: usize = 3;
/// Standard errors that count as scatter: the 97.5 % quantile of Student's t with four degrees of freedom is
/// 2.8.
const SCATTER: f64 = 3.0;
/// What one level left out changes, two may change twice.
const WINDOWS: f64 = 2.0;

/// q = C h^p on the finer levels, up to an alternation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trend {
    /// p.
    pub exponent: f64,
    /// What p may be off by.
    pub uncertainty: f64,
    /// The factor by which the line rises from its coarsest to its finest level; below one where it falls.
    pub rise: f64,
    /// The largest factor between the series and the line, either way.
    pub alternation: f64,
    /// Number of levels on the line.
    pub levels: usize,
}

impl Trend {
    /// The rise that says nothing: the alternation, and what an order may still lack by `unsettled` on these
    /// levels, h halved each time.
    pub fn noise(&self, unsettled: f64) -> f64 {
        self.alternation * (unsettled * (self.levels - 1) as f64).exp2()
    }

    /// Of error over bound, given as pairs with the same h.
    pub fn of_ratio(errors: &[(f64, f64)], bound: &[(f64, f64)]) -> Option<Self> {
        Self::of(&errors.iter().zip(bound).map(|(e, b)| (e.0, e.1 / b.1)).collect::<Vec<_>>())
    }

    /// Of the pairs (h, q), coarsest first; `None` for fewer than three, or where q is not positive.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        let is_positive = points.iter().all(|&(h, q)| h > 0.0 && q > 0.0 && q.is_finite());
        if points.len() < FEWEST || !is_positive {
            return None;
        }
        let finer = &points[(points.len() / 2).min(points.len() - FEWEST)..];
        let count = finer.len();
        let line = Line::through_logarithms(finer);
        let mut uncertainty = SCATTER * line.error;
        if count > FEWEST {
            for part in [&finer[1..], &finer[..count - 1]] {
                let change = Line::through_logarithms(part).slope - line.slope;
                uncertainty = uncertainty.max(WINDOWS * change.abs());
            }
        }
        let departure = |&(h, q): &(f64, f64)| (q.ln() - line.intercept - line.slope * h.ln()).abs();
        Some(Self {
            exponent: line.slope,
            uncertainty,
            rise: (finer[count - 1].0 / finer[0].0).powf(line.slope),
            alternation: finer.iter().map(departure).fold(0.0, f64::max).exp(),
            levels: count,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(exponent: f64, alternation: f64) -> Vec<(f64, f64)> {
        let place = |k: i32| f64::from(k * k % 7) / 3.0 - 1.0;
        (3..15)
            .map(|k| (0.5f64.powi(k), 0.5f64.powf(f64::from(k) * exponent) * (1.0 + alternation * place(k))))
            .collect()
    }

    #[test]
    fn the_exponent_lies_within_its_uncertainty() {
        for exponent in [-0.1, 0.0, 0.75] {
            let exact = Trend::of(&series(exponent, 0.0)).unwrap();
            assert!((exact.exponent - exponent).abs() < 1e-13 && exact.uncertainty < 1e-12, "{exact:?}");
            assert!((exact.rise - 32f64.powf(-exponent)).abs() < 1e-11 && exact.alternation < 1.0 + 1e-12);
            for alternation in [0.03, 0.1] {
                let trend = Trend::of(&series(exponent, alternation)).unwrap();
                assert!((trend.exponent - exponent).abs() < trend.uncertainty, "{trend:?}");
                assert!(trend.alternation < 1.0 + 3.0 * alternation);
            }
        }
    }

    #[test]
    fn too_little_shows_no_trend() {
        assert!(Trend::of(&series(1.0, 0.0)[..2]).is_none());
        assert!(Trend::of(&[(0.5, 1.0), (0.25, 0.0), (0.125, 1.0)]).is_none());
        assert_eq!(Trend::of(&series(1.0, 0.0)[..5]).unwrap().levels, 3);
    }
}
