//! C(q), the best constant of H^ν(0,1) ⊂ L^q(0,1), ν ≤ 1/2: ‖u‖_{L^q} ≤ C(q) ‖u‖_ν with the full norm (1.1); (3.6), (3.10), (4.12).
//!
//! Domain: 2 ≤ q < ∞ for ν = 1/2, 2 ≤ q ≤ 2/(1−2ν) for ν < 1/2. C(q) ≥ 1 by u = 1.
//!
//! **From above**, for all functions. The even reflection U of u on the circle (−1, 1) has ‖U‖_q = ‖u‖_q (normalised measure);
//! let c_k be its Fourier coefficients, p = 1 + 2ν ≤ 2 and K(t) = |2 sin(πt/2)/π|^{-p}. Then
//! ∫∫_{(−1,1)²} (U(x)−U(y))² K(x−y) = 2 ∫∫_{(0,1)²} (u(x)−u(y))² [K(x−y) + K(x+y)],
//! K(x+y) ≤ K(x−y), because sin(π(x+y)/2) ≥ |sin(π(x−y)/2)|, and K(t) ≤ t^{-p} + b with b = (π/2)^p − 1 on (0, 1), because
//! (s/sin s)^p has positive Taylor coefficients. The left side is Σ Ω_k |c_k|² in closed form. Together
//!   ‖u‖²_ν ≥ Σ w_k |c_k|²,  w_0 = 1,  w_k = 1 − 2b + κ (R_k − R_0),  κ = π^p/(sin(πν) Γ(p)),  R_k = Γ(k+1/2+ν)/Γ(k+1/2−ν);
//! at ν = 1/2 w_k = π² k + 3 − π²/2. Beckner's sharp inequality on the circle (Ann. of Math. 138 (1993) 213-242) is
//!   ‖U‖²_q ≤ Σ m_k |c_k|²,  m_k = Γ(1/q) Γ(k+1−1/q) / (Γ(1−1/q) Γ(k+1/q)).
//! Hence C(q)² ≤ max_k m_k/w_k. m_k/R_k falls with k, which bounds the tail. Where the maximum is 1, C(q) = 1 exactly.
//!
//! **From below**: the quotient of any function. Piecewise linears on a mesh geometric to 0, and the ascent
//! u ← B⁻¹ ∫ |u|^{q−2} u φ_i, B the matrix of ‖·‖²_ν: the quotient rises, ‖·‖_q being convex. Cost O(N³) once, O(N²) a step.

use super::forms::mass_form;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::quadrature::Rule;
use crate::sobolev::{FractionalOrder, Partition, PiecewisePolynomial, gram_linears};
use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};
use std::f64::consts::PI;

/// Terms of the maximum that are computed; beyond, the tail bound.
const TERMS: usize = 100_000;

/// Rounding of products of that many factors.
const ROUNDING: f64 = 1e-10;

/// Most steps of the ascent, and the relative rise below which it stops.
const STEPS: usize = 400;
const RISE: f64 = 1e-12;

/// Checks ν ≤ 1/2 and 2 ≤ q ≤ 2/(1−2ν), q < ∞.
fn check(order: FractionalOrder, q: f64) -> Result<()> {
    let nu = order.value();
    Error::require("nu", nu, "(0, 1/2] for the embedding in L^q", order.offset() <= 0.0)?;
    // q = 2/(1−2ν) itself is rounded.
    let admissible =
        (2.0..=1e6).contains(&q) && q * order.one_minus_twice() <= 2.0 * (1.0 + 4.0 * f64::EPSILON);
    Error::require("q", q, "[2, 2/(1-2 nu)] and at most 1e6", admissible).map(|_| ())
}

/// The critical exponent 2/(1−2ν), infinite at ν = 1/2.
///
/// # Errors
/// [`Error::OutOfRange`] for ν > 1/2, where functions are continuous.
pub fn critical_exponent(order: FractionalOrder) -> Result<f64> {
    Error::require("nu", order.value(), "(0, 1/2]", order.offset() <= 0.0)?;
    // + 0: 1 − 2ν may be −0.
    Ok(2.0 / (order.one_minus_twice() + 0.0))
}

/// An upper bound of C(q), for every function of H^ν(0,1); rounded up.
///
/// # Errors
/// [`Error::OutOfRange`] outside the domain.
pub fn embedding_upper_bound(order: FractionalOrder, q: f64) -> Result<f64> {
    check(order, q)?;
    let (nu, below) = (order.value(), -order.offset());
    let p = 1.0 + 2.0 * nu;
    let kappa = PI.powf(p) / ((PI * nu).sin() * libm::tgamma(p));
    // R_0 = Γ(1/2+ν)/Γ(1/2−ν), R_1 = R_0 (1/2+ν)/(1/2−ν) = Γ(3/2+ν)/Γ(3/2−ν): no pole at ν = 1/2.
    let first = libm::tgamma(1.5 + nu) / libm::tgamma(1.0 + below);
    let start = first * below / (0.5 + nu);
    let shift = 1.0 - 2.0 * ((0.5 * PI).powf(p) - 1.0) - kappa * start;
    let (mut r, mut m, mut largest) = (first, q - 1.0, 1.0f64);
    for k in 1..TERMS {
        largest = largest.max(m / (shift + kappa * r));
        let j = k as f64;
        r *= (j + 0.5 + nu) / (j + below);
        m *= (j + 1.0 - 1.0 / q) / (j + 1.0 / q);
    }
    // R/(A + κR) rises to 1/κ, or falls from its value here.
    let tail = (m / r) * (1.0 / kappa).max(r / (shift + kappa * r));
    let bound = largest.max(tail);
    // Where nothing exceeds the constant function the bound is attained by it.
    Ok(if bound <= 1.0 { 1.0 } else { (bound * (1.0 + ROUNDING)).sqrt() })
}

