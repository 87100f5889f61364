//! (6.2) for one function: |v(x) − v̄| ≤ h^{1/2} ‖v'‖₀ at a node x, v with constant slopes on equal cells.

use crate::SplitMix;
use fractional_sobolev::{Domain, Error, ErrorNorm, Estimate, Result, Work, projection_constant};

/// Most cells: sums of so many terms keep twelve digits.
const LARGEST: usize = 1 << 20;

/// |v(x) − v̄| / ‖v'‖₀ at x = node/N for the v with these N slopes; 0 for a constant.
///
/// # Method
///
/// Both sides scale alike with h, so that the interval is (0, 1). At x = j/N the slopes that come nearest are
/// the means of k over the cells, k(s) = s before x and s − 1 beyond; on a cell k is
/// linear with slope one, and what they miss is
///
/// κ(x)² − q² = 1/(12 N²).
///
/// Values and mean of v are summed from the slopes; κ does not enter. Cost O(N) for one function.
///
/// ```
/// use experiments::interpolation::{extremal_slopes, largest_share, mean_deviation};
/// // at an end the best constant of (6.2) is 1/√3
/// let found = mean_deviation(&extremal_slopes(100, 0)?, 0)?;
/// assert!((found.value - 1.0 / 3f64.sqrt()).abs() < 1e-5);
/// assert!(largest_share(20, 10, 1)?.value < 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::CountOutOfRange`] unless 1 ≤ N ≤ 2^20 and node ≤ N; [`Error::NotFinite`] for a slope.
pub fn mean_deviation(slopes: &[f64], node: usize) -> Result<Estimate> {
    let cells = slopes.len();
    check(cells, node)?;
    if let Some(index) = slopes.iter().position(|slope| !slope.is_finite()) {
        return Err(Error::NotFinite { name: "slopes", index, value: slopes[index] });
    }
    let scale = slopes.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
    if scale == 0.0 {
        return Estimate::new(0.0, 0.0, Work::default());
    }
    let (mut value, mut at_node, mut mean, mut square) = (0.0, 0.0, 0.0, 0.0);
    for (i, slope) in slopes.iter().map(|s| s / scale).enumerate() {
        if i == node {
            at_node = value;
        }
        mean += value + 0.5 * slope;
        value += slope;
        square += slope * slope;
    }
    if node == cells {
        at_node = value;
    }
    // v in units of 1/N, ‖v'‖² = Σ s²/N.
    let n = cells as f64;
    let quotient = (at_node - mean / n).abs() / (n * square).sqrt();
    let rounding = 4.0 * n * f64::EPSILON;
    Estimate::new(quotient, rounding, Work { points: cells as u64, ..Work::default() })
}

/// The slopes that come nearest to the best constant at x = node/N.
///
/// # Errors
/// As [`mean_deviation`].
pub fn extremal_slopes(cells: usize, node: usize) -> Result<Vec<f64>> {
    check(cells, node)?;
    let n = cells as f64;
    let beyond = |i: usize| if i < node { 0.0 } else { 1.0 };
    Ok((0..cells).map(|i| (i as f64 + 0.5) / n - beyond(i)).collect())
}

/// The largest share of the best constant κ that `functions` random slopes reach at any node, every other one
/// the extremal slopes of the node with noise.
///
/// # Errors
/// As [`mean_deviation`].
pub fn largest_share(cells: usize, functions: usize, seed: u64) -> Result<Estimate> {
    let mut random = SplitMix::new(seed);
    let mut best = Estimate::new(0.0, 0.0, Work::default())?;
    for k in 0..functions {
        let node = random.below(cells + 1);
        let noise = random.uniform();
        let mut slopes = extremal_slopes(cells, node)?;
        for slope in &mut slopes {
            let rough = random.between(-1.0, 1.0);
            *slope = if k % 2 == 0 { rough } else { *slope + noise * rough };
        }
        let quotient = mean_deviation(&slopes, node)?;
        let constant = pointwise(node as f64 / cells as f64)?;
        let share = quotient.value / constant.value;
        if share > best.value {
            best = Estimate::new(share, (quotient.error + constant.error) / constant.value, quotient.work)?;
        }
    }
    Ok(best)
}

/// κ(x), the best constant of (6.2) at x ∈ \[0, 1\], h = 1.
///
/// ```
/// let end = experiments::interpolation::pointwise(0.0)?;
/// assert!((end.value - 1.0 / 3f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] outside [0, 1].
pub fn pointwise(x: f64) -> Result<Estimate> {
    projection_constant(Domain::Interval(1.0), ErrorNorm::At(x), 1.0, 1e-12).map(|found| found.constant)
}

fn check(cells: usize, node: usize) -> Result<()> {
    if cells == 0 || cells > LARGEST {
        return Err(Error::CountOutOfRange { name: "cells", value: cells, range: "[1, 1048576]" });
    }
    if node > cells {
        return Err(Error::CountOutOfRange { name: "node", value: node, range: "[0, cells]" });
    }
    Ok(())
}
