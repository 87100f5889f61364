//! The balance of θ over element lengths: the bounds at the printed θ and where they cross, beside the worst
//! pairs there are.

use super::balance::{ElementBalance, WorstPair};
use super::exponent::Exponent;
use super::theta::printed_theta;
use crate::error::Result;

/// Bounds and worst cases of one element length.
#[derive(Debug, Clone, PartialEq)]
pub struct BalanceRow {
    /// h.
    pub h: f64,
    /// The printed θ and the larger bound there.
    pub printed: [f64; 2],
    /// θ where the printed bounds cross and the bound there.
    pub crossing: [f64; 2],
    /// The same for the sharpened bounds.
    pub sharpened: [f64; 2],
    /// Worst case over the contact sets of the first case, of the second, for the printed θ.
    pub cases: [f64; 2],
    /// Worst case over all contact sets.
    pub worst: WorstPair,
    /// W of all contact intervals.
    pub pairs: Vec<WorstPair>,
}

/// W over the contact sets [a, 1 − b] of the first case, max(a, b) ≤ θ, and of the second, max(a, b) ≥ θ;
/// zero without any.
pub fn worst_of_cases(pairs: &[WorstPair], theta: f64) -> [f64; 2] {
    let worst = |keep: &dyn Fn(f64) -> bool| {
        let kept = pairs.iter().filter(|p| keep(p.ends[0].max(p.ends[1])));
        kept.fold(0.0, |m: f64, p| m.max(p.value))
    };
    [worst(&|a| a <= theta), worst(&|a| a >= theta)]
}

impl ElementBalance {
    /// Bounds and worst cases for the given element lengths.
    ///
    /// # Errors
    /// [`crate::Error::OutOfRange`] unless 0 < h < 1.
    pub fn rows(&self, lengths: &[f64]) -> Result<Vec<BalanceRow>> {
        lengths.iter().map(|&h| self.row(h)).collect()
    }

    fn row(&self, h: f64) -> Result<BalanceRow> {
        let theta = printed_theta(h, self.constants().tau())?;
        let pairs = self.worst_pairs(h)?;
        let larger = |theta: f64| self.first_bound(h, theta).max(self.second_bound(h, theta)[0]);
        let (crossing, sharpened) = (self.crossing(h, false), self.crossing(h, true));
        let sharp = self.sharpened_first_bound(h, sharpened).max(self.second_bound(h, sharpened)[1]);
        let none = WorstPair { ends: [0.0; 2], value: 0.0, direction: [0.0; 2] };
        let worst = pairs.iter().fold(none, |best, p| if p.value > best.value { *p } else { best });
        Ok(BalanceRow {
            h,
            printed: [theta, larger(theta)],
            crossing: [crossing, larger(crossing)],
            sharpened: [sharpened, sharp],
            cases: worst_of_cases(&pairs, theta),
            worst,
            pairs,
        })
    }

    /// The largest W(E) over the bound of its own case at θ = max(a, b), the sharper one where two are known,
    /// over all contact intervals of all rows: at most one unless a bound fails.
    ///
    /// The second case has a bound for θ ≤ 1/2 only.
    pub fn largest_share(&self, rows: &[BalanceRow]) -> f64 {
        let share = |h: f64, pair: &WorstPair| {
            let theta = pair.ends[0].max(pair.ends[1]);
            let second = self.second_bound(h, theta);
            let second = if theta <= 0.5 { second[0].min(second[1]) } else { f64::INFINITY };
            pair.value / self.sharpened_first_bound(h, theta).min(second)
        };
        let shares = rows.iter().flat_map(|row| row.pairs.iter().map(move |pair| share(row.h, pair)));
        shares.fold(0.0, f64::max)
    }
}

/// Exponents of h over the rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BalanceExponents {
    /// Of the larger bound at the printed θ.
    pub printed: Exponent,
    /// Of the bounds where they cross.
    pub crossing: Exponent,
    /// Of the sharpened bounds where they cross.
    pub sharpened: Exponent,
    /// Of the worst pair.
    pub worst: Exponent,
}

impl BalanceExponents {
    /// By least squares over at least three lengths.
    ///
    /// # Errors
    /// [`crate::Error::CountOutOfRange`] with fewer than three lengths.
    pub fn fit(rows: &[BalanceRow]) -> Result<Self> {
        let fit = |value: &dyn Fn(&BalanceRow) -> f64| {
            Exponent::fit(&rows.iter().map(|r| (r.h, value(r))).collect::<Vec<_>>())
        };
        Ok(Self {
            printed: fit(&|r| r.printed[1])?,
            crossing: fit(&|r| r.crossing[1])?,
            sharpened: fit(&|r| r.sharpened[1])?,
            worst: fit(&|r| r.worst.value)?,
        })
    }
}
