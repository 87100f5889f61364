//! Products with symmetric circulants, by one real Fourier transform.

use crate::error::{Error, Result};
use fractional_sobolev_numeric::transforms::{
    Complex, ComplexToReal, FftError, Planner, RealToComplex,
};
use std::sync::{Arc, Mutex};

/// A symmetric circulant in which a symmetric Toeplitz matrix is embedded.
pub(crate) struct Circulant {
    /// eigenvalues, divided by the length of the circulant
    symbol: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    /// buffers that finished products leave for the next one
    workspaces: Mutex<Vec<Workspace>>,
}

/// Buffers of one product.
struct Workspace {
    signal: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl Circulant {
    /// The circulant for the symmetric Toeplitz matrix with the given first column.
    pub(crate) fn new(column: &[f64]) -> Result<Self> {
        let length = smooth_length(2 * column.len());
        let mut planner = Planner::default();
        let symbol = eigenvalues(column, length)?.iter().map(|s| s / length as f64).collect();
        Ok(Self {
            symbol,
            forward: planner.forward(length),
            inverse: planner.inverse(length),
            workspaces: Mutex::new(Vec::new()),
        })
    }

    /// Adds the product with the Toeplitz matrix: y += T x.
    pub(crate) fn add(&self, x: &[f64], y: &mut [f64]) -> Result<()> {
        let free = self.workspaces.lock().ok().and_then(|mut free| free.pop());
        let mut space = free.unwrap_or_else(|| self.workspace());
        let Workspace { signal, spectrum, scratch } = &mut space;
        signal[..x.len()].copy_from_slice(x);
        signal[x.len()..].fill(0.0);
        self.forward.process_with_scratch(signal, spectrum, scratch).map_err(fourier)?;
        spectrum.iter_mut().zip(&self.symbol).for_each(|(a, b)| *a *= b);
        self.inverse.process_with_scratch(spectrum, signal, scratch).map_err(fourier)?;
        y.iter_mut().zip(signal.iter()).for_each(|(y, s)| *y += s);
        if let Ok(mut free) = self.workspaces.lock() {
            free.push(space);
        }
        Ok(())
    }

    fn workspace(&self) -> Workspace {
        let scratch = self.forward.get_scratch_len().max(self.inverse.get_scratch_len());
        Workspace {
            signal: self.inverse.make_output_vec(),
            spectrum: self.forward.make_output_vec(),
            scratch: vec![Complex::default(); scratch],
        }
    }
}

/// The eigenvalues S_0 ..= S_{length/2} of the circulant that extends the column symmetrically.
fn eigenvalues(column: &[f64], length: usize) -> Result<Vec<f64>> {
    let mut circulant = vec![0.0; length];
    for (k, &entry) in column.iter().enumerate() {
        circulant[k] = entry;
        if k > 0 {
            circulant[length - k] = entry;
        }
    }
    let forward = Planner::default().forward(length);
    let mut symbol = forward.make_output_vec();
    forward.process(&mut circulant, &mut symbol).map_err(fourier)?;
    // Symmetric, hence real: imaginary parts are rounding.
    Ok(symbol.iter().map(|s| s.re).collect())
}

/// The smallest 2^a or 3·2^a that is at least n: for these lengths all stages are fast.
fn smooth_length(n: usize) -> usize {
    let power = n.next_power_of_two().max(4);
    let with_three = power / 4 * 3;
    if with_three >= n { with_three } else { power }
}

/// The error of a transform: buffers of a wrong length (impossible, since the plans allocate them) or values
/// that are not finite.
fn fourier(error: FftError) -> Error {
    Error::Solver { reason: format!("Fourier transform: {error}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each product takes two transforms with a rounding error of ε log₂ n.
    const TRANSFORM_TOLERANCE: f64 = 1e-13;

    #[test]
    fn products_are_the_sums_of_their_rows() {
        for size in [1 << 17, 100_003, 1000, 40, 1] {
            let column: Vec<f64> = (0..size).map(|k| 1.0 / (1.0 + k as f64).powf(1.3)).collect();
            let x: Vec<f64> = (0..size).map(|k| (0.37 * (k * k % 10_007) as f64).sin()).collect();
            let circulant = Circulant::new(&column).unwrap();
            let mut y = vec![1.0; size];
            // the second product takes the buffers of the first
            circulant.add(&x, &mut y).unwrap();
            circulant.add(&x, &mut y).unwrap();
            let largest = y.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            for row in (0..size).step_by(size.div_ceil(40)).chain([size - 1]) {
                let sum: f64 = (0..size).map(|j| column[row.abs_diff(j)] * x[j]).sum();
                let off = (y[row] - 1.0 - 2.0 * sum).abs();
                assert!(off <= TRANSFORM_TOLERANCE * largest, "{size}, row {row}: {off:e}");
            }
        }
    }
}
