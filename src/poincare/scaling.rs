//! Lemma 5.2 over a sequence of zones: growth of the constants, and what it says of (5.1)-(5.3).

use super::constant::{gamma, gamma_at_point, gamma_whole};
use super::limits::END_SLOPE;
use super::mellin::end_limit;
use super::zone::{Condition, Zone};
use crate::error::Result;
use crate::estimate::Tolerance;
use crate::report::Verdict;
use crate::sobolev::FractionalOrder;
use std::f64::consts::LN_2;

/// One order: constants computed for several zones, and the law of the limit θ → 0 where one is known.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalingCurve {
    /// ν.
    pub order: FractionalOrder,
    /// Pairs (θ, γ).
    pub computed: Vec<(f64, f64)>,
    /// Pairs (θ, law at θ); may be empty.
    pub law: Vec<(f64, f64)>,
}

impl ScalingCurve {
    /// Growth between the last two zones computed, beside the law; the constant itself where there is one zone only.
    pub fn growth(&self) -> Option<String> {
        let (nu, &(theta1, gamma1)) = (self.order, self.computed.last()?);
        let Some(&(theta0, gamma0)) = self.computed.iter().rev().find(|(theta, _)| *theta != theta1) else {
            return Some(format!("nu = {nu}: {gamma1:.9} at theta = {theta1:e}"));
        };
        let logarithm = (theta0 / theta1).ln();
        Some(if nu.is_below_half() {
            let power = (gamma1 / gamma0).ln() / -logarithm;
            format!("nu = {nu}: theta^{power:.4}, law theta^{:.4}", nu.offset())
        } else if nu.offset() == 0.0 {
            let slope = (gamma1 * gamma1 - gamma0 * gamma0) / logarithm;
            let inside = END_SLOPE / 3.0;
            format!(
                "nu = 1/2: gamma^2 gains {slope:.6} per ln(1/theta); law {END_SLOPE:.6} at an end, {inside:.6} inside"
            )
        } else {
            let limit = self.law.last().map_or(String::new(), |(_, law)| format!(", limit {law:.6}"));
            format!("nu = {nu}: {gamma1:.6}{limit}")
        })
    }

    /// The verdict on this order, from numbers only. With γ₁ the constant of the whole interval the lemma is tested with
    /// explicit constants, found here and not proved:
    ///
    /// * ν < 1/2: γ ≤ (γ₁ + B) θ^{ν−1/2}, B the limit of γ θ^{1/2−ν};
    /// * ν = 1/2: γ ≤ γ₁ + (A ln(1/θ))^{1/2}, A = 3/(2π²); by which factor (5.2) is loose, or where it fails;
    /// * ν > 1/2: γ ≤ γ₀, the constant for functions that vanish at an end.
    ///
    /// Functions that vanish on the zone have no such constant here when ν ≤ 1/2.
    ///
    /// # Errors
    /// As [`gamma`](super::gamma).
    pub fn verdict(&self, condition: Condition, tolerance: Tolerance) -> Result<Verdict> {
        let nu = self.order;
        let whole = gamma_whole(nu, tolerance)?.value;
        let explicit: Box<dyn Fn(f64) -> f64> = if nu.offset() > 0.0 {
            match gamma_at_point(nu, 0.0, tolerance) {
                Ok(at_end) => Box::new(move |_| at_end.value),
                // out of reach just above 1/2; |u|_ν grows with ν, so that the bound at 1/2 holds
                Err(_) => {
                    let half = gamma_whole(FractionalOrder::HALF, tolerance)?.value;
                    Box::new(move |theta: f64| half + (END_SLOPE * -theta.ln()).sqrt())
                }
            }
        } else if condition == Condition::Vanishing {
            Box::new(|_| f64::INFINITY)
        } else if nu.offset() == 0.0 {
            Box::new(move |theta: f64| whole + (END_SLOPE * -theta.ln()).sqrt())
        } else {
            let limit = end_limit(nu)?.value;
            Box::new(move |theta: f64| (whole + limit) * theta.powf(nu.offset()))
        };
        for &(theta, gamma) in &self.computed {
            let allowed = explicit(theta);
            // Both sides are known to the tolerance only, and near ν = 1 they agree to many digits.
            if gamma > allowed * (1.0 + 4.0 * tolerance.relative()) {
                let words = format!("{gamma} > {allowed} at nu = {nu}, theta = {theta:e}");
                return Ok(Verdict::NotConfirmed(words));
            }
        }
        if nu.offset() != 0.0 {
            return Ok(Verdict::Holds);
        }
        if let Some((theta, gamma)) = self.computed.iter().find(|(theta, _)| *theta > 0.5) {
            let words = "but ln(1/theta) -> 0 as theta -> 1; it holds for theta <= 1/2";
            return Ok(Verdict::PrintedFormFails(format!("gamma = {gamma:.4} at theta = {theta}, {words}")));
        }
        let at_half = gamma(nu, Zone::end(0.5)?, Condition::MeanZero, tolerance)?.value / LN_2;
        let smallest = self.computed.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0));
        Ok(smallest.map_or(Verdict::Holds, |(theta, gamma)| {
            let factor = at_half * -theta.ln() / gamma;
            Verdict::HoldsLoose(format!(
                "a factor {factor:.3} at nu = 1/2, theta = {theta:e} (C from theta = 1/2)"
            ))
        }))
    }
}
