//! Lemma 6.2: the best constants on a mesh.
//!
//! C(ν, N) = sup ‖u − I^h u‖ / (h^s |u|_{1+ν,Γ}) over u ∈ H^{1+ν}(Γ) on N equal elements of Γ, s = 1 + ν or ν. By the lemma's proof
//! C(ν, N) is at most the constant of one element; it is smaller for N > 1, because |u|²_{1+ν,Γ} also holds the pairs of
//! points in different elements, which the proof drops. The loss stays bounded as N grows. Dense; cost O((N m)³).

use super::ascent::error_form;
use super::element::ErrorNorm;
use super::elements::ElementMesh;
use super::forms::{MAX_CELLS, without_constants};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::numeric::pencil::Factored;
use crate::sobolev::{FractionalOrder, gram_linears};
use faer::Mat;

/// The best constant of Lemma 6.2 on `elements` equal elements, from slopes linear on `cells` equal cells per element.
///
/// A lower bound; the error is estimated from half as many cells. For [`ErrorNorm::H1`] the elements have length h.
///
/// # Errors
/// [`Error::CountOutOfRange`] without elements, for fewer than 4 or an odd number of cells per element, or for more than 4096
/// cells in all.
pub fn mesh_constant(
    norm: ErrorNorm,
    order: FractionalOrder,
    elements: usize,
    cells: usize,
) -> Result<Estimate> {
    let quotient = extremal_on_mesh(elements, cells, |mesh| {
        Ok((gram_linears(mesh.cells(), order), error_form(norm, mesh)?))
    })?;
    // From elements of length 1/N to elements of length 1.
    let power = match norm {
        ErrorNorm::L2 => 1.0 + order.value(),
        _ => order.value(),
    };
    let scale = (elements as f64).powf(power);
    Estimate::new(scale * quotient.value, scale * quotient.error, quotient.work)
}

/// The root of the largest quotient of the second form by the first on N equal elements of (0, 1).
pub(super) fn extremal_on_mesh(
    elements: usize,
    cells: usize,
    forms: impl Fn(&ElementMesh) -> Result<(Mat<f64>, Mat<f64>)>,
) -> Result<Estimate> {
    if cells < 4 || !cells.is_multiple_of(2) {
        return Err(Error::CountOutOfRange { name: "cells per element", value: cells, range: "even, >= 4" });
    }
    let total = elements.saturating_mul(cells);
    if total > MAX_CELLS {
        return Err(Error::CountOutOfRange { name: "cells", value: total, range: "<= 4096" });
    }
    let value = |cells: usize| -> Result<f64> {
        let mesh = ElementMesh::uniform(elements, cells)?;
        let (seminorm, form) = forms(&mesh)?;
        Ok(Factored::new(&without_constants(&seminorm, mesh.cells()))?.largest_eigenvalue(&form)?.0.sqrt())
    };
    let (coarse, fine) = (value(cells / 2)?, value(cells)?);
    Estimate::new(fine, fine - coarse, Work { factorizations: 4, ..Work::default() })
}
