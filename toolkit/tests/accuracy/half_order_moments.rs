//! The moments of `moment` at ν = 1/2 beside their closed form by the Wiener-Hopf method: a second computation.

use fractional_sobolev::{Moment, gauss_legendre, moment};
use std::f64::consts::PI;

/// Number of roots of tan z = z in the product; the remainder is computed by an integral, to 2e-15.
const ROOTS: usize = 4000;
/// Largest number of powers of w; for w ≤ 0.3 rounding dominates the remainder earlier.
const POWERS: usize = 30;
/// Number of points of the integral over s.
const POINTS: usize = 40;
/// Rounding errors, in units of ε, of f_k/g_k and of a term of c_m; m for the product and for the binomial
/// coefficient are added.
const ROUNDINGS: f64 = 20.0;

/// The moment M(e) at ν = 1/2, 1e-6 ≤ e ≤ 0.7, and its error.
///
/// # Method
///
/// dx dx'/(x−x')² is invariant under y = ln(x/(1−x)): |w|² = ∬ (w(y)−w(y'))² / (4 sinh²((y−y')/2)) on the
/// line, with the symbol G(ξ) = 2(πξ coth πξ − 1), and w = 0 for y > ln q, q = e/(1−e). With z_n the positive
/// roots of tan z = z, G = G₊(ξ) G₊(−ξ),
///
/// g_k = G₊(ik) = π (2/3)^{1/2} k Π_n (1 + πk/z_n)/(1 + k/n).
///
/// In t = ln q − y > 0 the operator is T = T(G₋) T(G₊), and e^{−kt} is an eigenvector of the adjoint of an
/// analytic Toeplitz operator: ⟨e^{−jt}, T⁻¹ e^{−kt}⟩ = 1/((j+k) g_j g_k). The load is Σ f_k q^k e^{−kt}, f_k
/// = (−1)^{k−1} k for m = 1 and (−1)^k k(k−1)/2 for m = x, so that q dM²/dq = h², h(q) = Σ (f_k/g_k) q^k, and
///
/// M(e)² = ∫₀ᵉ h² ds/(s(1−s)),  s = q/(1+q).
///
/// The only singularities of h lie on q ≤ −1, and w = (√(1+q) − 1)/(√(1+q) + 1) maps the plane without them to
/// the unit disc: h = Σ c_m w^m with c_m = Σ_k 4^k C(m+k−1, m−k) f_k/g_k, since q = 4w/(1−w)². At w = −1, which
/// is q = −1, h grows like (1+w)^{−5} for m = x (f_k/g_k is like k^{3/2}) and like (1+w)^{−3} for m = 1, so
/// that (1+w)⁵ h = Σ d_m w^m has small coefficients (`Series::at`). They are sums of alternating terms as large
/// as (3 + 2√2)^m, whose rounding errors are computed along with them; w ≤ 0.3 for s ≤ 0.7, where Euler's
/// transformation (powers of s, terms up to 2^m) loses more digits. Cost: 4000 roots, 120 000 logarithms, once.
fn half_order_moment([mass, first]: &[Series; 2], length: f64, moment: Moment) -> (f64, f64) {
    // h is linear in m: that of e − x is e times that of 1 less that of x.
    let (a, b) = match moment {
        Moment::Mass => (1.0, 0.0),
        Moment::FromFreeEnd => (0.0, 1.0),
        Moment::FromZone => (length, -1.0),
    };
    let h = |s: f64| {
        let root = (1.0 - s).sqrt();
        let w = s / (1.0 + root).powi(2);
        let ((m, em), (f, ef)) = (mass.at(w), first.at(w));
        (
            a * m + b * f,
            a.abs() * (em + m.abs() * f64::EPSILON) + b.abs() * (ef + f.abs() * f64::EPSILON),
        )
    };
    let rule = gauss_legendre(POINTS).unwrap();
    let over = |value: f64, t: f64| value / (t * (1.0 - length * t));
    let square = rule.integrate(|t| over(h(length * t).0.powi(2), t));
    let error = rule.integrate(|t| {
        let (value, error) = h(length * t);
        over(error * (2.0 * value.abs() + error), t)
    });
    (square.sqrt(), (error + 32.0 * f64::EPSILON * square) / square.sqrt())
}

/// The series of h for m = 1 and m = x.
fn both_series() -> [Series; 2] {
    let roots: Vec<Root> = (1..=ROOTS).map(Root::new).collect();
    let ratios: Vec<f64> = (1..=POWERS).map(|k| ratio(k, &roots)).collect();
    [Series::new(&ratios, |_| 1.0), Series::new(&ratios, |k| 0.5 * (1.0 - k))]
}

/// The coefficients d_1, d_2, ... and the rounding error of each.
struct Series {
    coefficients: Vec<(f64, f64)>,
}

