//! The kernel that turns slopes into the squared seminorm.
//!
//! For u(x) = c + ∫₀ˣ v on an interval of length ℓ,
//!
//! |u|_ν² = ∬ v(s) v(t) K(s,t) ds dt,
//! K(s,t) = 2 ∫₀^m ∫_M^ℓ (y−x)^{−1−2ν} dx dy,  m = min(s,t), M = max(s,t).
//!
//! With p = 1 − 2ν and the three lengths α = m, γ = M − m, β = ℓ − M,
//!
//! ν K = [ (α+γ)^p + (β+γ)^p − γ^p − (α+β+γ)^p ] / p,   at ν = 1/2:  ln(1 + αβ/(γℓ)).
//!
//! K is positive; it is computed with a small relative error for all lengths and all p, p = 0 included.

/// (e^{p x} − 1)/p; x at p = 0.
pub(crate) fn exp_quotient(p: f64, x: f64) -> f64 {
    if p == 0.0 { x } else { (p * x).exp_m1() / p }
}

/// ln(a/b), also if the quotient exceeds the range of f64.
pub(crate) fn ln_ratio(a: f64, b: f64) -> f64 {
    let ratio = a / b;
    if ratio.is_normal() { ratio.ln() } else { a.ln() - b.ln() }
}

/// ln(1 + a/b), also if the quotient exceeds the range of f64.
pub(crate) fn ln_one_plus_ratio(a: f64, b: f64) -> f64 {
    let ratio = a / b;
    if ratio.is_finite() { ratio.ln_1p() } else { a.ln() - b.ln() }
}

/// ((a+b)^p − a^p)/p for a > 0, b ≥ 0; ln(1 + b/a) at p = 0.
pub(crate) fn power_increment(p: f64, a: f64, b: f64) -> f64 {
    a.powf(p) * exp_quotient(p, ln_one_plus_ratio(b, a))
}

/// ν K for the lengths α, γ, β, γ > 0.
pub(crate) fn kernel(p: f64, alpha: f64, gamma: f64, beta: f64) -> f64 {
    let (near, far) = if alpha <= beta { (alpha, beta) } else { (beta, alpha) };
    if far > gamma {
        // (near+γ)^p − γ^p against the same increment further out, at least 2^{2ν} times smaller
        return power_increment(p, gamma, near) - power_increment(p, far + gamma, near);
    }
    // With a = ln(1+α/γ), b = ln(1+β/γ), q = ln(1+αβ/(γℓ)): e^{a+b−q} = ℓ/γ, and the bracket factors.
    let cross = (far / (near + gamma + far)) * (near / gamma);
    let (a, b, q) = ((near / gamma).ln_1p(), (far / gamma).ln_1p(), cross.ln_1p());
    let product = exp_quotient(p, a) * exp_quotient(p, b) * p;
    gamma.powf(p) * ((p * (a + b)).exp() * exp_quotient(-p, q) - product)
}
