//! An a priori bound with explicit constants for the Signorini problem, τ = 2.
//!
//! Γ_C is straight, n its outward normal, its segments have length h; on each segment the rectangle Q of height H h
//! lies in Ω, and S_h is the union of these rectangles. No friction, no initial gap, one material, u_h = I^h u on
//! Γ_D. |u|₂² = Σ ‖∂_i ∂_j u_k‖². Constants of the form: M = S = 1 for ∫∇u·∇v; M = 2μ + 2 max(λ, 0),
//! S = (λ² + (λ+2μ)²)^{1/2} for elasticity. Then, c the constant of a segment at ν = 1/2 and θ = coth(πH),
//!
//! |u − u_h|_a² ≤ h² (M A² |u|₂² + (b² + 2 c π θ S) |u|²_{2,S_h}),
//!
//! b = 0 for the nodal cone; for the midpoint cone b = (θ/π) S B, B = 1 for ∫∇u·∇v and a constant of Korn's
//! inequality for elasticity ([`half_plane_korn`]).
//!
//! 1. Let d = u − I^h u, z = I^h u − u_h. z = 0 on Γ_D, and |u − u_h|_a² = |d|_a² + 2 a(u − u_h, z) − |z|_a²,
//!    a(u − u_h, z) ≤ ∫ σ_N z_N; nodal cone: at most t = ∫ σ_N (I^h u)_N. Midpoint cone: at most
//!    t + ∫ (σ_N − πσ_N) z_N with t = ∫ πσ_N (I^h u)_N, and ∫ (σ_N − πσ_N) z_N ≤ b h |u|_{2,S_h} |z|_a; then
//!    2 x |z| − |z|² ≤ x².
//! 2. |u − I^h u|₁ ≤ A h |u|₂; right isosceles triangles with legs h: A = 1/t, t + tan t = 0 (F. Kikuchi, X.
//!    Liu, Japan J. Indust. Appl. Math. 23 (2006) 75-82). |v|_a² ≤ M |∇v|²: split ∇v into trace, deviator,
//!    rotation.
//! 3. A segment: t ≤ c h² |σ_N|_{1/2,T} |u_N'|_{1/2,T}. For the midpoint cone ∫_T πσ_N (I^h u)_N is at most
//!    half of ‖σ_N‖_{L¹} ‖u_N'‖_{L¹}.
//! 4. Trace on a rectangle: |w|²_{1/2,T} ≤ 2πθ ‖∇w‖²_Q, ‖w − πw‖²_T ≤ (θ/π) h ‖∇w‖²_Q (cosine series).
//!    For w = σ_N = λ div u + 2μ ∂_n u_n and w = ∂_t u_n: ‖∇σ_N‖ ‖∇∂_t u_n‖ ≤ ½ S |u|²_{2}, ‖∇σ_N‖ ≤ S |u|₂;
//!    ‖∇z_N‖ ≤ B |z|_a.
//!
//! Proofs: `book/src/theorem_3_1_without_c.md`. Cost: none.

use crate::cone::Cone;
use crate::error::{Error, Result};
use crate::fem::{Form, Lame};
use crate::numeric::search::sign_change;
use std::f64::consts::{FRAC_PI_2, GOLDEN_RATIO, PI};

/// Relative amount by which results are rounded up: more than the rounding error of a few dozen operations.
const ROUND_UP: f64 = 1.0 + 1e-14;

/// The data of a mesh that enter the bound.
///
/// Only A depends on the triangles; H refers to the contact segments, h is their length.
///
/// ```
/// use signorini::proof::MeshShape;
/// let shape = MeshShape::right_isosceles();
/// // A = 1/t with t + tan t = 0.
/// let t = 1.0 / shape.interpolation;
/// assert!((t + t.tan()).abs() < 1e-12 && shape.height == 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshShape {
    /// The constant A in |u − I^h u|₁ ≤ A h |u|₂ on every triangle. For arbitrary triangles: the ratio of the
    /// largest circumradius to h (K. Kobayashi, T. Tsuchiya, Japan J. Indust. Appl. Math. 31 (2014) 193-210).
    pub interpolation: f64,
    /// The relative height H: the rectangle of height H h on each contact segment lies in Ω.
    pub height: f64,
}

impl MeshShape {
    /// The data of right isosceles triangles with legs of length h along Γ_C and perpendicular to it: A = 0.49291...,
    /// H = 1.
    pub fn right_isosceles() -> Self {
        let is_beyond = |t: f64| t * t.cos() + t.sin() < 0.0;
        let (t, _) = sign_change(FRAC_PI_2, PI, 0.0, is_beyond);
        Self { interpolation: ROUND_UP / t, height: 1.0 }
    }
}

/// The constant B in ‖∇v_y‖ ≤ B |v|_a, v_y the component normal to Γ_C, for v = 0 on ∂Ω \ Γ_C, Γ_C straight
/// and Ω on one side of its line: B = φ/(2μ + 2 min(λ, 0))^{1/2}, φ = (1 + √5)/2, rounded up.
///
/// Extended by zero, v is defined on the half-plane. In a Fourier mode v = (i f, g)(ky) e^{ikx}, k > 0, with primes
/// for d/d(ky), φ² |ε|² − |∇v_y|² is k² times
///
/// φ² (f² + g'² + ½ (f' + g)²) − g² − g'²
///   = ½ φ² (f' + 2f/φ + g/φ³)² + φ (g' − f/φ + g/φ²)² − (1/φ) d/d(ky) (φ f − g)²,
///
/// and the integral of the last term is (φ f(0) − g(0))²/φ ≥ 0. |v|_a² ≥ 2 (μ + min(λ, 0)) ‖ε‖². The constant is
/// sharp for λ = 0; for λ = μ the smallest B² μ is 1.183, compared with φ²/2 = 1.309.
///
/// ```
/// use signorini::{fem::Lame, proof::half_plane_korn};
/// // B² μ = φ²/2 for λ ≥ 0, φ the golden ratio.
/// assert!((half_plane_korn(Lame::new(1.0, 1.0)?).powi(2) - 1.3090169943749475).abs() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn half_plane_korn(lame: Lame) -> f64 {
    ROUND_UP * GOLDEN_RATIO / (2.0 * (lame.mu() + lame.lambda().min(0.0))).sqrt()
}