impl Series {
    /// The series from k/g_k and factor(k) = ±f_k/k, without its alternating sign.
    fn new(ratios: &[f64], factor: impl Fn(f64) -> f64) -> Self {
        let coefficient = |m: usize| {
            // 4^k C(m+k−1, m−k) downwards from k = m.
            let mut binomial = 4f64.powi(m as i32);
            let mut terms = Vec::with_capacity(m);
            for k in (1..=m).rev() {
                let sign = if k % 2 == 1 { 1.0 } else { -1.0 };
                terms.push(sign * factor(k as f64) * ratios[k - 1] * binomial);
                binomial *=
                    ((2 * k - 1) * (2 * k - 2)) as f64 / (4 * (m + k - 1) * (m - k + 1)) as f64;
            }
            let size = compensated(terms.iter().map(|term| term.abs()));
            (compensated(terms), size * (m as f64 + ROUNDINGS) * f64::EPSILON)
        };
        let plain: Vec<(f64, f64)> = (1..=POWERS).map(coefficient).collect();
        let times = |m: usize| {
            let terms = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0].into_iter().zip(plain[..=m].iter().rev());
            terms.fold((0.0, 0.0), |(sum, lost), (b, (c, l))| (sum + b * c, lost + b * l))
        };
        Self { coefficients: (0..POWERS).map(times).collect() }
    }

    /// The value of h at w and its error, with the number of terms that minimises the sum of rounding error and
    /// remainder.
    ///
    /// The larger of two consecutive |d_m| decreases from m = 2 on (observed up to m = 40, not proved): the
    /// remainder after M terms is then at most max(|d_{M−1}|, |d_M|) w^{M+1}/(1 − w).
    fn at(&self, w: f64) -> (f64, f64) {
        let (mut value, mut rounding, mut power) = (0.0, 0.0, 1.0);
        let mut best = (0.0, f64::INFINITY);
        let mut before = f64::INFINITY;
        for &(d, lost) in &self.coefficients {
            power *= w;
            value += d * power;
            rounding += lost * power;
            let size = d.abs() + lost;
            let left = size.max(before) * power * w / (1.0 - w);
            before = size;
            if left + rounding < best.1 {
                best = (value, left + rounding);
            }
        }
        let scale = (1.0 + w).powi(-5);
        (best.0 * scale, best.1 * scale)
    }
}

/// The n-th positive root of sin z = z cos z: z = (n + 1/2)π − d.
struct Root {
    above: f64,
    below: f64,
}

impl Root {
    /// Newton's method for d, so that d itself has full relative accuracy.
    fn new(n: usize) -> Self {
        let above = (n as f64 + 0.5) * PI;
        // cot z = tan d, and z tan d = 1.
        let mut below = 1.0 / above;
        for _ in 0..6 {
            let (z, tangent) = (above - below, below.tan());
            below -= (z * tangent - 1.0) / (z * (1.0 + tangent * tangent) - tangent);
        }
        Self { above, below }
    }
}

/// k/g_k = (3/2)^{1/2}/π Π_n (1 + k/n)/(1 + πk/z_n), relative to Π (1 + k/n)/(1 + k/(n+1/2)) = Π_{j≤k} (1 +
/// 1/(2j)).
fn ratio(k: usize, roots: &[Root]) -> f64 {
    let half: f64 = (1..=k).map(|j| 1.0 + 0.5 / j as f64).product();
    let k = k as f64;
    let logarithm = |root: &Root| {
        let (a, z) = (root.above / PI, root.above - root.below);
        (-k * root.below / (a * (z + PI * k))).ln_1p()
    };
    let sum = compensated(roots.iter().rev().map(logarithm));
    // z_n/π = a − 1/(π²a) + ..., a = n + 1/2: the rest is −∫ k/(π² a² (a+k)) da.
    let from = (ROOTS + 1) as f64;
    let rest = (1.0 / from - (k / from).ln_1p() / k) / (PI * PI);
    1.5f64.sqrt() / PI * half * (sum - rest).exp()
}

/// The sum of the terms with Neumaier's compensation.
fn compensated(terms: impl IntoIterator<Item = f64>) -> f64 {
    let (mut sum, mut carry) = (0.0f64, 0.0);
    for term in terms {
        let next = sum + term;
        carry += if sum.abs() >= term.abs() { (sum - next) + term } else { (term - next) + sum };
        sum = next;
    }
    sum + carry
}

#[test]
fn moments_of_half_order_have_their_closed_form() {
    let series = both_series();
    for length in [1e-3, 0.1, 0.25, 0.5, 0.6, 0.7] {
        for m in [Moment::Mass, Moment::FromFreeEnd, Moment::FromZone] {
            let found = moment(0.5, length..1.0, m, 1e-10).unwrap();
            let (closed, error) = half_order_moment(&series, length, m);
            let apart = (found.constant.value - closed).abs();
            assert!(apart <= found.constant.error + error, "{length} {m:?}: {found:?} {closed}");
            assert!(error < 1e-9 * closed, "{length} {m:?}: {closed} {error:e}");
            let [lower, upper] = found.bounded().map_or([0.0, f64::INFINITY], |found| {
                [found.lower, found.upper.unwrap()].map(|bound| bound.value)
            });
            assert!(lower - error <= closed && closed <= upper + error, "{length} {m:?}: {closed}");
        }
    }
}

#[test]
fn another_program_with_forty_digits_agrees() {
    // mpmath, 400 roots with a summed tail, 70 powers.
    let known = [
        (0.2, 0.083_651_250_832_953_84, 0.007_249_041_690_524_879),
        (0.5, 0.227_746_412_459_886_86, 0.048_972_831_541_786_43),
        (0.6, 0.284_558_533_995_324_05, 0.073_320_149_170_287_36),
    ];
    let series = both_series();
    for (length, mass, first) in known {
        for (moment, exact) in [(Moment::Mass, mass), (Moment::FromFreeEnd, first)] {
            let (found, error) = half_order_moment(&series, length, moment);
            assert!((found - exact).abs() <= error, "{length} {moment:?}: {found} {exact}");
        }
    }
}

#[test]
fn roots_and_the_first_ratio() {
    let first = Root::new(1);
    let z = first.above - first.below;
    assert!((z.tan() - z).abs() < 1e-12 && (z - 4.493_409_457_909_064).abs() < 1e-14);
    let roots: Vec<Root> = (1..=ROOTS).map(Root::new).collect();
    assert!((ratio(1, &roots) / 0.568_276_111_684_543_8 - 1.0).abs() < 1e-13);
    assert!((ratio(10, &roots) / 1.340_250_500_348_664_7 - 1.0).abs() < 1e-13);
}
