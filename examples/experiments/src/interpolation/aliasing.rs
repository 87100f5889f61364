//! Remark 2: in the dual norm of H^{1/2} Lagrange interpolation of H^{3/2} functions gains nothing over
//! h^{3/2}.

use crate::ErrorExt;
use fractional_sobolev::Order;
use fractional_sobolev::{Domain, ErrorNorm, interpolation_constant};
use fractional_sobolev::{Error, Result};
use fractional_sobolev::{Estimate, Tolerance, Work};
use signorini::rates::ConvergenceOrder;
use std::f64::consts::{FRAC_PI_2, PI};

/// Rounding of the closed forms.
const ROUNDING: f64 = 1e-13;

/// u_N = −(1 − cos(2πNx)) on N equal elements of (0, 1).
///
/// # Method
///
/// u_N(x) = −(1 − cos(2πNx)) ≤ 0 on (0, 1) vanishes at the nodes of N equal elements: I^h u_N = 0 and e =
/// u_N. Since the representer of 1 in H^{1/2}(0,1) is 1, the mean and the wave are orthogonal in the dual
/// norm:
/// ```text
/// ‖e‖²_{1/2,*} = 1 + ‖cos(2πN·)‖²_{1/2,*},  0 ≤ ‖cos‖_{1/2,*} ≤ γ₁(1/2) h^{1/2}/√2 by (4.7)'s duality,
/// ‖u_N‖²_{3/2} = 3/2 + ω²/2 + ω² |sin ω·|²_{1/2},  |sin ω·|²_{1/2} = 2ω Si(ω) − 2 Cin(2ω),  ω = 2πN.
/// ```
/// So ‖e‖\_{1/2,\*} ~ h^{3/2} ‖u‖\_{3/2} / (√8 π²): the wave is aliased to a constant, which no dual norm
/// makes small. The upper bound is Lemma 6.2: ‖e‖\_{1/2,\*} ≤ ‖e‖₀ ≤ C_L2(1/2) h^{3/2} |u|\_{3/2}.
///
/// One function for all h: u = −Σ_j c_j 2^{-3j/2} (1 − cos(2π 2^j x)), c_j = (1+j)^{-p}, p > 1/2, is in
/// H^{3/2}; on 2^k elements the waves j ≥ k are aliased and the others have mean-free errors, so
/// ‖e‖\_{1/2,\*} ≥ |∫ e| = Σ\_{j≥k} c_j 2^{-3j/2}.
///
/// Reference: P. Hild, C. R. Acad. Sci. Paris 326 (1998) 1233-1236, for the phenomenon; these functions are
/// chosen here.
///
/// ```
/// use experiments::interpolation::AliasedWave;
/// let wave = AliasedWave::new(64)?;
/// assert!((wave.value(1.0 / 128.0) + 2.0).abs() < 1e-12); // −(1 − cos π)
/// assert!(wave.dual_norm_of_error()?.value >= 1.0 && wave.seminorm()?.value < wave.norm()?.value);
/// // ‖e‖_{1/2,*}/‖u‖_{3/2} ~ h^{3/2}/(√8 π²)
/// let limit = 64f64.powf(-1.5) / (8f64.sqrt() * std::f64::consts::PI.powi(2));
/// assert!((wave.quotient()?.value / limit - 1.0).abs() < 0.05);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AliasedWave {
    elements: usize,
}

impl AliasedWave {
    /// One wave per element.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for no element or more than 2^50.
    pub fn new(elements: usize) -> Result<Self> {
        if elements == 0 || elements > 1 << 50 {
            return Err(Error::CountOutOfRange { name: "elements", value: elements, range: "1 ..= 2^50" });
        }
        Ok(Self { elements })
    }

    /// u_N(x).
    pub fn value(self, x: f64) -> f64 {
        let sine = (PI * self.elements as f64 * x).sin();
        -2.0 * sine * sine
    }

