//! A quantity that alternates about a power of h: errors of one transition, at another place of its cell on every
//! level. Its order with what it may be off by, and how far the finer levels depart from one power.

use super::regression::regression;
use signorini::rates::ConvergenceOrder;

/// q = C h^p on the finer levels, up to an alternation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trend {
    /// The order as h → 0, from all levels.
    pub order: ConvergenceOrder,
    /// The slope of the regression line over the finer half of the levels.
    pub slope: f64,
    /// The factor by which that line rises from its coarsest to its finest level; below one where it falls.
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
        let ratios: Vec<(f64, f64)> = errors.iter().zip(bound).map(|(e, b)| (e.0, e.1 / b.1)).collect();
        Self::along(&ratios, ConvergenceOrder::of_power(&ratios)?)
    }

    /// Of errors of linear elements (h, e), coarsest first; `None` for fewer than five, or where e is not positive.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        Self::along(points, ConvergenceOrder::of(points)?)
    }

    fn along(points: &[(f64, f64)], order: ConvergenceOrder) -> Option<Self> {
        let ConvergenceOrder { order: slope, regime: (coarsest, finest), .. } = regression(points)?;
        let finer = points.iter().filter(|point| point.0 <= coarsest);
        // What is left of ln q without the power, about its mean: the residual of the regression line.
        let rest: Vec<f64> = finer.map(|(h, q)| q.ln() - slope * h.ln()).collect();
        let mean = rest.iter().sum::<f64>() / rest.len() as f64;
        let alternation = rest.iter().map(|r| (r - mean).abs()).fold(0.0, f64::max).exp();
        Some(Self { order, slope, rise: (finest / coarsest).powf(slope), alternation, levels: rest.len() })
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
            let of = |alternation: f64| {
                let ones: Vec<(f64, f64)> = series(exponent, 0.0).iter().map(|&(h, _)| (h, 1.0)).collect();
                Trend::of_ratio(&series(exponent, alternation), &ones).unwrap()
            };
            let exact = of(0.0);
            assert!((exact.slope - exponent).abs() < 1e-13, "{exact:?}");
            assert!(
                (exact.order.order - exponent).abs() < 1e-6 && exact.order.uncertainty < 1e-5,
                "{exact:?}"
            );
            assert!((exact.rise - 32f64.powf(-exponent)).abs() < 1e-11 && exact.alternation < 1.0 + 1e-12);
            for alternation in [0.03, 0.1] {
                let trend = of(alternation);
                assert!((trend.order.order - exponent).abs() < trend.order.uncertainty, "{trend:?}");
                assert!(trend.alternation < 1.0 + 3.0 * alternation);
            }
        }
    }

    #[test]
    fn too_little_shows_no_trend() {
        assert!(Trend::of(&series(1.0, 0.0)[..4]).is_none());
        assert!(Trend::of(&[(0.5, 1.0), (0.25, 0.0), (0.125, 1.0)]).is_none());
        assert_eq!(Trend::of(&series(1.0, 0.0)[..5]).unwrap().levels, 3);
    }
}
