//! Differences of ln Γ and of ψ = (ln Γ)' over short distances, formed term by term without cancellation.

use nalgebra::Complex;

/// B_{2k} / (2k (2k−1)), k = 1, ..., 8: Stirling's series; the next term is below 1e-18 from |z| = 12 on.
const STIRLING: [f64; 8] = [
    1.0 / 12.0,
    -1.0 / 360.0,
    1.0 / 1260.0,
    -1.0 / 1680.0,
    1.0 / 1188.0,
    -691.0 / 360360.0,
    1.0 / 156.0,
    -3617.0 / 122400.0,
];

/// Real part from which Stirling's series is used.
const SHIFTED: f64 = 12.0;

/// ln(a/b) for a = z + p/2, b = z − p/2: 2 artanh(p/(2z)), accurate for small p.
fn log_ratio(z: Complex<f64>, p: f64) -> Complex<f64> {
    // |a/b|² = 1 + 2 p Re z / |b|²
    let b = z - 0.5 * p;
    let modulus = 0.5 * (2.0 * p * z.re / b.norm_sqr()).ln_1p();
    // a b̄ = |z|² − p²/4 − i p Im z
    let angle = (-p * z.im).atan2(z.norm_sqr() - 0.25 * p * p);
    Complex::new(modulus, angle)
}

/// e^z − 1.
fn exp_m1(z: Complex<f64>) -> Complex<f64> {
    let half = (0.5 * z.im).sin();
    Complex::new(z.re.exp_m1() - 2.0 * z.re.exp() * half * half, z.re.exp() * z.im.sin())
}

/// ln Γ(z + p/2) − ln Γ(z − p/2), accurate relative to p; Re z > |p|/2.
pub(crate) fn log_gamma_difference(mut z: Complex<f64>, p: f64) -> Complex<f64> {
    let mut difference = Complex::new(0.0, 0.0);
    while z.re - 0.5 * p.abs() < SHIFTED {
        difference -= log_ratio(z, p);
        z += 1.0;
    }
    let (a, b) = (z + 0.5 * p, z - 0.5 * p);
    let ratio = log_ratio(z, p);
    difference += ratio * (z - 0.5) + (a.ln() + b.ln()) * (0.5 * p) - p;
    let mut power = b.inv();
    let square = power * power;
    for (k, &coefficient) in STIRLING.iter().enumerate() {
        difference += power * exp_m1(-ratio * (2 * k + 1) as f64) * coefficient;
        power *= square;
    }
    difference
}

/// B_{2k} / (2k), k = 1, ..., 4: the series of ψ; from 21 on the next term is below 1e-16.
const DIGAMMA: [f64; 4] = [1.0 / 12.0, -1.0 / 120.0, 1.0 / 252.0, -1.0 / 240.0];

/// Number of terms of Σ z/(k(k+z)) before the series is used.
const SUMMED: u32 = 20;

/// ψ(1+z) + γ = Σ_{k≥1} z/(k(k+z)) for 0 ≤ z ≤ 1, accurate relative to z; γ is Euler's constant.
pub(crate) fn digamma_above_one(z: f64) -> f64 {
    let shifted = f64::from(SUMMED + 1);
    let log = (z / shifted).ln_1p();
    let mut rest = log + 0.5 * z / (shifted * (shifted + z));
    for (k, coefficient) in (1..).zip(DIGAMMA) {
        let twice = 2 * k;
        rest -= coefficient * shifted.powi(-twice) * (-f64::from(twice) * log).exp_m1();
    }
    rest + (1..=SUMMED).rev().map(f64::from).map(|k| z / (k * (k + z))).sum::<f64>()
}
