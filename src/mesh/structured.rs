//! Structured grids: squares cut by the diagonal from bottom left to top right, mapped if wanted.

use super::geometry::{BoundaryEdge, Part, Point};
use super::triangulation::Triangulation;
use crate::error::{Error, Result};

/// Labels of the four sides of a structured grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sides {
    /// y = 0.
    pub bottom: Part,
    /// x = 1.
    pub right: Part,
    /// y = 1.
    pub top: Part,
    /// x = 0.
    pub left: Part,
}

impl Sides {
    /// Contact at the bottom, fixed at the top, free on both sides: the scenes `block` and `membrane`.
    pub const HANGING: Sides =
        Sides { bottom: Part::Contact, right: Part::Neumann, top: Part::Dirichlet, left: Part::Neumann };
}

/// The unit square in `nx` by `ny` rectangles, each cut from bottom left to top right; node (i, j) has the
/// number j(nx + 1) + i.
///
/// # Errors
/// [`Error::CountOutOfRange`] for a count outside 1 ... 16384.
pub fn rectangles(nx: usize, ny: usize, sides: Sides) -> Result<Triangulation> {
    for (name, value) in [("cells in x", nx), ("cells in y", ny)] {
        if !(1..=16384).contains(&value) {
            let range = "[1, 16384]";
            return Err(Error::CountOutOfRange { name, value, range });
        }
    }
    let node = |i: usize, j: usize| j * (nx + 1) + i;
    let nodes =
        (0..=ny).flat_map(|j| (0..=nx).map(move |i| [i as f64 / nx as f64, j as f64 / ny as f64])).collect();
    let triangles = (0..ny)
        .flat_map(|j| (0..nx).map(move |i| (i, j)))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let edge = |part, from, to| BoundaryEdge { nodes: [from, to], part };
    let boundary = (0..nx)
        .map(|i| edge(sides.bottom, node(i, 0), node(i + 1, 0)))
        .chain((0..ny).map(|j| edge(sides.right, node(nx, j), node(nx, j + 1))))
        .chain((0..nx).rev().map(|i| edge(sides.top, node(i + 1, ny), node(i, ny))))
        .chain((0..ny).rev().map(|j| edge(sides.left, node(0, j + 1), node(0, j))))
        .collect();
    Ok(Triangulation::trusted(nodes, triangles, boundary))
}

/// The unit square in n x n squares.
///
/// ```
/// use signorini::mesh::{Sides, unit_square};
/// let mesh = unit_square(4, Sides::HANGING)?;
/// assert_eq!((mesh.nodes().len(), mesh.triangles().len()), (25, 32));
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// As for [`rectangles`].
pub fn unit_square(n: usize, sides: Sides) -> Result<Triangulation> {
    rectangles(n, n, sides)
}

/// The image of the `nx` by `ny` grid of the unit square under `map`.
///
/// # Errors
/// As for [`rectangles`]; names the first triangle that the map inverts or flattens.
pub fn mapped_grid(
    nx: usize,
    ny: usize,
    sides: Sides,
    map: impl Fn(Point) -> Point,
) -> Result<Triangulation> {
    rectangles(nx, ny, sides)?.mapped(map)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn structured_grids_pass_the_check_of_foreign_meshes() {
        let mesh = rectangles(3, 2, Sides::HANGING).unwrap();
        let checked =
            Triangulation::new(mesh.nodes().to_vec(), mesh.triangles().to_vec(), mesh.boundary().to_vec());
        assert_eq!(checked.unwrap(), mesh);
        assert!(unit_square(0, Sides::HANGING).is_err());
        assert!(mapped_grid(2, 2, Sides::HANGING, |[x, y]| [y, x]).is_err());
    }
}
