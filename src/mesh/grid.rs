//! Triangulations with the numbering of a structured grid: detection and coarsening by a factor of two.
//!
//! Node (i, j) has the number j (nx + 1) + i, and every quadrilateral is cut from bottom left to top right, as in
//! `rectangles` and its images. If the differences of neighbouring nodes are the same two vectors
//! everywhere, to the last bit, every interior node has congruent surrounding triangles. Cost: O(nodes).

use super::geometry::{BoundaryEdge, Part, Point};
use super::structured::{SideParts, rectangles};
use super::triangulation::Triangulation;
use std::collections::HashMap;

/// The counts of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Grid {
    pub(crate) nx: usize,
    pub(crate) ny: usize,
}

impl Grid {
    /// The grid whose numbering the triangulation has, if it has one.
    pub(crate) fn of(mesh: &Triangulation) -> Option<Self> {
        let &[first, second, ..] = mesh.triangles() else { return None };
        let nx = first[2].checked_sub(2)?;
        if nx == 0 || first != [0, 1, nx + 2] || second != [0, nx + 2, nx + 1] {
            return None;
        }
        let ny = (mesh.nodes().len() / (nx + 1)).checked_sub(1)?;
        let grid = Self { nx, ny };
        if grid.nodes() != mesh.nodes().len() || 2 * nx * ny != mesh.triangles().len() {
            return None;
        }
        let fits = mesh.triangles().chunks_exact(2).enumerate().all(|(cell, pair)| {
            let a = grid.node(cell % nx, cell / nx);
            let d = a + nx + 1;
            pair[0] == [a, a + 1, d + 1] && pair[1] == [a, d + 1, d]
        });
        fits.then_some(grid)
    }

    pub(crate) fn nodes(self) -> usize {
        (self.nx + 1) * (self.ny + 1)
    }

    /// The number of node (i, j).
    pub(crate) fn node(self, i: usize, j: usize) -> usize {
        j * (self.nx + 1) + i
    }

    /// The two steps of the grid, where they are the same everywhere.
    pub(crate) fn steps(self, mesh: &Triangulation) -> Option<[Point; 2]> {
        let nodes = mesh.nodes();
        let step = |from: usize, to: usize| [0, 1].map(|axis| nodes[to][axis] - nodes[from][axis]);
        let row = self.nx + 1;
        let steps = [step(0, 1), step(0, row)];
        let across = (0..nodes.len() - 1).all(|k| k % row == self.nx || step(k, k + 1) == steps[0]);
        let along = (0..nodes.len() - row).all(|k| step(k, k + row) == steps[1]);
        (across && along).then_some(steps)
    }

    /// The grid of half as many cells each way; `None` for an odd count.
    pub(crate) fn coarser(self) -> Option<Self> {
        let halves = |count: usize| (count.is_multiple_of(2) && count >= 2).then_some(count / 2);
        Some(Self { nx: halves(self.nx)?, ny: halves(self.ny)? })
    }

    /// For every fine node, the two coarse nodes whose midpoint it is; twice the same for a node of the coarse grid.
    pub(crate) fn parents(self, coarse: Self) -> Vec<[u32; 2]> {
        (0..self.nodes())
            .map(|node| {
                let (i, j) = (node % (self.nx + 1), node / (self.nx + 1));
                let below = coarse.node(i / 2, j / 2) as u32;
                [below, coarse.node(i.div_ceil(2), j.div_ceil(2)) as u32]
            })
            .collect()
    }

