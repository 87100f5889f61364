//! Symmetric sparse matrices in node blocks: row i holds one block (components × components) for each neighbour of
//! node i.
//!
//! Unknown c of node i has the number i · components + c. Both triangles are stored, so products and eliminations
//! access rows only. A product costs two operations per entry and is parallel.

use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Rows handled by one task of a parallel product.
const CHUNK: usize = 4096;

/// A sparse matrix with one dense block per pair of neighbouring nodes.
#[derive(Debug, Clone)]
pub(crate) struct BlockMatrix {
    components: usize,
    offsets: Vec<usize>,
    columns: Vec<u32>,
    /// Blocks row by row, each in row-major order.
    values: Vec<f64>,
}

impl BlockMatrix {
    pub(crate) fn new(
        components: usize,
        offsets: Vec<usize>,
        columns: Vec<u32>,
        values: Vec<f64>,
    ) -> Self {
        Self { components, offsets, columns, values }
    }

    /// The matrix with the given entries of every row; a block with at least one entry is stored as a whole.
    pub(crate) fn of_rows(components: usize, rows: &[BTreeMap<usize, f64>]) -> Self {
        let c = components;
        let (mut offsets, mut columns, mut values) = (vec![0], Vec::new(), Vec::new());
        for block in rows.chunks_exact(c) {
            let neighbours: BTreeSet<usize> =
                block.iter().flat_map(|row| row.keys().map(|k| k / c)).collect();
            for node in neighbours {
                columns.push(node as u32);
                for row in block {
                    values.extend(
                        (node * c..(node + 1) * c).map(|k| row.get(&k).copied().unwrap_or(0.0)),
                    );
                }
            }
            offsets.push(columns.len());
        }
        Self { components, offsets, columns, values }
    }

    /// Number of unknowns per node.
    pub(crate) fn components(&self) -> usize {
        self.components
    }

    /// Number of nodes.
    pub(crate) fn nodes(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Number of unknowns.
    pub(crate) fn unknowns(&self) -> usize {
        self.nodes() * self.components
    }

    /// The neighbours of a node in ascending order, the node itself included.
    pub(crate) fn neighbours(&self, node: usize) -> &[u32] {
        &self.columns[self.offsets[node]..self.offsets[node + 1]]
    }

    /// The blocks of a node's rows, in the order of its neighbours, each in row-major order.
    pub(crate) fn blocks(&self, node: usize) -> &[f64] {
        let block = self.components * self.components;
        &self.values[self.offsets[node] * block..self.offsets[node + 1] * block]
    }

    /// The entries of row `unknown` as (column, value).
    pub(crate) fn row(&self, unknown: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let c = self.components;
        let (node, a) = (unknown / c, unknown % c);
        (self.offsets[node]..self.offsets[node + 1]).flat_map(move |k| {
            let column = self.columns[k] as usize * c;
            (0..c).map(move |b| (column + b, self.values[(k * c + a) * c + b]))
        })
    }

    /// The diagonal entry of row `unknown`.
    pub(crate) fn diagonal(&self, unknown: usize) -> f64 {
        let found = self.row(unknown).find(|&(column, _)| column == unknown);
        found.map_or(0.0, |(_, value)| value)
    }

    /// The product K x.
    pub(crate) fn multiply(&self, x: &[f64]) -> Vec<f64> {
        self.map_rows(|column, value| value * x[column])
    }

    /// out ← K x.
    pub(crate) fn multiply_into(&self, x: &[f64], out: &mut [f64]) {
        match self.components {
            1 => self.multiply_blocks::<1>(x, out),
            _ => self.multiply_blocks::<2>(x, out),
        }
    }

    fn multiply_blocks<const C: usize>(&self, x: &[f64], out: &mut [f64]) {
        out.par_chunks_mut(C).enumerate().with_min_len(CHUNK).for_each(|(node, out)| {
            let mut sum = [0.0; C];
            for (&column, block) in
                self.neighbours(node).iter().zip(self.blocks(node).chunks_exact(C * C))
            {
                let x = &x[column as usize * C..(column as usize + 1) * C];
                for a in 0..C {
                    for b in 0..C {
                        sum[a] += block[a * C + b] * x[b];
                    }
                }
            }
            out.copy_from_slice(&sum);
        });
    }

    /// The product |K| |x|: the size of the terms in every row of K x.
    ///
    /// The rounding error of each entry of K x is at most a small multiple of ε times this number.
    pub(crate) fn multiply_absolute(&self, x: &[f64]) -> Vec<f64> {
        self.map_rows(|column, value| (value * x[column]).abs())
    }

    fn map_rows(&self, term: impl Fn(usize, f64) -> f64 + Sync) -> Vec<f64> {
        let mut sums = vec![0.0; self.unknowns()];
        sums.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, sums)| {
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum = self.row(chunk * CHUNK + k).map(|(column, value)| term(column, value)).sum();
            }
        });
        sums
    }
}
