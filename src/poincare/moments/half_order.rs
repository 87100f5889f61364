//! The moments of [`super::moment_norm`] at ν = 1/2 in closed form, by Wiener and Hopf's method.
//!
//! dx dx'/(x−x')² is invariant under y = ln(x/(1−x)): |w|² = ∬ (w(y)−w(y'))² / (4 sinh²((y−y')/2)) on the line, with the
//! symbol G(ξ) = 2(πξ coth πξ − 1), and w = 0 for y > ln q, q = e/(1−e). With z_n the positive roots of tan z = z, G =
//! G₊(ξ) G₊(−ξ),
//!
//! g_k = G₊(ik) = π (2/3)^{1/2} k Π_n (1 + πk/z_n)/(1 + k/n).
//!
//! In t = ln q − y > 0 the operator is T = T(G₋) T(G₊), and e^{−kt} is an eigenvector of the adjoint of an analytic
//! Toeplitz operator: ⟨e^{−jt}, T⁻¹ e^{−kt}⟩ = 1/((j+k) g_j g_k). The load is Σ f_k q^k e^{−kt}, f_k = (−1)^{k−1} k for m = 1
//! and (−1)^k k(k−1)/2 for m = x, so that q dM²/dq = h², h(q) = Σ (f_k/g_k) q^k, and
//!
//! M(e)² = ∫₀ᵉ h² ds/(s(1−s)),  s = q/(1+q).
//!
//! In powers of s (Euler's transformation) h converges for s < 1, with coefficients like m^{−5/2}. They are differences of
//! f_k/g_k and lose 2^m of their digits, which s^m makes good up to s = 1/2. Cost: 4000 roots, 200 000 logarithms, once.

use super::dual::Moment;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::quadrature::Rule;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// Roots of tan z = z in the product; the rest by an integral, to 1e-14.
const ROOTS: usize = 4000;
/// Powers of s.
const POWERS: usize = 40;
/// Points of the integral over s.
const POINTS: usize = 40;
/// Longest part: beyond, the lost digits count.
const LONGEST: f64 = 0.7;
/// Rounding of the coefficients f_k/g_k, relative.
const ROUNDING: f64 = 4e-16;

/// M(e) at ν = 1/2 as [`super::moment_norm`] defines it.
///
/// ```
/// use signorini::poincare::{Moment, half_order_moment};
/// // K(1/2) = B(1/2)², forty digits by another program
/// let square = half_order_moment(0.5, Moment::Mass)?.value.powi(2);
/// assert!((square - 0.051_868_428_388_348_907).abs() < 1e-14);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 1e-6 ≤ e ≤ 0.7.
pub fn half_order_moment(length: f64, moment: Moment) -> Result<Estimate> {
    Error::require("length", length, "[1e-6, 0.7]", (1e-6..=LONGEST).contains(&length))?;
    let [mass, first] = SERIES.get_or_init(series);
    // h is linear in m: that of e − x is e times that of 1 less that of x.
    let h = |s: f64| match moment {
        Moment::Mass => horner(mass, s),
        Moment::FromFreeEnd => horner(first, s),
        Moment::FromZone => length * horner(mass, s) - horner(first, s),
    };
    let rule = Rule::gauss_legendre(POINTS)?;
    let square = length * rule.integrate(|t| h(length * t).powi(2) / (length * t * (1.0 - length * t)));
    // What is left of the series, and its lost digits.
    let last = (POWERS as f64).powf(-2.5) * length.powi(POWERS as i32) / (1.0 - length);
    let lost: f64 = (1..=POWERS).map(|m| (2.0 * length).powi(m as i32)).sum::<f64>() * ROUNDING;
    let size = h(length).abs() * if moment == Moment::FromZone { 0.5 } else { 1.0 };
    let error = 2.0 * square * ((last + lost) * length.powi(moment.degree()) / size + 16.0 * f64::EPSILON);
    let work = Work { points: POINTS as u64, ..Work::default() };
    Estimate::new(square, error, work)?.sqrt()
}

/// Coefficients of s, s², ... for m = 1 and m = x.
static SERIES: OnceLock<[Vec<f64>; 2]> = OnceLock::new();

fn horner(coefficients: &[f64], s: f64) -> f64 {
    s * coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c)
}

