//! Elements that consist of cells: functions are piecewise polynomials on the cells, I^h and π^h act on the
//! elements.

use crate::Mesh;
use crate::error::{Error, Result};
use std::ops::Range;

/// A mesh of cells, which are grouped into elements.
///
/// (u − I^h u)' = u' − π^h u' on every element: the derivative of the Lagrange interpolant of u is the P0
/// projection of the slope of u. One mesh and one set of forms are therefore used for Lemma 6.2 (Lagrange) and
/// (4.6), (4.7) (P0 projection).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ElementMesh {
    cells: Mesh,
    elements: Vec<Range<usize>>,
}

impl ElementMesh {
    /// The elements of a mesh, scaled to (0, 1), each divided into `cells` equal cells.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without cells.
    pub(super) fn refined(mesh: &Mesh, cells: usize) -> Result<Self> {
        let count = mesh.len().saturating_mul(cells);
        let partition = if mesh.uniform_length().is_some() {
            Mesh::uniform(count, 1.0)?
        } else {
            if cells == 0 {
                return Err(Error::CountOutOfRange { name: "cells", value: 0, range: "[1, inf)" });
            }
            let parts =
                mesh.lengths().iter().flat_map(|h| vec![h / mesh.total() / cells as f64; cells]);
            Mesh::from_lengths(&parts.collect::<Vec<_>>())?
        };
        let elements = (0..mesh.len()).map(|e| e * cells..(e + 1) * cells).collect();
        Ok(Self { cells: partition, elements })
    }

    /// The cells.
    pub(super) fn cells(&self) -> &Mesh {
        &self.cells
    }

    /// The range of cells of each element.
    pub(super) fn elements(&self) -> &[Range<usize>] {
        &self.elements
    }

    /// The length of an element.
    pub(super) fn length(&self, element: usize) -> f64 {
        let range = &self.elements[element];
        self.cells.distance(range.start, range.end)
    }
}
