//! (4.6) and (4.7): the L² projection π^h onto piecewise constants, best constants and norms on a mesh.
//!
//! (4.6)  ‖φ − π^h φ‖₀ ≤ C(r) h^r |φ|_r,  best on one element C(r) = γ₁(r) for 0 < r < 1, 1 for r = 0, 1/π for r = 1
//!        (|φ|₀ = ‖φ‖₀, |φ|₁ = ‖φ'‖₀).
//! (4.7)  ‖φ − π^h φ‖_{1/2,*} ≤ C*(r) h^{r+1/2} |φ|_r,  with C*(r) = sup ∫ (φ − φ̄) ψ / (|φ|_r |ψ|_{1/2}) on (0, 1):
//!        elements add up because Σ |·|²_{r,I} ≤ |·|²_{r,Γ}. The paper's chain gives γ₁(r) γ₁(1/2), equal at r = 1/2.
//! Norms on a mesh: sup over all φ ∈ H^r(Γ), Γ = (0, 1), of the quotient without powers of h, on N equal elements: measured at
//! N and 2N they give the rate r or r + 1/2 from above (the estimate) and from below (no better one is possible).
//! Cost: Legendre's basis on one element as in Lemma 6.1; dense eigenproblems of the cells on a mesh.

use super::dual::DualNorm;
use super::element::{ErrorNorm, element_constant};
use super::elements::ElementMesh;
use super::forms::{dual_projection_form, projection_form, seminorm_form};
use super::global::extremal_on_mesh;
use super::legendre::{converge, odd_degrees, seminorm_gram, stiffness_gram};
use super::local::{require_unit, sample_norms};
use super::samples::{PanelRules, SampleSlope};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::pencil::Factored;
use crate::sobolev::{FractionalOrder, Partition};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use std::f64::consts::FRAC_1_PI;

/// The norm in which φ − π^h φ is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProjectionNorm {
    /// ‖·‖₀, (4.6).
    L2,
    /// ‖·‖_{1/2,*}, (4.7).
    Dual,
}

impl ProjectionNorm {
    /// The exponent of h in (4.6) or (4.7).
    pub fn rate(self, r: f64) -> f64 {
        match self {
            ProjectionNorm::L2 => r,
            ProjectionNorm::Dual => r + 0.5,
        }
    }
}

/// Best C(r) of (4.6) on one element, 0 ≤ r ≤ 1.
///
/// ```
/// use signorini::{Tolerance, interpolation::projection_constant};
/// let best = projection_constant(1.0, Tolerance::balanced())?;
/// assert!((best.value - std::f64::consts::FRAC_1_PI).abs() < 1e-15);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for r outside [0, 1]; [`Error::ToleranceNotMet`].
pub fn projection_constant(r: f64, tolerance: Tolerance) -> Result<Estimate> {
    Error::require("r", r, "[0, 1]", (0.0..=1.0).contains(&r))?;
    if r == 0.0 {
        return Estimate::new(1.0, 0.0, Work::default());
    }
    if r == 1.0 {
        return Estimate::new(FRAC_1_PI, 0.0, Work::default());
    }
    element_constant(ErrorNorm::Derivative, FractionalOrder::new(r)?, tolerance)
}

/// Best C*(r) with which (4.7) follows element by element, 0 ≤ r ≤ 1; its square is the largest eigenvalue of
/// A_{1/2}⁻¹ x = λ A_r x in L²-orthonormal coordinates.
///
/// # Errors
/// As [`projection_constant`].
pub fn dual_projection_constant(r: f64, tolerance: Tolerance) -> Result<Estimate> {
    Error::require("r", r, "[0, 1]", (0.0..=1.0).contains(&r))?;
    converge("projection constant in the dual norm", tolerance, |count| {
        let degrees = odd_degrees(count);
        let (half, mut work) = seminorm_gram(FractionalOrder::HALF, &degrees)?;
        let broken = |_| Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot: count };
        let inverse = half.llt(Side::Lower).map_err(broken)?.solve(Mat::<f64>::identity(count, count));
        let form = if r == 0.0 {
            Mat::identity(count, count)
        } else if r == 1.0 {
            stiffness_gram(&degrees)
        } else {
            let (gram, cost) = seminorm_gram(FractionalOrder::new(r)?, &degrees)?;
            work += cost;
            gram
        };
        let (top, _) = Factored::new(&form)?.largest_eigenvalue(&inverse)?;
        work.factorizations += 3;
        Ok((top.sqrt(), work))
    })
}

/// sup ‖φ − π^h φ‖ / |φ|_r over φ ∈ H^r(0, 1) on N equal elements, from piecewise linears on `cells` cells per element.
///
/// A lower bound; its error is estimated from half as many cells (three times what second order would leave).
///
/// # Errors
/// [`Error::OutOfRange`] for r outside [0, 1]; [`Error::CountOutOfRange`] without elements or for fewer than 4 or an odd
/// number of cells per element, or for more than 4096 cells in all (the matrices are dense).
pub fn projection_norm_on_mesh(
    norm: ProjectionNorm,
    r: f64,
    elements: usize,
    cells: usize,
) -> Result<Estimate> {
    extremal_on_mesh(elements, cells, |mesh| {
        let form = match norm {
            ProjectionNorm::L2 => projection_form(mesh),
            ProjectionNorm::Dual => dual_projection_form(mesh)?,
        };
        Ok((seminorm_form(mesh.cells(), r)?, form))
    })
}

/// ‖φ − π^h φ‖₀ on a mesh of (0, 1) for φ in closed form; cost O(N).
///
/// # Errors
/// [`Error::OutOfRange`] unless the mesh is one of (0, 1), or for parameters of φ out of range.
pub fn sample_projection_error(phi: SampleSlope, mesh: &Partition) -> Result<Estimate> {
    sample_norms(phi, mesh).map(|(_, projection)| projection)
}

/// ‖φ − π^h φ‖_{1/2,*} for φ in closed form, on elements of `cells_per_element` cells of the dual norm's interval (0, 1).
///
/// # Errors
/// [`Error::LengthMismatch`] unless the cells divide into such elements; [`Error::OutOfRange`] for another interval.
pub fn sample_projection_dual_error(
    phi: SampleSlope,
    norm: &DualNorm,
    cells_per_element: usize,
) -> Result<Estimate> {
    phi.check()?;
    require_unit(norm.cells())?;
    let (lengths, starts) = (norm.cells().lengths(), norm.cells().from_left());
    let elements = lengths.len() / cells_per_element.max(1);
    let mesh = ElementMesh::new(norm.cells().clone(), &vec![cells_per_element; elements])?;
    let rules = PanelRules::new()?;
    let mut load = vec![0.0; lengths.len() + 1];
    for (e, range) in mesh.elements().iter().enumerate() {
        let moments: Vec<[f64; 2]> =
            range.clone().map(|i| phi.cell_moments(starts[i], lengths[i], &rules)).collect();
        let integral: f64 = range.clone().zip(&moments).map(|(i, m)| lengths[i] * (m[0] + m[1])).sum();
        let mean = integral / mesh.length(e);
        for (i, [falling, rising]) in range.clone().zip(moments) {
            load[i] += lengths[i] * (falling - 0.5 * mean);
            load[i + 1] += lengths[i] * (rising - 0.5 * mean);
        }
    }
    norm.of_load(&load)
}
