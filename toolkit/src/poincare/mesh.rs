//! Graded cells for the extremal function of a zone.
//!
//! The extremal function is analytic except at 0, 1 and the ends of the zone's intervals, where it behaves like
//! powers of the distance r. Each interval between these points is divided into halves, and each half is graded
//! towards its point: an affine cell next to it, then cells on which u is a polynomial in ln r. In ln r the
//! function is a sum of exponentials that vary on scales of order one near the *features* (r equal to the
//! distance of another singular point, or to half the length) and slowly elsewhere: cells grow geometrically
//! with their distance from the features, so that θ = 1e-300 requires only a few more cells than θ = 1e-3.

use super::slopes::cell::Cell;
use crate::Order;
use std::ops::Range;

/// The parameters of a mesh; two different models are compared to estimate the error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MeshModel {
    /// Extent in ln r of the cells at a feature.
    finest: f64,
    /// Ratio of one cell to the previous one, away from features.
    growth: f64,
    /// Radius of the innermost cells relative to the nearest feature.
    innermost: f64,
    /// The same next to a zone on which u vanishes.
    innermost_at_zero: f64,
    /// The same next to a single point at which u vanishes.
    innermost_at_point: f64,
    /// Rate in ln r at which the energy decays away from the features at which it is concentrated: |1−2ν|.
    decay: f64,
    /// Number of slope functions per cell.
    functions: usize,
}

/// Largest decrease of the energy across a cell, as an exponent: beyond it, slopes on the cell would be
/// linearly dependent in f64.
const LARGEST_FALL: f64 = 8.0;
/// Exponent 28 of the decay e^−28 of the energy from which a coarse slope is sufficient.
const NEGLIGIBLE_FALL: f64 = 28.0;

/// Smallest length of the innermost cells, relative to the nearest feature.
pub(crate) const SHORTEST_RADIUS: f64 = 1e-290;

/// Smallest ratio of two features that are treated as distinct.
const SEPARATION: f64 = 3.0;

/// Largest extent in ln r of a quadrature panel.
pub(crate) const PANEL_SPREAD: f64 = 2.0;

impl MeshModel {
    /// A model for a relative error of about `error` in γ.
    ///
    /// In experiments, `functions` = 4 ... 12 give worst errors 1e-5, 6e-7, 2e-7, 1e-8, 6e-11, 3e-12, ... over
    /// all orders and zones. Truncating r^{2ν} at r = δ costs the fraction δ^{1+2ν} of the energy; truncating
    /// r^ν, the behaviour next to a zone on which u vanishes, the fraction δ; truncating r^{2ν−1}, the
    /// behaviour at a single such point, δ^{2ν−1}.
    pub(crate) fn new(order: Order, error: f64) -> Self {
        let digits = -error.log10();
        Self {
            finest: 1.5,
            growth: 1.6,
            innermost: (0.1 * error).powf(1.0 / (1.0 + 2.0 * order.value())),
            innermost_at_zero: 0.1 * error,
            innermost_at_point: (0.1 * error)
                .powf(1.0 / order.one_minus_twice().abs())
                .max(SHORTEST_RADIUS),
            decay: order.one_minus_twice().abs(),
            functions: (2.0 + 0.8 * digits).ceil().clamp(4.0, 14.0) as usize,
        }
    }

    /// A coarser model of a different shape: shorter gradings, other cells, two degrees less.
    pub(crate) fn varied(self) -> Self {
        Self {
            finest: 1.15 * self.finest,
            growth: 1.05 * self.growth,
            innermost: self.innermost.powf(0.9),
            innermost_at_zero: self.innermost_at_zero.powf(0.9),
            innermost_at_point: self.innermost_at_point.powf(0.9),
            functions: self.functions - 2,
            ..self
        }
    }

    /// The number of Gauss points per panel of [`PANEL_SPREAD`] that keeps quadrature errors below the errors
    /// of the space.
    pub(crate) fn points(&self) -> usize {
        self.functions + 4
    }

