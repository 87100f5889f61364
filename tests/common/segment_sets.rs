//! The consistency term of one segment for any contact set made of the cells of a mesh, both cones.
//!
//! T = (0, 1), E a union of cells, N the rest; σ lives on E, w = u' on N. In the continuous piecewise linears
//! that vanish where they must, the best pair for the term is a small dense problem:
//!
//! | cone | term | σ enters through | w enters through |
//! | --- | --- | --- | --- |
//! | nodal | u(0) ∫σ(1−x) + u(1) ∫σx | ∫σ(1−x), ∫σx | −∫w over the gap at 0, ∫w over that at 1 |
//! | midpoint | ∫_N u ∫σ | ∫σ | −∫w x over gaps at 0 and inside, ∫w(1−x) over that at 1 |
//!
//! with ∫w = 0 on each gap inside, because u vanishes at both its ends. The space is conforming: every value
//! is a lower bound of the supremum for its set, where the signs u ≤ 0, σ ≤ 0 are not imposed. Cost O(N³).

use fractional_sobolev::{Given, Gram, Mesh, Order};
use nalgebra::{Cholesky, DMatrix};
use signorini::cone::Cone;
use signorini::{Error, Result, ToolkitError};
use std::ops::Range;

/// Numbers in (0, 1), the same on every machine.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 * 2f64.powi(-53)
    }
}

/// A mesh of (0, 1) and the Gram matrix of its hats.
#[derive(Debug, Clone)]
pub struct SegmentSets {
    nodes: Vec<f64>,
    gram: DMatrix<f64>,
}

/// Contact or not, per cell, and the ratio of the set.
#[derive(Debug, Clone, PartialEq)]
pub struct RatedSet {
    /// `true` on cells in contact.
    pub contact: Vec<bool>,
    /// sup term / (|σ|_ν |w|_ν) over the pairs of the mesh.
    pub ratio: f64,
}

impl RatedSet {
    /// Number of gaps.
    pub fn gaps(&self) -> usize {
        runs(&self.contact, false).len()
    }
}

/// The largest ratios found by three searches.
#[derive(Debug, Clone, PartialEq)]
pub struct SegmentSearch {
    /// Of the random sets.
    pub random: RatedSet,
    /// Where turning single cells of it for the better ends.
    pub climbed: RatedSet,
    /// Of all contact intervals of the mesh.
    pub interval: RatedSet,
}

impl SegmentSearch {
    /// The largest of them.
    pub fn largest(&self) -> f64 {
        self.random.ratio.max(self.climbed.ratio).max(self.interval.ratio)
    }
}

