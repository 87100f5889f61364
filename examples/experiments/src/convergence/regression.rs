//! The slope of a quantity over the finer levels, where it is no error of a discrete solution: terms and constants along a
//! chain of estimates, whose slopes add up because the regression is linear.

use signorini::rates::{ConvergenceOrder, ErrorModel};

/// Fewest levels: a line and what it leaves.
const FEWEST: usize = 3;
/// Times the change of the slope when a level is left out at an end: two may change twice.
const ENDS: f64 = 2.0;
/// Standard errors that count as scatter: few levels are left over, and the 97.5 % quantile of Student's t
/// with four is 2.8.
const SCATTER: f64 = 3.0;

/// The slope of the regression line in ln q over ln h over the finer half of the levels (h, q), three at least.
///
/// The uncertainty is that of the slope *on these levels*, the larger of three standard errors and twice the largest change
/// when a level is left out at either end; it says nothing of the order as h → 0, which
/// [`ConvergenceOrder::of`] reads. `None` for fewer than three levels or a value that is not positive.
pub fn regression(points: &[(f64, f64)]) -> Option<ConvergenceOrder> {
    let is_positive = points.iter().all(|&(h, q)| h > 0.0 && q > 0.0 && q.is_finite());
    if points.len() < FEWEST || !is_positive {
        return None;
    }
    let finer = &points[(points.len() / 2).min(points.len() - FEWEST)..];
    let last = finer.len() - 1;
    let (order, error) = line(finer);
    let mut uncertainty = SCATTER * error;
    if finer.len() > FEWEST {
        for part in [&finer[1..], &finer[..last]] {
            uncertainty = uncertainty.max(ENDS * (line(part).0 - order).abs());
        }
    }
    let (model, regime) = (ErrorModel::Power, (finer[0].0, finer[last].0));
    Some(ConvergenceOrder { order, uncertainty, model, regime })
}

/// Slope of the regression line in logarithms and its standard error.
fn line(points: &[(f64, f64)]) -> (f64, f64) {
    let points: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let spread: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let slope = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread;
    let residual: f64 = points.iter().map(|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sum();
    (slope, if points.len() > 2 { (residual / (count - 2.0) / spread).sqrt() } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_a_series_that_scatters_lies_within_its_uncertainty() {
        let place = |k: i32| f64::from(k * k % 7) / 3.0 - 1.0;
        for p in [-0.1, 0.0, 0.75, 1.5] {
            for alternation in [0.03, 0.1] {
                for levels in [6, 9, 12] {
                    let term = |k: i32| 0.5f64.powf(f64::from(k) * p) * (1.0 + alternation * place(k));
                    let points: Vec<(f64, f64)> =
                        (3..3 + levels).map(|k| (0.5f64.powi(k), term(k))).collect();
                    let read = regression(&points).unwrap();
                    assert!((read.order - p).abs() <= read.uncertainty, "{p} {alternation} {levels}: {read}");
                }
            }
        }
        assert!(regression(&[(0.5, 1.0), (0.25, 1.0)]).is_none());
        assert!(regression(&[(0.5, 1.0), (0.25, 1.0), (0.125, 0.0)]).is_none());
    }
}
