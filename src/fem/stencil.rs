//! The stiffness matrix on a grid with constant steps, without storing it: nine kinds of nodes (left, inside,
//! right × bottom, inside, top), seven blocks each.
//!
//! The neighbours of node (i, j) are (−1,−1), (0,−1), (−1,0), itself, (1,0), (0,1), (1,1), in the order of their
//! numbers; those outside the grid have zero blocks. Products have the arithmetic cost of those with an assembled
//! matrix and require no memory for it.

use super::form::{Element, Form};
use super::frame::Frame;
use crate::mesh::{Grid, Triangulation};
use rayon::prelude::*;

pub(crate) const NEIGHBOURS: [(isize, isize); 7] =
    [(-1, -1), (0, -1), (-1, 0), (0, 0), (1, 0), (0, 1), (1, 1)];

/// A block of two unknowns by two; a scalar form fills the first entry.
pub(crate) type Block = [[f64; 2]; 2];

/// The blocks of the nine kinds of nodes.
#[derive(Debug, Clone)]
pub(crate) struct Stencils {
    grid: Grid,
    components: usize,
    /// By 3 · (row kind) + (column kind).
    blocks: [[Block; 7]; 9],
}

/// 0 at the first, 2 at the last, 1 between.
pub(crate) fn kind(index: usize, last: usize) -> usize {
    if index == 0 { 0 } else { 1 + usize::from(index == last) }
}

impl Stencils {
    /// The stencils of a form on a triangulation that is a grid with constant steps and has one material.
    pub(crate) fn of(mesh: &Triangulation, form: &Form, frame: &Frame) -> Option<Self> {
        let grid = Grid::of(mesh)?;
        let one_material = match mesh.regions().split_first() {
            None => true,
            Some((&first, rest)) => {
                let material = form.material(first as usize);
                rest.iter().all(|&region| form.material(region as usize) == material)
            }
        };
        if !one_material {
            return None;
        }
        let [e, f] = grid.steps(mesh)?;
        let region = mesh.region(0);
        let at = |(i, j): (isize, isize)| {
            let (i, j) = (i as f64, j as f64);
            [i * e[0] + j * f[0], i * e[1] + j * f[1]]
        };
        let mut blocks = [[[[0.0; 2]; 2]; 7]; 9];
        for (kind, blocks) in blocks.iter_mut().enumerate() {
            let rows = cells(kind / 3);
            for (x, y) in
                cells(kind % 3).into_iter().flat_map(|x| rows.iter().map(move |&y| (x, y)))
            {
                let [a, b, c, d] = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(p, q)| (x + p, y + q));
                for corners in [[a, b, c], [a, c, d]] {
                    let Some(own) = corners.iter().position(|&corner| corner == (0, 0)) else {
                        continue;
                    };
                    let element = Element::new(corners.map(at));
                    for (j, corner) in corners.into_iter().enumerate() {
                        let Some(k) = NEIGHBOURS.iter().position(|&n| n == corner) else {
                            continue;
                        };
                        let block = element.block(form, region, own, j);
                        let block =
                            if form.components() == 1 { block } else { frame.turn_block(block) };
                        for (sum, term) in
                            blocks[k].as_flattened_mut().iter_mut().zip(block.as_flattened())
                        {
                            *sum += term;
                        }
                    }
                }
            }
        }
        Some(Self { grid, components: form.components(), blocks })
    }

    pub(crate) fn grid(&self) -> Grid {
        self.grid
    }

    /// The blocks of the nine kinds of nodes, by 3 · (row kind) + (column kind).
    pub(crate) fn blocks(&self) -> &[[Block; 7]; 9] {
        &self.blocks
    }

    /// The entries of row `unknown` (node-major) as (column, value), zeros left out.
    pub(crate) fn row(&self, unknown: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let c = self.components;
        let (node, a) = (unknown / c, unknown % c);
        let width = self.grid.nx + 1;
        let stencil =
            &self.blocks[3 * kind(node / width, self.grid.ny) + kind(node % width, self.grid.nx)];
        NEIGHBOURS.iter().zip(stencil).flat_map(move |(&(i, j), block)| {
            let column = node.wrapping_add_signed(j * width as isize + i);
            (0..c)
                .map(move |b| (column.wrapping_mul(c).wrapping_add(b), block[a][b]))
                .filter(|&(_, v)| v != 0.0)
        })
    }

    /// K x for node-major x.
    pub(crate) fn multiply(&self, x: &[f64]) -> Vec<f64> {
        self.map_rows(x, |value, x| value * x)
    }

    /// |K| |x|.
    pub(crate) fn multiply_absolute(&self, x: &[f64]) -> Vec<f64> {
        self.map_rows(x, |value, x| (value * x).abs())
    }

    fn map_rows(&self, x: &[f64], term: impl Fn(f64, f64) -> f64 + Sync) -> Vec<f64> {
        let (c, width) = (self.components, self.grid.nx + 1);
        let mut sums = vec![0.0; x.len()];
        sums.par_chunks_mut(c * width).enumerate().for_each(|(j, row)| {
            for i in 0..width {
                let column_kind = kind(i, self.grid.nx);
                let stencil = &self.blocks[3 * kind(j, self.grid.ny) + column_kind];
                let inside = column_kind == 1 && j > 0 && j < self.grid.ny;
                for (k, &(p, q)) in NEIGHBOURS.iter().enumerate() {
                    let (p, q) = (i.wrapping_add_signed(p), j.wrapping_add_signed(q));
                    if !inside && (p > self.grid.nx || q > self.grid.ny) {
                        continue;
                    }
                    let at = c * (q * width + p);
                    for a in 0..c {
                        for b in 0..c {
                            row[c * i + a] += term(stencil[k][a][b], x[at + b]);
                        }
                    }
                }
            }
        });
        sums
    }
}

/// The cells adjacent to a node of the given kind, by their lower corner relative to the node.
fn cells(kind: usize) -> Vec<isize> {
    match kind {
        0 => vec![0],
        1 => vec![-1, 0],
        _ => vec![-1],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::{Lame, stiffness};
    use crate::mesh::{SideParts, mapped_grid};

    #[test]
    fn stencils_are_the_assembled_matrix() {
        let mesh =
            mapped_grid(8, 4, SideParts::HANGING, |[x, y]| [2.0 * x + 0.5 * y, x - y + 3.0 * y])
                .unwrap();
        let elastic = Form::elastic(Lame::new(2.0, 0.75).unwrap());
        for (form, frame) in [
            (Form::Scalar { reaction: 1.5 }, Frame::cartesian()),
            (elastic.clone(), Frame::cartesian()),
            (elastic, Frame::turned([0.6, 0.8])),
        ] {
            let stencils = Stencils::of(&mesh, &form, &frame).unwrap();
            let matrix = stiffness(&mesh, &form, &frame);
            let x: Vec<f64> = (0..matrix.unknowns()).map(|i| ((7 * i) % 11) as f64 - 5.0).collect();
            for (a, b) in [
                (stencils.multiply(&x), matrix.multiply(&x)),
                (stencils.multiply_absolute(&x), matrix.multiply_absolute(&x)),
            ] {
                assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-12), "{form:?}");
            }
            for unknown in 0..matrix.unknowns() {
                let sum: f64 = stencils.row(unknown).map(|(column, value)| value * x[column]).sum();
                assert!((sum - matrix.multiply(&x)[unknown]).abs() < 1e-12);
            }
        }
    }
}