/// The a priori bound of |u − u_h|_a at τ = 2 for one form, one cone, and one shape of mesh.
///
/// The norm is the energy norm of the form; the constants depend neither on h nor on u, and
/// [`ExplicitBound::bound`] and [`ExplicitBound::constant`] are rounded up. Notation: |v|_a² ≤ M ‖∇v‖²,
/// ‖∇σ_N‖ ≤ S |u|₂, θ = coth(πH), A and H of [`MeshShape`], B of [`half_plane_korn`] (1 for ∫∇u·∇v), c of
/// [`ExplicitBound::new`], S_h the union of the rectangles of height H h on the contact segments.
///
/// ```
/// use signorini::{cone::Cone, fem::Form};
/// use signorini::proof::{ExplicitBound, MeshShape};
/// let shape = MeshShape::right_isosceles();
/// let bound = ExplicitBound::new(&Form::LAPLACE, Cone::Nodal, shape, 0.25, 1.0)?;
/// assert_eq!(bound.projection, 0.0);
/// assert!((bound.bound(0.1, 2.0, 2.0)? / (0.2 * bound.constant()) - 1.0).abs() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExplicitBound {
    /// M^{1/2} A, the constant of the interpolation error.
    pub approximation: f64,
    /// b, the constant of the projection term: (θ/π) S B for the midpoint cone, 0 for the nodal cone.
    pub projection: f64,
    /// 2 c π θ S, the constant of the consistency term.
    pub consistency: f64,
}

impl ExplicitBound {
    /// The bound with the constant `segment` = c: the consistency term of a segment is at most
    /// c h² |σ_N|_{1/2} |u_N'|_{1/2}. For the nodal cone c is [`super::product_bound`] or
    /// [`super::product_constant`], or [`super::consistency_constant`] if every segment has at most one
    /// non-contact interval, at an end; for the midpoint cone half of one of the first two. `korn` is B, used
    /// only by the midpoint cone in elasticity.
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a form with a reaction term or several
    /// materials; [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for constants that are not positive
    /// and finite.
    pub fn new(form: &Form, cone: Cone, shape: MeshShape, segment: f64, korn: f64) -> Result<Self> {
        for (name, value) in [
            ("interpolation", shape.interpolation),
            ("height", shape.height),
            ("segment", segment),
            ("korn", korn),
        ] {
            Error::require(name, value, "(0, inf)", value > 0.0 && value.is_finite())?;
        }
        let (energy, stress, korn) = match form {
            Form::Scalar { reaction: 0.0 } => (1.0, 1.0, 1.0),
            Form::Elastic { materials } if materials.len() == 1 => {
                let (lambda, mu) = (materials[0].lambda(), materials[0].mu());
                (2.0 * mu + 2.0 * lambda.max(0.0), lambda.hypot(lambda + 2.0 * mu), korn)
            }
            _ => {
                return Err(Error::incompatible(
                    "form",
                    format!("{form:?}"),
                    "the bound with explicit constants",
                    "the Laplacian, or linear elasticity with a homogeneous material",
                ));
            }
        };
        let theta = 1.0 / (PI * shape.height).tanh();
        let consistency = 2.0 * segment * PI * theta * stress;
        let projection = match cone {
            Cone::Nodal => 0.0,
            Cone::Midpoint => theta / PI * stress * korn,
        };
        let approximation = energy.sqrt() * shape.interpolation;
        Ok(Self { approximation, projection, consistency })
    }

    /// The bound of |u − u_h|_a for mesh size h, from |u|₂ on Ω (`whole`) and on the rectangles (`near`); if only
    /// `whole` is known and passed for both, this is [`ExplicitBound::constant`] h |u|₂.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless h > 0 and 0 ≤ near ≤ whole, all finite.
    pub fn bound(&self, h: f64, whole: f64, near: f64) -> Result<f64> {
        Error::require("h", h, "(0, inf)", h > 0.0 && h.is_finite())?;
        Error::require("|u|_2", whole, "[0, inf)", whole >= 0.0 && whole.is_finite())?;
        Error::require("|u|_2 near the edge", near, "[0, |u|_2]", near >= 0.0 && near <= whole)?;
        let edge = self.projection.hypot(self.consistency.sqrt()) * near;
        Ok(ROUND_UP * h * (self.approximation * whole).hypot(edge))
    }

    /// The constant C in |u − u_h|_a ≤ C h |u|₂.
    ///
    /// C = (M A² + b² + 2 c π θ S)^{1/2}: the bound with |u|_{2,S_h} replaced by |u|₂.
    pub fn constant(&self) -> f64 {
        ROUND_UP * self.approximation.hypot(self.projection).hypot(self.consistency.sqrt())
    }
}