impl SegmentSets {
    /// Equal cells, 4 to 1024.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange).
    pub fn new(order: impl Given<Order>, cells: usize) -> Result<Self> {
        if !(4..=1024).contains(&cells) {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "cells",
                value: cells,
                range: "4 to 1024",
            }));
        }
        let partition = Mesh::uniform(cells, 1.0)?;
        Ok(Self { nodes: partition.nodes(), gram: Gram::new(&partition, order, 1e-8)?.to_dense()? })
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.nodes.len() - 1
    }

    /// sup term / (|σ|_ν |w|_ν) over the pairs of the mesh; 0 where one has no room, as for full contact.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](signorini::ToolkitError::LengthMismatch) unless there is one entry per cell.
    pub fn ratio(&self, cone: Cone, contact: &[bool]) -> Result<f64> {
        let (given, expected) = (contact.len(), self.cells());
        if given != expected {
            return Err(Error::Toolkit(ToolkitError::LengthMismatch { name: "contact", given, expected }));
        }
        let gaps = runs(contact, false);
        let (of_contact, of_gaps) = (self.hats(&runs(contact, true)), self.hats(&gaps));
        if of_contact.is_empty() || of_gaps.is_empty() {
            return Ok(0.0);
        }
        let (last, nodal) = (self.cells(), cone == Cone::Nodal);
        let moments = |hats: &[usize], weight: &dyn Fn(f64) -> f64| -> Vec<f64> {
            hats.iter().map(|&i| self.integral(i, 0..last, weight)).collect()
        };
        let over = |gap: &Range<usize>, weight: &dyn Fn(f64) -> f64| -> Vec<f64> {
            of_gaps.iter().map(|&i| self.integral(i, gap.clone(), weight)).collect()
        };
        let at = |gap: &Range<usize>| (gap.start == 0, gap.end == last);
        // Constraints: ∫ w = 0 inside; a gap without a hat of its own has none.
        let inside = gaps.iter().filter(|gap| at(gap) == (false, false) && gap.len() > 1);
        let constraints: Vec<Vec<f64>> = inside.map(|gap| over(gap, &|_| 1.0)).collect();
        let end = |of_left: bool, weight: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let found = gaps.iter().find(|gap| if of_left { at(gap).0 } else { at(gap).1 });
            found.map_or(vec![0.0; of_gaps.len()], |gap| over(gap, weight))
        };
        let (s, m) = if nodal {
            let of_sigma = vec![moments(&of_contact, &|x| 1.0 - x), moments(&of_contact, &|x| x)];
            let of_w = vec![end(true, &|_| -1.0), end(false, &|_| 1.0)];
            (self.dual(&of_contact, of_sigma, &[])?, self.dual(&of_gaps, of_w, &constraints)?)
        } else {
            let opening = gaps.iter().map(|gap| match at(gap).1 {
                true => over(gap, &|x| 1.0 - x),
                false => over(gap, &|x| -x),
            });
            let sum = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(&b).map(|(x, y)| x + y).collect();
            let of_w = opening.fold(vec![0.0; of_gaps.len()], sum);
            let of_sigma = moments(&of_contact, &|_| 1.0);
            (self.dual(&of_contact, vec![of_sigma], &[])?, self.dual(&of_gaps, vec![of_w], &constraints)?)
        };
        let product = &s * &m;
        let square = if nodal {
            let (half, apart) =
                (0.5 * (product[(0, 0)] + product[(1, 1)]), 0.5 * (product[(0, 0)] - product[(1, 1)]));
            half + (apart * apart + product[(0, 1)] * product[(1, 0)]).max(0.0).sqrt()
        } else {
            product[(0, 0)]
        };
        Ok(square.max(0.0).sqrt())
    }

    /// `count` random sets with up to `gaps` gaps of lengths of all sizes, the ascent from the best of them,
    /// and every contact interval.
    ///
    /// # Errors
    /// As for [`SegmentSets::ratio`].
    pub fn search(&self, cone: Cone, gaps: usize, count: usize, seed: u64) -> Result<SegmentSearch> {
        let mut numbers = Numbers(seed);
        let sets = (0..count).map(|_| self.random(gaps, &mut numbers)).collect();
        let random = self.largest(cone, sets)?;
        let climbed = self.climbed(cone, random.clone())?;
        let n = self.cells();
        let ends = (0..n).flat_map(|a| (a + 1..=n).map(move |b| a..b));
        let intervals = ends.map(|e| (0..n).map(|k| e.contains(&k)).collect()).collect();
        Ok(SegmentSearch { random, climbed, interval: self.largest(cone, intervals)? })
    }

    /// The set made better as long as turning one cell raises its ratio.
    fn climbed(&self, cone: Cone, from: RatedSet) -> Result<RatedSet> {
        let mut best = from;
        loop {
            let turned = (0..self.cells()).map(|k| {
                let mut contact = best.contact.clone();
                contact[k] = !contact[k];
                contact
            });
            let found = self.largest(cone, turned.collect())?;
            if found.ratio <= best.ratio {
                return Ok(best);
            }
            best = found;
        }
    }

    fn largest(&self, cone: Cone, sets: Vec<Vec<bool>>) -> Result<RatedSet> {
        let rated = sets.into_iter().map(|contact| {
            let ratio = self.ratio(cone, &contact)?;
            Ok(RatedSet { contact, ratio })
        });
        let nothing = RatedSet { contact: vec![true; self.cells()], ratio: 0.0 };
        rated
            .into_iter()
            .try_fold(nothing, |a, b: Result<RatedSet>| b.map(|b| if b.ratio > a.ratio { b } else { a }))
    }

    /// Runs whose ends are random nodes.
    fn random(&self, gaps: usize, numbers: &mut Numbers) -> Vec<bool> {
        let n = self.cells();
        let count = 1 + (numbers.next() * (2 * gaps) as f64) as usize;
        let mut ends: Vec<usize> =
            (0..count).map(|_| 1 + (numbers.next() * (n - 1) as f64) as usize).collect();
        ends.sort_unstable();
        let first = numbers.next() < 0.5;
        (0..n).map(|k| first ^ (ends.partition_point(|&end| end <= k) % 2 == 1)).collect()
    }

    /// The nodes whose hats live on the runs.
    fn hats(&self, of: &[Range<usize>]) -> Vec<usize> {
        let last = self.cells();
        let nodes = |run: &Range<usize>| {
            run.start + usize::from(run.start > 0)..run.end + usize::from(run.end == last)
        };
        of.iter().flat_map(nodes).collect()
    }

    /// ∫ of hat i times a linear weight over the given cells: Simpson's rule on both its cells.
    fn integral(&self, i: usize, cells: Range<usize>, weight: &dyn Fn(f64) -> f64) -> f64 {
        let own = i.saturating_sub(1)..(i + 1).min(self.cells());
        own.filter(|cell| cells.contains(cell))
            .map(|cell| {
                let (a, b) = (self.nodes[cell], self.nodes[cell + 1]);
                (b - a) / 6.0 * (2.0 * weight(0.5 * (a + b)) + weight(self.nodes[i]))
            })
            .sum()
    }

    /// b_i' G⁻¹ b_j on the hats, under the constraints c' w = 0.
    fn dual(&self, hats: &[usize], loads: Vec<Vec<f64>>, constraints: &[Vec<f64>]) -> Result<DMatrix<f64>> {
        let size = hats.len();
        let matrix = DMatrix::from_fn(size, size, |i, j| self.gram[(hats[i], hats[j])]);
        let right: Vec<&Vec<f64>> = loads.iter().chain(constraints).collect();
        let right = DMatrix::from_fn(size, right.len(), |i, j| right[j][i]);
        let indefinite = || {
            Error::Toolkit(ToolkitError::NotPositiveDefinite {
                what: "Gram matrix of a part of the segment",
                pivot: size,
            })
        };
        let solution = Cholesky::new(matrix).ok_or_else(indefinite)?.solve(&right);
        let forms = right.tr_mul(&solution);
        let (n, all) = (loads.len(), right.ncols());
        let free = forms.view((0, 0), (n, n)).into_owned();
        if all == n {
            return Ok(free);
        }
        let mixed = forms.view((n, 0), (all - n, n)).into_owned();
        let fixed = forms.view((n, n), (all - n, all - n)).into_owned();
        let multipliers = Cholesky::new(fixed).ok_or_else(indefinite)?.solve(&mixed);
        Ok(free - mixed.tr_mul(&multipliers))
    }
}