    /// ‖u_N − I^h u_N‖\_{1/2,\*}: the middle of its bounds, with their half distance as error.
    ///
    /// # Errors
    /// None for N ≥ 1; those of [`interpolation_constant`] are passed on.
    pub fn dual_norm_of_error(self) -> Result<Estimate> {
        let unit = Domain::Interval(1.0);
        let gamma =
            interpolation_constant(unit, ErrorNorm::Derivative, Order::HALF, Tolerance::balanced())?.constant;
        let wave = gamma.value * gamma.value / (2.0 * self.elements as f64);
        // √(1 + w) − 1 without cancellation
        let excess = wave / (1.0 + (1.0 + wave).sqrt());
        Estimate::new(1.0 + 0.5 * excess, 0.5 * excess, gamma.work)
    }

    /// |u_N'|\_{1/2} = |u_N|\_{3/2}.
    ///
    /// # Errors
    /// None for N ≥ 1.
    pub fn seminorm(self) -> Result<Estimate> {
        let omega = 2.0 * PI * self.elements as f64;
        let wave = 2.0 * omega * sine_integral(omega) - 2.0 * cosine_integral_entire(2.0 * omega);
        let value = omega * wave.sqrt();
        Estimate::new(value, ROUNDING * value, Work::default())
    }

    /// ‖u_N‖\_{3/2}.
    ///
    /// # Errors
    /// None for N ≥ 1.
    pub fn norm(self) -> Result<Estimate> {
        let omega = 2.0 * PI * self.elements as f64;
        let seminorm = self.seminorm()?.value;
        let value = (1.5 + 0.5 * omega * omega).sqrt().hypot(seminorm);
        Estimate::new(value, ROUNDING * value, Work::default())
    }

    /// ‖u_N − I^h u_N‖\_{1/2,\*} / ‖u_N‖\_{3/2}.
    ///
    /// # Errors
    /// None for N ≥ 1; those of [`interpolation_constant`] are passed on.
    pub fn quotient(self) -> Result<Estimate> {
        let (dual, norm) = (self.dual_norm_of_error()?, self.norm()?);
        let value = dual.value / norm.value;
        Estimate::new(value, value * (dual.relative_error() + norm.relative_error()), dual.work)
    }
}

/// Σ\_{j≥k} (1+j)^{-p} 2^{-3j/2}: a lower bound of ‖u − I^h u‖\_{1/2,\*} on 2^k elements for the one function
/// of all waves.
///
/// ```
/// use experiments::interpolation::{all_waves_mean, all_waves_rate};
/// // Σ x^j/(1+j) = −ln(1−x)/x at x = 2^{−3/2}
/// let x = 0.5f64.powf(1.5);
/// assert!((all_waves_mean(0, 1.0)?.value + (1.0 - x).ln() / x).abs() < 1e-13);
/// assert!((all_waves_rate(200, 1.0)?.value - 1.5).abs() < 0.02);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 1/2 < p ≤ 10 (else u is not in H^{3/2}); [`Error::CountOutOfRange`] for k >
/// 600, where it underflows.
pub fn all_waves_mean(k: usize, p: f64) -> Result<Estimate> {
    Error::require("p", p, "(1/2, 10]", p > 0.5 && p <= 10.0)?;
    if k > 600 {
        return Err(Error::CountOutOfRange { name: "level k", value: k, range: "0 ..= 600" });
    }
    // 2^{-3j/2} falls below the last digit after 36 terms.
    let terms = (k..k + 40).rev().map(|j| (1.0 + j as f64).powf(-p) * (-1.5 * j as f64).exp2());
    let value: f64 = terms.sum();
    Estimate::new(value, ROUNDING * value, Work { points: 40, ..Work::default() })
}

/// The exponent of h = 2^{-k} by which [`all_waves_mean`] falls between the levels k and 2k; it nears 3/2
/// like p/k.
///
/// Its error is that of [`ConvergenceOrder::of_last`]: 3.5 times the change from the exponent between k/2 and k, and
/// what the errors of the means leave.
///
/// # Errors
/// As [`all_waves_mean`], for the level 2k.
pub fn all_waves_rate(k: usize, p: f64) -> Result<Estimate> {
    if k < 2 {
        return Err(Error::CountOutOfRange { name: "level k", value: k, range: "2 ..= 300" });
    }
    let [first, middle, last] = [k / 2, k, 2 * k].map(|level| all_waves_mean(level, p));
    let (first, middle, last) = (first?, middle?, last?);
    let level = |k: usize, mean: Estimate| (0.5f64.powi(k as i32), mean);
    let points = [level(k / 2, first), level(k, middle), level(2 * k, last)];
    let none = Error::CountOutOfRange { name: "level k", value: k, range: "2 ..= 300" };
    let found = ConvergenceOrder::of_last(&points).ok_or(none)?;
    Estimate::new(found.order, found.uncertainty, first.work + middle.work + last.work)
}

