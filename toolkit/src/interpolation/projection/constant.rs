//! (4.6) and (4.7): best constants of the L² projection π^h onto piecewise constants.

use crate::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::interpolation::element::{
    ErrorNorm, converge, element_constant, odd_degrees, seminorm_gram, stiffness_gram,
};
use crate::numeric::dense::Cholesky;
use crate::numeric::pencil::Factored;
use nalgebra::DMatrix;
use std::f64::consts::FRAC_1_PI;

/// The norm in which φ − π^h φ is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProjectionNorm {
    /// ‖·‖₀, (4.6).
    L2,
    /// ‖·‖_{1/2,*}, (4.7).
    Dual,
}

impl ProjectionNorm {
    /// The exponent of h in (4.6) or (4.7).
    pub fn rate(self, r: f64) -> f64 {
        match self {
            ProjectionNorm::L2 => r,
            ProjectionNorm::Dual => r + 0.5,
        }
    }
}

/// Best C(r) of (4.6) on one element, 0 ≤ r ≤ 1.
///
/// # Method
///
/// On N elements, with Legendre's basis on one of them as in Lemma 6.1:
///
/// ```text
/// (4.6)  ‖φ − π^h φ‖₀ ≤ C(r) h^r |φ|_r,  C(r) = γ₁(r) for 0 < r < 1, C(0) = 1, C(1) = 1/π
/// (4.7)  ‖φ − π^h φ‖_{1/2,*} ≤ C*(r) h^{r+1/2} |φ|_r,  C*(r) = sup ∫ (φ − φ̄) ψ / (|φ|_r |ψ|_{1/2})
/// ```
///
/// C* on (0, 1). Here |φ|₀ = ‖φ‖₀ and |φ|₁ = ‖φ'‖₀. Elements add up because Σ |·|²_{r,I} ≤ |·|²_{r,Γ}. The
/// paper's chain gives γ₁(r) γ₁(1/2) in place of C*(r), equal at r = 1/2.
///
/// ```
/// use fractional_sobolev::{Tolerance, interpolation::projection_constant};
/// let best = projection_constant(1.0, Tolerance::balanced())?;
/// assert!((best.value - std::f64::consts::FRAC_1_PI).abs() < 1e-15);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for r outside [0, 1]; [`Error::ToleranceNotMet`].
#[doc(alias("L2 projection"))]
pub fn projection_constant(r: f64, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
    let tolerance = tolerance.given()?;
    Error::require("r", r, "[0, 1]", (0.0..=1.0).contains(&r))?;
    if r == 0.0 {
        return Estimate::new(1.0, 0.0, Work::default());
    }
    if r == 1.0 {
        return Estimate::new(FRAC_1_PI, 0.0, Work::default());
    }
    element_constant(ErrorNorm::Derivative, Order::new(r)?, tolerance)
}

/// Best C*(r) with which (4.7) follows element by element, 0 ≤ r ≤ 1; its square is the largest eigenvalue of
/// A_{1/2}⁻¹ x = λ A_r x in L²-orthonormal coordinates.
///
/// ```
/// use fractional_sobolev::{Tolerance, interpolation::{ProjectionNorm, dual_projection_constant, projection_constant}};
/// // equal to the paper's chain γ₁(r) γ₁(1/2) at r = 1/2
/// let asked = Tolerance::balanced();
/// let (dual, one) = (dual_projection_constant(0.5, asked)?, projection_constant(0.5, asked)?);
/// assert!((dual.value - one.value.powi(2)).abs() < 1e-8);
/// assert_eq!(ProjectionNorm::Dual.rate(0.5), 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`projection_constant`].
pub fn dual_projection_constant(r: f64, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
    let tolerance = tolerance.given()?;
    Error::require("r", r, "[0, 1]", (0.0..=1.0).contains(&r))?;
    converge("projection constant in the dual norm", tolerance, |count| {
        let degrees = odd_degrees(count);
        let (half, mut work) = seminorm_gram(Order::HALF, &degrees)?;
        let broken = || Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot: count };
        let inverse = Cholesky::new(&half).ok_or_else(broken)?.solve(&DMatrix::identity(count, count));
        let form = if r == 0.0 {
            DMatrix::identity(count, count)
        } else if r == 1.0 {
            stiffness_gram(&degrees)
        } else {
            let (gram, cost) = seminorm_gram(Order::new(r)?, &degrees)?;
            work += cost;
            gram
        };
        let (top, _) = Factored::new(&form)?.largest_eigenvalue(&inverse)?;
        work.factorizations += 3;
        Ok((top.sqrt(), work))
    })
}
