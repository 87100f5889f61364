//! The contact interval at an end on the Dirichlet boundary, in closed form.
//!
//! Half-plane y > 0 in plane strain, κ = 3 − 4ν, ε = ln κ/(2π): clamped for x < 0, in frictionless contact on (0, ℓ),
//! free for x > ℓ, loaded only by the far field. With Muskhelishvili's potential, σ_yy − iσ_xy = Φ⁺ − Φ⁻ and
//! 2μ(u' + iv') = κΦ⁺ + Φ⁻ on the axis, the field without a singularity at ℓ is, up to a real factor,
//!
//! Φ(z) = z^{−1/2} exp(2iε arcosh √(z/ℓ)),
//!
//! | where | field |
//! | --- | --- |
//! | r < ℓ | −σ_N = 2 r^{−1/2} sinh(2ε arccos √(r/ℓ)): compressive, like 2 sinh(πε) r^{−1/2} at the end |
//! | r > ℓ | −u_N = (κ+1)/μ √ℓ (cosh y sin 2εy − 2ε sinh y cos 2εy)/(1 + 4ε²), y = arcosh √(r/ℓ) |
//!
//! Both sign conditions hold for the same sign of the factor. The gap closes again where tan 2εy = 2ε tanh y, near
//! r/ℓ = e^{(π + arctan 2ε)/ε}/4. This is derived on the page `section_1_clamped_end`. Domain: −1 < ν < 1/2 (ε = 0 at
//! ν = 1/2).

use std::f64::consts::PI;

/// The near-tip field with one contact interval adjacent to the Dirichlet boundary, its free real factor set to one; μ = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactZone {
    kappa: f64,
    epsilon: f64,
    length: f64,
}

impl ContactZone {
    /// The field with contact on (0, `length`) for a body with Poisson's ratio `poisson`.
    pub fn new(poisson: f64, length: f64) -> Self {
        let kappa = 3.0 - 4.0 * poisson;
        // ln κ from κ − 1 = 2 (1 − 2ν), which is accurate near ν = 1/2.
        let epsilon = (2.0 * (1.0 - 2.0 * poisson)).ln_1p() / (2.0 * PI);
        Self { kappa, epsilon, length }
    }

    /// The contact pressure −σ_N at the distance r > 0 from the Dirichlet boundary; 0 outside the contact
    /// interval.
    ///
    /// It is 2 r^{−1/2} sinh(2ε arccos √(r/ℓ)) for 0 < r < ℓ, ℓ the length of the contact interval: it
    /// behaves like r^{−1/2} as r → 0 and vanishes like (ℓ − r)^{1/2} at the transition.
    pub fn pressure(&self, r: f64) -> f64 {
        if r >= self.length {
            return 0.0;
        }
        2.0 * (2.0 * self.epsilon * (r / self.length).sqrt().acos()).sinh() / r.sqrt()
    }

    /// The opening −u_N at the distance r from the Dirichlet boundary; 0 on the contact interval, negative
    /// where u_N ≤ 0 is violated.
    ///
    /// (κ+1)/μ √ℓ (cosh y sin 2εy − 2ε sinh y cos 2εy)/(1 + 4ε²), y = arcosh √(r/ℓ); it behaves like (r −
    /// ℓ)^{3/2} near ℓ.
    pub fn opening(&self, r: f64) -> f64 {
        if r <= self.length {
            return 0.0;
        }
        let y = (r / self.length).sqrt().acosh();
        let (sin, cos) = (2.0 * self.epsilon * y).sin_cos();
        let bracket = y.cosh() * sin - 2.0 * self.epsilon * y.sinh() * cos;
        (self.kappa + 1.0) * self.length.sqrt() * bracket
            / (1.0 + 4.0 * self.epsilon * self.epsilon)
    }
}

/// −u_N is the integral of (κ+1)/2 x^{−1/2} sin(2ε arcosh √(x/ℓ)); √x = √ℓ cosh y takes out the root. The gap closes where
/// tan t = 2ε tanh(t/2ε), t = 2εy: at t = π + arctan 2ε up to e^{−2y}, where ln(r/ℓ) = 2y − ln 4.
#[test]
fn the_opening_is_the_integral_of_its_slope_and_closes_where_it_is_said_to() {
    for poisson in [-0.9, 0.0, 0.25, 0.45] {
        let zone = ContactZone::new(poisson, 0.3);
        let (y, steps) = (2.5f64, 20_000);
        let slope = |y: f64| 2.0 * 0.3f64.sqrt() * y.sinh() * (2.0 * zone.epsilon * y).sin();
        let step = y / steps as f64;
        let sum: f64 = (0..steps).map(|k| slope((k as f64 + 0.5) * step)).sum();
        let integral = 0.5 * (zone.kappa + 1.0) * step * sum;
        let opening = zone.opening(0.3 * y.cosh().powi(2));
        assert!((integral / opening - 1.0).abs() < 1e-6, "{poisson}: {integral} {opening}");
        let reach = (PI + (2.0 * zone.epsilon).atan()) / zone.epsilon - 4f64.ln();
        if reach < 600.0 {
            let at = |t: f64| zone.opening(0.3 * (reach + t).exp());
            assert!(at(-1e-3) > 0.0 && at(1e-3) < 0.0, "{poisson}");
        }
    }
}

#[test]
fn the_zone_presses_and_the_rest_is_open() {
    let zone = ContactZone::new(0.25, 1e-12);
    assert!((zone.epsilon - 2f64.ln() / (2.0 * PI)).abs() < 1e-16);
    let end = zone.pressure(1e-60) * 1e-30;
    assert!((end - 2.0 * (PI * zone.epsilon).sinh()).abs() < 1e-12);
    assert!((1..20).all(|k| zone.pressure(1e-12 * (1.0 - 0.05 * f64::from(k))) > 0.0));
    assert!((1..12).all(|k| zone.opening(1e-12 * 10f64.powi(k)) > 0.0));
}
