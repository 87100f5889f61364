//! A level with constant stencils: no matrix is stored.
//!
//! Vectors are stored row by row of the grid. A sweep relaxes every second row, then the others; in a row every
//! second node, then the others: four colours, and rows of one parity in parallel. Inner nodes are never fixed. Cost:
//! 28 multiplications per node and sweep for two components.

use super::grid_rows::{Beside, RowStencils};
use super::level::{Level, Sweep};
use super::real::Real;
use crate::fem::{Stencils, kind};
use crate::mesh::Grid;
use rayon::prelude::*;

/// Number of entries below which a task is not split.
const GRAIN: usize = 1 << 14;

/// A level with C components.
#[derive(Debug, Clone)]
pub(super) struct GridLevel<const C: usize> {
    grid: Grid,
    unit: f64,
    exact: RowStencils<f64, C>,
    /// The stencils times −1, divided by the unit.
    negated: RowStencils<f32, C>,
}

impl<const C: usize> GridLevel<C> {
    pub(super) fn new(stencils: &Stencils) -> Self {
        let own = |block: &crate::fem::Block| (0..C).map(|a| block[a][a]).fold(0.0, f64::max);
        let unit = own(&stencils.blocks()[4][3]);
        Self {
            grid: stencils.grid(),
            unit,
            exact: RowStencils::new(stencils.blocks(), 1.0),
            negated: RowStencils::new(stencils.blocks(), -1.0 / unit),
        }
    }

    fn width(&self) -> usize {
        C * (self.grid.nx + 1)
    }

    fn rows_a_task(&self) -> usize {
        (GRAIN / self.width()).max(1)
    }

    /// out ← out + factor · K x.
    fn add_product<T: Real>(&self, stencils: &RowStencils<T, C>, x: &[T], out: &mut [T]) {
        let width = self.width();
        let row = |j: usize| x.get(j * width..(j + 1) * width).unwrap_or_default();
        let rows = out.par_chunks_mut(width).enumerate().with_min_len(self.rows_a_task());
        rows.for_each(|(j, out)| {
            let beside =
                Beside { below: row(j.wrapping_sub(1).min(self.grid.ny + 1)), above: row(j + 1) };
            stencils.add_product(kind(j, self.grid.ny), row(j), beside, out);
        });
    }
}

impl<const C: usize> Level for GridLevel<C> {
    fn unknowns(&self) -> usize {
        C * self.grid.nodes()
    }

    fn unit(&self) -> f64 {
        self.unit
    }

    fn place(&self, unknown: usize) -> usize {
        let m = self.grid.nx + 1;
        let (node, a) = (unknown / C, unknown % C);
        let (i, j) = (node % m, node / m);
        (j * C + a) * m + i
    }

    fn multiply(&self, x: &[f64], out: &mut [f64]) {
        out.par_chunks_mut(GRAIN).for_each(|out| out.fill(0.0));
        self.add_product(&self.exact, x, out);
    }

    fn sweep(&self, x: &mut [f32], b: &[f32], fixed: &[bool], direction: Sweep) {
        let width = self.width();
        let (mut even, mut odd) = (Vec::new(), Vec::new());
        for (j, row) in x.chunks_mut(width).enumerate() {
            if j % 2 == 0 { even.push(row) } else { odd.push(row) }
        }
        let forward = direction == Sweep::Forward;
        let phases = if forward { [0, 1] } else { [1, 0] };
        for parity in phases {
            let (moving, still) = if parity == 0 { (&mut even, &odd) } else { (&mut odd, &even) };
            let beside = |k: usize| still.get(k).map_or(&[][..], |row| &**row);
            let rows = moving.par_iter_mut().enumerate().with_min_len(self.rows_a_task());
            rows.for_each_init(
                || vec![0.0; width],
                |sums, (k, row)| {
                    let j = 2 * k + parity;
                    let here = j * width..(j + 1) * width;
                    let below = if parity == 0 { beside(k.wrapping_sub(1)) } else { beside(k) };
                    let above = if parity == 0 { beside(k) } else { beside(k + 1) };
                    let first = if forward { 0 } else { 1 };
                    let data = (&b[here.clone()], &fixed[here]);
                    self.negated.relax(
                        kind(j, self.grid.ny),
                        first,
                        row,
                        Beside { below, above },
                        data,
                        sums,
                    );
                },
            );
        }
    }

    fn residual(&self, x: &[f32], b: &[f32], out: &mut [f32]) {
        out.par_chunks_mut(GRAIN)
            .zip(b.par_chunks(GRAIN))
            .for_each(|(out, b)| out.copy_from_slice(b));
        self.add_product(&self.negated, x, out);
    }

    fn restrict(&self, fine: &[f32], coarse: &mut [f32]) {
        let m = self.grid.nx + 1;
        let count = self.grid.nx / 2 + 1;
        let row =
            |j: usize, a: usize| fine.get((j * C + a) * m..(j * C + a + 1) * m).unwrap_or_default();
        let rows = coarse.par_chunks_mut(count).enumerate().with_min_len(self.rows_a_task());
        rows.for_each(|(k, out)| {
            let (j, a) = (2 * (k / C), k % C);
            let own = row(j, a);
            let above = row(j + 1, a);
            let below = if j == 0 { &[][..] } else { row(j - 1, a) };
            let half = |row: &[f32], i: usize| row.get(i).map_or(0.0, |value| 0.5 * value);
            for (i, out) in out.iter_mut().enumerate() {
                let i = 2 * i;
                let mut sum = own[i]
                    + half(own, i + 1)
                    + half(above, i)
                    + half(above, i + 1)
                    + half(below, i);
                if i > 0 {
                    sum += half(own, i - 1) + half(below, i - 1);
                }
                *out = sum;
            }
        });
    }

    fn prolong<T: Real>(&self, coarse: &[T], fine: &mut [T]) {
        let m = self.grid.nx + 1;
        let count = self.grid.nx / 2 + 1;
        let half = T::of(0.5);
        let rows = fine.par_chunks_mut(m).enumerate().with_min_len(self.rows_a_task());
        rows.for_each(|(k, out)| {
            let (j, a) = (k / C, k % C);
            let row = |j: usize| &coarse[(j * C + a) * count..(j * C + a + 1) * count];
            let (below, above) = (row(j / 2), row(j.div_ceil(2)));
            // Nodes of odd numbers lie between their lower left and upper right neighbours, on diagonals of
            // odd rows.
            for (i, (p, q)) in below.iter().zip(above).enumerate() {
                out[2 * i] += half * *p + half * *q;
            }
            for (i, (p, q)) in below.iter().zip(&above[1..]).enumerate() {
                out[2 * i + 1] += half * *p + half * *q;
            }
        });
    }
}
