//! Values, derivatives, restrictions, sums and products of resolved functions, cell by cell.

use super::cells::{Cell, Common, Place, Resolved};
use super::fit::Fit;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::functions::break_of;
use crate::piecewise::{Piece, bubbles_of};

/// Relative rounding error of a value of a polynomial.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Largest number of bisections of a cell for a product.
const HALVINGS: u32 = 40;
/// Coordinates within this multiple of the ends, relative to the larger of them, belong to the interval.
const BEYOND: f64 = 16.0 * f64::EPSILON;

impl Resolved {
    /// u(x), from the right at a jump.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside the interval.
    pub(crate) fn value(&self, x: f64) -> Result<Estimate> {
        self.value_at(self.inside(x)?)
    }

    /// The value at a signed distance from the breakpoint c_k; a signed zero is the limit from that side.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] if there is no breakpoint k; [`Error::OutOfRange`] outside the interval.
    pub(crate) fn value_near(&self, k: usize, distance: f64) -> Result<Estimate> {
        let base = break_of(&self.breaks, k)?;
        self.inside(base + distance)?;
        self.value_at(Place { base, offset: distance })
    }

    fn inside(&self, x: f64) -> Result<Place> {
        let [left, right] = [self.first().coordinate(), self.end.coordinate()];
        let slack = BEYOND * left.abs().max(right.abs());
        let admissible = x >= left - slack && x <= right + slack;
        Error::require("x", x, "{the interval of the function}", admissible).map(Place::at)
    }

    fn value_at(&self, place: Place) -> Result<Estimate> {
        let is_left = |cell: &Cell| {
            let apart = place.from(cell.start);
            apart > 0.0 || apart == 0.0 && !place.offset.is_sign_negative()
        };
        let k = self.cells.partition_point(is_left).max(1) - 1;
        let cell = &self.cells[k];
        let t = (place.from(cell.start) / cell.length).clamp(0.0, 1.0);
        let value = cell.piece.value(t);
        let hidden = [(k, true), (k + 1, false)]
            .into_iter()
            .filter(|&(node, _)| self.place(node).offset == 0.0)
            .filter_map(|(node, is_right)| self.hidden(node, is_right))
            .fold(0.0, f64::max);
        Estimate::new(value, cell.off + hidden + ROUNDING * cell.piece.size(), Work::default())
    }

