//! The Mellin symbol of the seminorm on the half line.
//!
//! |f|²_{ν,(0,∞)} = (1/2π) ∫ C(t) |a(t)|² dt for f = (1/2π) ∫ a(t) x^{ν−1/2+it} dt, 0 < ν < 1/2,
//! C(t) = (1/ν) [ 2 Γ(1−2ν) Re( Γ(1/2+ν+it) / Γ(1/2−ν+it) ) − 1 ].
//!
//! With p = 1 − 2ν the bracket is Re[(1 + 2it/p) e^G] − 1, G = ln Γ(1+p) − [ln Γ(1+p/2+it) − ln Γ(1−p/2+it)].

use crate::numeric::gamma::log_gamma_difference;
use nalgebra::Complex;

/// The symbol C for one order.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HalfLineSymbol {
    /// p = 1 − 2ν.
    gap: f64,
    /// ln Γ(1+p).
    log_gamma: f64,
}

impl HalfLineSymbol {
    /// The symbol for p = 1 − 2ν in (0, 1).
    pub(crate) fn new(gap: f64) -> Self {
        Self { gap, log_gamma: log_gamma_difference(Complex::new(1.0 + 0.5 * gap, 0.0), gap).re }
    }

    /// The value ν C(t).
    pub(crate) fn at(&self, t: f64) -> f64 {
        let g = self.log_gamma - log_gamma_difference(Complex::new(1.0, t), self.gap);
        let half = (0.5 * g.im).sin();
        g.re.exp_m1() - g.re.exp() * (2.0 * half * half + 2.0 * t / self.gap * g.im.sin())
    }
}
