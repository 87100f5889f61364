//! A level with an assembled matrix, for arbitrary meshes.
//!
//! Vectors are node-major. Nodes are coloured greedily so that no two neighbours share a colour; a sweep treats one
//! colour after another, and the nodes of a colour in parallel. The cycle uses a copy of the matrix in
//! f32, divided by its largest diagonal entry. Cost of a sweep: two operations per entry.

use super::grid_rows::inverse_of;
use super::level::{Level, Sweep};
use super::real::Real;
use crate::fem::BlockMatrix;
use rayon::prelude::*;

/// Number of nodes below which a task is not split.
const GRAIN: usize = 1 << 12;

/// A level with C components per node.
#[derive(Debug, Clone)]
pub(super) struct SparseLevel<'a, const C: usize> {
    matrix: &'a BlockMatrix,
    unit: f64,
    offsets: Vec<u32>,
    columns: Vec<u32>,
    /// K divided by the unit.
    values: Vec<[[f32; C]; C]>,
    inverses: Vec<[[f32; C]; C]>,
    colours: Vec<Vec<u32>>,
    /// The two coarse nodes whose midpoint is a given node.
    parents: Vec<[u32; 2]>,
}

impl<'a, const C: usize> SparseLevel<'a, C> {
    /// The level of an assembled matrix; `parents` is empty on the coarsest one.
    pub(super) fn new(matrix: &'a BlockMatrix, parents: Vec<[u32; 2]>) -> Self {
        let count = matrix.nodes();
        let unit =
            (0..matrix.unknowns()).map(|i| matrix.diagonal(i)).fold(f64::MIN_POSITIVE, f64::max);
        let mut level = Self {
            matrix,
            unit,
            offsets: vec![0],
            columns: Vec::new(),
            values: Vec::new(),
            inverses: vec![[[0.0; C]; C]; count],
            colours: colours(matrix),
            parents,
        };
        for node in 0..count {
            for (&column, block) in
                matrix.neighbours(node).iter().zip(matrix.blocks(node).chunks_exact(C * C))
            {
                let scaled = |a: usize, b: usize| block[a * C + b] / unit;
                level.columns.push(column);
                level
                    .values
                    .push(std::array::from_fn(|a| std::array::from_fn(|b| scaled(a, b) as f32)));
                if column as usize == node {
                    let own = std::array::from_fn(|a| {
                        std::array::from_fn(|b| scaled(a.min(C - 1), b.min(C - 1)))
                    });
                    level.inverses[node] =
                        inverse_of::<C>(&own).map(|row| row.map(|value| value as f32));
                }
            }
            level.offsets.push(level.columns.len() as u32);
        }
        level
    }

    /// Σ over neighbours of K x (without the diagonal block of the node if `others`).
    fn row_sum(&self, node: usize, x: &[f32], others: bool) -> [f32; C] {
        let mut sum = [0.0; C];
        let entries = self.offsets[node] as usize..self.offsets[node + 1] as usize;
        for (&column, block) in self.columns[entries.clone()].iter().zip(&self.values[entries]) {
            let column = column as usize;
            if others && column == node {
                continue;
            }
            let x = &x[column * C..(column + 1) * C];
            for a in 0..C {
                for b in 0..C {
                    sum[a] += block[a][b] * x[b];
                }
            }
        }
        sum
    }

