//! A short zone of length θ in the interior: local coordinates for the kernel; the local basis is in
//! [`super::hats`].
//!
//! Near the zone K(s,t) is a constant κ plus a part of order r^p, p = 1 − 2ν, r the distance from the zone. For
//! p > 0 a jump of u has finite energy, the extremal function jumps down and up again, and in the step basis
//! its energy θ^p would be a difference of numbers of order one. Within a group G of cells around the zone
//!
//! * neighbouring steps are replaced by their differences, continuous hat functions; the last step of G
//!   is kept (the net increment),
//! * the kernel is taken relative to the point P at the left end of the zone: K(s,t) − κ for s, t ∈ G and
//!   K(s,t) − K(P,t) for s ∈ G, t outside. The hat functions and the functions of degree ≥ 1 have zero
//!   increment and are not affected by the subtraction; for the last step it is added back.
//!
//! All entries then have the order of magnitude of the energies of their basis functions, uniformly in θ. For
//! p well below 0 the basis of steps is preferable (a wide plateau of many short hat functions would have a
//! negligible energy compared with theirs); there the group serves only to replace near points by P in
//! distant interactions.

use super::kernel::{exp_quotient, kernel, ln_ratio};
use super::space::SlopeSpace;
use std::ops::Range;

/// The group is used for zones shorter than this fraction of their distance from the ends ...
pub(crate) const SHORT: f64 = 0.05;
/// ... and extends to this distance, in the same unit.
const REACH: f64 = 0.3;
/// Ratio of distances from P below which two hat functions do not interact: their share of the energy is this
/// ratio times a logarithm.
const NEGLIGIBLE: f64 = 1e-16;
/// The same for p > 0.1 at the zone, where the entries of hat functions are differences of larger entries
/// and have larger rounding errors. The energy of the extremal function decays like (θ/r)^p, and the ratio
/// increases accordingly up to the second number.
const NEGLIGIBLE_FOR_JUMPS: (f64, f64) = (1e-13, 1e-6);
/// Order below which the rounding error of the entries is 1e-16/ν, and more interactions must be neglected.
const SMALL_ORDER: f64 = 0.2;

/// The ratio for p > 0.1 at the zone, which is the share of the energy that is neglected.
pub(crate) fn negligible_for_jumps(p: f64) -> f64 {
    NEGLIGIBLE_FOR_JUMPS.0 * (2.0 * SMALL_ORDER / (1.0 - p)).max(1.0)
}
/// Smallest energy of a plateau of hat functions, relative to theirs, for which the precision of f64 suffices.
const WELL_CONDITIONED: f64 = 1e-4;
/// Ratio of distances from P below which the nearer point is replaced by P.
const INDISTINCT: f64 = 1e-15;

/// The group G and its point P.
#[derive(Debug, Clone)]
pub(crate) struct Local {
    pub(super) p: f64,
    pub(super) cells: Range<usize>,
    /// True if hat functions are used instead of steps.
    pub(super) has_hats: bool,
    /// The first cell to the right of P.
    origin: usize,
    /// Distances of P from the two ends, and the length at which d^p is subtracted.
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) unit: f64,
    unit_power: f64,
    /// Distance from P to the nearer end of each panel and of each cell.
    panel_offsets: Vec<f64>,
    cell_offsets: Vec<f64>,
}

/// Distances from the boundary in front of entry `origin` to the nearer end of each entry.
fn offsets(lengths: &[f64], origin: usize) -> Vec<f64> {
    let mut distances = vec![0.0; lengths.len()];
    for i in origin + 1..lengths.len() {
        distances[i] = distances[i - 1] + lengths[i - 1];
    }
    for i in (0..origin.saturating_sub(1)).rev() {
        distances[i] = distances[i + 1] + lengths[i + 1];
    }
    distances
}

impl Local {
    /// The group around the cells of `zone` (for a zone of several intervals, from the first to the last);
    /// `None` if it is not needed.
    pub(crate) fn new(space: &SlopeSpace, zone: &Range<usize>, p: f64) -> Option<Self> {
        let lengths: Vec<f64> = space.cells.iter().map(|cell| cell.length).collect();
        let length: f64 = lengths[zone.clone()].iter().sum();
        let (left, rest) =
            (*space.cell_left.get(zone.start)?, *space.cell_right.get(zone.end.checked_sub(1)?)?);
        let nearest = left.min(rest);
        if length <= 0.0 || length > SHORT * nearest {
            return None;
        }
        let origin = zone.start;
        // κ must not exceed what a net increment costs: θ^p is the smaller energy for p > 0, that of the
        // whole for p ≤ 0
        let unit = if p > 0.0 { length } else { nearest };
        let cell_offsets = offsets(&lengths, origin);
        let reached = |c: &usize| cell_offsets[*c] + lengths[*c] <= REACH * nearest;
        let start = (0..origin).rev().take_while(reached).last().unwrap_or(origin);
        let end = (origin..lengths.len()).take_while(reached).last().map_or(origin, |c| c + 1);
        let shortest = lengths[start..end].iter().copied().fold(length, f64::min);
        let has_hats = p >= 0.0 || (shortest / nearest).powf(-p) > WELL_CONDITIONED;
        let first_panel = space.panels.iter().position(|panel| panel.cell >= origin)?;
        let panel_lengths: Vec<f64> = space.panels.iter().map(|panel| panel.length).collect();
        Some(Self {
            p,
            cells: start..end,
            has_hats,
            origin,
            left,
            right: length + rest,
            unit,
            unit_power: unit.powf(p),
            panel_offsets: offsets(&panel_lengths, first_panel),
            cell_offsets,
        })
    }

