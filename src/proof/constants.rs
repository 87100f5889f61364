//! The explicit constants of one τ.

use crate::error::{Error, Result};
use crate::estimate::Tolerance;
use crate::interpolation::{
    ErrorNorm, critical_exponent, element_constant, embedding_upper_bound, limits, projection_constant,
};
use crate::poincare::{Condition, Zone, gamma, gamma_at_point};
use crate::sobolev::FractionalOrder;
use std::collections::HashMap;

/// Asked of γ_θ; the estimated error is added, so that the constant is an upper bound.
const GAMMA: f64 = 1e-5;
/// Zones 2^{−1}, ..., 2^{−LAW} from which the constant of the printed law is read.
const LAW: i32 = 16;

/// C(q), C_L2, γ₁, 1/π, 1/√3 and γ_θ for one regularity τ.
#[derive(Debug, Clone)]
pub struct ProofConstants {
    tau: f64,
    order: FractionalOrder,
    q: f64,
    /// C(q) of H^ν(0,1) ⊂ L^q(0,1) with the full norm, from above.
    pub embedding: f64,
    /// C_L2(ν) of Lemma 6.1.
    pub interpolation: f64,
    /// γ₁(ν) of (4.6).
    pub projection: f64,
    /// 1/π of (4.6) for r = 1.
    pub wirtinger: f64,
    /// 1/√3 of (6.2).
    pub pointwise: f64,
    /// sup of γ_θ over the printed law.
    law: f64,
    /// sup of γ_θ/√ln(1/θ) at τ = 2.
    corrected_law: f64,
    gammas: HashMap<u64, f64>,
}

impl ProofConstants {
    /// For 3/2 < τ < 5/2; q ≥ 2 is used at τ = 2 only (2 in the paper), q = 1/(2 − τ) below.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside these ranges; [`Error::ToleranceNotMet`] from the constants.
    pub fn new(tau: f64, q: f64) -> Result<Self> {
        Error::require("tau", tau, "(3/2, 5/2)", tau > 1.5 && tau < 2.5)?;
        let order = FractionalOrder::from_offset(tau - 2.0)?;
        let tolerance = Tolerance::balanced();
        let upper = |e: crate::Estimate| e.value + e.error;
        let (q, embedding) = if tau < 2.0 {
            let q = critical_exponent(order)?;
            (q, embedding_upper_bound(order, q)?.value)
        } else {
            (q, embedding_upper_bound(FractionalOrder::HALF, q)?.value)
        };
        let mut constants = Self {
            tau,
            order,
            q,
            embedding,
            interpolation: upper(element_constant(ErrorNorm::L2, order, tolerance)?),
            projection: upper(projection_constant(order.value(), tolerance)?),
            wirtinger: upper(projection_constant(1.0, tolerance)?),
            pointwise: upper(limits::pointwise(0.0)?),
            law: 0.0,
            corrected_law: 0.0,
            gammas: HashMap::new(),
        };
        if tau > 2.0 {
            constants.law = upper(gamma_at_point(order, 0.0, Tolerance::new(GAMMA)?)?);
            constants.corrected_law = constants.law;
        } else {
            for k in 1..=LAW {
                constants.gamma(0.5f64.powi(k))?;
            }
        }
        Ok(constants)
    }

    /// τ.
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// ν = τ − 3/2.
    pub fn order(&self) -> FractionalOrder {
        self.order
    }

    /// q.
    pub fn q(&self) -> f64 {
        self.q
    }

    /// 1 − 1/q: τ − 1 for τ < 2.
    pub fn hoelder(&self) -> f64 {
        1.0 - 1.0 / self.q
    }

    /// γ_θ(ν), mean zero on a zone of length θ at an end, from above; τ > 2: vanishing at an end, whatever θ.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for θ outside (0, 1].
    pub fn gamma(&mut self, theta: f64) -> Result<f64> {
        if self.tau > 2.0 {
            return Ok(self.law);
        }
        if let Some(&known) = self.gammas.get(&theta.to_bits()) {
            return Ok(known);
        }
        let zone = Zone::end(theta)?;
        let found = gamma(self.order, zone, Condition::MeanZero, Tolerance::new(GAMMA)?)?;
        let value = found.value + found.error;
        self.gammas.insert(theta.to_bits(), value);
        // Constants of the laws: never below a value that was used.
        if self.tau < 2.0 {
            self.law = self.law.max(value * theta.powf(2.0 - self.tau));
            self.corrected_law = self.law;
        } else if theta <= 0.5 {
            self.law = self.law.max(value / -theta.ln());
            self.corrected_law = self.corrected_law.max(value / (-theta.ln()).sqrt());
        }
        Ok(value)
    }

    /// γ for a zone of at least this share of the segment: its length rounded down to a power of 1/2.
    ///
    /// # Errors
    /// As [`ProofConstants::gamma`].
    pub fn gamma_below(&mut self, share: f64) -> Result<f64> {
        let power = share.min(1.0).log2().floor();
        // log2 may round up to the next integer
        let theta = if power.exp2() > share { 0.5 * power.exp2() } else { power.exp2() };
        self.gamma(theta)
    }

    /// The printed law of γ_θ with its constant: C θ^{τ−2}; C ln(1/θ) at τ = 2; C above.
    pub fn law(&self, theta: f64) -> f64 {
        match self.tau {
            tau if tau < 2.0 => self.law * theta.powf(tau - 2.0),
            2.0 => self.law * -theta.ln(),
            _ => self.law,
        }
    }

    /// The law that holds: C √ln(1/θ) at τ = 2, else the printed one.
    pub fn corrected_law(&self, theta: f64) -> f64 {
        if self.tau == 2.0 { self.corrected_law * (-theta.ln()).sqrt() } else { self.law(theta) }
    }
}
