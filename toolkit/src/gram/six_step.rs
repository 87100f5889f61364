//! Products with long symmetric circulants, by a blocked transform that works within the cache.
//!
//! y = C x, C of even length 2n with eigenvalues S_k = S_{2n−k} (real, since C is symmetric). Even and odd
//! samples are packed, z_j = x_{2j} + i x_{2j+1}, and with Z the transform of z, w = e^{−πik/n}, E = (Z_k +
//! Z̄_{n−k})/2, O = (Z_k − Z̄_{n−k})/(2i), the product is Z_k ← P_k Z_k + Q_k (w O + i w̄ E),  P_k = (S_k +
//! S_{n+k})/2 = P_{n−k},  Q_k = (S_k − S_{n+k})/2 = −Q_{n−k}.
//!
//! Z itself is Bailey's transform (FFTs in external or hierarchical memory, J. Supercomputing 4 (1990)
//! 23-35): with n = n₁n₂, j = j₁n₂ + j₂, k = k₁ + n₁k₂, Z_k = Σ_{j₂} e^{−2πi j₂k₂/n₂} [ e^{−2πi j₂k₁/n}
//! Σ_{j₁} z_j e^{−2πi j₁k₁/n₁} ]. Three passes over memory: columns (eight at a time, transposed into a
//! buffer) with the twiddles; pairs of rows k₁, n₁−k₁, each transformed, multiplied and transformed back
//! while in the cache; columns backwards. Nothing is reordered in between, since a product does not depend
//! on the order of the frequencies. Twiddles are products of two factors from tables of O(√n). Cost O(n log
//! n), memory about 5n numbers with the buffers of a product.

use crate::numeric::{is_smooth, parallel};
use rayon::prelude::*;
use realfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Number of columns in a block: 128 contiguous bytes, two cache lines.
const BLOCK: usize = 8;

type C = Complex<f64>;

/// e^{−2πim/n} for all m < n, as products of two factors.
struct Roots {
    fine: Vec<C>,
    coarse: Vec<C>,
}

impl Roots {
    fn new(n: usize) -> Self {
        let step = (n as f64).sqrt().ceil() as usize;
        Self {
            fine: (0..step).map(|m| root(m, n)).collect(),
            coarse: (0..n.div_ceil(step)).map(|m| root(m * step, n)).collect(),
        }
    }

    fn at(&self, m: usize) -> C {
        let step = self.fine.len();
        self.coarse[m / step] * self.fine[m % step]
    }
}

/// e^{−2πim/n}, 0 ≤ m < n.
fn root(m: usize, n: usize) -> C {
    let turned = if 2 * m > n { m as f64 - n as f64 } else { m as f64 };
    let (sine, cosine) = (TAU * turned / n as f64).sin_cos();
    Complex::new(cosine, -sine)
}

/// A symmetric circulant of length 2 n₁ n₂.
pub(crate) struct SixStep {
    /// n₁, a power of two
    rows: usize,
    /// n₂, a multiple of the block size
    columns: usize,
    column_forward: Arc<dyn Fft<f64>>,
    column_inverse: Arc<dyn Fft<f64>>,
    row_forward: Arc<dyn Fft<f64>>,
    row_inverse: Arc<dyn Fft<f64>>,
    roots: Roots,
    /// e^{−πi k₁/n}, k₁ < n₁, and e^{−πi k₂/n₂}, k₂ < n₂, the products of which are w
    packing: (Vec<C>, Vec<C>),
    /// (P, Q)/n of the rows k₁ ≤ n₁/2
    symbol: Vec<[f64; 2]>,
}

/// Buffers of one product: blocks of columns and pairs of rows.
pub(crate) struct SixStepWorkspace {
    blocks: Vec<C>,
    pairs: Vec<C>,
}

/// (n₁, n₂) with n₁ n₂ ≥ n and n₁ close to n₂.
fn shape(n: usize) -> (usize, usize) {
    let rows = ((n as f64).sqrt() as usize).next_power_of_two().max(2);
    let mut blocks = n.div_ceil(rows).div_ceil(BLOCK);
    while !is_smooth(blocks) {
        blocks += 1;
    }
    (rows, BLOCK * blocks)
}

impl SixStep {
    /// The length 2 n₁ n₂ of a circulant, at least `least`.
    pub(crate) fn length(least: usize) -> usize {
        let (rows, columns) = shape(least.div_ceil(2));
        2 * rows * columns
    }