    pub(crate) fn contains(&self, cell: usize) -> bool {
        self.cells.contains(&cell)
    }

    /// True if the basis has hat functions and the kernel is shifted in this cell.
    pub(crate) fn is_shifted(&self, cell: usize) -> bool {
        self.has_hats && self.contains(cell)
    }

    /// The signed distance from P of the point ξ of a panel.
    pub(crate) fn position(&self, space: &SlopeSpace, panel: usize, xi: f64) -> f64 {
        let (offset, shape) = (self.panel_offsets[panel], &space.panels[panel]);
        if shape.cell >= self.origin {
            offset + shape.left_distance(xi)
        } else {
            -(offset + shape.right_distance(1.0 - xi))
        }
    }

    /// (x^p − a^p)/p for the distances x, a of t and P from the left end.
    pub(crate) fn of_further(&self, t: f64) -> f64 {
        self.left.powf(self.p) * exp_quotient(self.p, (t / self.left).ln_1p())
    }

    /// (y^p − b^p)/p for the distances y, b of s and P from the right end.
    pub(crate) fn of_nearer(&self, s: f64) -> f64 {
        self.right.powf(self.p) * exp_quotient(self.p, (-s / self.right).ln_1p())
    }

    /// ν (K(s,t) − κ) for s < t in G at distance d, without the terms of either point alone.
    pub(crate) fn inside(&self, d: f64) -> f64 {
        -self.unit_power * exp_quotient(self.p, ln_ratio(d, self.unit))
    }

    /// ν (K(P,t) − κ), or ν (K(s,P) − κ), for a point of G at signed distance `position` from P; without κ
    /// if there are no hat functions.
    pub(crate) fn origin_kernel(&self, position: f64) -> f64 {
        if !self.has_hats {
            let (before, after) = if position > 0.0 {
                (self.left, self.right - position)
            } else {
                (self.left + position, self.right)
            };
            return kernel(self.p, before, position.abs(), after);
        }
        let alone =
            if position > 0.0 { self.of_further(position) } else { self.of_nearer(position) };
        alone + self.inside(position.abs())
    }

    /// `Some(true)` if the distance of the first panel from P is below the rounding error at the second one,
    /// `Some(false)` in the opposite case, `None` otherwise.
    pub(crate) fn is_nearer(&self, space: &SlopeSpace, i: usize, j: usize) -> Option<bool> {
        let reach = |panel: usize| self.panel_offsets[panel] + space.panels[panel].length;
        let is_nearer =
            |near: usize, far: usize| reach(near) < INDISTINCT * self.panel_offsets[far];
        if is_nearer(i, j) { Some(true) } else { is_nearer(j, i).then_some(false) }
    }

    /// The largest and the smallest distance from P over cells of G next to `cell`, `width` on either side.
    pub(super) fn range(
        &self,
        space: &SlopeSpace,
        cells: impl Iterator<Item = usize>,
    ) -> (f64, f64) {
        cells.fold((f64::INFINITY, 0.0), |(low, high), c| {
            let offset = self.cell_offsets[c];
            (offset.min(low), (offset + space.cells[c].length).max(high))
        })
    }

    /// True if hat functions up to the distance `near` from P do not interact with those beyond `far`.
    pub(super) fn is_apart(&self, near: f64, far: f64) -> bool {
        let ratio = if self.p > 0.1 {
            let fall = (near / self.unit).max(1.0).powf(self.p);
            (negligible_for_jumps(self.p) * fall).min(NEGLIGIBLE_FOR_JUMPS.1)
        } else {
            NEGLIGIBLE
        };
        near < ratio * far
    }

    /// True if no basis function with a step of cell c interacts with one of cell d, by the distances from P; a
    /// hat function joins at most three cells. The last step of G has an increment and interacts with all larger
    /// functions, and so does a function outside G.
    pub(crate) fn is_negligible(&self, space: &SlopeSpace, c: usize, d: usize) -> bool {
        let around = |cell: usize| {
            let (low, high) =
                (cell.saturating_sub(2).max(self.cells.start), (cell + 2).min(self.last()));
            if self.contains(cell) { low..=high } else { cell..=cell }
        };
        // Near the end of G the last step itself may be among the neighbours: then nothing is skipped.
        let is_local =
            |cell: usize| self.contains(*around(cell).start()) && *around(cell).end() < self.last();
        let [first, second] = [c, d].map(|cell| self.range(space, around(cell)));
        (is_local(c) && self.is_apart(first.1, second.0))
            || (is_local(d) && self.is_apart(second.1, first.0))
    }

    /// The cell whose step is kept.
    pub(super) fn last(&self) -> usize {
        self.cells.end - 1
    }
}