/// A function and its quotient ‖u‖_{L^q}/‖u‖_ν: a lower bound of C(q).
#[derive(Debug, Clone, PartialEq)]
pub struct EmbeddingTrial {
    /// The quotient; its error is that of evaluating it.
    pub quotient: Estimate,
    /// The function.
    pub function: PiecewisePolynomial,
}

/// Piecewise linears on a mesh geometric to 0, for C(q) at one ν and any q.
#[derive(Debug, Clone)]
pub struct EmbeddingSpace {
    order: FractionalOrder,
    partition: Partition,
    norm: Mat<f64>,
    factor: Llt<f64>,
}

impl EmbeddingSpace {
    /// Elements shrink by `ratio` from 1/4 to 1/4 ratio^layers at the end 0; equal ones on the rest of (0, 1).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for ν > 1/2 or a ratio outside (0, 1), or elements too short.
    pub fn new(order: FractionalOrder, layers: usize, ratio: f64) -> Result<Self> {
        critical_exponent(order)?;
        let mut lengths = Partition::geometric(layers, ratio, 0.25)?.lengths().to_vec();
        let rest = (3.0 * ratio / (1.0 - ratio)).ceil().max(4.0) as usize;
        lengths.extend(vec![0.75 / rest as f64; rest]);
        let partition = Partition::from_lengths(lengths)?;
        let norm = gram_linears(&partition, order) + mass_form(&partition);
        let pivot = partition.len();
        let factor = norm
            .llt(Side::Lower)
            .map_err(|_| Error::NotPositiveDefinite { what: "Gram matrix of the norm", pivot })?;
        Ok(Self { order, partition, norm, factor })
    }

    /// The best quotient found by ascents from functions concentrated at 0 to several degrees, and from u = 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q outside the domain.
    pub fn climb(&self, q: f64) -> Result<EmbeddingTrial> {
        check(self.order, q)?;
        let nodes = self.partition.from_left();
        let depth = (nodes[1] / nodes[nodes.len() - 1]).ln();
        let mut best = self.trial(q, &vec![1.0; nodes.len()])?;
        for fraction in [0.1, 0.3, 0.6] {
            // (λ² + x²)^{-(1−2ν)/4}-like bubbles for ν < 1/2, logarithms at 1/2, cut off at λ.
            let lambda = (fraction * depth).exp();
            let decay = 0.5 * self.order.one_minus_twice();
            let start: Vec<f64> = nodes
                .iter()
                .map(|x| {
                    let log = (lambda * lambda + x * x).ln() * 0.5;
                    // (1 + λ − x^...)/decay → −ln x as the decay vanishes
                    0.1 + if decay > 1e-3 { (-2.0 * decay * log).exp() } else { 0.1 - log }
                })
                .collect();
            let found = self.ascend(q, start)?;
            if found.quotient.value > best.quotient.value {
                best = found;
            }
        }
        Ok(best)
    }

    fn ascend(&self, q: f64, start: Vec<f64>) -> Result<EmbeddingTrial> {
        let rule = Rule::gauss_legendre(12)?;
        let mut values = start;
        let mut last = 0.0;
        for _ in 0..STEPS {
            let largest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            values.iter_mut().for_each(|v| *v /= largest);
            let (load, power) = self.load(q, &values, &rule);
            let quotient = power.powf(1.0 / q) / self.energy(&values).sqrt();
            if quotient <= last * (1.0 + RISE) {
                break;
            }
            last = quotient;
            let next = self.factor.solve(&load);
            values = (0..values.len()).map(|i| next[(i, 0)]).collect();
        }
        self.trial(q, &values)
    }

    /// (∫ |u|^{q−2} u φ_i, ∫ |u|^q).
    fn load(&self, q: f64, values: &[f64], rule: &Rule) -> (Mat<f64>, f64) {
        let mut load = Mat::zeros(values.len(), 1);
        let mut power = 0.0;
        for (i, &h) in self.partition.lengths().iter().enumerate() {
            for (t, w) in rule.iter() {
                let u = values[i] * (1.0 - t) + values[i + 1] * t;
                let weight = h * w * u.abs().powf(q - 1.0).copysign(u);
                load[(i, 0)] += weight * (1.0 - t);
                load[(i + 1, 0)] += weight * t;
                power += weight * u;
            }
        }
        (load, power)
    }

    fn energy(&self, values: &[f64]) -> f64 {
        let u = Mat::from_fn(values.len(), 1, |i, _| values[i]);
        (u.transpose() * (&self.norm * &u))[(0, 0)]
    }

    fn trial(&self, q: f64, values: &[f64]) -> Result<EmbeddingTrial> {
        let function = PiecewisePolynomial::linears(self.partition.clone(), values)?;
        let top = function.lq_norm(q, Tolerance::balanced())?;
        let norm = function.norm(0, self.order, Tolerance::balanced())?;
        let value = top.value / norm.value;
        let relative = top.relative_error() + norm.relative_error();
        let work = Work { factorizations: 1, ..top.work + norm.work };
        Ok(EmbeddingTrial { quotient: Estimate::new(value, relative * value, work)?, function })
    }
}
