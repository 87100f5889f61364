//! Lemma 6.2: the best constants on a mesh.

use super::ascent::error_form;
use crate::error::{Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::interpolation::element::ErrorNorm;
use crate::interpolation::elements::ElementMesh;
use crate::interpolation::extremal::{Forms, extremal, extremal_on_cells};
use crate::{Order, gram_linears};

/// The best constant of Lemma 6.2 on `elements` equal elements: a lower bound, the best constant at most
/// `error` above it.
///
/// For [`ErrorNorm::H1`] the elements have length h.
///
/// # Method
///
/// C(ν, N) = sup ‖u − I^h u‖ / (h^s |u|\_{1+ν,Γ}) over u ∈ H^{1+ν}(Γ) on N equal elements of Γ, s = 1 + ν or
/// ν. By the lemma's proof C(ν, N) is at most the constant of one element; it is smaller for N > 1, because
/// |u|²_{1+ν,Γ} also holds the pairs of points in different elements, which the proof drops. The loss stays
/// bounded as N grows.
/// Lower bounds from slopes linear on m cells per element; what is missing falls like m^{-1-2ν} (a slope
/// behaves like r^{2ν} at a node), at most like m^{-2}. Dense; cost O((N m)³).
///
/// ```
/// use fractional_sobolev::{Order, Tolerance, interpolation::{ErrorNorm, element_constant, mesh_constant, mesh_constant_on_cells}};
/// let (norm, order, asked) = (ErrorNorm::Derivative, Order::HALF, Tolerance::new(1e-2)?);
/// let (mesh, one) = (mesh_constant(norm, order, 4, asked)?, element_constant(norm, order, asked)?);
/// assert!(mesh.value < one.value);
/// assert!((mesh_constant_on_cells(norm, order, 4, 8)?.value / mesh.value - 1.0).abs() < 0.1);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) without elements or for more than 1024 of them;
/// [`Error::ToleranceNotMet`](crate::Error::ToleranceNotMet) when it takes more than 4096 cells in all.
pub fn mesh_constant(
    norm: ErrorNorm,
    order: impl Given<Order>,
    elements: usize,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let constant = |quotient| scaled(norm, order, elements, quotient);
    extremal(elements, tolerance, |mesh| forms(norm, order, mesh))
        .map_err(|error| error.carry("best constant on a mesh", constant))
        .and_then(constant)
}

/// The same from slopes linear on `cells` equal cells per element; the error is what halving the cells has
/// added.
///
/// # Errors
/// [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) without elements, for fewer than 4 or an odd
/// number of cells per element, or for more than 4096 cells in all.
pub fn mesh_constant_on_cells(
    norm: ErrorNorm,
    order: impl Given<Order>,
    elements: usize,
    cells: usize,
) -> Result<Estimate> {
    let order = order.given()?;
    scaled(norm, order, elements, extremal_on_cells(elements, cells, |mesh| forms(norm, order, mesh))?)
}

fn forms(norm: ErrorNorm, order: Order, mesh: &ElementMesh) -> Result<Forms> {
    Ok((gram_linears(mesh.cells(), order), error_form(norm, mesh)?))
}

/// From elements of length 1/N to elements of length 1.
fn scaled(norm: ErrorNorm, order: Order, elements: usize, quotient: Estimate) -> Result<Estimate> {
    let power = match norm {
        ErrorNorm::L2 => 1.0 + order.value(),
        ErrorNorm::Derivative | ErrorNorm::H1 { .. } => order.value(),
    };
    let scale = (elements as f64).powf(power);
    Estimate::new(scale * quotient.value, scale * quotient.error, quotient.work)
}
