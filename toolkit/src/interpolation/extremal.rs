//! The largest quotient of two quadratic forms over the piecewise linear functions on m cells per element of a
//! mesh.
//!
//! It is a lower bound of the supremum over the whole space and increases as the cells are bisected. The
//! increments under bisection decrease by a factor of at least two, so that the last increment bounds the
//! remaining error; it is the error returned.

use super::elements::ElementMesh;
use super::forms::{MAX_CELLS, without_constants};
use crate::Mesh;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::pencil::Factored;
use nalgebra::DMatrix;

/// Smallest number of cells per element of the finer of two meshes that are compared.
const FEWEST: usize = 4;

/// The seminorm |·|_r² and the form that is compared with it, on a mesh.
pub(super) type Forms = (DMatrix<f64>, DMatrix<f64>);

/// The square root of a largest quotient, and the values at the cell nodes of a function with seminorm 1 that
/// attains it.
pub(super) struct Largest {
    pub(super) root: Estimate,
    pub(super) mesh: ElementMesh,
    pub(super) values: Vec<f64>,
}

/// The square root of the largest quotient on as many cells as the tolerance requires, at least `first` per
/// element.
///
/// # Errors
/// [`Error::CountOutOfRange`] for more than 1024 elements; [`Error::ToleranceNotMet`] if more than 4096 cells
/// are required.
pub(super) fn largest(
    mesh: &Mesh,
    first: usize,
    tolerance: Tolerance,
    forms: impl Fn(&ElementMesh) -> Result<Forms>,
) -> Result<Largest> {
    let fits = |cells: usize| mesh.len().saturating_mul(cells) <= MAX_CELLS;
    if !fits(FEWEST) {
        return Err(Error::CountOutOfRange {
            name: "elements",
            value: mesh.len(),
            range: "[1, 1024]",
        });
    }
    let mut cells = if fits(first) { first } else { FEWEST };
    let mut work = Work { factorizations: 2, ..Work::default() };
    let mut coarse = quotient(mesh, cells / 2, &forms)?.0;
    let mut best: Option<Estimate> = None;
    while fits(cells) {
        let (fine, mesh, values) = quotient(mesh, cells, &forms)?;
        work += Work { factorizations: 2, iterations: 1, ..Work::default() };
        let root = Estimate::new(fine, fine - coarse, work)?;
        if root.relative_error() <= tolerance.relative() {
            return Ok(Largest { root, mesh, values });
        }
        best = Some(root);
        (coarse, cells) = (fine, 2 * cells);
    }
    let why = "more than 4096 cells are required";
    Err(Error::best_of("best constant on a mesh", tolerance.relative(), best, why))
}

fn quotient(
    mesh: &Mesh,
    cells: usize,
    forms: &impl Fn(&ElementMesh) -> Result<Forms>,
) -> Result<(f64, ElementMesh, Vec<f64>)> {
    let mesh = ElementMesh::refined(mesh, cells)?;
    let (seminorm, form) = forms(&mesh)?;
    let (top, vector) =
        Factored::new(&without_constants(&seminorm, mesh.cells()))?.largest_eigenvalue(&form)?;
    // The vector has xᵀ B x = 1.
    let root = top.sqrt();
    Ok((root, mesh, vector.into_iter().map(|x| x * root).collect()))
}
