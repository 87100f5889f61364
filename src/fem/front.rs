//! One dense front of the multifrontal factorization: assembly, partial Cholesky, substitution.
//!
//! A front holds p pivots (consecutive positions) and r further rows (positions after them, ascending):
//!
//! [[F₁₁, ·], [F₂₁, F₂₂]]  →  F₁₁ = L₁₁ L₁₁',  L₂₁ = F₂₁ L₁₁⁻ᵀ,  update F₂₂ − L₂₁ L₂₁'.
//!
//! The columns (L₁₁; L₂₁) are kept as one column-major panel; only lower triangles are touched.

use super::matrix::BlockMatrix;
use super::pool::Pool;
use crate::error::{Error, Result};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::reborrow::{Reborrow, ReborrowMut};
use faer::{Accum, MatMut, Par};
use std::ops::Range;

/// Number of operations from which on a front is factorized in parallel.
const PARALLEL: f64 = 2e8;

/// A pivot below this multiple of its diagonal entry counts as zero: the body has no Dirichlet boundary.
const VANISHING: f64 = 1e-13;

/// The input of the elimination of a subtree.
pub(super) struct Ordering<'a> {
    pub(super) matrix: &'a BlockMatrix,
    /// Position of every unknown; the largest number for prescribed ones.
    pub(super) positions: &'a [u32],
    /// The unknown at every position.
    pub(super) unknowns: &'a [u32],
    pub(super) pool: Pool,
}

/// The factored columns of one front.
#[derive(Debug)]
pub(super) struct Front {
    pivots: Range<usize>,
    rows: Vec<u32>,
    /// (p + r) x p, column-major.
    panel: Vec<f64>,
}

/// The update matrix of a front for its parent: a symmetric matrix on `rows`, lower triangle, column-major.
#[derive(Debug, Default)]
pub(super) struct Update {
    rows: Vec<u32>,
    values: Vec<f64>,
}

impl Update {
    /// Entry (i, j), i ≥ j.
    pub(super) fn at(&self, i: usize, j: usize) -> f64 {
        self.values[j * self.rows.len() + i]
    }
}

impl Front {
    /// Assembles the rows of K at `pivots` and the children's updates, and eliminates. `rows` are found from
    /// the entries unless given.
    pub(super) fn eliminate(
        ordering: &Ordering<'_>,
        pivots: Range<usize>,
        rows: Option<Vec<u32>>,
        children: Vec<Update>,
    ) -> Result<(Self, Update)> {
        let rows = rows.unwrap_or_else(|| rows_of(ordering, &pivots, &children));
        let height = pivots.len() + rows.len();
        let mut panel = ordering.pool.zeros(height * pivots.len());
        let mut update = ordering.pool.zeros(rows.len() * rows.len());
        let local = |position: usize| {
            if position < pivots.end {
                position - pivots.start
            } else {
                pivots.len() + rows.partition_point(|&row| (row as usize) < position)
            }
        };
        for (j, position) in pivots.clone().enumerate() {
            // The unknowns of a node follow each other, so that most places are the next one.
            let mut next = (usize::MAX, 0);
            for (column, value) in ordering.matrix.row(ordering.unknowns[position] as usize) {
                let other = ordering.positions[column] as usize;
                if other >= position && other < ordering.unknowns.len() {
                    let place = if other == next.0 { next.1 } else { local(other) };
                    panel[j * height + place] += value;
                    let follows = place + 1 < pivots.len()
                        || rows.get(place + 1 - pivots.len()) == Some(&(other as u32 + 1));
                    next = if follows { (other + 1, place + 1) } else { (usize::MAX, 0) };
                }
            }
        }
        for child in children {
            extend_add(&child, &local, pivots.len(), height, &mut panel, &mut update);
            ordering.pool.keep(child.values);
        }
        let front = Self { pivots, rows, panel };
        front.factor(ordering, update)
    }

    fn factor(mut self, ordering: &Ordering<'_>, mut update: Vec<f64>) -> Result<(Self, Update)> {
        let (p, r) = (self.pivots.len(), self.rows.len());
        if p > 0 {
            let operations = p as f64 * (p + r) as f64 * (p + r) as f64;
            let par = if operations > PARALLEL { Par::rayon(0) } else { Par::Seq };
            let panel = MatMut::from_column_major_slice_mut(&mut self.panel, p + r, p);
            let (mut top, mut bottom) = panel.split_at_row_mut(p);
            let mut memory =
                MemBuffer::new(cholesky_in_place_scratch::<f64>(p, par, Default::default()));
            let stack = MemStack::new(&mut memory);
            cholesky_in_place(top.rb_mut(), Default::default(), par, stack, Default::default())
                .map_err(|_| self.pivots.start)
                .and_then(|_| {
                    vanishing_pivot(ordering, &self.pivots, |j| top[(j, j)]).map_or(Ok(()), Err)
                })
                .map_err(|position| {
                    Error::not_positive_definite(
                        "stiffness matrix",
                        ordering.unknowns[position] as usize,
                    )
                })?;
            solve_lower_triangular_in_place(top.rb(), bottom.rb_mut().transpose_mut(), par);
            matmul(
                MatMut::from_column_major_slice_mut(&mut update, r, r),
                BlockStructure::TriangularLower,
                Accum::Add,
                bottom.rb(),
                BlockStructure::Rectangular,
                bottom.rb().transpose(),
                BlockStructure::Rectangular,
                -1.0,
                par,
            );
        }
        let rows = self.rows.clone();
        Ok((self, Update { rows, values: update }))
    }

