//! Dual norms: sup ⟨f, v⟩ / ||v|| over v, for three norms of order ν.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::check::require_values;
use crate::numeric::conjugate_gradients::{ConjugateGradients, Step, System};
use crate::numeric::sum::RunningSum;
use crate::quadrature::Rule;
use crate::sobolev::gram::GramOperator;
use crate::sobolev::gram::dense::{gram_linears, mass_linears};
use crate::sobolev::order::FractionalOrder;
use crate::sobolev::partition::Partition;
use crate::sobolev::piecewise::PiecewisePolynomial;
use crate::sobolev::root::accept;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// The norm whose dual is meant.
///
/// | [`DualOf`] | ‖v‖² | space |
/// | --- | --- | --- |
/// | `Slobodeckij` | ∥v∥²_0 + \|v\|²_ν, (1.1) of the paper | H^ν(I) |
/// | `Interpolation` | Σ_k (1+λ_k)^ν v_k², v_k cosine coefficients | H^ν(I) |
/// | `InterpolationZero` | the same with sines | H^ν, H^{1/2}_{00}, H^ν_0 for ν below, at, above 1/2 |
///
/// λ_k = (kπ/L)². The first at ν = 1/2 is the norm ∥·∥\_{1/2,*} of (4.7) and Remark 2; the others are \[L²,
/// H¹\]_ν and \[L², H¹_0\]_ν by eigenpairs.
///
/// The first two are equivalent norms of one space, with different constants; the third is larger than the
/// second and belongs to a smaller space at ν ≥ 1/2, so that its dual norm is smaller than the second's. A
/// functional on a mesh (its values on hats) is measured by one SPD solve with M + A: the supremum over the
/// piecewise linears of that mesh, a lower bound. For a function the mesh is halved until the limit is known.
#[doc(alias("H-1/2", "dual norm"))]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DualOf {
    /// ∥v∥²_0 + |v|²_ν.
    Slobodeckij,
    /// Interpolation between L² and H¹, by cosines.
    Interpolation,
    /// Interpolation between L² and H¹_0, by sines.
    InterpolationZero,
}

/// Dense Cholesky up to this many unknowns.
const DENSE: usize = 300;
/// Halvings of the mesh, and the largest number of elements, of a dual norm of a function.
const MAX_HALVINGS: usize = 12;
const MAX_ELEMENTS: usize = 40_000;
/// sup ⟨f, v⟩/||v||_ν (Slobodeckij) over the piecewise linears of a mesh, from the values ⟨f, φ_i⟩ on its N +
/// 1 hats.
///
/// ```
/// use signorini::Tolerance;
/// use signorini::sobolev::{FractionalOrder, Partition, dual_norm_of_functional};
/// // v ↦ ∫ v on (0, 1), by its values on the hats: the supremum is attained by the constant
/// let mesh = Partition::uniform(4, 1.0)?;
/// let load = [0.125, 0.25, 0.25, 0.25, 0.125];
/// let found = dual_norm_of_functional(&mesh, FractionalOrder::HALF, &load, Tolerance::balanced())?;
/// assert!((found.value - 1.0).abs() < 1e-8);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`Error::LengthMismatch`], [`Error::NotFinite`], [`Error::NotPositiveDefinite`],
/// [`Error::ToleranceNotMet`].
#[doc(alias("H-1/2", "negative norm", "dual norm"))]
pub fn dual_norm_of_functional(
    partition: &Partition,
    order: FractionalOrder,
    functional: &[f64],
    tolerance: Tolerance,
) -> Result<Estimate> {
    require_values("functional on hats", functional, partition.len() + 1)?;
    let size = functional.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    if size == 0.0 {
        return Estimate::new(0.0, 0.0, Work::default());
    }
    let load: Vec<f64> = functional.iter().map(|v| v / size).collect();
    let squared = if load.len() <= DENSE {
        solve_dense(partition, order, &load)?
    } else {
        let root = |squared: Estimate| squared.sqrt()?.times(size);
        solve_iteratively(partition, order, &load, tolerance).map_err(|e| e.carry("dual norm", root))?
    };
    let why = "rounding of the form and of its factorization";
    accept("dual norm", squared.sqrt()?.times(size)?, tolerance, why)
}

