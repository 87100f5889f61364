//! Elements made of cells: functions live on the cells, I^h and π^h on the elements.

use fractional_sobolev::{Error, Function, Mesh, Result, Tolerance};
use std::ops::Range;

/// A mesh into cells, grouped into elements.
///
/// # Method
///
/// (u − I^h u)' = u' − π^h u' on every element: Lagrange interpolation of u is the P0 projection of its
/// slope. One mesh and one set of forms therefore serve Lemma 6.2 (Lagrange) and (4.6), (4.7) (P0
/// projection).
///
/// ```
/// use experiments::interpolation::ElementMesh;
/// use fractional_sobolev::{Function, Mesh};
/// let mesh = ElementMesh::uniform(4, 8)?;
/// assert!(mesh.elements().len() == 4 && mesh.cells().len() == 32 && mesh.h() == 0.25);
/// // π^h of I^h x: the means of x
/// let means = mesh.projection(&Function::interpolate(mesh.cells(), 1, |x| x)?)?;
/// assert!((means.value(0, 0.5)? - 0.125).abs() < 1e-15);
/// let cells = Mesh::geometric(3, 0.5, 1.0)?;
/// assert_eq!(ElementMesh::single(cells.clone())?.h(), 1.0);
/// assert_eq!(ElementMesh::new(cells, &[3, 1])?.h(), 0.5);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ElementMesh {
    cells: Mesh,
    elements: Vec<Range<usize>>,
}

impl ElementMesh {
    /// Elements of the given numbers of cells, left to right.
    ///
    /// # Errors
    /// [`Error::EntryOutOfRange`] for an element without cells, [`Error::LengthMismatch`] unless they add up.
    pub fn new(cells: Mesh, cells_per_element: &[usize]) -> Result<Self> {
        let mut elements = Vec::with_capacity(cells_per_element.len());
        let mut start = 0;
        for (index, &count) in cells_per_element.iter().enumerate() {
            if count == 0 {
                let (name, range) = ("cells of an element", ">= 1");
                return Err(Error::EntryOutOfRange { name, index, value: 0.0, range });
            }
            elements.push(start..start + count);
            start += count;
        }
        if start != cells.len() {
            return Err(Error::LengthMismatch {
                name: "cells of all elements",
                given: start,
                expected: cells.len(),
            });
        }
        Ok(Self { cells, elements })
    }

    /// All cells in one element.
    ///
    /// # Errors
    /// None: a mesh has a cell.
    pub fn single(cells: Mesh) -> Result<Self> {
        let count = cells.len();
        Self::new(cells, &[count])
    }

    /// `elements` equal elements on (0, 1), each of `cells` equal cells.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without elements or cells.
    pub fn uniform(elements: usize, cells: usize) -> Result<Self> {
        let count = elements.saturating_mul(cells);
        let partition = Mesh::uniform(count, 1.0)?;
        Self::new(partition, &vec![cells; elements])
    }

    /// The cells.
    pub fn cells(&self) -> &Mesh {
        &self.cells
    }

    /// The ranges of cells of the elements.
    pub fn elements(&self) -> &[Range<usize>] {
        &self.elements
    }

    /// Length of the longest element: the h of the paper.
    pub fn h(&self) -> f64 {
        (0..self.elements.len()).map(|e| self.length(e)).fold(0.0, f64::max)
    }

    /// Length of an element.
    fn length(&self, element: usize) -> f64 {
        let range = &self.elements[element];
        self.cells.lengths()[range.clone()].iter().sum()
    }

    /// π^h v: the mean of v on each element.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] unless v lives on the cells of this mesh.
    pub fn projection(&self, v: &Function<'_>) -> Result<Function<'static>> {
        self.require_cells(v.mesh()?)?;
        let mut lengths = Vec::with_capacity(self.elements.len());
        let mut means = Vec::with_capacity(self.elements.len());
        for (e, range) in self.elements.iter().enumerate() {
            lengths.push(self.length(e));
            means.push(v.restrict(range.clone())?.mean(Tolerance::reference())?.value);
        }
        Function::piecewise(&Mesh::from_lengths(lengths)?, 0, &means)
    }

    fn require_cells(&self, mesh: &Mesh) -> Result<()> {
        if mesh.lengths() == self.cells.lengths() {
            return Ok(());
        }
        let (given, expected) = (mesh.len(), self.cells.len());
        Err(Error::LengthMismatch { name: "cells of the function (lengths must agree)", given, expected })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_the_interpolant_is_the_projection_of_the_slope() {
        let mesh = ElementMesh::new(Mesh::graded(&[0.0, 2.0], 3, 0.4).unwrap(), &[2, 5, 1]).unwrap();
        let cubic = |x: f64| x * (1.0 - x * (2.0 - 0.7 * x));
        let u = Function::interpolate(mesh.cells(), 3, cubic).unwrap();
        let projected = mesh.projection(&u.derivative().unwrap()).unwrap();
        let interpolant = Function::interpolate(projected.mesh().unwrap(), 1, cubic).unwrap();
        let interpolant = interpolant.derivative().unwrap();
        for e in 0..3 {
            let (a, b) = (projected.value(e, 0.5).unwrap(), interpolant.value(e, 0.5).unwrap());
            assert!((a - b).abs() < 1e-14, "{e}: {a} {b}");
        }
    }

    #[test]
    fn bad_groups_are_errors() {
        let cells = || Mesh::uniform(4, 1.0).unwrap();
        let empty = ElementMesh::new(cells(), &[2, 0, 2]);
        assert!(matches!(empty, Err(Error::EntryOutOfRange { index: 1, value: 0.0, .. })));
        assert!(ElementMesh::new(cells(), &[2, 1]).is_err());
        assert!(ElementMesh::uniform(0, 3).is_err() && ElementMesh::uniform(usize::MAX, 3).is_err());
        let other = Function::piecewise(&Mesh::uniform(2, 1.0).unwrap(), 0, &[0.0, 1.0]).unwrap();
        assert!(ElementMesh::single(cells()).unwrap().projection(&other).is_err());
    }
}
