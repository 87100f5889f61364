//! Angular functions: u = r^λ U(θ) and the traction r^{λ−1} Σ(θ) on the rays.

use super::basis::{conditions, fields, kernel};
use super::factor::Fields;
use super::wedge::{Medium, SideCondition, Wedge};
use crate::error::{Error, Result};
use faer::c64;

/// Number of rays on which the size of a function is sampled.
const RAYS: usize = 64;

/// An angular function of a wedge, scaled so that the largest displacement component on 65 equidistant rays
/// is one; it is real for real λ.
///
/// Elastic: displacement (u_r, u_θ), traction (σ_θθ, σ_rθ), shear modulus 1/2. Scalar: (u, 0) and (∂u/∂θ, 0).
///
/// Displacement and traction refer to the polar basis (e_r, e_θ) at θ; σ_N = σ_θθ on both
/// sides of an elastic wedge; in the scalar case ∂u/∂n is −∂u/∂θ at θ = 0, ∂u/∂θ at θ = ω, times r^{−1}.
///
/// ```
/// use signorini::singular::{Medium, Wedge};
/// let crack = Wedge::new(std::f64::consts::TAU, "N-N".parse()?, Medium::PlaneStrain(0.3))?;
/// for mode in &crack.exponents()?.exponents[0].modes {
///     assert_eq!(mode.exponent().1, 0.0);
///     // The faces of the crack carry no traction.
///     assert!(mode.traction(0.0).iter().all(|t| t.0.abs() < 1e-12));
/// }
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    wedge: Wedge,
    lambda: c64,
    /// a₁, a₂, b₁, b₂; scalar: coefficients of cos λϑ, sin λϑ.
    coefficients: [c64; 4],
    /// ϑ = θ − origin, or ω − θ − origin where the sides are exchanged.
    origin: f64,
    is_turned: bool,
}

impl Mode {
    /// The angular function of a zero of a factor.
    pub(super) fn of(wedge: &Wedge, fields: Fields, lambda: c64) -> Result<Self> {
        let ([first, second], is_turned) = wedge.ordered();
        let (zero, one, kappa) = (c64::new(0.0, 0.0), c64::new(1.0, 0.0), wedge.kappa());
        let half = 0.5 * wedge.angle();
        let far = |angle: f64| conditions(second, lambda, kappa, angle);
        let pick = |angle: f64, i: usize, j: usize| kernel(far(angle).map(|row| [row[i], row[j]]));
        let (coefficients, origin) = match fields {
            Fields::Scalar if first == SideCondition::Free => ([one, zero, zero, zero], 0.0),
            Fields::Scalar => ([zero, one, zero, zero], 0.0),
            Fields::Even => {
                let [a, b] = pick(half, 0, 2);
                ([a, zero, b, zero], half)
            }
            Fields::Odd => {
                let [a, b] = pick(half, 1, 3);
                ([zero, a, zero, b], half)
            }
            Fields::Reflected => {
                let [a, b] = pick(wedge.angle(), 0, 2);
                ([a, zero, b, zero], 0.0)
            }
            Fields::Inner => ([one, zero, zero, zero], 0.0),
            Fields::Outer => ([zero, zero, one, zero], 0.0),
            Fields::Clamped => {
                // u = 0 at θ = 0: b₁ = (κ−λ) a₁, b₂ = −(κ+λ) a₂
                let (even, odd) = (kappa - lambda, -(kappa + lambda));
                let reduced =
                    far(wedge.angle()).map(|row| [row[0] + even * row[2], row[1] + odd * row[3]]);
                let [a, b] = kernel(reduced);
                ([a, b, even * a, odd * b], 0.0)
            }
        };
        let mut mode = Self { wedge: *wedge, lambda, coefficients, origin, is_turned };
        let rays = (0..=RAYS).map(|k| wedge.angle() * k as f64 / RAYS as f64);
        let sizes = rays.flat_map(|theta| mode.rows(theta).into_iter().take(2));
        let largest = sizes.fold(zero, |m, u| if u.norm() > m.norm() { u } else { m });
        // Divided as a complex number, so that the largest displacement becomes real.
        let is_usable = largest.norm() > 0.0 && largest.norm().is_finite();
        Error::require("norm of the angular function", largest.norm(), "(0, inf)", is_usable)?;
        mode.coefficients = mode.coefficients.map(|c| c / largest);
        Ok(mode)
    }

    /// The exponent λ as (Re λ, Im λ).
    pub fn exponent(&self) -> (f64, f64) {
        (self.lambda.re, self.lambda.im)
    }

    fn local(&self, theta: f64) -> f64 {
        if self.is_turned { self.wedge.angle() - theta - self.origin } else { theta - self.origin }
    }

    fn rows(&self, theta: f64) -> [c64; 4] {
        let angle = self.local(theta);
        let sign = if self.is_turned { -1.0 } else { 1.0 };
        if self.wedge.medium() == Medium::Scalar {
            let (sine, cosine) = ((self.lambda * angle).sin(), (self.lambda * angle).cos());
            let [a, b, ..] = self.coefficients;
            let slope = self.lambda * (b * cosine - a * sine) * sign;
            return [a * cosine + b * sine, c64::new(0.0, 0.0), slope, c64::new(0.0, 0.0)];
        }
        let sums = fields(self.lambda, self.wedge.kappa(), angle)
            .map(|row| row.iter().zip(self.coefficients).map(|(f, c)| f * c).sum::<c64>());
        let [radial, tangential, normal, shear] = sums;
        [radial, tangential * sign, normal * self.lambda, shear * self.lambda * sign]
    }

    /// The angular function U(θ), 0 ≤ θ ≤ ω: radial and tangential component, each as real and imaginary part; scalar
    /// (u, 0).
    ///
    /// The displacement of the corresponding term is Re (c r^λ U(θ)) with a complex coefficient c.
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let flat = Wedge::new(std::f64::consts::PI, "D-N".parse()?, Medium::Scalar)?;
    /// let mode = flat.exponents()?.exponents[0].modes[0].clone();
    /// // U(θ) = sin(θ/2) up to sign: 0 on the clamped side.
    /// assert!(mode.displacement(0.0)[0].0.abs() < 1e-15);
    /// assert!((mode.displacement(1.0)[0].0.abs() - 0.5f64.sin()).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn displacement(&self, theta: f64) -> [(f64, f64); 2] {
        let [a, b, ..] = self.rows(theta);
        [a, b].map(|u| (u.re, u.im))
    }

    /// The traction Σ(θ) on the ray θ, without its factor r^{λ−1}: normal and tangential component, each as real and
    /// imaginary part.
    pub fn traction(&self, theta: f64) -> [(f64, f64); 2] {
        let [.., a, b] = self.rows(theta);
        [a, b].map(|t| (t.re, t.im))
    }

    /// (u_N, σ_N) on the first or the second side: outward displacement and normal stress; scalar (u, ∂u/∂n).
    pub(super) fn contact(&self, is_second: bool) -> (c64, c64) {
        let theta = if is_second { self.wedge.angle() } else { 0.0 };
        let outward = if is_second { 1.0 } else { -1.0 };
        let [u, v, normal, _] = self.rows(theta);
        if self.wedge.medium() == Medium::Scalar {
            (u, normal * outward)
        } else {
            (v * outward, normal)
        }
    }
}
