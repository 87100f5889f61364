//! Quadratic forms of e^{-τ|x-y|} for piecewise polynomials, exact and computed in one pass over the elements.
//!
//! For a block of consecutive elements of total length ℓ
//!   a = ∫ e^{-τ(x-left)} f,  b = ∫ e^{-τ(right-x)} f,  d = ∫∫ e^{-τ|x-y|} f(x) f(y),  e = e^{-τℓ},
//! and two neighbouring blocks are joined by
//!   a = a₁ + e₁ a₂,  b = b₂ + e₂ b₁,  d = d₁ + d₂ + 2 b₁ a₂,  e = e₁ e₂,
//! in a binary tree: the rounding error grows like the logarithm of the number of elements, and is computed along
//! with the sums. On an element of length h, z = τh, f = Σ f_k P_k(2t-1) and its autocorrelation ∫_0^{1-r} f(t)
//! f(t+r) dt = Σ c_n P_n(2r-1), n ≤ 2p + 1:
//!   a = h Σ f_k m_k(z),  b = h Σ (-1)^k f_k m_k(z),  d = 2h² Σ c_n m_n(z),
//!   m_n(z) = ∫_0^1 e^{-zt} P_n(2t-1) dt = (-1)^n e^{-z/2} i_n(z/2),
//! p the degree of f, i_n the modified spherical Bessel functions. Cost O(N (p + 1)) for one τ.

use crate::error::Result;
use crate::numeric::legendre;
use crate::numeric::sum::RunningSum;
use crate::piecewise::PiecewisePolynomial;
use crate::quadrature::Rule;

/// Number of elements summed sequentially before halves are joined.
const RUN: usize = 4;

/// A piecewise polynomial on (0, 1), given by Legendre coefficients.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    degree: usize,
    lengths: Vec<f64>,
    /// p + 1 coefficients per element
    values: Vec<f64>,
    /// 2p + 2 coefficients of the autocorrelation per element
    correlations: Vec<f64>,
}

/// The four integrals of a block of elements, and the rounding errors of the first three.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    pub(super) near: f64,
    pub(super) far: f64,
    pub(super) form: f64,
    pub(super) decay: f64,
    pub(super) near_error: f64,
    pub(super) far_error: f64,
    pub(super) form_error: f64,
}

impl Run {
    fn join(self, right: Self) -> Self {
        let (passed, returned) = (self.decay * right.near, right.decay * self.far);
        let cross = 2.0 * self.far * right.near;
        let (near, far) = (self.near + passed, right.far + returned);
        let form = self.form + right.form + cross;
        let ulp = f64::EPSILON;
        Self {
            near,
            far,
            form,
            decay: self.decay * right.decay,
            near_error: self.near_error
                + self.decay * right.near_error
                + ulp * (near.abs() + passed.abs()),
            far_error: right.far_error
                + right.decay * self.far_error
                + ulp * (far.abs() + returned.abs()),
            form_error: self.form_error
                + right.form_error
                + 2.0 * (self.far_error * right.near.abs() + self.far.abs() * right.near_error)
                + ulp * (form.abs() + cross.abs()),
        }
    }
}

impl Cells {
    /// The function u / `unit`, with its interval scaled to (0, 1).
    pub(super) fn new(u: &PiecewisePolynomial, unit: f64) -> Result<Self> {
        let (degree, total) = (u.degree(), u.mesh().total());
        let lengths: Vec<f64> = u.mesh().lengths().iter().map(|h| h / total).collect();
        let rule = Rule::gauss_legendre(degree + 1)?;
        let mut legendre_values = vec![0.0; degree + 1];
        let mut values = vec![0.0; lengths.len() * (degree + 1)];
        for (piece, out) in u.pieces().iter().zip(values.chunks_exact_mut(degree + 1)) {
            for (t, w) in rule.iter() {
                let value = w * (piece.value(t) / unit);
                legendre::fill(&mut legendre_values, 2.0 * t - 1.0);
                for (k, (sum, p)) in out.iter_mut().zip(&legendre_values).enumerate() {
                    *sum += (2 * k + 1) as f64 * value * p;
                }
            }
        }
        Self::of_coefficients(degree, lengths, values)
    }

