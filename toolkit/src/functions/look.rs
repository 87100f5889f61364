//! What every norm of a formula sees of it between the breakpoints.
//!
//! Every interval between breakpoints is sampled at 2 × [`LOOKS`] points of equal distance, once. A polynomial on a
//! cell, by whichever method, must agree with the samples in the cell, or the cell is bisected. A feature that stands
//! out over 1/500 of the interval, such as a bell whose standard deviation is 1/1000 of it, covers at least one
//! sample, wherever it lies.
//!
//! The ends of the cells that [`super::waves`] finds in this way are kept in a [`Look`]. There the cells of integrals of
//! functions with structure on many scales ([`super::by_scales`]) and of the polynomials of dual norms are cut, and the
//! elements of u − u_h next to a breakpoint are bisected until a narrow cell lies outside of them. The rules for |u|_ν and
//! the cells of `crate::resolved` do not use them.

use super::arm::Arm;
use super::function::SingularFunction;

/// Number of samples of a side.
pub(super) const LOOKS: usize = 256;
/// Position of a sample in its share of the side: no simple fraction, at which functions have special values.
const WITHIN: f64 = 0.4822;
/// A cell is narrow if its distance to the breakpoint exceeds its length by this factor: on cells that shrink towards a
/// breakpoint the two are comparable.
const NARROW: f64 = 3.0;
/// The same factor for cells that are shorter than those of a singularity at the breakpoint, and their number from which
/// errors of rules are not extrapolated.
const SHORTER: f64 = 1.5;
const SEVERAL: usize = 2;

/// The distance of sample j of a side from its breakpoint, in units of the length of the side.
pub(super) fn share(j: usize) -> f64 {
    (j as f64 + WITHIN) / LOOKS as f64
}

/// The distance of sample j of a side from its breakpoint.
pub(super) fn distance(arm: &Arm, j: usize) -> f64 {
    arm.length * share(j)
}

/// The cells on which a function is a polynomial to the requested accuracy.
#[derive(Debug, Default)]
pub(crate) struct Look {
    /// For every side the distances from its breakpoint at which cells meet, in increasing order.
    cuts: Vec<Vec<f64>>,
    /// For every side the distance from its breakpoint to the nearest narrow cell; infinite if there is none.
    nearest: Vec<f64>,
    /// True if there is structure on a scale much shorter than the distance to the breakpoints.
    pub(super) is_inside: bool,
    /// True if several cells are shorter than those that shrink towards the breakpoint, though not much.
    pub(super) is_structured: bool,
}

impl Look {
    /// Appends a side, by the distances from its breakpoint at which its cells end, the first one being 0.
    pub(super) fn push(&mut self, ends: &[f64]) {
        let narrow = |pair: &&[f64]| (pair[1] - pair[0]) * NARROW < pair[0];
        let nearest = ends.windows(2).find(narrow).map_or(f64::INFINITY, |pair| pair[0]);
        self.cuts.push(ends.get(1..ends.len().saturating_sub(1)).unwrap_or_default().to_vec());
        self.nearest.push(nearest);
        self.is_inside |= nearest.is_finite();
        let shorter = |pair: &&[f64]| (pair[1] - pair[0]) * SHORTER < pair[0];
        self.is_structured |= ends.windows(2).filter(shorter).count() >= SEVERAL;
    }

    /// The distances in (near, far) at which cells of a side meet.
    pub(crate) fn cuts(&self, arm: &Arm, near: f64, far: f64) -> &[f64] {
        let all = self.cuts.get(arm.index()).map_or(&[][..], Vec::as_slice);
        let first = all.partition_point(|&cut| cut <= near);
        &all[first..all.partition_point(|&cut| cut < far).max(first)]
    }

    /// The distance from breakpoint k to the nearest narrow cell on the given side of it.
    pub(crate) fn nearest(&self, k: usize, is_right: bool) -> f64 {
        let index = if is_right { Some(2 * k) } else { (2 * k).checked_sub(1) };
        index.and_then(|index| self.nearest.get(index)).copied().unwrap_or(f64::INFINITY)
    }
}

impl SingularFunction<'_> {
    /// The samples (δ, u) of a side with near < δ < far.
    pub(crate) fn seen_within(
        &self,
        arm: &Arm,
        near: f64,
        far: f64,
    ) -> impl Iterator<Item = (f64, f64)> + '_ {
        let values = self.samples_of(arm.index());
        let place =
            |delta: f64| (delta / arm.length * LOOKS as f64 - WITHIN).clamp(0.0, LOOKS as f64);
        let first = (place(near).floor() as usize).min(values.len());
        let end = ((place(far).ceil() as usize) + 1).min(values.len()).max(first);
        let arm = *arm;
        let of = move |(k, &value): (usize, &f64)| (distance(&arm, first + k), value);
        values[first..end]
            .iter()
            .enumerate()
            .map(of)
            .filter(move |(delta, _)| *delta > near && *delta < far)
    }

    /// The samples in a cell: their coordinates in it, from left to right 0 to 1, and the values.
    pub(crate) fn seen_in_cell(&self, arm: &Arm, near: f64, far: f64) -> (Vec<f64>, Vec<f64>) {
        let local = |(delta, value): (f64, f64)| {
            let t = if arm.sign > 0.0 { delta - near } else { far - delta } / (far - near);
            (t, value)
        };
        self.seen_within(arm, near, far).map(local).unzip()
    }
}