/// Si(x) = ∫₀^x sin t / t dt for x ≥ 2.
fn sine_integral(x: f64) -> f64 {
    FRAC_PI_2 + exponential_integral(x).1
}

/// Cin(x) = ∫₀^x (1 − cos t)/t dt = γ + ln x − Ci(x) for x ≥ 2.
fn cosine_integral_entire(x: f64) -> f64 {
    const EULER: f64 = 0.577_215_664_901_532_9;
    EULER + x.ln() + exponential_integral(x).0
}

/// E₁(ix) as (real, imaginary), x ≥ 2, by e^{-z}/(z+1−1/(z+3−4/(z+5−...))), evaluated from the back.
///
/// Ci(x) = −Re, Si(x) = π/2 + Im. Relative truncation exp(−4 √(n x)) or so: 80 levels are plenty at x = 2.
fn exponential_integral(x: f64) -> (f64, f64) {
    const LEVELS: i32 = 80;
    let (mut re, mut im) = (2.0 * f64::from(LEVELS) + 1.0, x);
    for n in (0..LEVELS).rev() {
        let square = f64::from((n + 1) * (n + 1));
        let size = re * re + im * im;
        let (quotient_re, quotient_im) = (square * re / size, -square * im / size);
        re = 2.0 * f64::from(n) + 1.0 - quotient_re;
        im = x - quotient_im;
    }
    let size = re * re + im * im;
    let (sin, cos) = x.sin_cos();
    // e^{-ix} (re − i im)/size
    ((cos * re - sin * im) / size, -(sin * re + cos * im) / size)
}

#[cfg(test)]
mod tests {
    use super::super::dual_norm::DualNorm;
    use super::*;
    use fractional_sobolev::{Function, Mesh};

    #[test]
    fn integral_functions_have_their_known_values() {
        // Abramowitz & Stegun, table 5.1 and 5.3
        assert!((sine_integral(2.0) - 1.605_412_976_802_695).abs() < 1e-14);
        assert!((sine_integral(10.0) - 1.658_347_594_218_874).abs() < 1e-14);
        let ci = |x: f64| -exponential_integral(x).0;
        assert!((ci(2.0) - 0.422_980_828_774_865).abs() < 1e-14);
        assert!((ci(10.0) + 0.045_456_433_004_455).abs() < 1e-14);
    }

    #[test]
    fn the_closed_norm_is_that_of_the_wave() {
        for n in [1, 2, 5] {
            let omega = 2.0 * PI * n as f64;
            let cells = Mesh::uniform(8 * n, 1.0).unwrap();
            let slope = Function::interpolate(&cells, 10, |x| -omega * (omega * x).sin()).unwrap();
            let seminorm = slope.seminorm(Order::HALF, Tolerance::balanced()).unwrap();
            let closed = AliasedWave::new(n).unwrap().seminorm().unwrap();
            assert!((seminorm.value / closed.value - 1.0).abs() < 1e-10, "{n}: {seminorm} {closed}");
        }
    }

    #[test]
    fn the_dual_norm_lies_within_its_bounds() {
        for n in [1, 4, 16] {
            let wave = AliasedWave::new(n).unwrap();
            let cells = Mesh::uniform(32 * n, 1.0).unwrap();
            let starts = cells.from_left().to_vec();
            let h = cells.lengths()[0];
            let norm = DualNorm::new(&cells).unwrap().of(|i, t| wave.value(starts[i] + h * t)).unwrap();
            let bounds = wave.dual_norm_of_error().unwrap();
            let distance = (norm.value - bounds.value).abs();
            assert!(distance <= bounds.error + norm.error, "{n}: {norm} {bounds}");
        }
        assert!(AliasedWave::new(0).is_err());
        assert!(all_waves_mean(3, 0.5).is_err() && all_waves_mean(601, 0.6).is_err());
    }
}