/// Maximal runs of cells with the given state.
fn runs(contact: &[bool], state: bool) -> Vec<Range<usize>> {
    let mut start = 0;
    let mut found = Vec::new();
    for run in contact.chunk_by(|a, b| a == b) {
        if run[0] == state {
            found.push(start..start + run.len());
        }
        start += run.len();
    }
    found
}

mod tests {
    use super::*;
    use fractional_sobolev::Tolerance;
    use signorini::proof::{consistency_constant, worst_ratio};

    fn sets(nu: f64) -> SegmentSets {
        SegmentSets::new(Order::new(nu).unwrap(), 40).unwrap()
    }

    fn one_gap(cells: usize, gap: usize) -> Vec<bool> {
        (0..cells).map(|k| k >= gap).collect()
    }

    #[test]
    fn one_gap_and_its_complement_exchange_the_cones() {
        let sets = sets(0.3);
        for gap in [3, 10, 25] {
            let nodal = sets.ratio(Cone::Nodal, &one_gap(40, gap)).unwrap();
            let midpoint = sets.ratio(Cone::Midpoint, &one_gap(40, 40 - gap)).unwrap();
            assert!((nodal / midpoint - 1.0).abs() < 1e-11, "{gap}: {nodal} {midpoint}");
        }
    }

    #[test]
    fn piecewise_linears_and_constants_bound_the_same_ratio() {
        let here = sets(0.25).ratio(Cone::Nodal, &one_gap(40, 10)).unwrap();
        let there = worst_ratio(Cone::Nodal, 1.75, 0.0, 0.25, Tolerance::new(0.02).unwrap()).unwrap().value;
        assert!(here < 1.02 * there && here > 0.8 * there, "{here} {there}");
    }

    #[test]
    fn a_gap_without_room_only_takes_room_from_the_pressure() {
        let sets = sets(0.25);
        let base = one_gap(40, 12);
        let mut inside = base.clone();
        inside[25] = false;
        let ratio = |contact: &[bool]| sets.ratio(Cone::Midpoint, contact).unwrap();
        assert!(ratio(&inside) < ratio(&base));
        assert_eq!(RatedSet { contact: inside, ratio: 0.0 }.gaps(), 2);
    }

    #[test]
    fn no_random_set_passes_the_sharp_constant() {
        for nu in [0.1, 0.5, 0.9] {
            let order = Order::new(nu).unwrap();
            let sharp = consistency_constant(order, Tolerance::fast()).unwrap().value;
            for cone in [Cone::Nodal, Cone::Midpoint] {
                let found = sets(nu).search(cone, 10, 200, 7).unwrap();
                let best = found.largest();
                assert!(found.random.ratio <= found.climbed.ratio, "{cone} {nu}: {found:?}");
                assert!(best <= sharp.value, "{cone} {nu}: {found:?} {sharp}");
                assert!(best > 0.7 * sharp.value, "{cone} {nu}: {found:?} {sharp}");
            }
        }
    }
}
