//! Convolutions on a rectangle of cells by Fourier transforms on a torus of at least twice its size.

use crate::numeric::{is_smooth, parallel};
use rustfft::num_complex::Complex64;
use rustfft::{Fft, FftPlanner};
use std::sync::Arc;

/// The torus; its lengths have no prime factors above 5.
pub(super) struct Torus {
    size: [usize; 2],
    forward: [Arc<dyn Fft<f64>>; 2],
    backward: [Arc<dyn Fft<f64>>; 2],
}

/// Transforms, stored with the second index of the torus first.
pub(super) type Spectrum = Vec<Complex64>;

impl Torus {
    /// The torus for offsets −n₁ < i < n₁, −n₂ < j < n₂.
    pub(super) fn new(cells: [usize; 2]) -> Self {
        let size = cells.map(|n| smooth(2 * n - 1));
        let mut planner = FftPlanner::new();
        let forward = size.map(|n| planner.plan_fft_forward(n));
        Self { size, forward, backward: size.map(|n| planner.plan_fft_inverse(n)) }
    }

    /// The transform of a field given by rows of the second index; two real fields may be combined as real and
    /// imaginary part.
    pub(super) fn transform(&self, mut field: Vec<Complex64>, rows: usize) -> Spectrum {
        let [n, m] = self.size;
        let used = rows.min(m) * n;
        parallel::pieces(&mut field[..used], n, &|_, row| self.forward[0].process(row));
        let mut turned = turn(&field, n, m);
        parallel::pieces(&mut turned, m, &|_, column| self.forward[1].process(column));
        turned
    }

    /// The first `rows` rows of the inverse transform.
    pub(super) fn back(&self, mut spectrum: Spectrum, rows: usize) -> Vec<Complex64> {
        let [n, m] = self.size;
        parallel::pieces(&mut spectrum, m, &|_, column| self.backward[1].process(column));
        let mut field = turn(&spectrum, m, n);
        let over = 1.0 / (n * m) as f64;
        parallel::pieces(&mut field[..rows * n], n, &|_, row| {
            self.backward[0].process(row);
            row.iter_mut().for_each(|value| *value *= over);
        });
        field
    }

    pub(super) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// A field of zeros.
    pub(super) fn zeros(&self) -> Vec<Complex64> {
        vec![Complex64::default(); self.size[0] * self.size[1]]
    }

    /// The index of an offset in a field.
    pub(super) fn at(&self, offset: [i64; 2]) -> usize {
        let [i, j] = [0, 1].map(|k| offset[k].rem_euclid(self.size[k] as i64) as usize);
        j * self.size[0] + i
    }
}

/// The transpose of a field of m rows of length n.
fn turn(field: &[Complex64], n: usize, m: usize) -> Vec<Complex64> {
    const BLOCK: usize = 32;
    let mut turned = vec![Complex64::default(); n * m];
    parallel::pieces(&mut turned, BLOCK * m, &|block, rows| {
        for j in (0..m).step_by(BLOCK) {
            for (i, row) in rows.chunks_mut(m).enumerate() {
                let from = block * BLOCK + i;
                (j..(j + BLOCK).min(m)).for_each(|j| row[j] = field[j * n + from]);
            }
        }
    });
    turned
}

/// The smallest number from n upwards without prime factors above 5.
fn smooth(n: usize) -> usize {
    (n.max(1)..).find(|&n| is_smooth(n)).unwrap_or(n)
}
