//! The cells on which u − u_h is smooth, and those at the breakpoints of u.
//!
//! The elements of the mesh are cut at the breakpoints, and further until no cell is longer than its distance
//! to the nearest breakpoint. The two pieces next to a breakpoint are bisected until there is no structure in them on
//! a scale much shorter than the distance to the breakpoint: the half at the breakpoint is
//! singular, the other one is as long as its distance to it. The two halves at a breakpoint form its *patch*.

use crate::error::{Error, Result};
use crate::functions::Look;
use crate::mesh::Mesh;
use crate::numeric::sum::RunningSum;

/// A node and a breakpoint are identified if they differ by at most this, relative to the larger of the ends.
const SAME: f64 = 4.0 * f64::EPSILON;

/// A part of an element, between two breakpoints.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    pub(super) element: usize,
    /// in local coordinates of the element
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) length: f64,
    /// between the breakpoints `gap` and `gap` + 1, with the distances of its ends to these
    pub(super) gap: usize,
    pub(super) left: f64,
    pub(super) right: f64,
    /// the breakpoint to whose patch it belongs
    pub(super) patch: Option<usize>,
    /// true if the breakpoint is one of its ends
    pub(super) is_singular: bool,
}

impl Part {
    /// The two halves.
    pub(super) fn halves(self) -> [Self; 2] {
        let (half, middle) = (0.5 * self.length, 0.5 * (self.from + self.to));
        [
            Self { to: middle, length: half, right: self.right + half, ..self },
            Self { from: middle, length: half, left: self.left + half, ..self },
        ]
    }

    /// The cells of the part, from left to right.
    fn refine(self, look: &Look, cells: &mut Vec<Self>) {
        let [first, second] = self.halves();
        match (self.left == 0.0, self.right == 0.0) {
            (true, false) if self.length > look.nearest(self.gap, true) => {
                first.refine(look, cells);
                second.refine(look, cells);
            }
            (false, true) if self.length > look.nearest(self.gap + 1, false) => {
                first.refine(look, cells);
                second.refine(look, cells);
            }
            (true, false) => {
                let patch = Some(self.gap);
                cells
                    .extend([Self { patch, is_singular: true, ..first }, Self { patch, ..second }]);
            }
            (false, true) => {
                let patch = Some(self.gap + 1);
                cells
                    .extend([Self { patch, ..first }, Self { patch, is_singular: true, ..second }]);
            }
            (false, false) if self.length <= 1.01 * self.left.min(self.right) => cells.push(self),
            _ => {
                first.refine(look, cells);
                second.refine(look, cells);
            }
        }
    }
}

/// The cells of all elements, from left to right.
pub(super) fn layout(partition: &Mesh, breaks: &[f64], look: &Look) -> Result<Vec<Part>> {
    let size = breaks.iter().fold(0.0_f64, |most, c| most.max(c.abs())).max(partition.total());
    let end = partition.left() + partition.total();
    let last = breaks[breaks.len() - 1];
    let same = (breaks[0] - partition.left()).abs().max((last - end).abs()) <= 16.0 * SAME * size;
    Error::require(
        "left end of the mesh",
        partition.left(),
        "{left end of the function's interval}: the mesh and the function must have the same interval",
        same,
    )?;
    let mut cuts: Vec<Vec<f64>> = vec![Vec::new(); partition.len()];
    let mut is_break = vec![false; partition.len() + 1];
    for (k, &c) in breaks.iter().enumerate() {
        let node = match k {
            0 => Some(0),
            _ if k + 1 == breaks.len() => Some(partition.len()),
            _ => node_at(partition, c - partition.left(), SAME * size),
        };
        match node {
            Some(node) => is_break[node] = true,
            None => {
                let offset = c - partition.left();
                let element = partition.from_left().partition_point(|&x| x < offset) - 1;
                cuts[element].push(offset - partition.from_left()[element]);
            }
        }
    }
    let mut gaps: Vec<Vec<Part>> = Vec::new();
    for (element, offsets) in cuts.iter().enumerate() {
        let h = partition.lengths()[element];
        let ends: Vec<f64> =
            std::iter::once(0.0).chain(offsets.iter().copied()).chain([h]).collect();
        for (k, pair) in ends.windows(2).enumerate() {
            if k > 0 || is_break[element] {
                gaps.push(Vec::new());
            }
            let gap = gaps.len() - 1;
            let (from, to) = (pair[0] / h, pair[1] / h);
            let (length, left, right) = (pair[1] - pair[0], 0.0, 0.0);
            let part = Part {
                element,
                from,
                to,
                length,
                gap,
                left,
                right,
                patch: None,
                is_singular: false,
            };
            gaps[gap].push(part);
        }
    }
    // Two breaks may lie closer than nodes are known.
    let expected = breaks.len() - 1;
    if gaps.len() != expected {
        let (name, given) = ("intervals between breakpoints that the mesh represents", gaps.len());
        return Err(Error::LengthMismatch { name, given, expected });
    }
    let mut cells = Vec::new();
    for parts in &mut gaps {
        let (mut left, mut right) = (RunningSum::default(), RunningSum::default());
        for part in parts.iter_mut() {
            part.left = left.value();
            left.add(part.length);
        }
        for part in parts.iter_mut().rev() {
            part.right = right.value();
            right.add(part.length);
        }
        parts.iter().for_each(|part| part.refine(look, &mut cells));
    }
    Ok(cells)
}

/// The inner node at a distance from the left end; of several that are equally close, the one between the
/// shortest elements, towards which the mesh is graded.
fn node_at(partition: &Mesh, offset: f64, tolerance: f64) -> Option<usize> {
    let nodes = partition.from_left();
    let first = nodes.partition_point(|&x| x < offset - tolerance).max(1);
    let end = nodes.partition_point(|&x| x <= offset + tolerance).min(partition.len());
    let around = |k: &usize| partition.lengths()[k - 1] + partition.lengths()[*k];
    (first..end).min_by(|a, b| around(a).total_cmp(&around(b)))
}