fn series() -> [Vec<f64>; 2] {
    let roots: Vec<f64> = (1..=ROOTS).map(root).collect();
    let ratios: Vec<f64> = (1..=POWERS).map(|k| ratio(k, &roots)).collect();
    let of = |factor: &dyn Fn(f64) -> f64| {
        // q^k = Σ_m C(m−1, k−1) s^m: the m-th coefficient is the (m−1)-th difference.
        let mut row: Vec<f64> = ratios.iter().enumerate().map(|(i, c)| factor((i + 1) as f64) * c).collect();
        let mut coefficients = vec![row[0]];
        while row.len() > 1 {
            row = row.windows(2).map(|pair| pair[0] - pair[1]).collect();
            coefficients.push(row[0]);
        }
        coefficients
    };
    [of(&|_| 1.0), of(&|k| 0.5 * (1.0 - k))]
}

/// The n-th positive root of sin z = z cos z, by Newton's method.
fn root(n: usize) -> f64 {
    let above = (n as f64 + 0.5) * PI;
    // With z = above − d: cot z = tan d, and z tan d = 1.
    let mut d = 1.0 / above;
    for _ in 0..6 {
        let (z, tangent) = (above - d, d.tan());
        d -= (z * tangent - 1.0) / (z * (1.0 + tangent * tangent) - tangent);
    }
    above - d
}

/// k/g_k = (3/2)^{1/2}/π Π_n (1 + k/n)/(1 + πk/z_n), against Π (1 + k/n)/(1 + k/(n+1/2)) = Π_{j≤k} (1 + 1/(2j)).
fn ratio(k: usize, roots: &[f64]) -> f64 {
    let half: f64 = (1..=k).map(|j| 1.0 + 0.5 / j as f64).product();
    let k = k as f64;
    let logarithm = |(i, z): (usize, &f64)| {
        let (a, b) = (i as f64 + 1.5, z / PI);
        (k * (b - a) / (a * (b + k))).ln_1p()
    };
    let sum: f64 = roots.iter().enumerate().rev().map(logarithm).sum();
    // z_n/π = a − 1/(π²a) + ..., a = n + 1/2: the rest is −∫ k/(π² a² (a+k)) da.
    let from = (ROOTS + 1) as f64;
    let rest = (1.0 / from - (k / from).ln_1p() / k) / (PI * PI);
    1.5f64.sqrt() / PI * half * (sum - rest).exp()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::Tolerance;
    use crate::poincare::moment_norm;
    use crate::sobolev::FractionalOrder;

    #[test]
    fn the_closed_form_agrees_with_slopes() {
        for length in [1e-3, 0.1, 0.25, 0.5, 0.6, 0.7] {
            for moment in [Moment::Mass, Moment::FromFreeEnd, Moment::FromZone] {
                let tolerance = Tolerance::new(1e-10).unwrap();
                let slopes = moment_norm(FractionalOrder::HALF, length, moment, tolerance).unwrap();
                let closed = half_order_moment(length, moment).unwrap();
                let apart = (slopes.value - closed.value).abs();
                assert!(apart <= slopes.error + closed.error, "{length} {moment:?}: {slopes} {closed}");
                assert!(closed.relative_error() < 3e-8, "{length} {moment:?}: {closed}");
            }
        }
        assert!(half_order_moment(0.8, Moment::Mass).is_err());
        assert!(half_order_moment(f64::NAN, Moment::Mass).is_err());
    }

    #[test]
    fn another_program_with_forty_digits_agrees() {
        // mpmath, 400 roots with a summed tail, 70 powers.
        let known = [
            (0.2, 0.083_651_250_832_953_84, 0.007_249_041_690_524_879),
            (0.5, 0.227_746_412_459_886_86, 0.048_972_831_541_786_43),
            (0.6, 0.284_558_533_995_324_05, 0.073_320_149_170_287_36),
        ];
        for (length, mass, first) in known {
            for (moment, exact) in [(Moment::Mass, mass), (Moment::FromFreeEnd, first)] {
                let found = half_order_moment(length, moment).unwrap();
                assert!((found.value - exact).abs() <= found.error, "{length} {moment:?}: {found} {exact}");
            }
        }
    }

    #[test]
    fn roots_and_the_first_ratio() {
        let first = root(1);
        assert!((first.tan() - first).abs() < 1e-12 && (first - 4.493_409_457_909_064).abs() < 1e-14);
        let roots: Vec<f64> = (1..=ROOTS).map(root).collect();
        assert!((ratio(1, &roots) / 0.568_276_111_684_543_8 - 1.0).abs() < 1e-13);
        assert!((ratio(10, &roots) / 1.340_250_500_348_664_7 - 1.0).abs() < 1e-13);
    }
}