    /// The values at a node for which its residual vanishes.
    fn relaxed(&self, node: usize, x: &[f32], b: &[f32], fixed: &[bool]) -> [f32; C] {
        let sum = self.row_sum(node, x, true);
        let rest: [f32; C] = std::array::from_fn(|a| b[node * C + a] - sum[a]);
        let held: [bool; C] = std::array::from_fn(|a| fixed[node * C + a]);
        let mut value: [f32; C] = std::array::from_fn(|a| x[node * C + a]);
        if held.iter().all(|&held| !held) {
            let inverse = &self.inverses[node];
            value = std::array::from_fn(|a| (0..C).map(|c| inverse[a][c] * rest[c]).sum());
        } else if let Some(a) = (0..C).find(|&a| !held[a]) {
            // C = 2: the other one is held.
            let entries = self.offsets[node] as usize..self.offsets[node + 1] as usize;
            let own = entries
                .clone()
                .find(|&k| self.columns[k] as usize == node)
                .unwrap_or(entries.start);
            let (row, other) = (&self.values[own][a], C - 1 - a);
            value[a] = (rest[a] - row[other] * value[other]) / row[a];
        }
        value
    }
}

/// The nodes by colour: each node has the first colour that no preceding neighbour has.
fn colours(matrix: &BlockMatrix) -> Vec<Vec<u32>> {
    let mut colours: Vec<Vec<u32>> = Vec::new();
    let mut colour_of = vec![usize::MAX; matrix.nodes()];
    for node in 0..matrix.nodes() {
        let is_taken = |colour: usize| {
            matrix.neighbours(node).iter().any(|&n| colour_of[n as usize] == colour)
        };
        let colour = (0..colours.len()).find(|&colour| !is_taken(colour)).unwrap_or(colours.len());
        if colour == colours.len() {
            colours.push(Vec::new());
        }
        colours[colour].push(node as u32);
        colour_of[node] = colour;
    }
    colours
}

impl<const C: usize> Level for SparseLevel<'_, C> {
    fn unknowns(&self) -> usize {
        self.matrix.unknowns()
    }

    fn unit(&self) -> f64 {
        self.unit
    }

    fn place(&self, unknown: usize) -> usize {
        unknown
    }

    fn multiply(&self, x: &[f64], out: &mut [f64]) {
        self.matrix.multiply_into(x, out);
    }

    fn sweep(&self, x: &mut [f32], b: &[f32], fixed: &[bool], direction: Sweep) {
        let count = self.colours.len();
        for k in 0..count {
            let colour = &self.colours[if direction == Sweep::Forward { k } else { count - 1 - k }];
            if colour.len() <= GRAIN {
                for &node in colour {
                    let value = self.relaxed(node as usize, x, b, fixed);
                    x[node as usize * C..(node as usize + 1) * C].copy_from_slice(&value);
                }
                continue;
            }
            let parts: Vec<Vec<[f32; C]>> = colour
                .par_chunks(GRAIN)
                .map(|nodes| {
                    nodes.iter().map(|&node| self.relaxed(node as usize, x, b, fixed)).collect()
                })
                .collect();
            for (&node, value) in colour.iter().zip(parts.iter().flatten()) {
                x[node as usize * C..(node as usize + 1) * C].copy_from_slice(value);
            }
        }
    }

    fn residual(&self, x: &[f32], b: &[f32], out: &mut [f32]) {
        out.par_chunks_mut(C).enumerate().with_min_len(GRAIN).for_each(|(node, out)| {
            let sum = self.row_sum(node, x, false);
            for a in 0..C {
                out[a] = b[node * C + a] - sum[a];
            }
        });
    }

    fn restrict(&self, fine: &[f32], coarse: &mut [f32]) {
        coarse.fill(0.0);
        for (node, &[p, q]) in self.parents.iter().enumerate() {
            for a in 0..C {
                let half = 0.5 * fine[node * C + a];
                coarse[p as usize * C + a] += half;
                coarse[q as usize * C + a] += half;
            }
        }
    }

    fn prolong<T: Real>(&self, coarse: &[T], fine: &mut [T]) {
        let half = T::of(0.5);
        fine.par_chunks_mut(C).zip(&self.parents).with_min_len(GRAIN).for_each(
            |(fine, &[p, q])| {
                for a in 0..C {
                    fine[a] +=
                        half * coarse[p as usize * C + a] + half * coarse[q as usize * C + a];
                }
            },
        );
    }
}