    /// The triangulation of every other node of this numbering; `None` if labels or regions change between them, or a
    /// triangle is inverted.
    pub(crate) fn coarse_mesh(self, mesh: &Triangulation) -> Option<(Self, Triangulation)> {
        let coarse = self.coarser()?;
        let fine = |k: usize| self.node(2 * (k % (coarse.nx + 1)), 2 * (k / (coarse.nx + 1)));
        let nodes: Vec<Point> = (0..coarse.nodes()).map(|k| mesh.nodes()[fine(k)]).collect();
        let template = rectangles(coarse.nx, coarse.ny, SideParts::HANGING).ok()?;
        let mut parts: HashMap<[usize; 2], Part> = HashMap::new();
        for &BoundaryEdge { nodes: [a, b], part } in mesh.boundary() {
            parts.insert([a.min(b), a.max(b)], part);
        }
        let boundary: Vec<BoundaryEdge> = template
            .boundary()
            .iter()
            .map(|edge| {
                let [a, b] = edge.nodes.map(fine);
                let middle = usize::midpoint(a, b);
                let part_of = |p: usize, q: usize| parts.get(&[p.min(q), p.max(q)]).copied();
                let part = part_of(a, middle)?;
                (part_of(middle, b) == Some(part)).then_some(BoundaryEdge { part, ..*edge })
            })
            .collect::<Option<_>>()?;
        let mut made = Triangulation::new(&nodes, template.triangles(), &boundary).ok()?;
        if !mesh.regions().is_empty() {
            made = made.with_regions(&self.coarse_regions(coarse, mesh)?).ok()?;
        }
        Some((coarse, made))
    }

    /// The common region of the four triangles in each coarse one.
    fn coarse_regions(self, coarse: Self, mesh: &Triangulation) -> Option<Vec<u32>> {
        let cell = |i: usize, j: usize| 2 * (j * self.nx + i);
        let mut regions = Vec::with_capacity(2 * coarse.nx * coarse.ny);
        for j in 0..coarse.ny {
            for i in 0..coarse.nx {
                let [a, b, c, d] =
                    [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(p, q)| cell(2 * i + p, 2 * j + q));
                for four in [[a, b, b + 1, c], [a + 1, d, d + 1, c + 1]] {
                    let region = mesh.regions()[four[0]];
                    if four.iter().any(|&t| mesh.regions()[t] != region) {
                        return None;
                    }
                    regions.push(region);
                }
            }
        }
        Some(regions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Hierarchy, mapped_grid, unit_square};

    #[test]
    fn grids_are_recognised_and_coarsened() {
        let fine = rectangles(8, 4, SideParts::HANGING).unwrap();
        let grid = Grid::of(&fine).unwrap();
        assert_eq!((grid.nx, grid.ny), (8, 4));
        assert_eq!(grid.steps(&fine), Some([[0.125, 0.0], [0.0, 0.25]]));
        let (coarse, mesh) = grid.coarse_mesh(&fine).unwrap();
        assert_eq!(mesh, rectangles(4, 2, SideParts::HANGING).unwrap());
        for (node, [a, b]) in grid.parents(coarse).into_iter().enumerate() {
            let (p, q) = (mesh.nodes()[a as usize], mesh.nodes()[b as usize]);
            assert_eq!(fine.nodes()[node], [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])]);
        }
        let bent = mapped_grid(4, 4, SideParts::HANGING, |[x, y]| [x, y * (1.0 + x)]).unwrap();
        assert!(Grid::of(&bent).is_some_and(|grid| grid.steps(&bent).is_none()));
        let hierarchy = Hierarchy::refined(unit_square(2, SideParts::HANGING).unwrap(), 1).unwrap();
        assert_eq!(Grid::of(hierarchy.finest()), None);
        assert!(Grid { nx: 3, ny: 4 }.coarser().is_none());
    }

    #[test]
    fn regions_and_labels_must_agree() {
        let fine = unit_square(4, SideParts::HANGING).unwrap();
        let grid = Grid::of(&fine).unwrap();
        let split = |at: usize| {
            let regions = (0..32).map(|t| u32::from(t / 2 % 4 >= at)).collect::<Vec<_>>();
            grid.coarse_mesh(&fine.clone().with_regions(&regions).unwrap())
        };
        let regions: Vec<u32> = (0..8).map(|t| (t / 2) % 2).collect();
        assert_eq!(split(2).unwrap().1.regions(), regions);
        assert!(split(1).is_none());
    }
}
