//! The largest quotient of two quadratic forms over the piecewise linears on N equal elements of (0, 1).
//!
//! A lower bound of the supremum over the whole space, which rises as the cells are halved. What halving them
//! adds falls by a factor of at least two each time, so the last addition bounds what is still missing: it is
//! the error returned.

use super::elements::ElementMesh;
use super::forms::{MAX_CELLS, without_constants};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::pencil::Factored;
use nalgebra::DMatrix;

/// Cells per element of the coarsest pair of meshes that is compared.
const FEWEST: usize = 4;

/// The seminorm |·|_r² and the form that is measured against it, on a mesh.
pub(super) type Forms = (DMatrix<f64>, DMatrix<f64>);

/// The root of the largest quotient on `cells` cells per element.
pub(super) fn extremal_on_cells(
    elements: usize,
    cells: usize,
    forms: impl Fn(&ElementMesh) -> Result<Forms>,
) -> Result<Estimate> {
    if cells < FEWEST || !cells.is_multiple_of(2) {
        return Err(Error::CountOutOfRange { name: "cells per element", value: cells, range: "even, >= 4" });
    }
    require_size(elements, cells)?;
    let (coarse, fine) = (quotient(elements, cells / 2, &forms)?, quotient(elements, cells, &forms)?);
    Estimate::new(fine, fine - coarse, Work { factorizations: 4, ..Work::default() })
}

/// The same on as many cells as the tolerance takes.
pub(super) fn extremal(
    elements: usize,
    tolerance: Tolerance,
    forms: impl Fn(&ElementMesh) -> Result<Forms>,
) -> Result<Estimate> {
    require_size(elements, FEWEST)?;
    let mut work = Work { factorizations: 2, ..Work::default() };
    let (mut coarse, mut cells) = (quotient(elements, FEWEST / 2, &forms)?, FEWEST);
    let mut best: Option<Estimate> = None;
    while elements.saturating_mul(cells) <= MAX_CELLS {
        let fine = quotient(elements, cells, &forms)?;
        work += Work { factorizations: 2, iterations: 1, ..Work::default() };
        let estimate = Estimate::new(fine, fine - coarse, work)?;
        if estimate.relative_error() <= tolerance.relative() {
            return Ok(estimate);
        }
        best = Some(estimate);
        (coarse, cells) = (fine, 2 * cells);
    }
    let why = "more than 4096 cells in all would be needed";
    Err(Error::best_of("best constant on a mesh", tolerance.relative(), best, why))
}

fn require_size(elements: usize, cells: usize) -> Result<()> {
    let total = elements.saturating_mul(cells);
    if total > MAX_CELLS {
        return Err(Error::CountOutOfRange { name: "cells", value: total, range: "<= 4096" });
    }
    Ok(())
}

fn quotient(elements: usize, cells: usize, forms: &impl Fn(&ElementMesh) -> Result<Forms>) -> Result<f64> {
    let mesh = ElementMesh::uniform(elements, cells)?;
    let (seminorm, form) = forms(&mesh)?;
    Ok(Factored::new(&without_constants(&seminorm, mesh.cells()))?.largest_eigenvalue(&form)?.0.sqrt())
}
