//! Contact sets on a fine edge of N cells, as lists of non-contact intervals (gaps): one or many transitions, Cantor
//! sets, fat Cantor sets.
//!
//! A gap (a, b) is open: its nodes a + 1, ..., b − 1 are free, a and b are in contact. All positions are rounded to
//! nodes of the fine edge, except that a single transition may lie between two nodes; a Cantor construction stops
//! where a gap would have no free node or a contact interval no cell, so that the discrete test problem is never
//! degenerate. Boundary dimension d: the number of gaps longer than l grows like l^{−d}.

use crate::error::{Error, Result};

/// Largest number of generations of a Cantor set; a grid of at most 2^26 cells resolves fewer.
const LARGEST_DEPTH: usize = 64;

/// An open gap between two contact nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Gap {
    /// Last contact node before the gap.
    pub(crate) left: usize,
    /// First contact node after it.
    pub(crate) right: usize,
}

/// `count` gaps of equal length, separated by contact intervals of the same length, with contact of half that length
/// at both ends.
pub(crate) fn many_gaps(cells: usize, count: usize) -> Result<Vec<Gap>> {
    let is_in = (1..=cells / 4).contains(&count);
    Error::require_count("non-contact intervals", count, "[1, cells / 4]", is_in)?;
    let node = |place: f64| (place * cells as f64 / count as f64).round() as usize;
    Ok((0..count)
        .map(|i| {
            let start = i as f64 + 0.25;
            Gap { left: node(start), right: node(start + 0.5) }
        })
        .filter(|gap| gap.right > gap.left + 1)
        .collect())
}

/// The gaps of `depth` generations of the Cantor construction that keeps two intervals of relative length `ratio`.
/// d = ln 2 / ln(1/ratio).
pub(crate) fn cantor(cells: usize, ratio: f64, depth: usize) -> Vec<Gap> {
    let mut gaps = Vec::new();
    let length = |_: usize, piece: f64| piece * (1.0 - 2.0 * ratio);
    split(0.0, cells as f64, 1, depth, &length, &mut gaps);
    gaps
}

/// The gaps of a Cantor set of measure `measure` > 0: 2^{k−1} gaps of length c 2^{−k/d} in generation k = 1 ...
/// depth.
pub(crate) fn fat_cantor(cells: usize, dimension: f64, measure: f64, depth: usize) -> Vec<Gap> {
    let shrink = (-std::f64::consts::LN_2 / dimension).exp();
    let total: f64 = (1..=depth).map(|k| 0.5 * (2.0 * shrink).powi(k as i32)).sum();
    let first = (1.0 - measure) / total * cells as f64;
    let mut gaps = Vec::new();
    let length = |generation: usize, _: f64| first * shrink.powi(generation as i32);
    split(0.0, cells as f64, 1, depth, &length, &mut gaps);
    gaps
}

/// Fails with [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless the number of
/// generations is admissible.
pub(crate) fn check_depth(depth: usize) -> Result<()> {
    Error::require_count("depth", depth, "[1, 64]", (1..=LARGEST_DEPTH).contains(&depth))
}

/// Opens a gap in the middle of (start, end) and proceeds recursively in both remaining intervals; gaps are listed in
/// the order of the edge.
fn split(
    start: f64,
    end: f64,
    generation: usize,
    depth: usize,
    length: &impl Fn(usize, f64) -> f64,
    gaps: &mut Vec<Gap>,
) {
    if generation > depth {
        return;
    }
    let middle = 0.5 * (start + end);
    let half = 0.5 * length(generation, end - start);
    let gap =
        Gap { left: (middle - half).round() as usize, right: (middle + half).round() as usize };
    let has_free_node = gap.right > gap.left + 1;
    let pieces_have_cells = gap.left > start.round() as usize && gap.right < end.round() as usize;
    if !has_free_node || !pieces_have_cells {
        return;
    }
    split(start, middle - half, generation + 1, depth, length, gaps);
    gaps.push(gap);
    split(middle + half, end, generation + 1, depth, length, gaps);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_third_set_on_its_own_grid() {
        let gaps = cantor(27, 1.0 / 3.0, 2);
        let expected = [(3, 6), (9, 18), (21, 24)].map(|(left, right)| Gap { left, right });
        assert_eq!(gaps, expected);
        // In the third generation gaps have length one: no free node, the construction stops.
        assert_eq!(cantor(27, 1.0 / 3.0, 9), expected);
    }

    #[test]
    fn a_fat_set_keeps_its_measure() {
        let cells = 1 << 16;
        let gaps = fat_cantor(cells, 0.5, 0.4, 5);
        let open: usize = gaps.iter().map(|g| g.right - g.left).sum();
        assert_eq!(gaps.len(), 31);
        assert!((open as f64 / cells as f64 - 0.6).abs() < 1e-3);
        assert!(gaps.windows(2).all(|pair| pair[0].right < pair[1].left));
    }

    #[test]
    fn equal_gaps() {
        let gaps = many_gaps(64, 4).unwrap();
        assert_eq!(gaps[0], Gap { left: 4, right: 12 });
        assert_eq!(gaps.len(), 4);
        for count in [0, 17, 1 << (usize::BITS - 2), usize::MAX] {
            assert!(many_gaps(64, count).is_err(), "{count}");
        }
    }
}
