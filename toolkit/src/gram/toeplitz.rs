//! Products y = A x on uniform meshes by the fast Fourier transform.
//!
//! On elements of equal length the entries of two separate hat functions (or indicator functions) depend only
//! on i − j; the half hat functions at the two ends have separate rows; the diagonal and its neighbours depend
//! on the distance to the ends and are stored. The Toeplitz part is embedded in a circulant
//! ([`super::circulant`]). The setup takes O(N) integrals, a product O(N log N) operations; memory: about 2 N
//! numbers, and up to 8 N for the buffers of a product.

use super::circulant::Circulant;
use crate::error::Result;
use crate::kernel::cells::CellPairs;
use crate::mesh::Mesh;
use crate::numeric::parallel;
use crate::numeric::sum::RunningSum;
use rayon::prelude::*;

/// Number of entries of an end row summed by one thread without compensation; the sums of the pieces are
/// compensated.
const PIECE: usize = 1 << 12;

/// The part of a Gram matrix on a uniform mesh outside its band.
pub(crate) struct Toeplitz {
    /// circulant of the inner hat functions, or of all indicator functions
    circulant: Circulant,
    /// row of the first half hat function, mirrored for the last one; empty for constants
    end_row: Vec<f64>,
}

impl Toeplitz {
    /// The entries −2 ∫∫ over separate cells, for hat functions.
    pub(crate) fn linears(partition: &Mesh, cells: &CellPairs, h: f64) -> Result<Self> {
        let n = partition.len();
        let gaps = multiples(h, n);
        // pairs[k]: two cells with k cells between them; the touching pair counts in the band
        let pairs: Vec<[[f64; 2]; 2]> = parallel::map(n.saturating_sub(1), &|k| {
            if k == 0 { [[0.0; 2]; 2] } else { cells.separate(h, h, gaps[k]) }
        });
        let at = |k: usize, a: usize, b: usize| pairs.get(k).map_or(0.0, |pair| pair[a][b]);
        // Node 0 has only the cell on its right, where its hat is the far one.
        let end_row: Vec<f64> = (0..=n)
            .map(|j| match j {
                0 | 1 => 0.0,
                _ if j == n => -2.0 * at(j - 2, 1, 1),
                _ => -2.0 * (at(j - 2, 1, 1) + at(j - 1, 1, 0)),
            })
            .collect();
        let inner: Vec<f64> = (0..n - 1)
            .map(|k| match k {
                0 => 0.0,
                1 => -2.0 * at(1, 0, 0),
                _ => -2.0 * (at(k - 2, 1, 1) + at(k - 1, 0, 1) + at(k - 1, 1, 0) + at(k, 0, 0)),
            })
            .collect();
        // The row of node 0 has no entry from two cells around node 1 but the ones above.
        Ok(Self { circulant: Circulant::new(&inner)?, end_row })
    }

    /// The entries −2 ∫∫ over separate cells, for indicator functions.
    pub(crate) fn constants(partition: &Mesh, cells: &CellPairs, h: f64) -> Result<Self> {
        let n = partition.len();
        let gaps = multiples(h, n);
        let column: Vec<f64> = parallel::map(n, &|k| {
            if k < 2 { 0.0 } else { -2.0 * cells.separate_constants(h, h, gaps[k - 1]) }
        });
        Ok(Self { circulant: Circulant::new(&column)?, end_row: Vec::new() })
    }

    /// Adds the part of A x outside the band to y.
    pub(crate) fn add(&self, x: &[f64], y: &mut [f64]) -> Result<()> {
        if self.end_row.is_empty() {
            return self.circulant.add(x, y);
        }
        let last = x.len() - 1;
        self.circulant.add(&x[1..last], &mut y[1..last])?;
        let sums: Vec<[f64; 2]> = y[1..last]
            .par_chunks_mut(PIECE)
            .enumerate()
            .map(|(piece, y)| {
                let from = 1 + piece * PIECE;
                let (left, mirrored) = (&self.end_row[from..], &self.end_row[..=last - from]);
                let (mut first, mut final_row) = (0.0, 0.0);
                for (((y, x_j), a), b) in
                    y.iter_mut().zip(&x[from..]).zip(left).zip(mirrored.iter().rev())
                {
                    *y += a * x[0] + b * x[last];
                    first += a * x_j;
                    final_row += b * x_j;
                }
                [first, final_row]
            })
            .collect();
        let mut ends = [RunningSum::default(); 2];
        for [first, final_row] in sums {
            ends[0].add(first);
            ends[1].add(final_row);
        }
        y[0] += ends[0].value() + self.end_row[last] * x[last];
        y[last] += ends[1].value() + self.end_row[last] * x[0];
        Ok(())
    }
}

/// The multiples h, 2h, ... as sums.
fn multiples(h: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|k| k as f64 * h).collect()
}
