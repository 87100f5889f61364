//! Piecewise polynomial slopes on an ordered list of cells.
//!
//! The unknowns x are the coefficients of du/dξ = Σ_k x_k L_k(ξ) on each cell, L_k = √(2k+1) P_k(2ξ−1), ξ ∈
//! (0,1) the coordinate of the cell. Function 0 of a cell raises u by 1 across it; the others leave the values
//! at both ends unchanged. The space is conforming in H^ν for every 0 < ν < 1: u is continuous and piecewise
//! smooth.

use super::cell::{Cell, Panel};
use crate::numeric::legendre;

/// Largest number of slope functions on one cell.
pub(crate) const MOST_FUNCTIONS: usize = 16;

/// Values of the basis at a point.
pub(crate) type Values = [f64; MOST_FUNCTIONS + 1];

/// Cells, the panels into which they are divided, and the numbering of the unknowns.
#[derive(Debug, Clone)]
pub(crate) struct SlopeSpace {
    pub(crate) cells: Vec<Cell>,
    pub(crate) panels: Vec<Panel>,
    /// First unknown of each cell, and the number of unknowns at the end.
    pub(crate) first: Vec<usize>,
    /// Distance of the left end of each cell from the left end of the interval.
    pub(crate) cell_left: Vec<f64>,
    /// Distance of the right end of each cell from the right end of the interval.
    pub(crate) cell_right: Vec<f64>,
    /// The same two distances for the panels.
    pub(crate) panel_left: Vec<f64>,
    pub(crate) panel_right: Vec<f64>,
}

/// The sums of the lengths before and after each entry, which add positive numbers only.
fn distances(lengths: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let running = |sum: &mut f64, length: &f64| {
        let before = *sum;
        *sum += length;
        Some(before)
    };
    let left: Vec<f64> = lengths.iter().scan(0.0, running).collect();
    let mut right: Vec<f64> = lengths.iter().rev().scan(0.0, running).collect();
    right.reverse();
    (left, right)
}

impl SlopeSpace {
    /// The space on these cells; `largest_spread` bounds ln(r₁/r₀) over a panel.
    pub(crate) fn new(cells: Vec<Cell>, largest_spread: f64) -> Self {
        let panels: Vec<Panel> = cells
            .iter()
            .enumerate()
            .flat_map(|(index, cell)| cell.panels(index, largest_spread))
            .collect();
        let mut first = vec![0];
        for cell in &cells {
            first.push(first[first.len() - 1] + cell.functions);
        }
        let lengths = |of: &mut dyn Iterator<Item = f64>| distances(&of.collect::<Vec<_>>());
        let (cell_left, cell_right) = lengths(&mut cells.iter().map(|cell| cell.length));
        let (panel_left, panel_right) = lengths(&mut panels.iter().map(|panel| panel.length));
        Self { cells, panels, first, cell_left, cell_right, panel_left, panel_right }
    }

    /// The number of unknowns.
    pub(crate) fn dimension(&self) -> usize {
        self.first[self.cells.len()]
    }

    /// The number of slope functions on the cell of a panel.
    pub(crate) fn functions(&self, panel: usize) -> usize {
        self.cells[self.panels[panel].cell].functions
    }

    /// The first unknown of the cell of a panel.
    pub(crate) fn first_of_panel(&self, panel: usize) -> usize {
        self.first[self.panels[panel].cell]
    }

    /// The slope functions of the panel's cell at the panel's point ξ.
    pub(crate) fn slopes(&self, panel: usize, xi: f64) -> Values {
        legendre(self.functions(panel), self.panels[panel].in_cell(xi))
    }
}

/// √(2k+1) P_k(2ξ−1) for k < `count`.
pub(crate) fn legendre(count: usize, xi: f64) -> Values {
    let mut values = plain_legendre(count, xi);
    for (k, value) in values.iter_mut().enumerate().take(count) {
        *value *= ((2 * k + 1) as f64).sqrt();
    }
    values
}

/// ∫₀^ξ √(2k+1) P_k(2t−1) dt for k < `count`: ξ, and (P_{k+1} − P_{k−1}) / (2 √(2k+1)).
pub(crate) fn legendre_primitives(count: usize, xi: f64) -> Values {
    let plain = plain_legendre(count + 1, xi);
    let mut values = [0.0; MOST_FUNCTIONS + 1];
    values[0] = xi;
    for k in 1..count {
        values[k] = 0.5 * (plain[k + 1] - plain[k - 1]) / ((2 * k + 1) as f64).sqrt();
    }
    values
}

fn plain_legendre(count: usize, xi: f64) -> Values {
    let mut values = [0.0; MOST_FUNCTIONS + 1];
    legendre::fill(&mut values[..count], 2.0 * xi - 1.0);
    values
}
