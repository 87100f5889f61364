//! Dual norms of functionals given by their values on the hat functions of a mesh: one linear system with the
//! positive definite matrix M + A.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::gram::{GramOperator, add_mass, gram_linears, mass_form, mass_linears};
use crate::mesh::Mesh;
use crate::numeric::check::require_values;
use crate::numeric::conjugate_gradients::{ConjugateGradients, Step, System};
use crate::numeric::dense::{Cholesky, product};
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use crate::root::accept;
use nalgebra::DMatrix;

/// Largest number of unknowns for a dense Cholesky factorization.
const DENSE: usize = 300;

/// A functional on the piecewise linear functions on a mesh, given by its values ⟨f, φ_i⟩ on the N + 1 hat
/// functions: a load vector, or a residual.
#[doc(alias("load vector", "residual", "dual norm"))]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MeshFunctional {
    partition: Mesh,
    values: Vec<f64>,
}

impl MeshFunctional {
    /// The functional with one value per node.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`] with the index.
    pub(crate) fn new(partition: Mesh, values: &[f64]) -> Result<Self> {
        require_values("values on hat functions", values, partition.len() + 1)?;
        Ok(Self { partition, values: values.to_vec() })
    }

    /// The dual norm sup ⟨f, v⟩/||v||_ν over the piecewise linear functions v on the mesh, with (1.1): a lower
    /// bound of the supremum over all v, the best one that follows from the values on the hat functions.
    ///
    /// It is computed by a dense factorization for up to 300 nodes, otherwise by conjugate gradients with the
    /// fast product: O(N log N) per step.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`], [`Error::ToleranceNotMet`] with the best value.
    pub(crate) fn dual_norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let size = self.values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        if size == 0.0 {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        let load: Vec<f64> = self.values.iter().map(|v| v / size).collect();
        let squared = if load.len() <= DENSE {
            solve_dense(&self.partition, order, &load)?
        } else {
            let root = |squared: Estimate| squared.sqrt()?.times(size);
            solve_iteratively(&self.partition, order, &load, tolerance)
                .map_err(|e| e.carry("dual norm", root))?
        };
        let why = "rounding of the matrix and of its factorization limits the accuracy";
        accept("dual norm", squared.sqrt()?.times(size)?, tolerance, why)
    }
}

/// Rounding error of an entry of the matrix, in units of the machine precision.
const ENTRY: f64 = 4.0;

/// bᵀ (M + A)⁻¹ b by Cholesky.
fn solve_dense(partition: &Mesh, order: Order, load: &[f64]) -> Result<Estimate> {
    let form = gram_linears(partition, order) + mass_form(partition);
    let n = load.len();
    // Scaled to a unit diagonal: short and long elements alike.
    let scale: Vec<f64> = (0..n).map(|i| form[(i, i)].sqrt().recip()).collect();
    let matrix = DMatrix::from_fn(n, n, |i, j| form[(i, j)] * scale[i] * scale[j]);
    let rhs = DMatrix::from_fn(n, 1, |i, _| load[i] * scale[i]);
    let factor = Cholesky::new(&matrix)
        .ok_or(Error::NotPositiveDefinite { what: "scaled mass plus Gram matrix", pivot: n })?;
    let mut x = factor.solve(&rhs);
    let residual = &rhs - product(&matrix, &x);
    x += factor.solve(&residual);
    let residual = &rhs - product(&matrix, &x);
    let value: f64 = (0..n).map(|i| rhs[(i, 0)] * x[(i, 0)]).sum();
    let absolute: f64 = (0..n).map(|i| (rhs[(i, 0)] * x[(i, 0)]).abs()).sum();
    let left: f64 = (0..n).map(|i| (residual[(i, 0)] * x[(i, 0)]).abs()).sum();
    // Entries are rounded, and for a function near a constant they cancel.
    let size = |i: usize, j: usize| (matrix[(i, j)] * x[(i, 0)] * x[(j, 0)]).abs();
    let entries: f64 = (0..n).map(|i| (0..n).map(|j| size(i, j)).sum::<f64>()).sum();
    let work = Work { factorizations: 1, ..Work::default() };
    Estimate::new(value, f64::EPSILON * (16.0 * absolute + ENTRY * entries) + left, work)
}

/// The matrix M + A with the fast operator A and the diagonal as preconditioner.
struct WithMass {
    operator: GramOperator,
    mass: (Vec<f64>, Vec<f64>),
    inverse: Vec<f64>,
}

impl System for WithMass {
    type Error = Error;

    fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        out.copy_from_slice(&self.operator.apply(x)?);
        add_mass(1.0, &self.mass, x, out);
        Ok(())
    }

    fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<()> {
        out.iter_mut().zip(r).zip(&self.inverse).for_each(|((z, r), d)| *z = r * d);
        Ok(())
    }
}

/// Number of last steps whose total gain estimates the remaining error; the convergence is linear or faster.
const SETTLED: usize = 20;

/// bᵀ (M + A)⁻¹ b by conjugate gradients on the fast product, with the diagonal as preconditioner.
///
/// bᵀx increases monotonically by the contributions of the steps; the iteration ends when the last 20 of them
/// add less than the tolerance.
fn solve_iteratively(
    partition: &Mesh,
    order: Order,
    load: &[f64],
    tolerance: Tolerance,
) -> Result<Estimate> {
    let n = load.len();
    let operator = GramOperator::linears(partition, order, Tolerance::reference())?;
    let mass = mass_linears(partition);
    let inverse = operator.diagonal().iter().zip(&mass.0).map(|(a, m)| 1.0 / (a + m)).collect();
    let mut system = WithMass { operator, mass, inverse };
    let mut iteration = ConjugateGradients::new(n);
    iteration.start(&mut system, load)?;
    let mut x = vec![0.0; n];
    let mut value = RunningSum::default();
    let mut gains: Vec<f64> = Vec::new();
    for steps in 1..=20 * n.min(2000) {
        let not_settled = gains.len() < SETTLED - 1 && iteration.rho() > 0.0;
        let Step::Gain(gain) = iteration.step(&mut system, &mut x)? else {
            return Err(Error::Solver {
                reason: format!(
                    "negative curvature of mass plus Gram matrix in step {steps} of conjugate gradients"
                ),
            });
        };
        gains.push(gain);
        value.add(gain);
        let rest =
            if not_settled { f64::INFINITY } else { gains.iter().rev().take(SETTLED).sum::<f64>() };
        if rest <= 0.5 * tolerance.relative() * value.value() || iteration.rho() <= 1e-30 * gains[0]
        {
            let rounding = 1e-13 * value.value();
            let work = Work { iterations: steps as u64, ..Work::default() };
            return Estimate::new(value.value(), rest.min(value.value()) + rounding, work);
        }
    }
    let rest = gains.iter().rev().take(SETTLED).sum::<f64>();
    let work = Work { iterations: gains.len() as u64, ..Work::default() };
    let best = Estimate::new(value.value(), rest, work)?;
    let why = "conjugate gradients did not converge within the maximum number of steps";
    Err(Error::not_met("square of the dual norm", tolerance.relative(), best, why))
}