    /// The circulant with eigenvalues S_0 ..= S_n and a length given by [`SixStep::length`].
    pub(crate) fn new(eigenvalues: &[f64]) -> Self {
        let n = eigenvalues.len() - 1;
        let (rows, columns) = shape(n);
        let mut planner = FftPlanner::new();
        let mut symbol = Vec::with_capacity((rows / 2 + 1) * columns);
        for row in 0..=rows / 2 {
            for column in 0..columns {
                // S_{n+k} = S_{n−k}
                let (k, scale) = (row + rows * column, 0.5 / n as f64);
                let (low, high) = (eigenvalues[k], eigenvalues[n - k]);
                symbol.push([scale * (low + high), scale * (low - high)]);
            }
        }
        Self {
            rows,
            columns,
            column_forward: planner.plan_fft_forward(rows),
            column_inverse: planner.plan_fft_inverse(rows),
            row_forward: planner.plan_fft_forward(columns),
            row_inverse: planner.plan_fft_inverse(columns),
            roots: Roots::new(n),
            packing: (
                (0..rows).map(|k| root(k, 2 * n)).collect(),
                (0..columns).map(|k| root(k, 2 * columns)).collect(),
            ),
            symbol,
        }
    }

    pub(crate) fn workspace(&self) -> SixStepWorkspace {
        let n = self.rows * self.columns;
        SixStepWorkspace { blocks: vec![C::default(); n], pairs: vec![C::default(); n] }
    }

    /// Adds the first entries of C x to y, where x is extended by zeros; neither is longer than the circulant.
    pub(crate) fn add(&self, x: &[f64], y: &mut [f64], space: &mut SixStepWorkspace) {
        self.columns_forward(x, &mut space.blocks);
        self.rows_there_and_back(&space.blocks, &mut space.pairs);
        self.columns_backward(&space.pairs, &mut space.blocks);
        let blocks = &space.blocks;
        parallel::pieces(y, 2 * self.columns, &|row, y| {
            for (block, y) in y.chunks_mut(2 * BLOCK).enumerate() {
                let from = (block * self.rows + row) * BLOCK;
                for (y, z) in y.chunks_mut(2).zip(&blocks[from..from + BLOCK]) {
                    y.iter_mut().zip([z.re, z.im]).for_each(|(y, z)| *y += z);
                }
            }
        });
    }

    /// A buffer for the lines of a block, and scratch space.
    fn line_buffers(&self, plan: &Arc<dyn Fft<f64>>, lines: usize) -> (Vec<C>, Vec<C>) {
        (vec![C::default(); lines], vec![C::default(); plan.get_inplace_scratch_len()])
    }

    /// blocks\[b\]\[k₁\]\[c\] ← the transforms, multiplied by the twiddle factors, of the columns j₂ = 8b + c.
    fn columns_forward(&self, x: &[f64], blocks: &mut [C]) {
        let (rows, plan) = (self.rows, &self.column_forward);
        blocks.par_chunks_mut(rows * BLOCK).enumerate().with_min_len(8).for_each_init(
            || self.line_buffers(plan, rows * BLOCK),
            |(lines, scratch), (b, block)| {
                for row in 0..rows {
                    let from = (2 * (row * self.columns + b * BLOCK)).min(x.len());
                    let samples = &x[from..(from + 2 * BLOCK).min(x.len())];
                    for c in 0..BLOCK {
                        let sample = |k: usize| samples.get(k).copied().unwrap_or(0.0);
                        lines[c * rows + row] = Complex::new(sample(2 * c), sample(2 * c + 1));
                    }
                }
                plan.process_with_scratch(lines, scratch);
                for (c, line) in lines.chunks_mut(rows).enumerate() {
                    self.twiddle(b * BLOCK + c, line, |z, factor| z * factor);
                }
                for (row, block) in block.chunks_exact_mut(BLOCK).enumerate() {
                    block.iter_mut().enumerate().for_each(|(c, z)| *z = lines[c * rows + row]);
                }
            },
        );
    }

