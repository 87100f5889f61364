//! Rows of a grid: products and relaxation with constant stencils.
//!
//! A row stores all first components, then all second ones, so that sums over neighbours run along it. The fast path
//! treats the inner nodes of an inner row; nodes at the boundary are treated one by one, with their own stencils.

use super::real::{Real, add_two};
use crate::fem::{Block, NEIGHBOURS, kind};

/// The neighbours by their place among [`NEIGHBOURS`].
const SOUTH_WEST: usize = 0;
const SOUTH: usize = 1;
const WEST: usize = 2;
const OWN: usize = 3;
const EAST: usize = 4;
const NORTH: usize = 5;
const NORTH_EAST: usize = 6;

/// A stencil: one block for each neighbour.
type Stencil<T, const C: usize> = [[[T; C]; C]; 7];

/// The nine stencils times a factor, and the inverses of their diagonal blocks.
#[derive(Debug, Clone)]
pub(super) struct RowStencils<T, const C: usize> {
    stencils: [Stencil<T, C>; 9],
    /// Inverses of the unscaled diagonal blocks, divided by the absolute value of the factor.
    inverses: [[[T; C]; C]; 9],
}

/// Three rows one above the other; missing ones are empty.
#[derive(Clone, Copy)]
pub(super) struct Beside<'a, T> {
    pub(super) below: &'a [T],
    pub(super) above: &'a [T],
}

impl<T: Real, const C: usize> RowStencils<T, C> {
    /// `factor` times the blocks.
    pub(super) fn new(blocks: &[[Block; 7]; 9], factor: f64) -> Self {
        let scaled = |block: &Block| {
            std::array::from_fn(|a| std::array::from_fn(|b| T::of(factor * block[a][b])))
        };
        let inverse = |stencil: &[Block; 7]| {
            let inverse = inverse_of::<C>(&stencil[OWN]);
            std::array::from_fn(|a| std::array::from_fn(|b| T::of(inverse[a][b] / factor.abs())))
        };
        Self {
            stencils: std::array::from_fn(|kind| std::array::from_fn(|k| scaled(&blocks[kind][k]))),
            inverses: std::array::from_fn(|kind| inverse(&blocks[kind])),
        }
    }

    /// out ← out + (factor · K x) in row `row_kind` (0 bottom, 1 inside, 2 top).
    pub(super) fn add_product(
        &self,
        row_kind: usize,
        row: &[T],
        beside: Beside<'_, T>,
        out: &mut [T],
    ) {
        let m = out.len() / C;
        if row_kind == 1 {
            self.add_others(beside, out);
            self.add_own_row(row, out);
        }
        for i in (0..m).filter(|&i| row_kind != 1 || i == 0 || i + 1 == m) {
            let stencil = &self.stencils[3 * row_kind + kind(i, m - 1)];
            let sum = node_sum::<T, C>(stencil, (i, m), [beside.below, row, beside.above], true);
            for a in 0..C {
                out[a * m + i] += sum[a];
            }
        }
    }

    /// Adds the contributions of the rows below and above to the inner nodes of an inner row.
    fn add_others(&self, beside: Beside<'_, T>, out: &mut [T]) {
        let m = out.len() / C;
        let s = &self.stencils[4];
        for a in 0..C {
            let out = &mut out[a * m + 1..(a + 1) * m - 1];
            for b in 0..C {
                let (below, above) =
                    (&beside.below[b * m..(b + 1) * m], &beside.above[b * m..(b + 1) * m]);
                add_two(
                    out,
                    (s[SOUTH_WEST][a][b], &below[..m - 2]),
                    (s[SOUTH][a][b], &below[1..m - 1]),
                );
                add_two(
                    out,
                    (s[NORTH][a][b], &above[1..m - 1]),
                    (s[NORTH_EAST][a][b], &above[2..]),
                );
            }
        }
    }

    /// Adds the contributions of the row itself to its inner nodes.
    fn add_own_row(&self, row: &[T], out: &mut [T]) {
        let m = out.len() / C;
        let s = &self.stencils[4];
        for a in 0..C {
            let out = &mut out[a * m + 1..(a + 1) * m - 1];
            for b in 0..C {
                let x = &row[b * m..(b + 1) * m];
                add_two(out, (s[WEST][a][b], &x[..m - 2]), (s[EAST][a][b], &x[2..]));
                add_two(out, (s[OWN][a][b], &x[1..m - 1]), (T::default(), &x[1..m - 1]));
            }
        }
    }

