//! Products with symmetric circulants, by a single real transform if it fits into the cache, otherwise by
//! blocks ([`super::six_step`]).

use super::six_step::{SixStep, SixStepWorkspace};
use crate::error::{Error, Result};
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use std::sync::{Arc, Mutex};

/// Length from which transforms are blocked.
const BLOCKED: usize = 1 << 18;

/// A symmetric circulant in which a symmetric Toeplitz matrix is embedded.
pub(crate) struct Circulant {
    transform: Transform,
    length: usize,
    /// buffers that finished products leave for the next one
    workspaces: Mutex<Vec<Workspace>>,
}

enum Transform {
    Plain(Plain),
    Blocked(SixStep),
}

struct Plain {
    /// eigenvalues, divided by the length of the circulant
    symbol: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

/// Buffers of one product.
enum Workspace {
    Plain { signal: Vec<f64>, spectrum: Vec<Complex<f64>>, scratch: Vec<Complex<f64>> },
    Blocked(SixStepWorkspace),
}

impl Circulant {
    /// The circulant for the symmetric Toeplitz matrix with the given first column.
    pub(crate) fn new(column: &[f64]) -> Result<Self> {
        let least = 2 * column.len();
        if smooth_length(least) < BLOCKED {
            Self::plain(column, smooth_length(least))
        } else {
            Self::blocked(column, SixStep::length(least))
        }
    }

    fn plain(column: &[f64], length: usize) -> Result<Self> {
        let mut planner = RealFftPlanner::new();
        let symbol = eigenvalues(column, length)?.iter().map(|s| s / length as f64).collect();
        let plain = Plain {
            symbol,
            forward: planner.plan_fft_forward(length),
            inverse: planner.plan_fft_inverse(length),
        };
        Ok(Self { transform: Transform::Plain(plain), length, workspaces: Mutex::new(Vec::new()) })
    }

    fn blocked(column: &[f64], length: usize) -> Result<Self> {
        let six_step = SixStep::new(&eigenvalues(column, length)?);
        Ok(Self {
            transform: Transform::Blocked(six_step),
            length,
            workspaces: Mutex::new(Vec::new()),
        })
    }

    /// Adds the product with the Toeplitz matrix: y += T x.
    pub(crate) fn add(&self, x: &[f64], y: &mut [f64]) -> Result<()> {
        let free = self.workspaces.lock().ok().and_then(|mut free| free.pop());
        let mut space = free.unwrap_or_else(|| self.workspace());
        match (&self.transform, &mut space) {
            (Transform::Blocked(six_step), Workspace::Blocked(space)) => six_step.add(x, y, space),
            (Transform::Plain(plain), Workspace::Plain { signal, spectrum, scratch }) => {
                signal[..x.len()].copy_from_slice(x);
                signal[x.len()..].fill(0.0);
                plain.forward.process_with_scratch(signal, spectrum, scratch).map_err(fourier)?;
                spectrum.iter_mut().zip(&plain.symbol).for_each(|(a, b)| *a *= b);
                plain.inverse.process_with_scratch(spectrum, signal, scratch).map_err(fourier)?;
                y.iter_mut().zip(signal.iter()).for_each(|(y, s)| *y += s);
            }
            // A workspace is made by the transform that takes it.
            _ => {
                return Err(Error::Solver {
                    reason: "Fourier transform: the length of a buffer is wrong".to_owned(),
                });
            }
        }
        if let Ok(mut free) = self.workspaces.lock() {
            free.push(space);
        }
        Ok(())
    }

    fn workspace(&self) -> Workspace {
        match &self.transform {
            Transform::Blocked(six_step) => Workspace::Blocked(six_step.workspace()),
            Transform::Plain(plain) => Workspace::Plain {
                signal: vec![0.0; self.length],
                spectrum: plain.forward.make_output_vec(),
                scratch: vec![
                    Complex::default();
                    plain.forward.get_scratch_len().max(plain.inverse.get_scratch_len())
                ],
            },
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
    let forward = RealFftPlanner::new().plan_fft_forward(length);
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
fn fourier(error: realfft::FftError) -> Error {
    Error::Solver { reason: format!("Fourier transform: {error}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each product takes two transforms with a rounding error of ε log₂ n.
    const TRANSFORM_TOLERANCE: f64 = 1e-13;

    #[test]
    fn blocked_and_plain_products_agree() {
        // circulants of length 2^18, of 2^a 3^b 5^c, and as short as the blocks allow
        for size in [1 << 17, 100_003, 77_777, 1000, 40] {
            let column: Vec<f64> = (0..size).map(|k| 1.0 / (1.0 + k as f64).powf(1.3)).collect();
            let x: Vec<f64> = (0..size).map(|k| (0.37 * (k * k % 10_007) as f64).sin()).collect();
            let plain = Circulant::plain(&column, smooth_length(2 * size)).unwrap();
            let blocked = Circulant::blocked(&column, SixStep::length(2 * size)).unwrap();
            let (mut a, mut b) = (vec![1.0; size], vec![1.0; size]);
            for _ in 0..2 {
                plain.add(&x, &mut a).unwrap();
                blocked.add(&x, &mut b).unwrap();
            }
            let largest = a.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let worst = a.iter().zip(&b).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            println!("{size}: {:.1e}", worst / largest);
            assert!(
                worst <= TRANSFORM_TOLERANCE * largest,
                "{size}: {worst:e} against {largest:e}"
            );
        }
    }
}
