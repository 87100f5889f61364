//! A quantity that alternates about a power of h: errors of one transition, at another place of its cell on every
//! level. Its order by [`ConvergenceOrder::of_scattered`], and how far the series departs from that power.

use signorini::rates::ConvergenceOrder;

/// q = C h^p on the finer levels, up to an alternation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trend {
    /// p, over the finer half of the levels.
    pub order: ConvergenceOrder,
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
        let order = ConvergenceOrder::of_scattered(points)?;
        let finer: Vec<(f64, f64)> =
            points.iter().copied().filter(|point| point.0 <= order.regime.0).collect();
        // What is left of ln q without the power, about its mean: the residual of the regression line.
        let rest: Vec<f64> = finer.iter().map(|(h, q)| q.ln() - order.order * h.ln()).collect();
        let mean = rest.iter().sum::<f64>() / rest.len() as f64;
        Some(Self {
            order,
            rise: (order.regime.1 / order.regime.0).powf(order.order),
            alternation: rest.iter().map(|r| (r - mean).abs()).fold(0.0, f64::max).exp(),
            levels: finer.len(),
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
            assert!(
                (exact.order.order - exponent).abs() < 1e-13 && exact.order.uncertainty < 1e-12,
                "{exact:?}"
            );
            assert!((exact.rise - 32f64.powf(-exponent)).abs() < 1e-11 && exact.alternation < 1.0 + 1e-12);
            for alternation in [0.03, 0.1] {
                let trend = Trend::of(&series(exponent, alternation)).unwrap();
                assert!((trend.order.order - exponent).abs() < trend.order.uncertainty, "{trend:?}");
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