    fn of_coefficients(degree: usize, lengths: Vec<f64>, values: Vec<f64>) -> Result<Self> {
        let correlations = correlations(degree, &values)?;
        Ok(Self { degree, lengths, values, correlations })
    }

    pub(super) fn degree(&self) -> usize {
        self.degree
    }

    pub(super) fn shortest(&self) -> f64 {
        self.lengths.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The mean ∫ f.
    pub(super) fn mean(&self) -> f64 {
        let mut sum = RunningSum::default();
        self.pieces().for_each(|(h, f)| sum.add(h * f[0]));
        sum.value()
    }

    /// The square ∫ f².
    pub(super) fn square(&self) -> f64 {
        let mut sum = RunningSum::default();
        for (h, f) in self.pieces() {
            sum.add(h * f.iter().enumerate().map(|(k, c)| c * c / (2 * k + 1) as f64).sum::<f64>());
        }
        sum.value()
    }

    /// The function f - c.
    pub(super) fn minus(&self, constant: f64) -> Result<Self> {
        let mut values = self.values.clone();
        values.iter_mut().step_by(self.degree + 1).for_each(|f| *f -= constant);
        Self::of_coefficients(self.degree, self.lengths.clone(), values)
    }

    /// The product θ f for θ constant on every element.
    pub(super) fn times(&self, share: impl Fn(usize) -> f64) -> Result<Self> {
        let mut values = self.values.clone();
        for (i, f) in values.chunks_exact_mut(self.degree + 1).enumerate() {
            f.iter_mut().for_each(|f| *f *= share(i));
        }
        Self::of_coefficients(self.degree, self.lengths.clone(), values)
    }

    /// The primitive F = ∫_0^x f.
    pub(super) fn primitive(&self) -> Result<Self> {
        let stride = self.degree + 2;
        let mut values = vec![0.0; self.lengths.len() * stride];
        let mut start = RunningSum::default();
        for ((h, f), out) in self.pieces().zip(values.chunks_exact_mut(stride)) {
            // ∫_0^t P_k = (P_{k+1} - P_{k-1}) / (4k + 2), and (P_1 + P_0)/2 for k = 0
            out[0] = start.value() + 0.5 * h * f[0];
            out[1] += 0.5 * h * f[0];
            for (k, c) in f.iter().enumerate().skip(1) {
                let share = h * c / (4 * k + 2) as f64;
                out[k + 1] += share;
                out[k - 1] -= share;
            }
            start.add(h * f[0]);
        }
        Self::of_coefficients(self.degree + 1, self.lengths.clone(), values)
    }

    fn pieces(&self) -> impl Iterator<Item = (f64, &[f64])> {
        self.lengths.iter().copied().zip(self.values.chunks_exact(self.degree + 1))
    }

    /// The integrals over the whole interval for e^{-τ|x-y|}.
    pub(super) fn run(&self, rate: f64) -> Run {
        let mut moments =
            Moments { z: f64::NAN, values: vec![0.0; 2 * self.degree + 2], decay: 0.0 };
        self.between(0, self.lengths.len(), rate, &mut moments)
    }

    fn between(&self, first: usize, end: usize, rate: f64, moments: &mut Moments) -> Run {
        if end - first <= RUN {
            let run = self.single(first, rate, moments);
            return (first + 1..end).fold(run, |run, i| run.join(self.single(i, rate, moments)));
        }
        let middle = first + (end - first) / 2;
        let left = self.between(first, middle, rate, moments);
        left.join(self.between(middle, end, rate, moments))
    }

    fn single(&self, i: usize, rate: f64, moments: &mut Moments) -> Run {
        let h = self.lengths[i];
        moments.at(rate * h);
        let (stride, ulp) = (self.degree + 1, 4.0 * f64::EPSILON);
        let (mut even, mut odd, mut size) = (0.0, 0.0, 0.0);
        for (k, (f, m)) in
            self.values[i * stride..][..stride].iter().zip(&moments.values).enumerate()
        {
            let term = f * m;
            if k % 2 == 0 {
                even += term
            } else {
                odd += term
            }
            size += term.abs();
        }
        let (mut form, mut form_size) = (0.0, 0.0);
        for (c, m) in self.correlations[i * 2 * stride..][..2 * stride].iter().zip(&moments.values)
        {
            form += c * m;
            form_size += (c * m).abs();
        }
        Run {
            near: h * (even + odd),
            far: h * (even - odd),
            // h² alone may underflow
            form: 2.0 * h * form * h,
            decay: moments.decay,
            near_error: ulp * h * size,
            far_error: ulp * h * size,
            form_error: 2.0 * ulp * h * form_size * h,
        }
    }
}

/// The coefficients c_n of every element.
fn correlations(degree: usize, values: &[f64]) -> Result<Vec<f64>> {
    let stride = degree + 1;
    let mut out = vec![0.0; 2 * values.len()];
    if degree == 0 {
        // f² (1 - r)
        for (f, c) in values.iter().zip(out.chunks_exact_mut(2)) {
            c[0] = 0.5 * f * f;
            c[1] = -0.5 * f * f;
        }
        return Ok(out);
    }
    let (outer, inner) = (Rule::gauss_legendre(2 * stride)?, Rule::gauss_legendre(stride)?);
    let mut legendre_values = vec![0.0; 2 * stride];
    for (f, c) in values.chunks_exact(stride).zip(out.chunks_exact_mut(2 * stride)) {
        let at = |t: f64| legendre::series(f.iter().copied(), 2.0 * t - 1.0);
        for (r, v) in outer.iter() {
            let rest = 1.0 - r;
            let value: f64 =
                inner.iter().map(|(t, w)| w * rest * at(rest * t) * at(rest * t + r)).sum();
            legendre::fill(&mut legendre_values, 2.0 * r - 1.0);
            for (n, (sum, p)) in c.iter_mut().zip(&legendre_values).enumerate() {
                *sum += (2 * n + 1) as f64 * v * value * p;
            }
        }
    }
    Ok(out)
}

/// The moments m_n(z) for the last z.
struct Moments {
    z: f64,
    values: Vec<f64>,
    decay: f64,
}

impl Moments {
    fn at(&mut self, z: f64) {
        if z != self.z {
            self.z = z;
            self.decay = (-z).exp();
            fill_moments(z, &mut self.values);
        }
    }
}

/// The values m_0(z), ... by the recurrence i_{n-1} - i_{n+1} = (2n+1)/x i_n, x = z/2: upwards if x exceeds n²,
/// otherwise downwards.
fn fill_moments(z: f64, values: &mut [f64]) {
    let (x, last) = (0.5 * z, values.len() - 1);
    values[0] = if z > 0.0 { -(-z).exp_m1() / z } else { 1.0 };
    let sign = |n: usize| if n.is_multiple_of(2) { 1.0 } else { -1.0 };
    if x > (last * last).max(4) as f64 {
        // e^{-x} cosh x / x - i_0 / x
        let mut previous = values[0];
        let mut current = (0.5 * (1.0 + (-z).exp()) - values[0]) / x;
        for n in 1..=last {
            values[n] = sign(n) * current;
            (previous, current) = (current, previous - (2 * n + 1) as f64 / x * current);
        }
        return;
    }
    // i_n / i_{n-1} settles like e^{-n²/x} from above
    let start = last + 15 + (6.5 * x.sqrt()) as usize;
    let mut ratio = 0.0;
    for n in (1..=start).rev() {
        ratio = if x > 0.0 { 1.0 / ((2 * n + 1) as f64 / x + ratio) } else { 0.0 };
        if n <= last {
            values[n] = ratio;
        }
    }
    let mut product = values[0];
    for n in 1..=last {
        product *= values[n];
        values[n] = sign(n) * product;
    }
}
