//! The explicit constants of the proofs for one τ and a fixed set of zones, computed at construction.

use crate::error::{Error, Result, ToolkitError};
use crate::numeric::parallel;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Order, Tolerance, embedding_bound, gamma,
    interpolation_constant, projection_constant,
};
use std::collections::HashMap;

/// Relative tolerance of γ_θ; the estimated error is added, so that the constant is an upper bound.
const GAMMA: f64 = 1e-5;
/// Zones 2^{−1}, ..., 2^{−LAW} that, in addition to the requested zones, determine the constant of the printed law.
const LAW: i32 = 16;
/// At τ = 2 the law is evaluated only for θ ≤ 1/2: ln(1/θ) vanishes at θ = 1, γ does not.
const LARGEST_ZONE_OF_LAW: f64 = 0.5;

/// A bound evaluated with the printed law of γ_θ and with the corrected law; they differ only at τ = 2.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TwoLaws {
    /// The bound with γ_θ ≤ C ln(1/θ) at τ = 2, γ_θ ≤ C θ^{τ−2} for τ < 2, γ_θ ≤ C for τ > 2.
    pub printed: f64,
    /// The bound with γ_θ ≤ C √ln(1/θ) at τ = 2, otherwise as printed.
    pub corrected: f64,
}

/// The constants C(q), C_L2, γ₁, 1/π, 1/√3 and γ_θ for one regularity τ and a fixed set of zones, that is,
/// subintervals of length θ at an end of the unit interval; each is an upper bound, the computed value plus
/// its error estimate.
///
/// ```
/// use signorini::proof::ProofConstants;
/// let constants = ProofConstants::new(1.75, 2.0, &[0.25])?;
/// assert_eq!((constants.q(), constants.hoelder()), (4.0, 0.75));
/// // The Poincaré constant grows as the zone shrinks, at most like its law C θ^{τ−2}.
/// assert!(constants.gamma(0.125)? >= constants.gamma(0.25)?);
/// assert!(constants.gamma(0.25)? <= constants.law(0.25).printed * (1.0 + 1e-12));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ProofConstants {
    tau: f64,
    order: Order,
    q: f64,
    /// An upper bound of the constant C(q) of the embedding H^s(0,1) ⊂ L^q(0,1), s = min(ν, 1/2), with the
    /// full norm.
    pub embedding: f64,
    /// The constant C_L2(ν) of Lemma 6.1.
    pub interpolation: f64,
    /// The constant γ₁(ν) of (4.6).
    pub projection: f64,
    /// The constant 1/π of (4.6) for r = 1.
    pub wirtinger: f64,
    /// The constant 1/√3 of (6.2).
    pub pointwise: f64,
    /// The constants C of the printed law and of the corrected law; for τ > 2 the constant itself.
    factors: TwoLaws,
    /// γ_θ, by the bits of θ; empty for τ > 2.
    gammas: HashMap<u64, f64>,
}

impl ProofConstants {
    /// The constants for 3/2 < τ < 5/2 and zones of the lengths `thetas` in (0, 1], to which 1, 2^{−1}, ...,
    /// 2^{−16} are added; q ≥ 2 is used for τ ≥ 2 (q = 2 in the paper), for τ < 2 q = 1/(2 − τ).
    ///
    /// The constants C of the laws are the largest ratios over all these zones, at τ = 2 over those with θ ≤
    /// 1/2. For τ > 2 no zones are used. Cost: one eigenvalue problem per zone.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for arguments outside these ranges;
    /// [`ToolkitError::ToleranceNotMet`](crate::ToolkitError::ToleranceNotMet) if the tolerance of a constant
    /// is not met.
    pub fn new(tau: f64, q: f64, thetas: &[f64]) -> Result<Self> {
        Error::require("tau", tau, "(3/2, 5/2)", tau > 1.5 && tau < 2.5)?;
        let order = Order::half_plus(tau - 2.0)?;
        let tolerance = Tolerance::balanced();
        let upper = |e: fractional_sobolev::Estimate| e.value + e.error;
        let (q, embedding) = if tau < 2.0 {
            let q = 2.0 / (-2.0 * order.offset());
            (q, embedding_bound(order, q)?.upper)
        } else {
            (q, embedding_bound(Order::HALF, q)?.upper)
        };
        let embedding = embedding.map_or(f64::NAN, upper);
        let (gammas, factors) = if tau > 2.0 {
            let constant = upper(
                gamma(order, Constraint::vanishing_at(0.0), Tolerance::new(GAMMA)?)?.constant,
            );
            (HashMap::new(), TwoLaws { printed: constant, corrected: constant })
        } else {
            let gammas = zone_constants(order, thetas)?;
            let factors = law_factors(tau, &gammas);
            (gammas, factors)
        };
        let unit = Domain::Interval(1.0);
        let interpolation =
            interpolation_constant(unit.clone(), ErrorNorm::L2, order, tolerance)?.constant;
        let projection = |norm, r: f64| {
            projection_constant(unit.clone(), norm, r, tolerance).map(|found| upper(found.constant))
        };
        Ok(Self {
            tau,
            order,
            q,
            embedding,
            interpolation: upper(interpolation),
            projection: projection(ErrorNorm::L2, order.value())?,
            wirtinger: projection(ErrorNorm::L2, 1.0)?,
            pointwise: projection(ErrorNorm::At(0.0), 1.0)?,
            factors,
            gammas,
        })
    }

