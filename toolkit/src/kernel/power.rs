//! Integrals of the kernel t^{-1-2ν} times polynomials along a line, without cancellation.
//!
//! With L = ln(1 + ℓ/x) and α = k − 2ν:
//! ∫_x^{x+ℓ} τ^{k-1-2ν} dτ = x^α (e^{αL} − 1)/α, where expm1 and log1p make α = 0 (ν = 1/2, k = 1) a
//! removable limit and ℓ ≪ x harmless. Moments about t = 0 (τ = x + t) subtract these; they do so only
//! for ℓ > 2x, where at most a digit is lost. For ℓ ≤ 2x the integrand is analytic in an ellipse of known
//! size and a Gauss rule of known order is exact to rounding.

use crate::order::Order;
use crate::quadrature::Rule;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// Orders 1 ..= MAX_POINTS of the Gauss rules that are tabulated.
const MAX_POINTS: usize = 40;

/// Largest ratio of the length of a piece to its distance from the singularity for which a single Gauss rule is
/// used.
pub(crate) const GAUSS_REACH: f64 = 2.0;

/// n-point Gauss-Legendre rules on (0, 1) and the largest ℓ/x for which each is exact to rounding.
struct GaussTable {
    rules: Vec<Rule>,
    reach: Vec<f64>,
}

fn gauss_table() -> &'static GaussTable {
    static TABLE: OnceLock<GaussTable> = OnceLock::new();
    TABLE.get_or_init(|| {
        let mut table = GaussTable { rules: Vec::new(), reach: Vec::new() };
        for n in 1..=MAX_POINTS {
            // n >= 1, so the rule exists
            let Ok(rule) = Rule::gauss_legendre(n) else { continue };
            table.rules.push(rule);
            // The error is about ρ^{-2n} with ρ + 1/ρ = 2 (1 + 2 x/ℓ): ρ^{-2n} = 1e-17
            let rho = 10f64.powf(17.0 / (2.0 * n as f64));
            table.reach.push(2.0 / (0.5 * (rho + 1.0 / rho) - 1.0));
        }
        table
    })
}

/// The rules for the kernel times polynomials of degree 2 `degree`, to a share of all digits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GaussRules {
    pub(crate) degree: usize,
    /// share of 17 digits
    pub(crate) share: f64,
}

impl GaussRules {
    /// The rules exact to rounding for the kernel times a quadratic.
    pub(crate) const EXACT: Self = Self { degree: 1, share: 1.0 };

    /// The rules for the relative accuracy `target` of a positive integral.
    pub(crate) fn to(degree: usize, target: f64) -> Self {
        Self { degree, share: (-target.log10() / 17.0).clamp(0.1, 1.0) }
    }

    /// The rule on (0, 1) for (x + ℓη)^{-1-2ν}, ratio = ℓ/x ≤ 2: `degree` points in addition to those for the
    /// kernel, whose number follows from the error ρ^{-2n}.
    pub(crate) fn simple(self, ratio: f64) -> &'static Rule {
        let table = gauss_table();
        let exact = table.reach.partition_point(|&reach| reach < ratio) as f64;
        let needed = (exact * self.share).ceil() as usize + self.degree;
        &table.rules[needed.min(MAX_POINTS - 1)]
    }

    /// Σ w f over pieces of (0, ℓ) that grow away from a singularity at −x, each by its rule.
    pub(crate) fn graded(self, x: f64, length: f64, mut f: impl FnMut(f64, f64)) {
        let mut start = 0.0;
        loop {
            let rest = length - start;
            let reach = GAUSS_REACH * (x + start);
            // A last piece slightly too long is cheaper than a sliver.
            let (piece, last) = if rest <= reach { (rest, true) } else { (reach, false) };
            for (point, weight) in self.simple(piece / (x + start)).iter() {
                f(start + piece * point, piece * weight);
            }
            if last {
                return;
            }
            start += piece;
        }
    }
}

/// The constant c of the symbol c |ξ|^{2ν} of the form ∫∫ (u(x)−u(y)) (v(x)−v(y)) |x−y|^{-1-2ν} on the line:
/// 2/C(1, ν), C the constant of the fractional Laplacian.
pub(crate) fn symbol_constant(order: Order) -> f64 {
    let sine = (PI * order.value().min(order.complement())).sin();
    2.0 * PI / (libm::tgamma(1.0 + 2.0 * order.value()) * sine)
}

/// The kernel t^{-1-2ν}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PowerKernel {
    /// 2ν
    pub(crate) twice: f64,
    /// 1 − 2ν, exact near ν = 1/2
    pub(crate) one_minus: f64,
    /// 2 − 2ν, exact near ν = 1
    pub(crate) two_minus: f64,
    /// 3 − 2ν
    pub(crate) three_minus: f64,
}

