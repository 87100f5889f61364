//! C(q) from below: the quotient ‖u‖\_{L^q}/‖u‖_ν of functions found by an ascent.

use super::upper::{check, critical_exponent};
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::interpolation::forms::mass_form;
use crate::numeric::dense::{Cholesky, product};
use crate::quadrature::Rule;
use crate::{Function, Mesh, Order, gram_linears};
use nalgebra::DMatrix;

/// Most steps of the ascent: some dozens do where the maximum is isolated.
const STEPS: usize = 400;

/// Relative rise in a step below which the ascent has arrived.
const RISE: f64 = 1e-12;

/// Gauss points per cell in the ascent; the quotient that is returned is integrated anew, to its tolerance.
const POINTS: usize = 12;

/// lim C(q)/√q for q → ∞ at ν = 1/2: (3/(4π²e))^{1/2}, from the logarithm cut off at ln(1/θ) = q/2.
///
/// ```
/// use fractional_sobolev::interpolation::EMBEDDING_GROWTH;
/// let exact = 3.0 / (4.0 * std::f64::consts::PI.powi(2) * 1f64.exp());
/// assert!((EMBEDDING_GROWTH.powi(2) - exact).abs() < 1e-15);
/// ```
pub const EMBEDDING_GROWTH: f64 = 0.167_198_939_329_408_5;

/// Largest exponent that a space for a critical exponent is made for.
const LARGEST_CRITICAL: f64 = 800.0;

/// Grading towards the end of the interval.
const RATIO: f64 = 0.6;

/// Layers in which the extremal functions for exponents up to q are seen.
pub(super) fn layers(q: f64) -> Result<usize> {
    Error::require("q", q, "[2, 1000]", (2.0..=EmbeddingSpace::LARGEST).contains(&q))?;
    Ok((30.0 + 0.6 * q / -RATIO.ln()) as usize)
}

/// A mesh of (0, 1) with those layers at 0.
pub(super) fn graded(q: f64) -> Result<Mesh> {
    Mesh::geometric(layers(q)?, RATIO, 1.0)
}

/// A function and its quotient ‖u‖\_{L^q}/‖u‖_ν: a lower bound of C(q).
///
/// Returned by [`EmbeddingSpace::climb`].
///
/// ```
/// use fractional_sobolev::interpolation::{EmbeddingSpace, EmbeddingTrial};
/// // ‖u‖_{L⁸} against ‖u‖_{1/2}: the function that was found has the quotient that was returned
/// let space = EmbeddingSpace::for_exponents_up_to(0.5, 8.0)?;
/// let EmbeddingTrial { quotient, function } = space.climb(8.0)?;
/// let again = function.lp(8.0, 1e-8)?.value / function.norm(0.5, 1e-8)?.value;
/// assert!((again / quotient.value - 1.0).abs() < 1e-6);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug)]
pub struct EmbeddingTrial {
    /// The quotient; its error is that of evaluating it.
    pub quotient: Estimate,
    /// The function.
    pub function: Function<'static>,
}

/// Piecewise linears on a mesh geometric to 0, for C(q) at one ν and any q.
///
/// # Method
///
/// Piecewise linears on a mesh geometric to 0, and u ← B⁻¹ ∫ |u|^{q−2} u φ_i, B the matrix of ‖·‖²_ν: the
/// quotient rises, ‖·‖_q being convex. Cost O(N³) once, O(N²) a step.
///
/// ```
/// use fractional_sobolev::{Order, interpolation::{EmbeddingSpace, critical_exponent, embedding_upper_bound}};
/// let order = Order::new(0.25)?;
/// let q = critical_exponent(order)?; // 4: ‖u‖_{L⁴} ≤ C ‖u‖_{1/4}
/// let lower = EmbeddingSpace::new(order, 20, 0.5)?.climb(q)?.quotient;
/// assert!(lower.value <= embedding_upper_bound(order, q)?.value && lower.value > 0.999);
/// EmbeddingSpace::at_critical_exponent(order)?;
/// EmbeddingSpace::for_exponents_up_to(Order::HALF, 4.0)?;
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct EmbeddingSpace {
    order: Order,
    partition: Mesh,
    norm: DMatrix<f64>,
    factor: Cholesky,
}