    /// Relaxes the nodes of a row, those of parity `first` before the others, for stencils times −1: each node is set
    /// to the value for which its residual vanishes. `sums` is a work array of the length of the row.
    pub(super) fn relax(
        &self,
        row_kind: usize,
        first: usize,
        row: &mut [T],
        beside: Beside<'_, T>,
        (b, fixed): (&[T], &[bool]),
        sums: &mut [T],
    ) {
        let m = row.len() / C;
        if row_kind == 1 {
            sums.copy_from_slice(b);
            self.add_others(beside, sums);
        }
        for parity in [first, 1 - first] {
            if row_kind == 1 {
                self.relax_inside(parity, row, sums);
            }
            for i in (parity..m).step_by(2).filter(|&i| row_kind != 1 || i == 0 || i + 1 == m) {
                self.relax_node(3 * row_kind + kind(i, m - 1), (i, m), row, beside, (b, fixed));
            }
        }
    }

    /// The inner nodes of one parity of an inner row.
    fn relax_inside(&self, parity: usize, row: &mut [T], sums: &[T]) {
        let m = row.len() / C;
        let (s, inverse) = (&self.stencils[4], &self.inverses[4]);
        let mut components = row.chunks_exact_mut(m);
        let x: [&mut [T]; C] = std::array::from_fn(|_| components.next().unwrap_or_default());
        let sums: [&[T]; C] = std::array::from_fn(|a| &sums[a * m..(a + 1) * m]);
        for i in (2 - parity..m - 1).step_by(2) {
            let mut rest: [T; C] = std::array::from_fn(|a| sums[a][i]);
            for b in 0..C {
                let (west, east) = (x[b][i - 1], x[b][i + 1]);
                for a in 0..C {
                    rest[a] += s[WEST][a][b] * west + s[EAST][a][b] * east;
                }
            }
            for a in 0..C {
                let mut value = T::default();
                for b in 0..C {
                    value += inverse[a][b] * rest[b];
                }
                x[a][i] = value;
            }
        }
    }

    /// Relaxes a node at the boundary: both unknowns, or the one that is not fixed.
    fn relax_node(
        &self,
        kind: usize,
        (i, m): (usize, usize),
        row: &mut [T],
        beside: Beside<'_, T>,
        (b, fixed): (&[T], &[bool]),
    ) {
        let sum = node_sum::<T, C>(
            &self.stencils[kind],
            (i, m),
            [beside.below, row, beside.above],
            false,
        );
        let rest: [T; C] = std::array::from_fn(|a| b[a * m + i] + sum[a]);
        let held: [bool; C] = std::array::from_fn(|a| fixed[a * m + i]);
        if held.iter().all(|&held| !held) {
            for a in 0..C {
                let mut value = T::default();
                for c in 0..C {
                    value += self.inverses[kind][a][c] * rest[c];
                }
                row[a * m + i] = value;
            }
        } else if let Some(a) = (0..C).find(|&a| !held[a]) {
            // C = 2: the other one is held; its share is in the stencil times −1, and so is the divisor.
            let other = C - 1 - a;
            let own = &self.stencils[kind][OWN][a];
            row[a * m + i] = -(rest[a] + own[other] * row[other * m + i]) / own[a];
        }
    }
}

/// Σ over neighbours of stencil times value, with the node itself or without.
fn node_sum<T: Real, const C: usize>(
    stencil: &Stencil<T, C>,
    (i, m): (usize, usize),
    rows: [&[T]; 3],
    own: bool,
) -> [T; C] {
    let mut sum = [T::default(); C];
    for (k, &(p, q)) in NEIGHBOURS.iter().enumerate() {
        let at = i.wrapping_add_signed(p);
        let row = rows[1_usize.wrapping_add_signed(q)];
        if at >= m || row.is_empty() || (k == OWN && !own) {
            continue;
        }
        for b in 0..C {
            let x = row[b * m + at];
            for a in 0..C {
                sum[a] += stencil[k][a][b] * x;
            }
        }
    }
    sum
}

/// The inverse of the leading C x C part.
pub(super) fn inverse_of<const C: usize>(block: &Block) -> [[f64; C]; C] {
    let [[p, q], [r, s]] = *block;
    let inverse = if C == 1 {
        [[1.0 / p, 0.0], [0.0, 0.0]]
    } else {
        let determinant = p * s - q * r;
        [[s / determinant, -q / determinant], [-r / determinant, p / determinant]]
    };
    std::array::from_fn(|a| std::array::from_fn(|b| inverse[a][b]))
}