/// (e^{αL} − 1)/α with its limit L at α = 0.
pub(crate) fn expm1_over(alpha: f64, log: f64) -> f64 {
    let y = alpha * log;
    if y.abs() < 1e-290 { log } else { y.exp_m1() / alpha }
}

/// ln(1 + ℓ/x) for x > 0, also if ℓ/x overflows.
pub(crate) fn log_ratio(x: f64, length: f64) -> f64 {
    let ratio = length / x;
    if ratio < 1e15 { ratio.ln_1p() } else { (x + length).ln() - x.ln() }
}

impl PowerKernel {
    pub(crate) fn new(order: Order) -> Self {
        let one_minus = order.one_minus_twice();
        Self {
            twice: 2.0 * order.value(),
            one_minus,
            two_minus: 2.0 * order.complement(),
            three_minus: 1.0 + 2.0 * order.complement(),
        }
    }

    /// The value t^{-1-2ν}.
    pub(crate) fn at(&self, t: f64) -> f64 {
        t.powf(-1.0 - self.twice)
    }

    /// ℓ t^{-1-2ν}, also if t^{-1-2ν} alone underflows.
    fn over(&self, length: f64, t: f64) -> f64 {
        (length / t) * t.powf(-self.twice)
    }

    /// ∫_t^∞ τ^{-1-2ν} dτ.
    pub(crate) fn tail(&self, t: f64) -> f64 {
        t.powf(-self.twice) / self.twice
    }

    /// The factor S^{1-2ν} by which integrals over two cells scale, computed from the exponent that is exact.
    pub(crate) fn scaling(&self, scale: f64) -> f64 {
        if self.twice < 0.5 { scale * scale.powf(-self.twice) } else { scale.powf(self.one_minus) }
    }

    /// ∫∫ (x−y)² / p² |x−y|^{-1-2ν} over one cell with itself: 2 p^{1-2ν} / ((2−2ν)(3−2ν)).
    pub(crate) fn own(&self, p: f64) -> f64 {
        2.0 * self.scaling(p) / (self.two_minus * self.three_minus)
    }

    /// ∫_0^ℓ (x+t)^{-1-2ν} dt.
    pub(crate) fn whole(&self, x: f64, length: f64) -> f64 {
        x.powf(-self.twice) * expm1_over(-self.twice, log_ratio(x, length))
    }

    /// ∫_x^{x+ℓ} (τ/ℓ)^k τ^{-1-2ν} dτ for α = k − 2ν, computed from the end that does not overflow.
    fn about_origin(&self, k: i32, alpha: f64, x: f64, length: f64) -> f64 {
        let log = log_ratio(x, length);
        if alpha >= 0.0 {
            let end = x + length;
            (end / length).powi(k) * end.powf(-self.twice) * expm1_over(-alpha, log)
        } else {
            (x / length).powi(k) * x.powf(-self.twice) * expm1_over(alpha, log)
        }
    }

    /// ∫_0^ℓ w(t) (x+t)^{-1-2ν} dt for w = 1 − t/ℓ and w = t/ℓ.
    pub(crate) fn hats(&self, x: f64, length: f64) -> [f64; 2] {
        if length <= GAUSS_REACH * x {
            let (mut near, mut far) = (0.0, 0.0);
            for (t, w) in GaussRules::EXACT.simple(length / x).iter() {
                let value = w * self.over(length, x + length * t);
                near += (1.0 - t) * value;
                far += t * value;
            }
            return [near, far];
        }
        let whole = self.whole(x, length);
        let first = self.about_origin(1, self.one_minus, x, length);
        let ratio = x / length;
        [(1.0 + ratio) * whole - first, first - ratio * whole]
    }

    /// ∫_0^ℓ w(t) (x+t)^{-1-2ν} dt for w = (1 − t/ℓ)², 2 (t/ℓ)(1 − t/ℓ), (t/ℓ)²; they sum to
    /// [`PowerKernel::whole`].
    pub(crate) fn squares(&self, x: f64, length: f64) -> [f64; 3] {
        if length <= GAUSS_REACH * x {
            let mut sums = [0.0; 3];
            for (t, w) in GaussRules::EXACT.simple(length / x).iter() {
                let value = w * self.over(length, x + length * t);
                sums[0] += (1.0 - t) * (1.0 - t) * value;
                sums[1] += 2.0 * t * (1.0 - t) * value;
                sums[2] += t * t * value;
            }
            return sums;
        }
        let whole = self.whole(x, length);
        let first = self.about_origin(1, self.one_minus, x, length);
        let second = self.about_origin(2, self.two_minus, x, length);
        let r = x / length;
        [
            (1.0 + r) * (1.0 + r) * whole - 2.0 * (1.0 + r) * first + second,
            2.0 * ((1.0 + 2.0 * r) * first - r * (1.0 + r) * whole - second),
            second - 2.0 * r * first + r * (r * whole),
        ]
    }
}
