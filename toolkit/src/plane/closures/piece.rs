//! Triangles and parts of triangles, relative to a base point so that small offsets have full relative
//! accuracy.
//!
//! A triangle at a declared corner c is {c + ρ e(t)}, 0 < ρ < 1, e(t) on the edge opposite c. It is divided at
//! ρ = 1/2 into a smaller such triangle and a strip of two triangles on which the function is smooth.

use super::function::SingularPlaneFunction;
use crate::numeric::scale::power_of_two;
use crate::plane::geometry::{Point, dot, length, minus, product_difference};
use crate::plane::simplex::{Corner, NO_NODE, Simplex};

/// A part of a triangle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) triangle: usize,
    base: Point,
    /// The declared corner at the base.
    anchor: Option<usize>,
    /// True if corner 0 is that declared corner.
    pub(super) is_singular: bool,
    pub(super) nodes: [usize; 3],
    /// The corners relative to the base.
    pub(super) at: [Point; 3],
}

/// A function with its units: lengths are divided by `extent`, values by `unit`, both powers of two.
#[derive(Debug, Clone, Copy)]
pub(super) struct View<'a> {
    pub(super) function: &'a SingularPlaneFunction<'a>,
    pub(super) extent: f64,
    pub(super) unit: f64,
}

impl View<'_> {
    /// The triangles as pieces.
    pub(super) fn pieces(&self) -> Vec<Piece> {
        let (mesh, corners) = (self.function.mesh(), self.function.corners());
        let one = |triangle: usize| {
            let mut nodes = mesh.triangles()[triangle];
            let known = (0..3).find(|&k| corners.at(nodes[k]).is_some());
            nodes.rotate_left(known.unwrap_or(0));
            let base = mesh.nodes()[nodes[0]];
            let at = nodes.map(|node| minus(mesh.nodes()[node], base).map(|x| x / self.extent));
            let base = base.map(|x| x / self.extent);
            let anchor = corners.at(nodes[0]);
            Piece { triangle, base, anchor, is_singular: known.is_some(), nodes, at }
        };
        (0..mesh.triangles().len()).map(one).collect()
    }

    /// The value of the function at an offset from the base of a piece.
    #[inline]
    pub(super) fn value(&self, piece: &Piece, offset: Point) -> f64 {
        let real = |p: Point| p.map(|x| x * self.extent);
        self.function.at(piece.triangle, real(piece.base), real(offset), piece.anchor) / self.unit
    }

    /// The exponent at the declared corner of a singular piece.
    pub(super) fn exponent(&self, piece: &Piece) -> f64 {
        piece.anchor.map_or(1.0, |corner| self.function.corners().all[corner].exponent)
    }
}

impl Piece {
    /// The declared corner of a singular piece.
    pub(super) fn corner(&self) -> Option<usize> {
        self.anchor.filter(|_| self.is_singular)
    }

    /// Twice the area.
    pub(super) fn twice_area(&self) -> f64 {
        let (a, b) = (minus(self.at[1], self.at[0]), minus(self.at[2], self.at[0]));
        product_difference(a[0], b[1], a[1], b[0]).abs()
    }

    /// The vector from the base of another piece to that of this one.
    pub(super) fn shift_from(&self, other: &Self) -> Point {
        minus(self.base, other.base)
    }

    /// The piece as a simplex, with its corners relative to a point.
    pub(super) fn simplex(&self, shift: Point) -> Simplex<1> {
        Simplex::triangle(std::array::from_fn(|k| Corner {
            node: self.nodes[k],
            at: [self.at[k][0] + shift[0], self.at[k][1] + shift[1]],
            values: [0.0],
        }))
    }

    /// The positions of the common corners of two pieces, by number of node.
    pub(super) fn shared(&self, other: &Self) -> Vec<[usize; 2]> {
        let find = |i: usize| {
            let same = |&node: &usize| node == self.nodes[i] && node != NO_NODE;
            other.nodes.iter().position(same).map(|j| [i, j])
        };
        (0..3).filter_map(find).collect()
    }

    /// The corner opposite the shortest edge.
    pub(super) fn sharpest(&self) -> usize {
        let opposite = |k: usize| length(minus(self.at[(k + 1) % 3], self.at[(k + 2) % 3]));
        (1..3).fold(0, |best, k| if opposite(k) < opposite(best) { k } else { best })
    }

    /// The cosine of the angle at a corner.
    pub(super) fn cosine(&self, k: usize) -> f64 {
        let (a, b) =
            (minus(self.at[(k + 1) % 3], self.at[k]), minus(self.at[(k + 2) % 3], self.at[k]));
        dot(a, b) / (length(a) * length(b))
    }

    /// A power of two comparable to the size of the piece.
    pub(super) fn size(&self) -> f64 {
        power_of_two(self.simplex([0.0; 2]).longest().1)
    }

    /// Smaller pieces: for a singular piece the part at its corner and two others, for any other piece its
    /// halves.
    pub(super) fn parts(&self) -> Vec<Self> {
        let middle = |i: usize, j: usize| {
            let (a, b) = (self.at[i], self.at[j]);
            [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
        };
        if !self.is_singular {
            let ([i, j], _) = self.simplex([0.0; 2]).longest();
            return [i, j]
                .map(|replaced| {
                    let mut half = *self;
                    (half.at[replaced], half.nodes[replaced]) = (middle(i, j), NO_NODE);
                    half
                })
                .to_vec();
        }
        let [a, p, q] = self.nodes;
        let (first, last) = (middle(0, 1), middle(0, 2));
        let part = |is_singular, nodes, at| Self { is_singular, nodes, at, ..*self };
        vec![
            part(true, [a, NO_NODE, NO_NODE], [self.at[0], first, last]),
            part(false, [p, q, NO_NODE], [self.at[1], self.at[2], last]),
            part(false, [p, NO_NODE, NO_NODE], [self.at[1], last, first]),
        ]
    }
}
