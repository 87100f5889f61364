//! The diagonal of a Gram matrix and its entries from neighbouring elements: a band with at most two
//! off-diagonals.

use super::dense::{diagonal_constant, diagonal_linear, neighbours_linear};
use crate::kernel::cells::CellPairs;
use crate::mesh::Mesh;
use crate::numeric::parallel;

/// Number of entries computed by one task.
const TOGETHER: usize = 64;

/// Number of rows from which threads are used.
const PARALLEL: usize = 1 << 14;

/// A symmetric band matrix: its diagonal and its off-diagonals.
pub(crate) struct Band {
    pub(crate) diagonal: Vec<f64>,
    off_diagonals: Vec<Vec<f64>>,
}

impl Band {
    /// The band for hat functions: all entries except those from pairs of elements that do not touch.
    pub(crate) fn linears(partition: &Mesh, cells: &CellPairs) -> Self {
        let lengths = partition.lengths();
        let n = lengths.len();
        Self {
            diagonal: parallel::map_together(n + 1, TOGETHER, &|i| {
                diagonal_linear(partition, cells, i)
            }),
            off_diagonals: vec![
                parallel::map_together(n, TOGETHER, &|i| neighbours_linear(partition, cells, i)),
                parallel::map_together(n - 1, TOGETHER, &|i| {
                    -2.0 * cells.touching(lengths[i], lengths[i + 1]).product
                }),
            ],
        }
    }

    /// The band for indicator functions.
    pub(crate) fn constants(partition: &Mesh, cells: &CellPairs) -> Self {
        let lengths = partition.lengths();
        let n = lengths.len();
        Self {
            diagonal: parallel::map_together(n, TOGETHER, &|i| {
                diagonal_constant(partition, cells, i)
            }),
            off_diagonals: vec![parallel::map_together(n - 1, TOGETHER, &|i| {
                -2.0 * cells.touching_constants(lengths[i], lengths[i + 1])
            })],
        }
    }

    /// The product of the band with x.
    pub(crate) fn times(&self, x: &[f64]) -> Vec<f64> {
        parallel::map_together(x.len(), PARALLEL, &|i| {
            let mut y = self.diagonal[i] * x[i];
            for (k, off) in self.off_diagonals.iter().enumerate() {
                let step = k + 1;
                if let (Some(a), Some(x)) = (off.get(i), x.get(i + step)) {
                    y += a * x;
                }
                if i >= step {
                    y += off[i - step] * x[i - step];
                }
            }
            y
        })
    }
}