    /// The cells for consecutive parts of the given lengths, in order, and the range of cells of each part. A
    /// part of length zero has no cells and marks a point at which u vanishes; each of the parts `frozen` is
    /// one cell on which u is constant.
    pub(crate) fn cells(&self, parts: &[f64], frozen: &[usize]) -> (Vec<Cell>, Vec<Range<usize>>) {
        let mut cells = Vec::new();
        let mut ranges = Vec::new();
        for (part, &length) in parts.iter().enumerate() {
            let start = cells.len();
            if length > 0.0 {
                if frozen.contains(&part) {
                    cells.push(Cell::uniform(length, 0));
                } else {
                    self.push_part(&mut cells, parts, part, frozen);
                }
            }
            ranges.push(start..cells.len());
        }
        (cells, ranges)
    }

    fn push_part(&self, cells: &mut Vec<Cell>, parts: &[f64], part: usize, frozen: &[usize]) {
        // Distances from either end of the part to the singular points beyond it.
        let running = |sum: &mut f64, length: &f64| {
            *sum += length;
            Some(*sum)
        };
        let left: Vec<f64> = parts[..part].iter().rev().scan(0.0, running).collect();
        let right: Vec<f64> = parts[part + 1..].iter().scan(0.0, running).collect();
        let innermost = |neighbour: Option<usize>| match neighbour.and_then(|part| parts.get(part))
        {
            Some(0.0) => self.innermost_at_point,
            Some(_) if neighbour.is_some_and(|part| frozen.contains(&part)) => {
                self.innermost_at_zero
            }
            _ => self.innermost,
        };
        let length = parts[part];
        cells.extend(self.half(length, &left, innermost(part.checked_sub(1))));
        let mirrored = self.half(length, &right, innermost(Some(part + 1)));
        cells.extend(mirrored.into_iter().rev().map(Cell::mirrored));
    }

    /// Cells from a singular point up to half the length of its interval; `innermost` is relative to the
    /// nearest feature.
    fn half(&self, length: f64, others: &[f64], innermost: f64) -> Vec<Cell> {
        let top = 0.5 * length;
        let mut features: Vec<f64> = Vec::new();
        for &distance in others {
            // Features closer than a cell are one feature.
            let apart = features.last().is_none_or(|&last| distance > SEPARATION * last);
            if distance > 0.0 && apart && SEPARATION * distance < top {
                features.push(distance);
            }
        }
        features.push(top);
        let inner = innermost * features[0];
        let mut cells = vec![Cell::uniform(inner, self.functions.min(2))];
        let mut spreads = self.grow((features[0] / inner).ln());
        spreads.reverse();
        for pair in features.windows(2) {
            let span = (pair[1] / pair[0]).ln();
            if span < 2.0 * self.finest {
                spreads.push((span, self.functions));
            } else {
                let half = self.grow(0.5 * span);
                spreads.extend(half.iter());
                spreads.extend(half.iter().rev());
            }
        }
        let mut radius = inner;
        for (spread, functions) in spreads {
            cells.push(Cell::from_left(radius, spread, functions));
            radius *= spread.exp();
        }
        // The rounding of the last radius is immaterial: the length of the part is only used through its
        // cells.
        cells
    }

    /// Extents that start near `finest` at a feature, grow by `growth` and fill `span`, with their numbers of
    /// functions.
    fn grow(&self, span: f64) -> Vec<(f64, usize)> {
        let mut extents = Vec::new();
        let (mut sum, mut next) = (0.0, self.finest);
        // One more cell as long as the common factor that makes them fit stays closer to 1.
        while extents.is_empty() || sum * (sum + next) < span * span {
            let is_carrying = sum * self.decay < NEGLIGIBLE_FALL;
            extents.push((next, if is_carrying { self.functions } else { 2 }));
            sum += next;
            next = (self.growth * next).min(LARGEST_FALL / self.decay);
        }
        extents.iter_mut().for_each(|(extent, _)| *extent *= span / sum);
        extents
    }
}