impl PiecewisePolynomial {
    /// The dual norm of the function as a functional v ↦ ∫ u v.
    ///
    /// ```
    /// use signorini::{Tolerance, sobolev::{DualOf, FractionalOrder, Partition, PiecewisePolynomial}};
    /// let one = PiecewisePolynomial::constants(Partition::uniform(4, 1.0)?, &[1.0; 4])?;
    /// let found = one.dual_norm(DualOf::Slobodeckij, FractionalOrder::HALF, Tolerance::balanced())?;
    /// assert!((found.value - 1.0).abs() < 1e-8); // attained by the constant itself
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] when meshes of 40 000 elements or 32 768 coefficients do not suffice.
    #[doc(alias("H-1/2", "negative norm"))]
    pub fn dual_norm(&self, of: DualOf, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        match of {
            DualOf::Slobodeckij => self.dual_by_halving(order, tolerance),
            DualOf::Interpolation => self.dual_by_modes(false, order, tolerance),
            DualOf::InterpolationZero => self.dual_by_modes(true, order, tolerance),
        }
    }

    fn dual_by_halving(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        let inner = Tolerance::new((0.01 * tolerance.relative()).max(1e-13))?;
        let mut values: Vec<Estimate> = Vec::new();
        let mut best: Option<Estimate> = None;
        for halvings in 0..=MAX_HALVINGS {
            if self.partition().len() << halvings > MAX_ELEMENTS {
                break;
            }
            let (partition, load) = self.load_on_halved(halvings)?;
            match dual_norm_of_functional(&partition, order, &load, inner) {
                Ok(value) => values.push(value),
                // The tolerance that counts is the caller's; finer meshes round more.
                Err(Error::ToleranceNotMet { .. }) => break,
                Err(other) => return Err(other),
            }
            if let [.., a, b, c] = values[..] {
                let estimate = limit_of_halvings(a, b, c)?;
                if estimate.value == 0.0 || estimate.relative_error() <= tolerance.relative() {
                    return Ok(estimate);
                }
                if best.is_none_or(|best| estimate.error < best.error) {
                    best = Some(estimate);
                }
            }
        }
        let why = "meshes of 40 000 elements do not suffice for its jumps";
        Err(Error::best_of("dual norm", tolerance.relative(), best, why))
    }

    /// ∫ u φ_i on the mesh with every element cut into 2^k.
    fn load_on_halved(&self, halvings: usize) -> Result<(Partition, Vec<f64>)> {
        let parts = 1 << halvings;
        let rule = Rule::gauss_legendre(self.degree() / 2 + 2)?;
        let mut lengths = Vec::with_capacity(parts * self.partition().len());
        let mut load = vec![0.0; parts * self.partition().len() + 1];
        for (piece, &h) in self.pieces().iter().zip(self.partition().lengths()) {
            for part in 0..parts {
                let (e, small) = (lengths.len(), h / parts as f64);
                lengths.push(small);
                for (t, w) in rule.iter() {
                    let value = w * small * piece.value((part as f64 + t) / parts as f64);
                    load[e] += (1.0 - t) * value;
                    load[e + 1] += t * value;
                }
            }
        }
        Ok((Partition::from_lengths(lengths)?, load))
    }
}

/// Aitken's limit of values on halved meshes, whose errors shrink by a constant factor.
fn limit_of_halvings(a: Estimate, b: Estimate, c: Estimate) -> Result<Estimate> {
    let (first, second) = (b.value - a.value, c.value - b.value);
    let ratio = if first == 0.0 { 0.0 } else { (second / first).abs() };
    let work = a.work + b.work + c.work;
    if ratio < 0.9 {
        let correction = second * ratio / (1.0 - ratio);
        Estimate::new(c.value + correction, correction.abs() + 2.0 * c.error, work)
    } else {
        Estimate::new(c.value, 10.0 * second.abs() + 2.0 * c.error, work)
    }
}

