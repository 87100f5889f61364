//! The excess energy of a coarse strip over a fine one: differences of symbols without cancellation.
//!
//! Let P be linear interpolation of edge data to a finer grid. The energy of the strip of mesh size h with edge
//! displacement g_h exceeds that of the finer strip (or of the continuous harmonic function) with edge displacement P
//! g_h by ⟨G g_h, g_h⟩ with G ≥ 0 diagonal in the modes. All expressions below are free of cancellation of
//! leading terms; θ = kπ/n, m the number of layers, φ = 2 asinh sin(θ/2).
//!
//! * One halving, s = sin(θ/4), c = cos(θ/4), S the symbols: D(θ) = S_h(θ) − 2 [c⁴ S_{h/2}(θ/2) + s⁴
//!   S_{h/2}(π − θ/2)], on the half plane D = 4sc { s² (4c²+1+c²+c⁴−c⁶)/(√(1+4s²c²) + c³ √(1+s²)) − s³
//!   √(1+c²) }. Several halvings: G_h(θ) = D(θ) + 2 [c⁴ G_{h/2}(θ/2) + s⁴ G_{h/2}(π − θ/2)].
//! * Continuous: T(θ) = (2 sin(θ/2))⁴ Σ_j |θ+2πj|⁻³ coth(m |θ+2πj|), G = S_h − T; with s = sin(θ/2), r = 2s/θ
//!   on the half plane G = 2s { s²/(1+√(1+s²)) + (1−r)(1+r+r²) − (s/π)³ Z }, Z = ζ(3, 1+x) + ζ(3, 1−x), x =
//!   θ/2π.
//! * Finite height enters through coth a − coth b = sinh(b−a)/(sinh a sinh b), with b − a also computed without
//!   cancellation.

use std::f64::consts::PI;

/// D(θ) between strips of m and 2m layers.
///
/// D(θ) = S_h(θ) − 2 [c⁴ S_{h/2}(θ/2) + s⁴ S_{h/2}(π − θ/2)] ≥ 0, O(θ³) for small θ; full relative accuracy.
pub(crate) fn halving(theta: f64, layers: f64) -> f64 {
    if theta == 0.0 {
        return 0.0;
    }
    let (s, c) = (0.25 * theta).sin_cos();
    let (s2, c2) = (s * s, c * c);
    let root = (1.0 + 4.0 * s2 * c2).sqrt();
    let low =
        s2 * (4.0 * c2 + 1.0 + c2 + c2 * c2 - c2 * c2 * c2) / (root + c * c2 * (1.0 + s2).sqrt());
    let half_plane = 4.0 * s * c * (low - s * s2 * (1.0 + c2).sqrt());
    // φ_h = 2 asinh q and 2 φ_{h/2} = 2 asinh p with q = 2sc, p = 2s √(1+s²).
    let q = 2.0 * s * c;
    let p = 2.0 * s * (1.0 + s2).sqrt();
    let coarse = 2.0 * layers * q.asinh();
    if coarse > DEEP {
        return half_plane;
    }
    let excess = 8.0 * s2 * s2 / (p * (1.0 + q * q).sqrt() + q * (1.0 + p * p).sqrt());
    let same = 2.0
        * c2
        * c2
        * 2.0
        * s
        * (1.0 + s2).sqrt()
        * coth_difference(coarse, 2.0 * layers * excess.asinh());
    let alias = 2.0 * s2 * s2 * 2.0 * c * (1.0 + c2).sqrt();
    let fine_alias = 4.0 * layers * c.asinh();
    half_plane / coarse.tanh() + same + alias * coth_difference(coarse, fine_alias - coarse)
}

/// Argument above which coth is 1 up to rounding.
const DEEP: f64 = 20.0;

/// coth a − coth(a + d) for a, d ≥ 0.
fn coth_difference(a: f64, d: f64) -> f64 {
    if a > DEEP {
        return 0.0;
    }
    // sinh d / (sinh a sinh(a+d)) with the exponential growth factored out.
    let decay = -(-2.0 * d).exp_m1() / -(-2.0 * (a + d)).exp_m1();
    decay * (-a).exp() / a.sinh()
}

/// T(θ): the energy of the continuous harmonic function with piecewise linear edge data.
///
/// T(θ) = (2 sin(θ/2))⁴ Σ_j |θ + 2πj|⁻³ coth(m |θ + 2πj|): the transform of the hat function is (2 sin(θ/2)/θ)², and
/// |θ| coth(m|θ|) the Dirichlet-to-Neumann symbol of the strip. T ≤ S_h (Dirichlet principle).
pub(crate) fn harmonic_symbol(theta: f64, layers: f64) -> f64 {
    if theta == 0.0 {
        return 1.0 / layers;
    }
    let s = (0.5 * theta).sin();
    let four = (2.0 * s).powi(4);
    four / (theta.powi(3) * (layers * theta).tanh()) + four * alias_sum(theta, layers)
}

/// G = S_h − T.
pub(crate) fn harmonic_defect(theta: f64, layers: f64) -> f64 {
    if theta == 0.0 {
        return 0.0;
    }
    let s = (0.5 * theta).sin();
    let s2 = s * s;
    let y = 0.5 * theta;
    let missing = one_minus_sinc(y);
    let r = 1.0 - missing;
    let low = 2.0 * s * (s2 / (1.0 + (1.0 + s2).sqrt()) + missing * (1.0 + r + r * r));
    let four = (2.0 * s).powi(4);
    let coarse = 2.0 * layers * s.asinh();
    let alias = four * alias_sum(theta, layers);
    if coarse > DEEP {
        return low - alias;
    }
    // θ − φ = 2 (y − asinh sin y) ≥ 0, from p = sinh y and q = sin y.
    let (p, q) = (y.sinh(), y.sin());
    let numerator = sinh_minus_sin(y) * (p + q);
    let excess = numerator / (p * (1.0 + q * q).sqrt() + q * (1.0 + p * p).sqrt());
    let finite = four / theta.powi(3) * coth_difference(coarse, 2.0 * layers * excess.asinh());
    low / coarse.tanh() + finite - alias
}

