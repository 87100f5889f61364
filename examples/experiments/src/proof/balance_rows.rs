//! The balance of θ over element lengths: the bounds at the printed θ and where they cross, beside the worst
//! pairs there are.
//!
//! *θ of the segment's own.* Nodal cone: take the vertex with the larger |u_N|, at distance r h from the
//! nearest zero, and m the mean of u_N' over T, |m| h ≤ M = max|u_N(a_i)| as both values have one sign. From
//! the vertex to the zero,
//!
//! M ≤ ∫|u_N' − m| + r h |m| ≤ (rh)^{1−1/q} ‖u_N' − m‖_{L^q} + r M,  ‖σ_N‖₀ ≤ γ_r h^ν |σ_N|_ν,
//!
//! the second because σ_N = 0 on that piece: (3.5) and (3.12) at the same θ = r. With
//! ‖v − m‖_{L^q(0,1)} ≤ C(q) (1 + γ₁²)^{1/2} |v|_ν the term is at most
//! C r^{1−1/q} γ_r/(1−r) h^{2τ−2} |σ_N|_ν |u_N'|_ν for r ≤ 1/2, and r^{1−1/q} γ_r is r^{2ν}, at ν = 1/2
//! r^{1−1/q} times a logarithm. For r ≥ 1/2 (3.14) with θ = 1/2 does it. Midpoint cone, r h
//! the distance of the first and the last contact point: σ_N = 0 off this piece and u_N' has mean zero on it,
//! and the same with ‖σ_N‖_{L¹} ≤ (rh)^{1−1/q} ‖σ_N‖_{L^q},
//! ‖u_N − π^h u_N‖_{L^∞} ≤ h^{1/2} ‖u_N'‖₀/√3, ‖u_N'‖₀ ≤ γ_r h^ν |u_N'|_ν.

use super::balance::{ElementBalance, WorstPair};
use crate::convergence::regression;
use signorini::cone::Cone;
use signorini::proof::ThetaRule;
use signorini::rates::ConvergenceOrder;
use signorini::{Error, Result, ToolkitError};

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
    /// The largest bound with θ_T = r over all contact intervals, nodal and midpoint cone.
    pub own: [f64; 2],
    /// The largest W over the bound with θ_T = r of the nodal cone: at most 1.
    pub own_share: f64,
}

/// r of a worst pair: the distance of the vertex with the larger |u_N| from contact, in units of h; for the
/// midpoint cone the diameter of the contact set.
fn own_theta(pair: &WorstPair, cone: Cone) -> f64 {
    let ([a, b], [left, right]) = (pair.ends, pair.direction);
    match cone {
        Cone::Nodal => {
            if left >= right {
                a
            } else {
                b
            }
        }
        Cone::Midpoint => 1.0 - a - b,
    }
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
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) unless 0 < h < 1.
    pub fn rows(&self, lengths: &[f64]) -> Result<Vec<BalanceRow>> {
        lengths.iter().map(|&h| self.row(h)).collect()
    }

    /// The bound of the consistency term over |σ_N|_ν |u_N'|_ν on an element of length h ≤ 1 with θ_T = r in
    /// (0, 1]: both cases at once.
    pub fn own_bound(&self, cone: Cone, h: f64, r: f64) -> f64 {
        let constants = self.constants();
        let scale = h.powf(1.0 + 2.0 * constants.order().value());
        let gamma = |theta: f64| constants.law(theta).printed;
        let norm = |part: f64| constants.embedding * part.hypot(1.0);
        let near = r.powf(constants.hoelder()) * gamma(r.min(0.5));
        scale
            * match (cone, r <= 0.5) {
                (Cone::Nodal, true) => norm(constants.projection) * near / (1.0 - r),
                (Cone::Nodal, false) => gamma(0.5) * constants.interpolation,
                (Cone::Midpoint, true) => norm(gamma(0.5)) * near * constants.pointwise,
                (Cone::Midpoint, false) => constants.projection * constants.wirtinger * gamma(0.5),
            }
    }

    fn row(&self, h: f64) -> Result<BalanceRow> {
        let theta = ThetaRule::Printed { tau: self.constants().tau() }.theta(h)?;
        let pairs = self.worst_pairs(h)?;
        let larger = |theta: f64| self.first_bound(h, theta).max(self.second_bound(h, theta)[0]);
        let (crossing, sharpened) = (self.crossing(h, false), self.crossing(h, true));
        let sharp = self.sharpened_first_bound(h, sharpened).max(self.second_bound(h, sharpened)[1]);
        let none = WorstPair { ends: [0.0; 2], value: 0.0, direction: [0.0; 2] };
        let worst = pairs.iter().fold(none, |best, p| if p.value > best.value { *p } else { best });
        let own = |pair: &WorstPair, cone: Cone| self.own_bound(cone, h, own_theta(pair, cone));
        let largest =
            |cone: Cone| pairs.iter().map(|pair| own(pair, cone)).fold(0.0, |m: f64, bound| m.max(bound));
        let shares = pairs.iter().map(|pair| pair.value / own(pair, Cone::Nodal));
        Ok(BalanceRow {
            h,
            printed: [theta, larger(theta)],
            crossing: [crossing, larger(crossing)],
            sharpened: [sharpened, sharp],
            cases: worst_of_cases(&pairs, theta),
            worst,
            own: [Cone::Nodal, Cone::Midpoint].map(largest),
            own_share: shares.fold(0.0, f64::max),
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
    pub printed: ConvergenceOrder,
    /// Of the bounds where they cross.
    pub crossing: ConvergenceOrder,
    /// Of the sharpened bounds where they cross.
    pub sharpened: ConvergenceOrder,
    /// Of the worst pair.
    pub worst: ConvergenceOrder,
    /// Of the largest bound with θ_T = r, nodal and midpoint cone.
    pub own: [ConvergenceOrder; 2],
}

impl BalanceExponents {
    /// By least squares over at least three lengths.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) with fewer than three lengths.
    pub fn fit(rows: &[BalanceRow]) -> Result<Self> {
        let few = ToolkitError::CountOutOfRange { name: "lengths", value: rows.len(), range: "[3, inf)" };
        let fit = |value: &dyn Fn(&BalanceRow) -> f64| {
            let points: Vec<(f64, f64)> = rows.iter().map(|r| (r.h, value(r))).collect();
            regression(&points).ok_or_else(|| Error::Toolkit(few.clone()))
        };
        Ok(Self {
            printed: fit(&|r| r.printed[1])?,
            crossing: fit(&|r| r.crossing[1])?,
            sharpened: fit(&|r| r.sharpened[1])?,
            worst: fit(&|r| r.worst.value)?,
            own: [fit(&|r| r.own[0])?, fit(&|r| r.own[1])?],
        })
    }
}
