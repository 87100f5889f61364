//! Theorems 3.1 and 4.1 for 3/2 < τ ≤ 2 with explicit constants, for comparison with the error of a problem with
//! known solution.
//!
//! s = τ − 1, ν = τ − 3/2, right isosceles triangles with legs h, the Laplacian:
//!
//! |u − u_h|₁² ≤ C(s)² h^{2s} |∇u|_s² + 2 c(ν) h^{2τ−2} |σ_N|_ν |u_N'|_ν + b²,
//!
//! C(s) of [`interpolation_constant`] on the triangle, value plus error; the sum over triangles of |∇u|²_{s,T} is at
//! most the square of the seminorm over a half disc that contains Ω. For every contact set c(ν) = min(K(ν), c₂(ν)) for
//! the nodal cone, K/2 for the midpoint cone, K of [`super::product_constant`], value plus error, and
//! c₂ = ½ (1+2ν)^(1+2ν) / (2+2ν)^(2+2ν), proved by pairs of points (page `segment_constants`). b = 0 for the nodal
//! cone; for the midpoint cone b² = (θ/π) h Σ_T ‖σ_N − πσ_N‖²_T ≤ (θ/π) P(ν)² h^{2τ−2} |σ_N|_ν², θ = coth π, P of
//! [`projection_constant`], as in [`super::ExplicitBound`], steps 1 and 4. On a segment of length h the product
//! ‖σ_N‖_{L¹} ‖u_N'‖_{L¹} scales like h^{1+2ν} |σ_N|_ν |u_N'|_ν, and 1 + 2ν = 2τ − 2; the sums of squared seminorms
//! over the segments are at most those over the edge.
//!
//! At τ = 2, ‖D²u‖ replaces |∇u|_s, and C is Kobayashi's bound.
//!
//! Elasticity, one material, u given on all of ∂Ω \ Γ_C for the midpoint cone: |v|_a² ≤ M ‖∇v‖², M = 2μ + 2 max(λ,
//! 0), applied to each component of u − I^h u, and ‖∇z_N‖ ≤ B |z|_a, B of [`half_plane_korn`]:
//!
//! |u − u_h|_a² ≤ M C(s)² h^{2s} |∇u|_s² + 2 c(ν) h^{2τ−2} |σ_N|_ν |u_N'|_ν + B² b².

use super::explicit_bound::half_plane_korn;
use super::segment_constants::product_constant;
use crate::cone::Cone;
use crate::error::{Error, Result};
use crate::fem::Lame;
use fractional_sobolev::{
    BestConstant, Domain, ErrorNorm, Estimate, Order, Tolerance, interpolation_constant, projection_constant,
};
use std::f64::consts::PI;

/// Relative accuracy of constants and norms; all are rounded up by their error estimates.
const ACCURACY: f64 = 1e-5;
/// Relative amount by which results are rounded up: more than the rounding error of a few dozen operations.
const ROUND_UP: f64 = 1.0 + 1e-13;

/// The constants of Theorems 3.1 and 4.1 for one τ, all rounded up.
///
/// C(s), s = τ − 1, is that of [`interpolation_constant`] on the right isosceles triangle with legs of length
/// 1 (at τ = 2 Kobayashi's bound), K(ν) that of [`product_constant`], P(ν) that of [`projection_constant`]; θ
/// = coth π; M and B: [`TheoremConstants::elastic`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TheoremConstants {
    /// The regularity τ.
    pub tau: f64,
    /// The order ν = τ − 3/2.
    pub order: Order,
    /// C(τ − 1); M^{1/2} C(τ − 1) for elasticity.
    pub interpolation: f64,
    /// K(ν); half of it is the constant of the consistency term for the midpoint cone.
    pub segment: f64,
    /// min(K(ν), c₂(ν)), the constant of the consistency term for the nodal cone.
    pub nodal: f64,
    /// (θ/π)^{1/2} P(ν); B (θ/π)^{1/2} P(ν) for elasticity.
    pub projection: f64,
}

/// c₂(ν) = ½ max x^(1+2ν) (1 − x) over 0 < x < 1.
fn by_pairs(order: Order) -> f64 {
    let power = 1.0 + 2.0 * order.value();
    0.5 * (power / (power + 1.0)).powf(power) / (power + 1.0)
}

fn up(estimate: Estimate) -> f64 {
    ROUND_UP * (estimate.value + estimate.error)
}

impl TheoremConstants {
    /// The constants for one τ and the Laplacian.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 3/2 < τ ≤ 2; the errors of
    /// [`interpolation_constant`], [`product_constant`] and [`projection_constant`].
    pub fn new(tau: f64) -> Result<Self> {
        let tau = Error::require("tau", tau, "(3/2, 2]", tau > 1.5 && tau <= 2.0)?;
        let (order, asked) = (Order::half_plus(tau - 2.0)?, Tolerance::new(ACCURACY)?);
        let triangle = Domain::Triangle([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        let interpolation = match interpolation_constant(triangle, ErrorNorm::Derivative, tau - 1.0, asked) {
            Ok(BestConstant { upper: Some(bound), .. }) if tau == 2.0 => ROUND_UP * bound.value,
            Ok(found) => up(found.constant),
            // The error estimate is added, so any tolerance is admissible.
            Err(error) => up(error.best().ok_or(error)?),
        };
        let unit = Domain::Interval(1.0);
        let projection = projection_constant(unit, ErrorNorm::L2, order.value(), asked)?.constant;
        let theta = 1.0 / PI.tanh();
        let segment = up(product_constant(order, asked)?.value);
        Ok(Self {
            tau,
            order,
            interpolation,
            segment,
            nodal: segment.min(ROUND_UP * by_pairs(order)),
            projection: (theta / PI).sqrt() * up(projection),
        })
    }

    /// The corresponding constants for elasticity.
    ///
    /// `interpolation` is multiplied by M^{1/2} = (2μ + 2 max(λ, 0))^{1/2}, `projection` by the constant B of
    /// [`half_plane_korn`]; K(ν) does not depend on the form.
    #[must_use]
    pub fn elastic(self, lame: Lame) -> Self {
        let energy = 2.0 * lame.mu() + 2.0 * lame.lambda().max(0.0);
        let interpolation = ROUND_UP * energy.sqrt() * self.interpolation;
        Self { interpolation, projection: ROUND_UP * half_plane_korn(lame) * self.projection, ..self }
    }

    /// The bound of |u − u_h|_a for triangles with legs h, given upper bounds of |u − I^h u|_a, of Σ_T
    /// |σ_N|_{ν,T}
    /// |u_N'|_{ν,T}, and of |σ_N|_ν.
    ///
    /// (x² + 2 c h^{2τ−2} p + b² h^{2τ−2} s²)^{1/2}, x = `interpolation`, p = `product`, s = `pressure`, c = [`nodal`](Self::nodal)
    /// and b = 0 for the nodal cone, c = K(ν)/2 and b = [`projection`](Self::projection) for the midpoint cone; rounded
    /// up.
    pub fn bound(&self, cone: Cone, h: f64, interpolation: f64, product: f64, pressure: f64) -> f64 {
        let scale = h.powf(self.tau - 1.0);
        let (segment, projection) = match cone {
            Cone::Nodal => (self.nodal, 0.0),
            Cone::Midpoint => (0.5 * self.segment, self.projection),
        };
        let term = scale * (2.0 * segment * product).sqrt();
        ROUND_UP * interpolation.hypot(term).hypot(scale * projection * pressure)
    }
}