/// Σ_{j≠0} |θ+2πj|⁻³ coth(m |θ+2πj|).
fn alias_sum(theta: f64, layers: f64) -> f64 {
    let x = theta / (2.0 * PI);
    let unit = 2.0 * PI;
    let mut sum = 0.0;
    for j in (1..=ALIASES).rev() {
        for place in [j as f64 + x, j as f64 - x] {
            let depth = layers * unit * place;
            let coth = if depth > DEEP { 1.0 } else { 1.0 / depth.tanh() };
            sum += coth / (place * place * place);
        }
    }
    let tail = zeta_tail(ALIASES as f64 + 1.0 + x) + zeta_tail(ALIASES as f64 + 1.0 - x);
    (sum + tail) / unit.powi(3)
}

/// Aliases summed one by one; the Euler-Maclaurin tail is then below 1e-17 relative, and for m ≥ 1 coth(2πmj)
/// is 1 in it.
const ALIASES: usize = 10;

/// ζ(3, a) for a ≥ 10 by the Euler-Maclaurin formula.
///
/// ζ(3, a) = Σ_{k ≥ 0} (a + k)⁻³ = 1/(2a²) + 1/(2a³) + 1/(4a⁴) − ...
fn zeta_tail(a: f64) -> f64 {
    let inverse = 1.0 / (a * a);
    // 1/(2a²) + 1/(2a³) + Σ B_2k/(2k)! (3)(4)...(2k+1) a^{−2−2k}
    let correction = 0.25
        - inverse
            * (1.0 / 12.0
                - inverse * (1.0 / 12.0 - inverse * (3.0 / 20.0 - inverse * (5.0 / 12.0))));
    0.5 * inverse + 0.5 * inverse / a + inverse * inverse * correction
}

/// 1 − sin y/y.
fn one_minus_sinc(y: f64) -> f64 {
    if y > 0.5 {
        return 1.0 - y.sin() / y;
    }
    let square = y * y;
    // Σ (−1)^k y^{2k+2}/(2k+3)!
    let mut sum = 0.0;
    for k in (1..=8).rev() {
        let (a, b) = ((2 * k) as f64, (2 * k + 1) as f64);
        sum = square / (a * b) * (1.0 - sum);
    }
    sum
}

/// sinh y − sin y = 2 (y³/3! + y⁷/7! + ...).
fn sinh_minus_sin(y: f64) -> f64 {
    let fourth = y.powi(4);
    let mut sum = 0.0;
    for k in (1..=6).rev() {
        let first = 4 * k;
        let product = (first..first + 4).map(f64::from).product::<f64>();
        sum = fourth / product * (1.0 + sum);
    }
    2.0 * y.powi(3) / 6.0 * (1.0 + sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strip::operator::scalar::scalar_symbol;

    /// ε/θ³ relative is what the plain differences keep; the tests use θ where that is below this.
    const PLAIN: f64 = 1e-9;

    #[test]
    fn halving_is_the_difference_of_symbols() {
        for layers in [1.0, 4.0, 64.0] {
            for k in 1..=32 {
                let theta = PI * f64::from(k) / 32.0;
                let (s, c) = (0.25 * theta).sin_cos();
                let fine = c.powi(4) * scalar_symbol(0.5 * theta, 2.0 * layers)
                    + s.powi(4) * scalar_symbol(PI - 0.5 * theta, 2.0 * layers);
                let plain = scalar_symbol(theta, layers) - 2.0 * fine;
                let got = halving(theta, layers);
                assert!((got - plain).abs() < PLAIN * plain, "{layers} {k}: {got} {plain}");
            }
        }
    }

    #[test]
    fn harmonic_defect_is_the_difference_of_symbols_and_the_limit_of_halvings() {
        for layers in [1.0, 4.0, 64.0] {
            for k in 1..=32 {
                let theta = PI * f64::from(k) / 32.0;
                let plain = scalar_symbol(theta, layers) - harmonic_symbol(theta, layers);
                let got = harmonic_defect(theta, layers);
                assert!((got - plain).abs() < PLAIN * plain, "{layers} {k}: {got} {plain}");
            }
        }
        // Eleven halvings leave 4^-11 of the low mode's defect.
        fn summed(theta: f64, layers: f64, halvings: usize) -> f64 {
            if halvings == 0 {
                return 0.0;
            }
            let (s, c) = (0.25 * theta).sin_cos();
            let below = summed(0.5 * theta, 2.0 * layers, halvings - 1);
            let alias = summed(PI - 0.5 * theta, 2.0 * layers, halvings - 1);
            halving(theta, layers) + 2.0 * (c.powi(4) * below + s.powi(4) * alias)
        }
        for theta in [1e-6, 0.01, 0.5, 2.0, PI] {
            let (limit, sum) = (harmonic_defect(theta, 3.0), summed(theta, 3.0, 11));
            assert!((limit - sum).abs() < 1e-5 * limit, "{theta}: {limit} {sum}");
        }
    }
}
