//! The cells of a resolved function.

use crate::error::{Error, Result};
use crate::mesh::Mesh;
use crate::numeric::sum::RunningSum;
use crate::piecewise::{Piece, PiecewisePolynomial};
use std::cmp::Ordering;

/// Coordinates that differ by this multiple of the larger one are equal.
const SAME: f64 = 4.0 * f64::EPSILON;
/// An element is short if it is shorter than this multiple of the interval: nodes of short elements are known from the
/// shortest element near them, not from the ends.
const SHORT: f64 = 1e-6;
/// Ratio of a cell to the rounding of its coordinates from which its ends may be moved by it.
const LONG: f64 = 64.0;

/// A point of the interval: a coordinate and the signed distance from it, which keeps its digits down to 1e-290.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    pub(super) base: f64,
    pub(super) offset: f64,
}

impl Place {
    pub(super) fn at(x: f64) -> Self {
        Self { base: x, offset: 0.0 }
    }

    pub(super) fn coordinate(self) -> f64 {
        self.base + self.offset
    }

    /// self − other.
    pub(super) fn from(self, other: Self) -> f64 {
        (self.base - other.base) + (self.offset - other.offset)
    }
}

/// A polynomial on a cell.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cell {
    pub(super) start: Place,
    pub(super) length: f64,
    pub(super) piece: Piece,
    /// a bound of |u − p|
    pub(super) off: f64,
    /// true if no length resolves u here: it is not smooth at a place that is not declared
    pub(super) is_rough: bool,
}

impl Cell {
    /// A rounding error of the ends of the cell.
    pub(super) fn blur(&self) -> f64 {
        if self.start.offset == 0.0 {
            0.0
        } else {
            2.0 * f64::EPSILON * self.start.coordinate().abs().max(self.start.offset.abs())
        }
    }
}

/// A function on an interval, resolved by polynomials.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Resolved {
    /// from left to right
    pub(super) cells: Vec<Cell>,
    pub(super) end: Place,
    /// the declared breakpoints, ends included
    pub(super) breaks: Vec<f64>,
    /// the breakpoints next to which the variation has not ended at the smallest distance
    pub(super) open: Vec<f64>,
    /// true if noise of the values, above rounding, is part of the error of a cell
    pub(super) is_noisy: bool,
}

impl Resolved {
    /// The exact representation of a piecewise polynomial.
    pub(crate) fn of_polynomials(u: &PiecewisePolynomial) -> Self {
        let places = places_of(u.mesh());
        let cell = |(k, piece): (usize, &Piece)| Cell {
            start: places[k],
            length: u.mesh().lengths()[k],
            piece: piece.clone(),
            off: 0.0,
            is_rough: false,
        };
        let end = places[places.len() - 1];
        Self {
            cells: u.pieces().iter().enumerate().map(cell).collect(),
            breaks: vec![places[0].coordinate(), end.coordinate()],
            end,
            open: Vec::new(),
            is_noisy: false,
        }
    }

    /// True if some side of a breakpoint is divided: the function is not one polynomial between its breakpoints.
    pub(crate) fn has_structure(&self) -> bool {
        self.cells.len() > 2 * (self.breaks.len() - 1)
    }

    /// True if noise of the values limits the accuracy: no other method has more digits.
    pub(crate) fn is_noisy(&self) -> bool {
        self.is_noisy
    }

    /// True if the function is not smooth at a point that is not declared and has not been found.
    pub(crate) fn is_rough(&self) -> bool {
        self.cells.iter().any(|cell| cell.is_rough)
    }

    pub(super) fn first(&self) -> Place {
        self.cells[0].start
    }

    /// The place of node 0 ≤ k ≤ number of cells.
    pub(super) fn place(&self, k: usize) -> Place {
        self.cells.get(k).map_or(self.end, |cell| cell.start)
    }

    /// The polynomials alone.
    pub(super) fn polynomials(&self) -> Result<PiecewisePolynomial> {
        polynomials_of(&self.cells)
    }

    /// The cells common to two functions on the same interval: for every one its left end and length, and the
    /// cells of both functions that contain it.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the intervals are equal to rounding.
    pub(super) fn common(&self, other: &Self) -> Result<Vec<Common>> {
        let size = [self.first(), self.end, other.first(), other.end]
            .iter()
            .fold(0.0_f64, |most, place| most.max(place.coordinate().abs()));
        let slack = SAME * size;
        for (name, mine, others) in [
            ("left end of the other function's interval", self.first(), other.first()),
            ("right end of the other function's interval", self.end, other.end),
        ] {
            let range =
                "{end of the function's interval}: both must be defined on the same interval";
            Error::require(
                name,
                others.coordinate(),
                range,
                others.from(mine).abs() <= 16.0 * slack,
            )?;
        }
        let (mine, others) = (self.places(), other.snapped_to(self, slack));
        let (mut i, mut j, mut found) = (0, 0, Vec::new());
        let mut start = mine[0];
        while i < self.cells.len() && j < other.cells.len() {
            let (a, b) = (mine[i + 1], others[j + 1]);
            // A last cell remains to the end.
            let order = match (i + 1 == self.cells.len(), j + 1 == other.cells.len()) {
                (true, true) => Ordering::Equal,
                (true, false) => Ordering::Greater,
                (false, true) => Ordering::Less,
                _ if a.from(b).abs() <= tolerance(a, b) => Ordering::Equal,
                _ => a.from(b).total_cmp(&0.0),
            };
            let end = if order == Ordering::Greater { b } else { a };
            let length = if start == mine[i] && end == a {
                self.cells[i].length
            } else if start == others[j] && end == b {
                other.cells[j].length
            } else {
                end.from(start)
            };
            if length > 0.0 {
                found.push(Common {
                    start,
                    length,
                    cells: [i, j],
                    from: [
                        share(start.from(mine[i]), self.cells[i].length),
                        share(start.from(others[j]), other.cells[j].length),
                    ],
                    to: [
                        if order != Ordering::Greater {
                            1.0
                        } else {
                            share(end.from(mine[i]), self.cells[i].length)
                        },
                        if order != Ordering::Less {
                            1.0
                        } else {
                            share(end.from(others[j]), other.cells[j].length)
                        },
                    ],
                });
            }
            i += usize::from(order != Ordering::Greater);
            j += usize::from(order != Ordering::Less);
            start = end;
        }
        Ok(found)
    }