impl EmbeddingSpace {
    /// A space that serves every exponent up to q: layers down to e^{-0.6 q}, beyond ln(1/θ) = q/2 where the
    /// extremal function is cut off.
    ///
    /// # Errors
    /// As [`EmbeddingSpace::new`]; [`Error::OutOfRange`] unless 2 ≤ q ≤ [`EmbeddingSpace::LARGEST`].
    pub fn for_exponents_up_to(order: impl Given<Order>, q: f64) -> Result<Self> {
        let order = order.given()?;
        Self::new(order, layers(q)?, RATIO)
    }

    /// A space for the critical exponent 2/(1−2ν): it serves exponents up to four times as large, where that
    /// is allowed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless ν < 1/2; as [`EmbeddingSpace::new`].
    pub fn at_critical_exponent(order: impl Given<Order>) -> Result<Self> {
        let order = order.given()?;
        let q = critical_exponent(order)?;
        Error::require("nu", order.value(), "(0, 1/2) for the critical exponent", q.is_finite())?;
        Self::for_exponents_up_to(order, (4.0 * q).min(LARGEST_CRITICAL))
    }

    /// Beyond this exponent the layers would leave the range of binary64.
    ///
    /// ```
    /// use fractional_sobolev::{Order, interpolation::EmbeddingSpace};
    /// let beyond = 1.01 * EmbeddingSpace::LARGEST;
    /// assert!(EmbeddingSpace::for_exponents_up_to(Order::HALF, beyond).is_err());
    /// ```
    pub const LARGEST: f64 = 1000.0;

    /// Elements shrink by `ratio` from 1/4 to 1/4 ratio^layers at the end 0; equal ones on the rest of (0,
    /// 1).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for ν > 1/2 or a ratio outside (0, 1), or elements too short.
    pub fn new(order: impl Given<Order>, layers: usize, ratio: f64) -> Result<Self> {
        let order = order.given()?;
        critical_exponent(order)?;
        let mut lengths = Mesh::geometric(layers, ratio, 0.25)?.lengths().to_vec();
        let rest = (3.0 * ratio / (1.0 - ratio)).ceil().max(4.0) as usize;
        lengths.extend(vec![0.75 / rest as f64; rest]);
        let partition = Mesh::from_lengths(lengths)?;
        let norm = gram_linears(&partition, order) + mass_form(&partition);
        let pivot = partition.len();
        let factor = Cholesky::new(&norm)
            .ok_or(Error::NotPositiveDefinite { what: "Gram matrix of the norm", pivot })?;
        Ok(Self { order, partition, norm, factor })
    }

    /// The best quotient found by ascents from functions concentrated at 0 to several degrees, and from u =
    /// 1.
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
        let rule = Rule::gauss_legendre(POINTS)?;
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
    fn load(&self, q: f64, values: &[f64], rule: &Rule) -> (DMatrix<f64>, f64) {
        let mut load = DMatrix::zeros(values.len(), 1);
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
        let u = DMatrix::from_fn(values.len(), 1, |i, _| values[i]);
        u.dot(&product(&self.norm, &u))
    }

    fn trial(&self, q: f64, values: &[f64]) -> Result<EmbeddingTrial> {
        let function = Function::linears(&self.partition, values)?;
        let top = function.lp(q, Tolerance::balanced())?;
        let norm = function.norm(self.order, Tolerance::balanced())?;
        let value = top.value / norm.value;
        let relative = top.relative_error() + norm.relative_error();
        let work = Work { factorizations: 1, ..top.work + norm.work };
        Ok(EmbeddingTrial { quotient: Estimate::new(value, relative * value, work)?, function })
    }
}
