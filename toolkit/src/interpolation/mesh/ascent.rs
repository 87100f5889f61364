//! An optimiser: from any slope to better ones, in the continuous piecewise linears on the cells of a mesh.

use crate::error::{Error, Given, Result};
use crate::interpolation::element::ErrorNorm;
use crate::interpolation::elements::ElementMesh;
use crate::interpolation::forms::{lagrange_form, projection_form, without_constants};
use crate::numeric::dense::{Cholesky, product};
use crate::{Function, Order, gram_linears};
use nalgebra::DMatrix;

/// Steps at most. On one element the second eigenvalue is at most about 0.4 of the first and two dozen steps
/// do; on a mesh of N elements the largest ones lie within O(N^{-2}) of each other.
const STEPS: usize = 2000;

/// Relative rise of the quotient in a step below which it has arrived.
const RISE: f64 = 1e-9;

/// The slope, linear on each cell, that is reached from the given values at the cell nodes once the quotient
/// rises no more.
///
/// # Method
///
/// A step replaces v by A⁻¹ B v, A the Gram matrix of |·|_ν (constants taken out) and B that of the squared
/// error norm: power iteration on the extremal quotient of Lemma 6.1 (one element) or 6.2 (a mesh), which
/// rises with every step. A second road to the best constants, from below. Cost O(N³) once, O(N²) per step.
///
/// ```
/// use fractional_sobolev::{Order, Mesh, Tolerance, interpolation::{ElementMesh, ErrorNorm, ascend}};
/// let (order, mesh) = (Order::HALF, ElementMesh::single(Mesh::uniform(16, 1.0)?)?);
/// let best = ascend(ErrorNorm::Derivative, order, &mesh, &mesh.cells().nodes())?;
/// let (norm, mean) = (best.norm(0.0, Tolerance::fast())?.value, best.mean(Tolerance::fast())?.value);
/// let found = (norm * norm - mean * mean).sqrt() / best.seminorm(order, Tolerance::fast())?.value;
/// assert!(found > 0.28 && found < 0.291_564_03); // the best constant from below
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::LengthMismatch`] unless there is a value per node; [`Error::NotFinite`] for bad values;
/// [`Error::NotPositiveDefinite`] when the Gram matrix breaks down to rounding (cells far too short).
pub fn ascend(
    norm: ErrorNorm,
    order: impl Given<Order>,
    mesh: &ElementMesh,
    start: &[f64],
) -> Result<Function<'static>> {
    let order = order.given()?;
    let cells = mesh.cells();
    let size = cells.len() + 1;
    // Checks the count and the values.
    let first = Function::linears(cells, start)?;
    if start.iter().all(|v| *v == start[0]) {
        return Ok(first);
    }
    let broken = || Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot: size };
    let gram = without_constants(&gram_linears(cells, order), cells);
    let factor = Cholesky::new(&gram).ok_or_else(broken)?;
    let form = error_form(norm, mesh)?;
    let mut values = DMatrix::from_fn(size, 1, |i, _| start[i]);
    let mut quotient = 0.0;
    for _ in 0..STEPS {
        let image = product(&form, &values);
        let next = values.dot(&image) / values.dot(&product(&gram, &values));
        if next <= quotient * (1.0 + RISE) {
            break;
        }
        quotient = next;
        values = factor.solve(&image);
        let largest = (0..size).map(|i| values[(i, 0)].abs()).fold(0.0, f64::max);
        values *= largest.recip();
    }
    let values: Vec<f64> = (0..size).map(|i| values[(i, 0)]).collect();
    Function::linears(cells, &values)
}

/// B: the squared error norm as a form of the nodal values of the slope.
pub(super) fn error_form(norm: ErrorNorm, mesh: &ElementMesh) -> Result<DMatrix<f64>> {
    Ok(match norm {
        ErrorNorm::L2 => lagrange_form(mesh)?,
        ErrorNorm::Derivative => projection_form(mesh),
        ErrorNorm::H1 { h } => {
            // As on elements of length h: lengths of this mesh are in units of its longest element.
            let scale = h / mesh.h();
            projection_form(mesh) + lagrange_form(mesh)? * (scale * scale)
        }
    })
}