/// bᵀ (M + A)⁻¹ b by Cholesky.
fn solve_dense(partition: &Partition, order: FractionalOrder, load: &[f64]) -> Result<Estimate> {
    let gram = gram_linears(partition, order);
    let (diagonal, off) = mass_linears(partition);
    let n = load.len();
    let entry = |i: usize, j: usize| {
        gram[(i, j)]
            + match i.abs_diff(j) {
                0 => diagonal[i],
                1 => off[i.min(j)],
                _ => 0.0,
            }
    };
    // Scaled to a unit diagonal: short and long elements alike.
    let scale: Vec<f64> = (0..n).map(|i| entry(i, i).sqrt().recip()).collect();
    let matrix = Mat::from_fn(n, n, |i, j| entry(i, j) * scale[i] * scale[j]);
    let rhs = Mat::from_fn(n, 1, |i, _| load[i] * scale[i]);
    let factor = matrix
        .llt(Side::Lower)
        .map_err(|_| Error::NotPositiveDefinite { what: "M + A, scaled", pivot: n })?;
    let mut x = factor.solve(&rhs);
    let residual = &rhs - &matrix * &x;
    x += factor.solve(&residual);
    let residual = &rhs - &matrix * &x;
    let value: f64 = (0..n).map(|i| rhs[(i, 0)] * x[(i, 0)]).sum();
    let absolute: f64 = (0..n).map(|i| (rhs[(i, 0)] * x[(i, 0)]).abs()).sum();
    let left: f64 = (0..n).map(|i| (residual[(i, 0)] * x[(i, 0)]).abs()).sum();
    let work = Work { factorizations: 1, ..Work::default() };
    Estimate::new(value, 16.0 * f64::EPSILON * absolute + left, work)
}

/// M + A, A a fast operator, with the diagonal as preconditioner.
struct WithMass {
    operator: GramOperator,
    mass: Vec<f64>,
    off: Vec<f64>,
    inverse: Vec<f64>,
}

impl System for WithMass {
    fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        out.copy_from_slice(&self.operator.apply(x)?);
        let n = x.len();
        for i in 0..n {
            out[i] += self.mass[i] * x[i];
            if i + 1 < n {
                out[i] += self.off[i] * x[i + 1];
                out[i + 1] += self.off[i] * x[i];
            }
        }
        Ok(())
    }

    fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<()> {
        out.iter_mut().zip(r).zip(&self.inverse).for_each(|((z, r), d)| *z = r * d);
        Ok(())
    }
}

/// Steps whose gains together stand for what is still to come: convergence is linear or faster.
const SETTLED: usize = 20;

/// bᵀ (M + A)⁻¹ b by conjugate gradients on the fast product, with the diagonal as preconditioner.
///
/// bᵀx grows monotonically by the steps' contributions; it has settled when the last 20 of them add less than
/// the tolerance.
fn solve_iteratively(
    partition: &Partition,
    order: FractionalOrder,
    load: &[f64],
    tolerance: Tolerance,
) -> Result<Estimate> {
    let n = load.len();
    let operator = GramOperator::linears(partition, order, Tolerance::reference())?;
    let (mass, off) = mass_linears(partition);
    let inverse = operator.diagonal().iter().zip(&mass).map(|(a, m)| 1.0 / (a + m)).collect();
    let mut system = WithMass { operator, mass, off, inverse };
    let mut iteration = ConjugateGradients::new(n);
    iteration.start(&mut system, load)?;
    let mut x = vec![0.0; n];
    let mut value = RunningSum::default();
    let mut gains: Vec<f64> = Vec::new();
    for steps in 1..=20 * n.min(2000) {
        let not_settled = gains.len() < SETTLED - 1 && iteration.rho() > 0.0;
        let Step::Gain(gain) = iteration.step(&mut system, &mut x)? else {
            return Err(Error::NotPositiveDefinite { what: "M + A", pivot: steps });
        };
        gains.push(gain);
        value.add(gain);
        let rest = if not_settled { f64::INFINITY } else { gains.iter().rev().take(SETTLED).sum::<f64>() };
        if rest <= 0.5 * tolerance.relative() * value.value() || iteration.rho() <= 1e-30 * gains[0] {
            let rounding = 1e-13 * value.value();
            let work = Work { iterations: steps as u64, ..Work::default() };
            return Estimate::new(value.value(), rest.min(value.value()) + rounding, work);
        }
    }
    let rest = gains.iter().rev().take(SETTLED).sum::<f64>();
    let work = Work { iterations: gains.len() as u64, ..Work::default() };
    let best = Estimate::new(value.value(), rest, work)?;
    let why = "conjugate gradients took their last step";
    Err(Error::not_met("square of the dual norm", tolerance.relative(), best, why))
}
