//! Constants of Lemma 6.1 in the limits of small and large orders, and the constant of (6.2).
//!
//! - ν → 0: |v|²_ν → ∫∫ (v(x)−v(y))²/|x−y|, whose eigenfunctions are the Legendre polynomials with eigenvalues
//!   4 H_k, H_k = 1 + 1/2 + ... + 1/k. Hence C_H1(0) = 1/2, and C_L2(0) follows from the three-term matrix of
//!   the primitive.
//! - ν → 1: (1−ν)|v|²_ν → ‖v'‖₀² (Bourgain, Brezis & Mironescu 2001). Hence C_H1 ~ √(1−ν)/π and C_L2 ~
//!   √(1−ν)/π².
//! - (6.2): |v(x) − v̄|² ≤ h κ(x/h)² ‖v'‖₀², the best constant for each x being κ(t)² = (t³ + (1−t)³)/3: v(x) −
//!   v̄ = ∫ k v' with k(s) = s/h for s < x, s/h − 1 for s > x. It is largest at the ends, 1/√3, and smallest in
//!   the centre, 1/(2√3). The paper has 1.

use super::form::{form, refused};
use super::legendre::odd_degrees;
use crate::constant::ErrorNorm;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::numeric::pencil::Factored;
use nalgebra::DMatrix;
use std::f64::consts::PI;

/// Number of odd polynomials for C_L2(0); its extremal function is analytic, and 12 polynomials give 16 digits.
const COUNT: usize = 12;

/// The limit of C(ν) as ν → 0, on an interval of length h scaled to 1.
///
/// # Errors
/// [`Error::Incompatible`] for a norm without a form.
pub(super) fn at_zero(norm: ErrorNorm, h: f64) -> Result<Estimate> {
    if norm == ErrorNorm::Derivative {
        return Estimate::new(0.5, 0.0, Work::default());
    }
    let value =
        |count: usize| -> Result<f64> {
            let degrees = odd_degrees(count);
            let harmonic = |k: usize| (1..=k).rev().map(|j| 1.0 / j as f64).sum::<f64>();
            let seminorm = DMatrix::from_fn(count, count, |i, j| {
                if i == j { 4.0 * harmonic(degrees[i]) } else { 0.0 }
            });
            Ok(Factored::new(&seminorm)?.largest_eigenvalue(&form(norm, h, &degrees)?)?.0.sqrt())
        };
    let fine = value(COUNT)?;
    let error = (fine - value(COUNT / 2)?).abs() + 16.0 * f64::EPSILON * fine;
    Estimate::new(fine, error, Work { factorizations: 4, ..Work::default() })
}

/// The supremum of ‖e‖/‖u'‖: 1 for the derivative, 1/π in L², (1 + h²/π²)^{1/2} for the full norm; attained by
/// u = sin πx.
///
/// # Errors
/// As [`at_zero`].
pub(super) fn zero(norm: ErrorNorm, h: f64) -> Result<Estimate> {
    one(norm, h).and_then(|constant| constant.times(PI))
}

/// The supremum of ‖e‖/‖u''‖, which is lim C(ν)/√(1−ν) as ν → 1: 1/π for the derivative, 1/π² in L², (π² +
/// h²)^{1/2}/π² for the full norm.
///
/// # Errors
/// As [`at_zero`].
pub(super) fn one(norm: ErrorNorm, h: f64) -> Result<Estimate> {
    let value = match norm {
        ErrorNorm::L2 => 1.0 / (PI * PI),
        ErrorNorm::Derivative => 1.0 / PI,
        ErrorNorm::H1 => PI.hypot(h) / (PI * PI),
        ErrorNorm::Dual | ErrorNorm::At(_) => return Err(refused(norm)),
    };
    Estimate::new(value, 4.0 * f64::EPSILON * value, Work::default())
}

/// The best constant κ(t) of (6.2) at the point x = t h: |v(x) − v̄| ≤ κ h^{1/2} ‖v'‖₀.
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 ≤ t ≤ 1.
pub(in crate::interpolation) fn pointwise(t: f64) -> Result<Estimate> {
    Error::require("x/h", t, "[0, 1]", (0.0..=1.0).contains(&t))?;
    let rest = 1.0 - t;
    let value = ((t * t * t + rest * rest * rest) / 3.0).sqrt();
    Estimate::new(value, 4.0 * f64::EPSILON * value, Work::default())
}