    /// The regularity τ.
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// The order ν = τ − 3/2.
    pub fn order(&self) -> Order {
        self.order
    }

    /// The exponent q of the embedding.
    pub fn q(&self) -> f64 {
        self.q
    }

    /// The exponent 1 − 1/q: τ − 1 for τ < 2.
    pub fn hoelder(&self) -> f64 {
        1.0 - 1.0 / self.q
    }

    /// An upper bound of γ_θ(ν), for functions of mean zero on a zone of length θ at an end of the interval; for τ >
    /// 2 the constant for functions vanishing at an end, which does not depend on θ.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) if no constant was computed for this θ.
    pub fn gamma(&self, theta: f64) -> Result<f64> {
        if self.tau > 2.0 {
            return Ok(self.factors.printed);
        }
        let range = "the list of lengths for which the constants were computed";
        self.gammas.get(&theta.to_bits()).copied().ok_or(Error::Toolkit(ToolkitError::OutOfRange {
            name: "theta",
            value: theta,
            range,
        }))
    }

    /// An upper bound of γ for a zone of at least the given fraction of the segment: its length is rounded down to a
    /// power of 1/2.
    ///
    /// # Errors
    /// As for [`ProofConstants::gamma`].
    pub fn gamma_below(&self, share: f64) -> Result<f64> {
        let power = share.min(1.0).log2().floor();
        // log2 may round up to the next integer
        let theta = if power.exp2() > share { 0.5 * power.exp2() } else { power.exp2() };
        self.gamma(theta)
    }

    /// The laws of γ_θ with their constants: C θ^{τ−2} for τ < 2; C ln(1/θ) as printed and C √ln(1/θ) as
    /// corrected, for θ ≤ 1/2, at τ = 2; C for τ > 2.
    pub fn law(&self, theta: f64) -> TwoLaws {
        let laws = laws(self.tau, theta);
        TwoLaws {
            printed: self.factors.printed * laws.printed,
            corrected: self.factors.corrected * laws.corrected,
        }
    }
}

/// The laws without their constants.
fn laws(tau: f64, theta: f64) -> TwoLaws {
    if tau == 2.0 {
        return TwoLaws { printed: -theta.ln(), corrected: (-theta.ln()).sqrt() };
    }
    let power = theta.powf((tau - 2.0).min(0.0));
    TwoLaws { printed: power, corrected: power }
}

/// γ_θ(ν) plus its estimated error, for the given zones and the powers of 1/2.
fn zone_constants(order: Order, thetas: &[f64]) -> Result<HashMap<u64, f64>> {
    let mut zones: Vec<f64> =
        (0..=LAW).map(|k| 0.5f64.powi(k)).chain(thetas.iter().copied()).collect();
    zones.sort_by(f64::total_cmp);
    zones.dedup();
    let tolerance = Tolerance::new(GAMMA)?;
    let constant = |&theta: &f64| -> Result<(u64, f64)> {
        let found = gamma(order, Constraint::mean_zero_on(0.0..theta), tolerance)?.constant;
        Ok((theta.to_bits(), found.value + found.error))
    };
    parallel::over(&zones, constant).into_iter().collect()
}

/// The largest ratios of γ_θ and its laws.
fn law_factors(tau: f64, gammas: &HashMap<u64, f64>) -> TwoLaws {
    let zones = gammas.iter().map(|(&bits, &gamma)| (f64::from_bits(bits), gamma));
    let mut most = TwoLaws::default();
    for (theta, gamma) in zones.filter(|&(theta, _)| tau < 2.0 || theta <= LARGEST_ZONE_OF_LAW) {
        let laws = laws(tau, theta);
        most.printed = most.printed.max(gamma / laws.printed);
        most.corrected = most.corrected.max(gamma / laws.corrected);
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_do_not_depend_on_the_order_of_the_zones() {
        let forward = ProofConstants::new(1.75, 2.0, &[0.3, 1e-7]).unwrap();
        let backward = ProofConstants::new(1.75, 2.0, &[1e-7, 0.3, 0.3]).unwrap();
        assert_eq!(forward, backward);
        assert!(forward.gamma(0.3).is_ok() && forward.gamma(0.31).is_err());
        assert!(forward.gamma(0.3).unwrap() <= forward.law(0.3).printed);
    }
}
