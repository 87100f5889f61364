//! Matrices of continuous piecewise linear functions Σ vᵢ φᵢ, the eigenvalue problems that define
//! best constants, and a constrained minimisation.

use crate::{Error, Result};
use fractional_sobolev::Mesh;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use std::ops::Range;

/// The mass matrix ∫ φᵢ φⱼ of the hat functions of a mesh: h/6 (2 1; 1 2) on an element of length
/// h.
pub fn mass_matrix(mesh: &Mesh) -> DMatrix<f64> {
    let mut mass = DMatrix::<f64>::zeros(mesh.len() + 1, mesh.len() + 1);
    for (k, h) in mesh.lengths().iter().enumerate() {
        let mut block = mass.view_mut((k, k), (2, 2));
        block += DMatrix::from_row_slice(2, 2, &[h / 3.0, h / 6.0, h / 6.0, h / 3.0]);
    }
    mass
}

/// A matrix whose columns span the v with ∫ v = 0 over `zone`, the union of the elements with
/// midpoints in it: φᵢ − (mᵢ/mₚ) φₚ for i ≠ p, mᵢ the integrals of the hat functions over the zone
/// and mₚ the largest of them.
pub fn mean_zero_basis(mesh: &Mesh, zone: Range<f64>) -> DMatrix<f64> {
    let (x, h, n) = (mesh.nodes(), mesh.lengths(), mesh.len());
    let mut integrals = DVector::<f64>::zeros(n + 1);
    for k in (0..n).filter(|&k| zone.contains(&(0.5 * (x[k] + x[k + 1])))) {
        integrals[k] += 0.5 * h[k];
        integrals[k + 1] += 0.5 * h[k];
    }
    let pivot = integrals.imax();
    let mut basis = DMatrix::<f64>::identity(n + 1, n + 1);
    basis.set_row(pivot, &(-integrals.transpose() / integrals[pivot]));
    basis.remove_column(pivot)
}

/// The matrix of v ↦ |V|₁², V the discrete harmonic function of the five-point stencil on n × n
/// squares of the unit square with edge values v, V = 0 on the opposite side and natural lateral
/// conditions. The mode cos kπx has the energy S_k Σ_i cos² kπi/n, end nodes with weight 1/2, S_k =
/// sinh η coth nη, cosh η = 2 − cos(kπ/n), S_0 = 1/n.
pub fn harmonic_energy(n: usize) -> DMatrix<f64> {
    let half = |i: usize| if i == 0 || i == n { 0.5 } else { 1.0 };
    let angle = |k: usize| k as f64 * PI / n as f64;
    let waves = DMatrix::from_fn(n + 1, n + 1, |k, i| half(i) * (angle(k) * i as f64).cos());
    let symbol = DVector::from_fn(n + 1, |k, _| match (2.0 - angle(k).cos()).acosh() {
        0.0 => 1.0 / (n * n) as f64,
        eta => 2.0 * half(k) / n as f64 * eta.sinh() / (n as f64 * eta).tanh(),
    });
    waves.tr_mul(&(DMatrix::from_diagonal(&symbol) * &waves))
}

/// The minimiser of ½ v·A v − b·v among the v with B v ≤ 0: v = A⁻¹ (b − Bᵀ q), the multipliers q ≥
/// 0 by 20 000 projected Gauss-Seidel sweeps.
///
/// # Errors
/// [`Error::Option`] if A is singular.
pub fn constrained_minimiser(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    below: &DMatrix<f64>,
) -> Result<DVector<f64>> {
    let inverse = a
        .clone()
        .try_inverse()
        .ok_or_else(|| Error::Option("the linear system is singular".to_owned()))?;
    let (d, free) = (below * &inverse * below.transpose(), below * &inverse * b);
    let mut q = DVector::<f64>::zeros(free.len());
    for s in (0..free.len()).cycle().take(20_000 * free.len()) {
        q[s] = (q[s] + (free[s] - d.column(s).dot(&q)) / d[(s, s)]).max(0.0);
    }
    Ok(inverse * (b - below.tr_mul(&q)))
}

/// The largest λ with M u = λ A u for a vector u ≠ 0, M symmetric and A symmetric positive
/// definite: that of L⁻¹ M L⁻ᵀ, A = L Lᵀ. It is the best constant in uᵀMu ≤ λ uᵀAu. Relative
/// rounding error ε κ(A), κ the condition number. Cost: O(n³).
///
/// # Errors
/// [`Error::Option`] if A is not positive definite up to rounding.
pub fn largest_eigenvalue(m: &DMatrix<f64>, a: &DMatrix<f64>) -> Result<f64> {
    let failed = || Error::Option("the form is not positive definite on this mesh".to_owned());
    let root = a.clone().cholesky().ok_or_else(failed)?.l();
    let half: DMatrix<f64> = root.solve_lower_triangular(m).ok_or_else(failed)?;
    let whole: DMatrix<f64> = root.solve_lower_triangular(&half.transpose()).ok_or_else(failed)?;
    Ok(whole.symmetric_eigenvalues().max())
}