    fn columns(&self) -> impl DoubleEndedIterator<Item = (usize, &[f64], &[f64])> {
        let p = self.pivots.len();
        let height = p + self.rows.len();
        self.panel.chunks_exact(height.max(1)).enumerate().map(move |(j, column)| {
            let (own, below) = column.split_at(p);
            (j, &own[j..], below)
        })
    }

    /// y ← L⁻¹ y for the columns of this front.
    ///
    /// y_p ← L_pp⁻¹ y_p for the pivots, then y_r ← y_r − L_rp y_p for the rows below.
    pub(super) fn forward(&self, values: &mut [f64]) {
        let mut below = vec![0.0; self.rows.len()];
        let own = &mut values[self.pivots.clone()];
        for (j, column, rest) in self.columns() {
            let y = own[j] / column[0];
            own[j] = y;
            axpy(-y, &column[1..], &mut own[j + 1..]);
            axpy(y, rest, &mut below);
        }
        for (&row, value) in self.rows.iter().zip(below) {
            values[row as usize] -= value;
        }
    }

    /// x ← L⁻ᵀ y for the columns of this front.
    ///
    /// x_p ← L_pp⁻ᵀ (y_p − L_rpᵀ x_r), the pivots in reverse order.
    pub(super) fn backward(&self, values: &mut [f64]) {
        let below: Vec<f64> = self.rows.iter().map(|&row| values[row as usize]).collect();
        let own = &mut values[self.pivots.clone()];
        for (j, column, rest) in self.columns().rev() {
            let known = inner(&column[1..], &own[j + 1..]) + inner(rest, &below);
            own[j] = (own[j] - known) / column[0];
        }
    }
}

/// All positions after the pivots that the pivots or the children touch, ascending.
fn rows_of(ordering: &Ordering<'_>, pivots: &Range<usize>, children: &[Update]) -> Vec<u32> {
    let end = pivots.end as u32;
    let limit = ordering.unknowns.len() as u32;
    let mut rows: Vec<u32> = children
        .iter()
        .flat_map(|child| child.rows.iter().copied())
        .filter(|&row| row >= end)
        .collect();
    let node =
        |position: usize| ordering.unknowns[position] as usize / ordering.matrix.components();
    for position in pivots.clone() {
        // All rows of a node have the same columns.
        if position > pivots.start && node(position) == node(position - 1) {
            continue;
        }
        let touched = ordering.matrix.row(ordering.unknowns[position] as usize);
        let after = touched.map(|(column, _)| ordering.positions[column]);
        rows.extend(after.filter(|&other| other >= end && other < limit));
    }
    rows.sort_unstable();
    rows.dedup();
    rows
}

/// Adds a child's update to the parent's panel (p columns of the given height) and update.
fn extend_add(
    child: &Update,
    local: &impl Fn(usize) -> usize,
    p: usize,
    height: usize,
    panel: &mut [f64],
    update: &mut [f64],
) {
    let map: Vec<usize> = child.rows.iter().map(|&row| local(row as usize)).collect();
    let size = map.len();
    for (j, &column) in map.iter().enumerate() {
        let source = &child.values[j * size + j..(j + 1) * size];
        if column < p {
            let target = &mut panel[column * height..(column + 1) * height];
            for (&i, value) in map[j..].iter().zip(source) {
                target[i] += value;
            }
        } else {
            let width = height - p;
            let target = &mut update[(column - p) * width..(column - p + 1) * width];
            for (&i, value) in map[j..].iter().zip(source) {
                target[i - p] += value;
            }
        }
    }
}

/// The first position whose pivot l_jj² is negligible relative to the diagonal entry of K.
fn vanishing_pivot(
    ordering: &Ordering<'_>,
    pivots: &Range<usize>,
    root: impl Fn(usize) -> f64,
) -> Option<usize> {
    pivots.clone().enumerate().find_map(|(j, position)| {
        let diagonal = ordering.matrix.diagonal(ordering.unknowns[position] as usize);
        let held = root(j) * root(j) > VANISHING * diagonal;
        (!held).then_some(position)
    })
}

fn axpy(a: f64, x: &[f64], y: &mut [f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += a * x);
}

/// The inner product in eight lanes, limited only by memory bandwidth.
pub(crate) fn inner<T: Into<f64> + Copy>(x: &[f64], y: &[T]) -> f64 {
    let mut lanes = [0.0; 8];
    let (x, y) = (x.chunks_exact(8), y.chunks_exact(8));
    let rest: f64 = x.remainder().iter().zip(y.remainder()).map(|(a, &b)| a * b.into()).sum();
    for (x, y) in x.zip(y) {
        for k in 0..8 {
            lanes[k] += x[k] * y[k].into();
        }
    }
    rest + lanes.iter().sum::<f64>()
}