    fn places(&self) -> Vec<Place> {
        (0..=self.cells.len()).map(|k| self.place(k)).collect()
    }

    /// The nodes, of which those that are a breakpoint of another function to rounding are known from it.
    fn snapped_to(&self, other: &Self, slack: f64) -> Vec<Place> {
        let mut places = self.places();
        for &c in &other.breaks {
            for place in &mut places {
                if (place.base - c).abs() <= slack {
                    place.base = c;
                }
            }
            let near = places.partition_point(|place| place.coordinate() < c - slack);
            for k in near..places.len() {
                if (places[k].coordinate() - c).abs() > slack {
                    break;
                }
                let around = |k: usize| self.cells.get(k).map_or(f64::INFINITY, |cell| cell.length);
                let shortest = around(k).min(k.checked_sub(1).map_or(f64::INFINITY, around));
                if places[k].base != c && shortest > LONG * slack {
                    places[k] = Place::at(c);
                }
            }
        }
        places
    }
}

/// A cell common to two functions.
pub(super) struct Common {
    pub(super) start: Place,
    pub(super) length: f64,
    pub(super) cells: [usize; 2],
    /// its ends in local coordinates of the two cells
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
}

fn share(distance: f64, length: f64) -> f64 {
    (distance / length).clamp(0.0, 1.0)
}

/// The distance up to which two nodes are the same.
fn tolerance(a: Place, b: Place) -> f64 {
    if a.base == b.base {
        SAME * a.offset.abs().max(b.offset.abs())
    } else {
        SAME * a.coordinate().abs().max(b.coordinate().abs())
    }
}

pub(super) fn polynomials_of(cells: &[Cell]) -> Result<PiecewisePolynomial> {
    let lengths: Vec<f64> = cells.iter().map(|cell| cell.length).collect();
    let ends: Vec<[f64; 2]> =
        cells.iter().map(|cell| [cell.piece.left, cell.piece.right]).collect();
    let bubbles = cells.iter().map(|cell| cell.piece.bubbles.clone()).collect();
    PiecewisePolynomial::with_bubbles(Mesh::from_lengths(&lengths)?, &ends, bubbles)
}

/// The nodes of a mesh, known from its ends or from the node of the shortest element in their neighbourhood.
fn places_of(mesh: &Mesh) -> Vec<Place> {
    let (n, lengths) = (mesh.len(), mesh.lengths());
    let (left, right) = (mesh.left(), mesh.left() + mesh.total());
    let short = SHORT * mesh.total();
    let around = |k: usize| {
        let before = k.checked_sub(1).map_or(f64::INFINITY, |k| lengths[k]);
        before.min(lengths.get(k).copied().unwrap_or(f64::INFINITY))
    };
    // Nodes next to an element shorter than all others near it.
    let is_anchor = |k: &usize| {
        let k = *k;
        0 < k
            && k < n
            && around(k) < short
            && around(k) < mesh.from_left()[k].min(mesh.from_right()[k]) * SHORT
            && around(k) <= around(k - 1)
            && around(k) < around(k + 1)
    };
    let anchors: Vec<usize> = (0..=n).filter(is_anchor).collect();
    let mut places: Vec<Place> = (0..=n)
        .map(|k| {
            let [from_left, from_right] = [mesh.from_left()[k], mesh.from_right()[k]];
            if from_left <= from_right {
                Place { base: left, offset: from_left }
            } else {
                Place { base: right, offset: -from_right }
            }
        })
        .collect();
    for anchor in anchors {
        let base = left + mesh.from_left()[anchor];
        places[anchor] = Place::at(base);
        let mut sum = RunningSum::default();
        for k in anchor + 1..=n {
            sum.add(lengths[k - 1]);
            if sum.value() >= places[k].offset.abs() {
                break;
            }
            places[k] = Place { base, offset: sum.value() };
        }
        let mut sum = RunningSum::default();
        for k in (0..anchor).rev() {
            sum.add(lengths[k]);
            if sum.value() >= places[k].offset.abs() {
                break;
            }
            places[k] = Place { base, offset: -sum.value() };
        }
    }
    places
}