    /// Applies the factors e^{−2πi j₂k₁/n} to column j₂.
    fn twiddle(&self, column: usize, line: &mut [C], apply: impl Fn(C, C) -> C) {
        let run = line.len().min(32);
        let fine: Vec<C> = (0..run).map(|k| self.roots.at(column * k)).collect();
        for (part, line) in line.chunks_mut(run).enumerate() {
            let coarse = self.roots.at(column * part * run);
            line.iter_mut().zip(&fine).for_each(|(z, f)| *z = apply(*z, coarse * f));
        }
    }

    /// The position of row k₁ among the pairs: 0 and n₁/2 first, then 1, n₁−1, 2, n₁−2, ...
    fn place(&self, row: usize) -> usize {
        match row {
            0 => 0,
            _ if 2 * row == self.rows => 1,
            _ if 2 * row < self.rows => 2 * row,
            _ => 2 * (self.rows - row) + 1,
        }
    }

    fn rows_there_and_back(&self, blocks: &[C], pairs: &mut [C]) {
        let (rows, columns) = (self.rows, self.columns);
        let scratch = self
            .row_forward
            .get_inplace_scratch_len()
            .max(self.row_inverse.get_inplace_scratch_len());
        pairs.par_chunks_mut(2 * columns).enumerate().with_min_len(8).for_each_init(
            || vec![C::default(); scratch],
            |scratch, (p, pair)| {
                let chosen = if p == 0 { [0, rows / 2] } else { [p, rows - p] };
                for (row, line) in chosen.into_iter().zip(pair.chunks_exact_mut(columns)) {
                    for (b, line) in line.chunks_exact_mut(BLOCK).enumerate() {
                        let from = (b * rows + row) * BLOCK;
                        line.copy_from_slice(&blocks[from..from + BLOCK]);
                    }
                }
                self.row_forward.process_with_scratch(pair, scratch);
                let (first, second) = pair.split_at_mut(columns);
                if p == 0 {
                    self.multiply_alone(0, first);
                    self.multiply_alone(rows / 2, second);
                } else {
                    for k in 0..columns {
                        let mirror = columns - 1 - k;
                        (first[k], second[mirror]) =
                            self.multiplied(p, k, first[k], second[mirror]);
                    }
                }
                self.row_inverse.process_with_scratch(pair, scratch);
            },
        );
    }

    /// The product for rows 0 and n₁/2, which are their own mirror images.
    fn multiply_alone(&self, row: usize, line: &mut [C]) {
        let columns = self.columns;
        for k in 0..columns {
            let mirror = if row == 0 { (columns - k) % columns } else { columns - 1 - k };
            if mirror >= k {
                (line[k], line[mirror]) = self.multiplied(row, k, line[k], line[mirror]);
            }
        }
    }

    /// The products of Z_k and Z_{n−k}, k = k₁ + n₁k₂.
    fn multiplied(&self, row: usize, column: usize, z: C, mirror: C) -> (C, C) {
        let [p, q] = self.symbol[row * self.columns + column];
        let w = self.packing.0[row] * self.packing.1[column];
        let even = (z + mirror.conj()) * 0.5;
        let difference = (z - mirror.conj()) * 0.5;
        let odd = w * Complex::new(difference.im, -difference.re);
        let turned = w.conj() * even;
        let turned = Complex::new(-turned.im, turned.re);
        (z * p + (odd + turned) * q, mirror * p + (odd - turned).conj() * q)
    }

    /// blocks\[b\]\[j₁\]\[c\] ← the inverse transforms of the columns.
    fn columns_backward(&self, pairs: &[C], blocks: &mut [C]) {
        let (rows, plan) = (self.rows, &self.column_inverse);
        blocks.par_chunks_mut(rows * BLOCK).enumerate().with_min_len(8).for_each_init(
            || self.line_buffers(plan, rows * BLOCK),
            |(lines, scratch), (b, block)| {
                for row in 0..rows {
                    let from = self.place(row) * self.columns + b * BLOCK;
                    pairs[from..from + BLOCK]
                        .iter()
                        .enumerate()
                        .for_each(|(c, z)| lines[c * rows + row] = *z);
                }
                for (c, line) in lines.chunks_mut(rows).enumerate() {
                    self.twiddle(b * BLOCK + c, line, |z, factor| z * factor.conj());
                }
                plan.process_with_scratch(lines, scratch);
                for (row, block) in block.chunks_exact_mut(BLOCK).enumerate() {
                    block.iter_mut().enumerate().for_each(|(c, z)| *z = lines[c * rows + row]);
                }
            },
        );
    }
}