    /// u′ between the nodes. The error of the derivative of a polynomial of degree d on a cell of length h is estimated as
    /// that of the polynomial times 2(d+2)²/h, Markov's bound for errors that are polynomials of degree d + 2.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub(crate) fn derivative(&self) -> Result<Self> {
        let of = |cell: &Cell| {
            let h = cell.length;
            let at = |t: f64| cell.piece.slope(t) / h;
            let ends = [at(0.0), at(1.0)];
            let bubbles = bubbles_of(cell.piece.bubbles.len(), ends, at)?;
            let piece = Piece { left: ends[0], right: ends[1], bubbles };
            let steep = 2.0 * ((cell.piece.bubbles.len() + 3) as f64).powi(2) / h;
            if !(piece.size() + steep * cell.off).is_finite() {
                let (name, value) = ("derivative", piece.size());
                return Err(Error::NotFinite { name, index: 0, value });
            }
            Ok(Cell { piece, off: steep * cell.off, ..cell.clone() })
        };
        let cells = self.cells.iter().map(of).collect::<Result<Vec<_>>>()?;
        let mut found = Self { cells, ..self.clone() };
        found.join();
        Ok(found)
    }

    /// True if the function jumps at a node, by more than the errors of its values.
    pub(crate) fn jumps(&self) -> bool {
        self.cells.windows(2).any(|pair| pair[0].piece.right != pair[1].piece.left)
    }

    /// Makes the values of neighbouring cells equal at their common node if they agree up to their errors.
    fn join(&mut self) {
        for k in 1..self.cells.len() {
            let (left, right) = (&self.cells[k - 1], &self.cells[k]);
            let slack = |cell: &Cell| cell.off + ROUNDING * cell.piece.size();
            let (before, after) = (left.piece.right, right.piece.left);
            if before != after && (before - after).abs() <= slack(left) + slack(right) {
                let limit = if slack(left) < slack(right) { before } else { after };
                self.cells[k - 1].piece.right = limit;
                self.cells[k].piece.left = limit;
            }
        }
    }

    /// The restriction to (a, b).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless a < b lie in the interval.
    pub(crate) fn restrict(&self, a: f64, b: f64) -> Result<Self> {
        Error::require("right end of the restriction", b, "(left end, inf)", a < b)?;
        let [from, to] = [self.nearest(self.inside(a)?), self.nearest(self.inside(b)?)];
        let mut cells = Vec::new();
        for (k, cell) in self.cells.iter().enumerate() {
            let end = self.place(k + 1);
            let (is_first, is_last) = (cell.start.from(from) < 0.0, end.from(to) > 0.0);
            let start = if is_first { from } else { cell.start };
            let length = if is_last || is_first {
                (if is_last { to } else { end }).from(start)
            } else {
                cell.length
            };
            if length <= 0.0 || end.from(from) <= 0.0 {
                continue;
            }
            let local = |place: Place| (place.from(cell.start) / cell.length).clamp(0.0, 1.0);
            let [t, s] =
                [if is_first { local(from) } else { 0.0 }, if is_last { local(to) } else { 1.0 }];
            let piece = cell.piece.part(t, s)?;
            cells.push(Cell { start, length, piece, ..cell.clone() });
        }
        let inside = |c: &f64| *c > a && *c < b;
        let mut breaks = vec![a];
        breaks.extend(self.breaks.iter().copied().filter(inside));
        breaks.push(b);
        let open = self.open.iter().copied().filter(|&c| c >= a && c <= b).collect();
        Ok(Self { cells, end: to, breaks, open, is_noisy: self.is_noisy })
    }

    /// The place of the node that is equal to a place up to rounding, else the place.
    fn nearest(&self, place: Place) -> Place {
        let x = place.coordinate();
        let known = self.breaks.iter().find(|c| (*c - x).abs() <= BEYOND * c.abs().max(x.abs()));
        known.map_or(place, |&c| Place::at(c))
    }

    /// a u + b v.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are defined on the same interval.
    pub(crate) fn combined(&self, a: f64, other: &Self, b: f64) -> Result<Self> {
        self.cellwise(other, |common, [mine, others], cells| {
            let [u, v] = parts(common, [mine, others])?;
            let count = u.bubbles.len().max(v.bubbles.len());
            let of = |piece: &Piece, k: usize| piece.bubbles.get(k).copied().unwrap_or(0.0);
            let piece = Piece {
                left: a * u.left + b * v.left,
                right: a * u.right + b * v.right,
                bubbles: (0..count).map(|k| a * of(&u, k) + b * of(&v, k)).collect(),
            };
            let off = a.abs() * mine.off + b.abs() * others.off;
            let rounding = f64::EPSILON * (a.abs() * u.size() + b.abs() * v.size());
            let off = if off > 0.0 { off + rounding } else { rounding };
            let is_rough = mine.is_rough || others.is_rough;
            cells.push(Cell { start: common.start, length: common.length, piece, off, is_rough });
            Ok(())
        })
    }

    /// u v.
    ///
    /// # Errors
    /// As [`Resolved::combined`].
    pub(crate) fn times(&self, other: &Self) -> Result<Self> {
        let fit = Fit::new()?;
        self.cellwise(other, |common, [mine, others], cells| {
            let [u, v] = parts(common, [mine, others])?;
            let off = mine.off * v.size() + others.off * (u.size() + mine.off);
            let is_rough = mine.is_rough || others.is_rough;
            let mut stack = vec![(0.0, 1.0, 0)];
            while let Some((from, to, halvings)) = stack.pop() {
                let value = |t: f64| {
                    let t = from + (to - from) * t;
                    Ok(u.value(t) * v.value(t))
                };
                let found = fit.of(value, &Default::default(), 0.0, 0.0)?;
                if found.is_resolved || halvings == HALVINGS {
                    let start = Place {
                        offset: common.start.offset + from * common.length,
                        ..common.start
                    };
                    cells.push(Cell {
                        start,
                        length: (to - from) * common.length,
                        piece: found.piece,
                        off: off + found.off,
                        is_rough,
                    });
                } else {
                    let middle = 0.5 * (from + to);
                    stack.extend([(middle, to, halvings + 1), (from, middle, halvings + 1)]);
                }
            }
            Ok(())
        })
    }

    /// c u.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let of = |cell: &Cell| Cell {
            piece: cell.piece.scaled(factor),
            off: factor.abs() * cell.off,
            ..cell.clone()
        };
        Self { cells: self.cells.iter().map(of).collect(), ..self.clone() }
    }

    fn cellwise(
        &self,
        other: &Self,
        of: impl Fn(&Common, [&Cell; 2], &mut Vec<Cell>) -> Result<()>,
    ) -> Result<Self> {
        let mut cells = Vec::new();
        for common in self.common(other)? {
            let [i, j] = common.cells;
            of(&common, [&self.cells[i], &other.cells[j]], &mut cells)?;
        }
        let both = |a: &[f64], b: &[f64]| {
            let mut all = [a, b].concat();
            all.sort_by(f64::total_cmp);
            all.dedup();
            all
        };
        let mut breaks = both(&self.breaks, &other.breaks[1..other.breaks.len() - 1]);
        breaks.dedup();
        let mut found = Self {
            cells,
            end: self.end,
            breaks,
            open: both(&self.open, &other.open),
            is_noisy: self.is_noisy || other.is_noisy,
        };
        found.join();
        Ok(found)
    }
}

fn parts(common: &Common, cells: [&Cell; 2]) -> Result<[Piece; 2]> {
    let part = |k: usize| cells[k].piece.part(common.from[k], common.to[k]);
    Ok([part(0)?, part(1)?])
}
