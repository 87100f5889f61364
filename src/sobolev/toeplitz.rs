//! y = A x on uniform meshes by the fast Fourier transform.
//!
//! On elements of equal length the entries of two hats (or indicators) that are apart depend on i − j alone; the half hats at
//! the two ends have rows of their own; the diagonal and its neighbours feel the distance to the ends and are kept as they are.
//! The Toeplitz part is embedded in a circulant of length 2^a or 3·2^a (two real FFTs). Setup O(N) integrals; product
//! O(N log N), memory about 10 N numbers.

use super::cells::CellPairs;
use super::partition::{Partition, RunningSum};
use crate::error::{Error, Result};
use rayon::prelude::*;
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use std::sync::{Arc, Mutex};

/// The part of a Gram matrix on a uniform mesh that lies off its band.
pub(crate) struct Toeplitz {
    /// eigenvalues of the circulant, divided by its length
    symbol: Vec<Complex<f64>>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    length: usize,
    /// number of unknowns
    size: usize,
    /// row of the first half hat; mirrored, of the last. Empty for constants.
    end_row: Vec<f64>,
    /// buffers of finished products, for the next one
    workspaces: Mutex<Vec<Workspace>>,
}

/// Buffers of one product.
struct Workspace {
    signal: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl Toeplitz {
    /// Entries −2 ∫∫ over separate cells, for hats.
    pub(crate) fn linears(partition: &Partition, cells: &CellPairs, h: f64) -> Result<Self> {
        let n = partition.len();
        let gaps = multiples(h, n);
        // pairs[k]: two cells with k cells between them; the touching pair counts in the band
        let pairs: Vec<[[f64; 2]; 2]> = (0..n.saturating_sub(1))
            .into_par_iter()
            .map(|k| if k == 0 { [[0.0; 2]; 2] } else { cells.separate(h, h, gaps[k]) })
            .collect();
        let at = |k: usize, a: usize, b: usize| pairs.get(k).map_or(0.0, |pair| pair[a][b]);
        // Node 0 has only the cell on its right, where its hat is the far one.
        let end_row: Vec<f64> = (0..=n)
            .map(|j| match j {
                0 | 1 => 0.0,
                _ if j == n => -2.0 * at(j - 2, 1, 1),
                _ => -2.0 * (at(j - 2, 1, 1) + at(j - 1, 1, 0)),
            })
            .collect();
        let inner: Vec<f64> = (0..=n)
            .map(|k| match k {
                0 => 0.0,
                1 => -2.0 * at(1, 0, 0),
                _ => -2.0 * (at(k - 2, 1, 1) + at(k - 1, 0, 1) + at(k - 1, 1, 0) + at(k, 0, 0)),
            })
            .collect();
        // The row of node 0 has no entry from two cells around node 1 but the ones above.
        Self::embed(&inner, end_row)
    }

    /// Entries −2 ∫∫ over separate cells, for indicator functions.
    pub(crate) fn constants(partition: &Partition, cells: &CellPairs, h: f64) -> Result<Self> {
        let n = partition.len();
        let gaps = multiples(h, n);
        let column: Vec<f64> = (0..n)
            .into_par_iter()
            .map(|k| if k < 2 { 0.0 } else { -2.0 * cells.separate_constants(h, h, gaps[k - 1]) })
            .collect();
        Self::embed(&column, Vec::new())
    }

    fn embed(column: &[f64], end_row: Vec<f64>) -> Result<Self> {
        let size = column.len();
        let length = smooth_length(2 * size);
        let mut circulant = vec![0.0; length];
        for (k, &entry) in column.iter().enumerate() {
            circulant[k] = entry / length as f64;
            if k > 0 {
                circulant[length - k] = entry / length as f64;
            }
        }
        let mut planner = RealFftPlanner::new();
        let forward = planner.plan_fft_forward(length);
        let inverse = planner.plan_fft_inverse(length);
        let mut symbol = forward.make_output_vec();
        forward.process(&mut circulant, &mut symbol).map_err(fourier)?;
        Ok(Self { symbol, forward, inverse, length, size, end_row, workspaces: Mutex::new(Vec::new()) })
    }

    /// y += off-band part of A x.
    pub(crate) fn add(&self, x: &[f64], y: &mut [f64]) -> Result<()> {
        let mut space = self.workspace();
        let outcome = self.transform(x, y, &mut space);
        if let Ok(mut free) = self.workspaces.lock() {
            free.push(space);
        }
        outcome
    }

    fn workspace(&self) -> Workspace {
        let free = self.workspaces.lock().ok().and_then(|mut free| free.pop());
        free.unwrap_or_else(|| Workspace {
            signal: vec![0.0; self.length],
            spectrum: self.forward.make_output_vec(),
            scratch: vec![
                Complex::default();
                self.forward.get_scratch_len().max(self.inverse.get_scratch_len())
            ],
        })
    }

    fn transform(&self, x: &[f64], y: &mut [f64], space: &mut Workspace) -> Result<()> {
        let Workspace { signal, spectrum, scratch } = space;
        signal[..self.size].copy_from_slice(x);
        signal[self.size..].fill(0.0);
        let last = self.size - 1;
        if !self.end_row.is_empty() {
            (signal[0], signal[last]) = (0.0, 0.0);
        }
        self.forward.process_with_scratch(signal, spectrum, scratch).map_err(fourier)?;
        spectrum.iter_mut().zip(&self.symbol).for_each(|(a, b)| *a *= b);
        self.inverse.process_with_scratch(spectrum, signal, scratch).map_err(fourier)?;
        if self.end_row.is_empty() {
            y.iter_mut().zip(signal.iter()).for_each(|(y, s)| *y += s);
            return Ok(());
        }
        let (mut first, mut final_row) = (RunningSum::default(), RunningSum::default());
        for j in 1..last {
            y[j] += signal[j] + self.end_row[j] * x[0] + self.end_row[last - j] * x[last];
            first.add(self.end_row[j] * x[j]);
            final_row.add(self.end_row[last - j] * x[j]);
        }
        y[0] += first.value() + self.end_row[last] * x[last];
        y[last] += final_row.value() + self.end_row[last] * x[0];
        Ok(())
    }

    pub(crate) fn bytes(&self) -> usize {
        16 * self.symbol.len() + 8 * self.end_row.len()
    }
}

/// h, 2h, ... as sums.
fn multiples(h: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|k| k as f64 * h).collect()
}

/// The smallest 2^a or 3·2^a that is at least n: lengths for which every stage is a fast one.
fn smooth_length(n: usize) -> usize {
    let power = n.next_power_of_two().max(4);
    let with_three = power / 4 * 3;
    if with_three >= n { with_three } else { power }
}

/// Buffers come from the plans themselves; a wrong length would be theirs.
fn fourier(error: realfft::FftError) -> Error {
    let (expected, given) = match error {
        realfft::FftError::InputBuffer(expected, given)
        | realfft::FftError::OutputBuffer(expected, given)
        | realfft::FftError::ScratchBuffer(expected, given) => (expected, given),
        realfft::FftError::InputValues(..) => (0, 0),
    };
    Error::LengthMismatch { name: "Fourier buffer", given, expected }
}
