//! Quadratic forms of continuous piecewise linear functions on the cells of an [`ElementMesh`]; v is
//! represented by its values at the cell nodes.
//!
//! | form | matrix |
//! | --- | --- |
//! | ‖v − π^h v‖₀² = ‖(u − I^h u)'‖₀² | E = M − Σ_e m_e m_eᵀ / h_e |
//! | ‖u − I^h u‖₀² | from the primitive of v − π^h v at Gauss points, exact |
//! | \|v\|_r², 0 ≤ r ≤ 1, made positive on the constants | A_r + m mᵀ |
//! | ‖v − π^h v‖²_{1/2,*} | E (A_{1/2} + L M)⁻¹ E on the mesh of length L scaled to (0, 1) |
//!
//! m_e are the integrals of the hat functions over element e, m those over the interval. The dual norm is a
//! supremum over the piecewise linear functions. The matrices are dense, for at most 4096 cells. The forms
//! with π^h vanish on constants, so that m mᵀ does not change the extremal quotients.

use super::elements::ElementMesh;
use crate::constant::UnitOrder;
use crate::error::{Error, Result};
use crate::gram::{gram_linears, mass_form, tridiagonal};
use crate::numeric::dense::{Cholesky, transpose_times};
use crate::quadrature::Rule;
use crate::{Mesh, Order};
use nalgebra::DMatrix;

/// Largest number of cells for which dense matrices are built.
pub(super) const MAX_CELLS: usize = 4096;

/// The integrals of the hat functions over the cells of a range, for all nodes.
pub(super) fn hat_integrals(cells: &Mesh, range: std::ops::Range<usize>) -> Vec<f64> {
    let mut integrals = vec![0.0; cells.len() + 1];
    for i in range {
        integrals[i] += 0.5 * cells.lengths()[i];
        integrals[i + 1] += 0.5 * cells.lengths()[i];
    }
    integrals
}

/// |v|_r²: ‖v‖₀² for r = 0, ‖v'‖₀² for r = 1, and the double integral of (1.1) for 0 < r < 1.
pub(super) fn seminorm_form(cells: &Mesh, r: UnitOrder) -> DMatrix<f64> {
    match r {
        UnitOrder::Zero => return mass_form(cells),
        UnitOrder::Inner(order) => return gram_linears(cells, order),
        UnitOrder::One => {}
    }
    let mut diagonal = vec![0.0; cells.len() + 1];
    for (i, h) in cells.lengths().iter().enumerate() {
        diagonal[i] += 1.0 / h;
        diagonal[i + 1] += 1.0 / h;
    }
    tridiagonal(&diagonal, &cells.lengths().iter().map(|h| -1.0 / h).collect::<Vec<_>>())
}

/// The form plus m mᵀ, which is positive definite.
pub(super) fn without_constants(form: &DMatrix<f64>, cells: &Mesh) -> DMatrix<f64> {
    let m = hat_integrals(cells, 0..cells.len());
    DMatrix::from_fn(m.len(), m.len(), |i, j| form[(i, j)] + m[i] * m[j])
}

/// The form ‖v − π^h v‖₀².
pub(super) fn projection_form(mesh: &ElementMesh) -> DMatrix<f64> {
    let mut form = mass_form(mesh.cells());
    for (e, range) in mesh.elements().iter().enumerate() {
        let m = hat_integrals(mesh.cells(), range.clone());
        let h = mesh.length(e);
        for i in range.start..=range.end {
            for j in range.start..=range.end {
                form[(i, j)] -= m[i] * m[j] / h;
            }
        }
    }
    form
}

/// The form ‖u − I^h u‖₀² for the slope v of u.
pub(super) fn lagrange_form(mesh: &ElementMesh) -> Result<DMatrix<f64>> {
    // The primitive is quadratic on a cell, its square of degree four.
    let rule = Rule::gauss_legendre(3)?;
    let lengths = mesh.cells().lengths();
    let mut form = DMatrix::<f64>::zeros(lengths.len() + 1, lengths.len() + 1);
    for (e, range) in mesh.elements().iter().enumerate() {
        let m = hat_integrals(mesh.cells(), range.clone());
        let nodes = range.start..=range.end;
        let total = mesh.length(e);
        for i in range.clone() {
            let h = lengths[i];
            let from_left = mesh.cells().distance(range.start, i);
            for (t, w) in rule.iter() {
                let fraction = (from_left + h * t) / total;
                let row: Vec<f64> = nodes
                    .clone()
                    .map(|k| {
                        let before = if k > range.start { 0.5 * lengths[k - 1] } else { 0.0 };
                        let primitive = match k {
                            _ if k < i => m[k],
                            _ if k == i => before + h * t * (1.0 - 0.5 * t),
                            _ if k == i + 1 => 0.5 * h * t * t,
                            _ => 0.0,
                        };
                        primitive - fraction * m[k]
                    })
                    .collect();
                for (a, x) in nodes.clone().zip(&row) {
                    for (b, y) in nodes.clone().zip(&row) {
                        form[(a, b)] += h * w * x * y;
                    }
                }
            }
        }
    }
    Ok(form)
}

/// The form ‖v − π^h v‖²_{1/2,*} over the piecewise linear functions, dual to |ψ|²_{1/2} + `length` ‖ψ‖².
pub(super) fn dual_projection_form(mesh: &ElementMesh, length: f64) -> Result<DMatrix<f64>> {
    let cells = mesh.cells();
    let size = cells.len() + 1;
    let norm = gram_linears(cells, Order::HALF) + mass_form(cells) * length;
    let broken =
        || Error::NotPositiveDefinite { what: "Gram matrix of the H^{1/2} norm", pivot: size };
    let factor = Cholesky::new(&norm).ok_or_else(broken)?;
    let load = projection_form(mesh);
    let dual = transpose_times(&load, &factor.solve(&load));
    Ok(DMatrix::from_fn(size, size, |i, j| 0.5 * (dual[(i, j)] + dual[(j, i)])))
}
