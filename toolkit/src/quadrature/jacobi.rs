//! Gauss-Jacobi rules on (0, 1) to the rounding of points and weights.
//!
//! The points are the eigenvalues of the Jacobi matrix (Golub & Welsch, Math. Comp. 23 (1969) 221-230), computed
//! without eigenvectors, then improved by Newton's method on the three-term recurrence. With n terms the recurrence
//! loses n ulps, and near an end of (0, 1), where points are of size 1/n², it loses n³ relative to the point.
//! The last Newton step and the weights 1/Σ p_k² are therefore computed with twice the digits, from coefficients
//! with twice the digits.

use super::Rule;
use crate::error::{Error, Result};
use crate::numeric::parallel;
use crate::numeric::twofold::Twofold;

/// Largest number of QL steps for one eigenvalue; two are typical.
const QL: usize = 60;
/// Largest numbers of Newton steps, in binary64 and with twice the digits.
const NEWTON: usize = 12;
const LAST: usize = 8;
/// Relative size of a step after which the next one is below rounding.
const SETTLED: f64 = 1e-9;
/// Largest number below 1.
const BELOW_ONE: f64 = 1.0 - 0.5 * f64::EPSILON;

/// The n-point rule for admissible n, α, β.
pub(super) fn jacobi_rule(n: usize, alpha: f64, beta: f64) -> Result<Rule> {
    let recurrence = Recurrence::new(n, alpha, beta);
    // Exponents beyond what binary64 squares have no finite recurrence.
    let range = || Error::OutOfRange {
        name: "alpha + beta",
        value: alpha + beta,
        range: "the range in which the recurrence is finite",
    };
    let mut starts = recurrence.eigenvalues().ok_or_else(range)?;
    starts.sort_by(f64::total_cmp);
    let mass = beta_function(alpha, beta);
    let found = parallel::over(&starts, |&start| recurrence.point(start));
    let points: Vec<f64> = found.iter().map(|(t, _)| *t).collect();
    let weights: Vec<f64> = found.iter().map(|(_, sum)| mass / sum).collect();
    if weights.iter().any(|w| !(*w > 0.0 && w.is_finite()))
        || points.windows(2).any(|t| t[0] >= t[1])
    {
        return Err(range());
    }
    Ok(Rule { points, weights })
}

/// B(α + 1, β + 1).
fn beta_function(alpha: f64, beta: f64) -> f64 {
    // The gamma function of x magnifies the rounding of x by x ψ(x), which is 5 at 4 and 150 at 40.
    const LARGEST: f64 = 2.0;
    const STEPS: f64 = 1e5;
    let one = Twofold::from(1.0);
    let [mut a, mut b] = [alpha, beta].map(|exponent| Twofold::from(exponent) + one);
    if a.value() + b.value() > STEPS {
        let [a, b] = [a.value(), b.value()];
        return (libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b)).exp();
    }
    // B(a, b) = B(a − 1, b) (a − 1)/(a + b − 1)
    let mut factor = one;
    while a.value() > LARGEST {
        a = a - one;
        factor = factor * a / (a + b);
    }
    while b.value() > LARGEST {
        b = b - one;
        factor = factor * b / (a + b);
    }
    let gamma = libm::tgamma(a.value()) * (libm::tgamma(b.value()) / libm::tgamma((a + b).value()));
    factor.value() * gamma
}

/// Orthonormal polynomials of the probability measure (1−t)^α t^β dt / B(α+1, β+1):
/// √b_{k+1} p_{k+1} = (t − a_k) p_k − √b_k p_{k−1}.
struct Recurrence {
    /// a_k
    diagonal: Vec<Twofold>,
    /// √b_1 ... √b_n
    beside: Vec<Twofold>,
    /// 1/√b_{k+1}, a_k/√b_{k+1}, √b_k/√b_{k+1}
    steps: Vec<[Twofold; 3]>,
}

/// The orthonormal polynomial of degree n at a point, its derivative, Σ_{k<n} p_k², and half of its derivative.
struct Evaluation {
    value: f64,
    derivative: f64,
    squares: f64,
    slopes: f64,
}

impl Recurrence {
    fn new(n: usize, alpha: f64, beta: f64) -> Self {
        let number = |k: usize| Twofold::from(k as f64);
        let (one, two) = (number(1), number(2));
        let [alpha, beta] = [alpha, beta].map(Twofold::from);
        let sum = alpha + beta;
        let diagonal: Vec<Twofold> = (0..n)
            .map(|k| {
                if k == 0 {
                    return (beta + one) / (sum + two);
                }
                let s = number(2 * k) + sum;
                Twofold::from(0.5) * (one + (beta - alpha) * sum / (s * (s + two)))
            })
            .collect();
        let beside: Vec<Twofold> = (1..=n)
            .map(|k| {
                let (first, k) = (k == 1, number(k));
                let s = two * k + sum;
                // k + α + β and s − 1 cancel at k = 1, where both may vanish
                let ratio = if first { one } else { (k + sum) / (s - one) };
                (k * (k + alpha) * (k + beta) * ratio / (s * s * (s + one))).sqrt()
            })
            .collect();
        let step = |k: usize| {
            let inverse = one / beside[k];
            let before = if k > 0 { beside[k - 1] * inverse } else { number(0) };
            [inverse, diagonal[k] * inverse, before]
        };
        let steps = (0..n).map(step).collect();
        Self { diagonal, beside, steps }
    }

