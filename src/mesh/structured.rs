//! Structured grids: squares cut by the diagonal from bottom left to top right, optionally mapped.

use super::geometry::{BoundaryEdge, Part, Point};
use super::triangulation::Triangulation;
use crate::error::{Error, Result};
use crate::numeric::check::require_memory;
use std::collections::{BTreeMap, BTreeSet};

/// Labels of the four sides of a structured grid.
///
/// ```
/// use signorini::mesh::{Part, SideParts, unit_square};
/// let clamped = SideParts { left: Part::Dirichlet, ..SideParts::HANGING };
/// let mesh = unit_square(3, clamped)?;
/// let fixed = mesh.nodes_on(Part::Dirichlet).into_iter().filter(|&on| on).count();
/// assert_eq!(fixed, 7);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SideParts {
    /// The side y = 0.
    pub bottom: Part,
    /// The side x = 1.
    pub right: Part,
    /// The side y = 1.
    pub top: Part,
    /// The side x = 0.
    pub left: Part,
}

/// Bytes per cell: its node, two triangles, and derived data.
const BYTES_OF_CELL: usize = 100;

impl SideParts {
    /// Contact at the bottom, Dirichlet at the top, free sides, as in the test problems `block` and `membrane`.
    pub const HANGING: SideParts = SideParts {
        bottom: Part::Contact,
        right: Part::Neumann,
        top: Part::Dirichlet,
        left: Part::Neumann,
    };
}

/// The triangulation of the unit square by `nx` × `ny` rectangles, each cut from bottom left to top right;
/// node (i, j) has the number j(nx + 1) + i.
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a count outside 1 ... 16384,
/// [`ToolkitError::TooLarge`](crate::ToolkitError::TooLarge) if there is not enough memory.
pub(crate) fn rectangles(nx: usize, ny: usize, sides: SideParts) -> Result<Triangulation> {
    for (name, value) in [("cells in x", nx), ("cells in y", ny)] {
        if !(1..=16384).contains(&value) {
            let range = "[1, 16384]";
            return Err(Error::count(name, value, range));
        }
    }
    require_memory("cells", nx.saturating_mul(ny), BYTES_OF_CELL)?;
    let node = |i: usize, j: usize| j * (nx + 1) + i;
    let nodes = (0..=ny)
        .flat_map(|j| (0..=nx).map(move |i| [i as f64 / nx as f64, j as f64 / ny as f64]))
        .collect();
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

/// The triangulation of the unit square by n × n squares, each cut from bottom left to top right; node (i, j) has the number j(n + 1) + i.
///
/// ```
/// use signorini::mesh::{SideParts, unit_square};
/// let mesh = unit_square(4, SideParts::HANGING)?;
/// assert_eq!((mesh.nodes().len(), mesh.triangles().len()), (25, 32));
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for n outside 1 ... 16384,
/// [`ToolkitError::TooLarge`](crate::ToolkitError::TooLarge) if there is not enough memory.
pub fn unit_square(n: usize, sides: SideParts) -> Result<Triangulation> {
    rectangles(n, n, sides)
}

/// The image under `map` of the `nx` × `ny` grid of the unit square.
///
/// ```
/// use signorini::mesh::{SideParts, mapped_grid};
/// let trapezoid = mapped_grid(8, 4, SideParts::HANGING, |[x, y]| [2.0 * x + 0.3 * y, y])?;
/// assert_eq!(trapezoid.nodes()[8], [2.0, 0.0]);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// As for [`unit_square`]; [`ToolkitError::Triangle`](crate::ToolkitError::Triangle) for the first triangle
/// whose image is inverted or degenerate, [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) for a
/// node whose image is not finite.
pub fn mapped_grid(
    nx: usize,
    ny: usize,
    sides: SideParts,
    map: impl Fn(Point) -> Point,
) -> Result<Triangulation> {
    rectangles(nx, ny, sides)?.mapped(map)
}

/// The triangulation of a union of unit squares, each with n × n squares cut from bottom left to top right; `places`
/// are their bottom left corners, `part` is evaluated at the midpoint of every boundary edge.
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a count outside 1 ... 4096, or without
/// squares; if two squares coincide, an error of [`Triangulation::new`].
pub fn unit_squares(
    n: usize,
    places: &[[i32; 2]],
    part: impl Fn(Point) -> Part,
) -> Result<Triangulation> {
    for (name, value) in [("cells of a square", n), ("squares", places.len())] {
        if !(1..=4096).contains(&value) {
            return Err(Error::count(name, value, "[1, 4096]"));
        }
    }
    let (mut nodes, mut triangles): (Vec<Point>, Vec<[usize; 3]>) = (Vec::new(), Vec::new());
    let mut known: BTreeMap<[i64; 2], usize> = BTreeMap::new();
    for [x, y] in places.iter().map(|place| place.map(|k| i64::from(k) * n as i64)) {
        let mut node = |i: i64, j: i64| {
            *known.entry([x + i, y + j]).or_insert_with(|| {
                nodes.push([x + i, y + j].map(|k| k as f64 / n as f64));
                nodes.len() - 1
            })
        };
        for (j, i) in (0..n as i64).flat_map(|j| (0..n as i64).map(move |i| (j, i))) {
            let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let sides = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let all: BTreeSet<[usize; 2]> = triangles.iter().flat_map(sides).collect();
    let labelled = |ends: &[usize; 2]| {
        let [p, q] = ends.map(|node| nodes[node]);
        BoundaryEdge { nodes: *ends, part: part([0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])]) }
    };
    let boundary =
        all.iter().filter(|[a, b]| !all.contains(&[*b, *a])).map(labelled).collect::<Vec<_>>();
    Triangulation::new(&nodes, &triangles, &boundary)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn structured_grids_pass_the_check_of_foreign_meshes() {
        let mesh = rectangles(3, 2, SideParts::HANGING).unwrap();
        let checked = Triangulation::new(mesh.nodes(), mesh.triangles(), mesh.boundary());
        assert_eq!(checked.unwrap(), mesh);
        assert!(unit_square(0, SideParts::HANGING).is_err());
        // Three squares around a reentrant corner: 3 n² cells, 8 n edges; one square is the structured grid.
        let free = |_| Part::Neumann;
        let around = unit_squares(3, &[[0, 0], [0, 1], [-1, 1]], free).unwrap();
        assert_eq!(
            (around.nodes().len(), around.triangles().len(), around.boundary().len()),
            (40, 54, 24)
        );
        assert_eq!(unit_squares(2, &[[0, 0]], free).unwrap().triangles().len(), 8);
        assert!(unit_squares(0, &[[0, 0]], free).is_err() && unit_squares(1, &[], free).is_err());
        assert!(unit_squares(1, &[[0, 0]; 2], free).is_err());
        assert!(mapped_grid(2, 2, SideParts::HANGING, |[x, y]| [y, x]).is_err());
    }
}