    /// The eigenvalues of the Jacobi matrix by the QL method with implicit shifts, O(n²); `None` if it does not
    /// converge.
    fn eigenvalues(&self) -> Option<Vec<f64>> {
        let n = self.diagonal.len();
        let mut d: Vec<f64> = self.diagonal.iter().map(|a| a.value()).collect();
        let mut e: Vec<f64> = self.beside.iter().map(|b| b.value()).collect();
        e[n - 1] = 0.0;
        if d.iter().chain(&e).any(|entry| !entry.is_finite()) {
            return None;
        }
        for first in 0..n {
            for step in 0.. {
                let small =
                    |k: &usize| e[*k].abs() <= 0.5 * f64::EPSILON * (d[*k].abs() + d[*k + 1].abs());
                let last = (first..n - 1).find(small).unwrap_or(n - 1);
                if last == first {
                    break;
                }
                if step == QL {
                    return None;
                }
                let ratio = (d[first + 1] - d[first]) / (2.0 * e[first]);
                let root = ratio.hypot(1.0);
                let mut g = d[last] - d[first] + e[first] / (ratio + root.copysign(ratio));
                let (mut s, mut c, mut p, mut is_split) = (1.0, 1.0, 0.0, false);
                for i in (first..last).rev() {
                    let (f, b) = (s * e[i], c * e[i]);
                    let r = f.hypot(g);
                    e[i + 1] = r;
                    if r == 0.0 {
                        d[i + 1] -= p;
                        e[last] = 0.0;
                        is_split = true;
                        break;
                    }
                    (s, c) = (f / r, g / r);
                    let shifted = d[i + 1] - p;
                    let turned = (d[i] - shifted) * s + 2.0 * c * b;
                    p = s * turned;
                    d[i + 1] = shifted + p;
                    g = c * turned - b;
                }
                if !is_split {
                    d[first] -= p;
                    e[first] = g;
                    e[last] = 0.0;
                }
            }
        }
        Some(d)
    }

    /// p_n/p_n' in binary64.
    fn newton_step(&self, t: f64) -> f64 {
        let (mut previous, mut value) = (0.0, 1.0);
        let (mut previous_slope, mut slope) = (0.0, 0.0);
        for [inverse, a, before] in &self.steps {
            let factor = t * inverse.high - a.high;
            let next = factor * value - before.high * previous;
            let next_slope = inverse.high * value + factor * slope - before.high * previous_slope;
            (previous, value) = (value, next);
            (previous_slope, slope) = (slope, next_slope);
        }
        value / slope
    }

    /// The values by twice the digits; derivatives have the digits of binary64.
    fn evaluate(&self, t: Twofold) -> Evaluation {
        let (mut previous, mut value) = (Twofold::default(), Twofold::from(1.0));
        let (mut previous_slope, mut slope) = (0.0, 0.0);
        let (mut squares, mut slopes) = (Twofold::default(), 0.0);
        for &[inverse, a, before] in &self.steps {
            squares = squares + value * value;
            slopes += value.high * slope;
            let factor = t * inverse - a;
            let next = factor * value - before * previous;
            let next_slope =
                inverse.high * value.high + factor.high * slope - before.high * previous_slope;
            (previous, value) = (value, next);
            (previous_slope, slope) = (slope, next_slope);
        }
        Evaluation { value: value.value(), derivative: slope, squares: squares.value(), slopes }
    }

    /// The root near an eigenvalue, and Σ_{k<n} p_k² there.
    fn point(&self, start: f64) -> (f64, f64) {
        let mut t = start.clamp(f64::MIN_POSITIVE, BELOW_ONE);
        for _ in 0..NEWTON {
            let next = t - self.newton_step(t);
            if !(next > 0.0 && next < 1.0) {
                break;
            }
            let moved = (next - t).abs();
            t = next;
            if moved <= SETTLED * t.min(1.0 - t) {
                break;
            }
        }
        let (mut root, mut squares) = (Twofold::from(t), f64::NAN);
        for _ in 0..LAST {
            let at = self.evaluate(root);
            let step = at.value / at.derivative;
            let next = root - Twofold::from(step);
            let room = next.value().min((Twofold::from(1.0) - next).value());
            if room.is_nan() || room <= 0.0 {
                break;
            }
            root = next;
            // Σ p_k² at the root, to the first order in the step
            squares = at.squares - 2.0 * at.slopes * step;
            if step.abs() <= SETTLED * room {
                break;
            }
        }
        (root.value().clamp(f64::MIN_POSITIVE, BELOW_ONE), squares)
    }
}
