//! u_N and λ on the edge of a strip from the gaps (non-contact intervals) of a test problem: powers of the distance
//! to their ends.

use super::contact_sets::Gap;
use super::pressure::contact_forces;
use crate::error::{Error, Result, ToolkitError};
use crate::strip::{EdgeData, LateralCondition};

/// The grid of a test problem.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    pub(super) tau: f64,
    pub(super) cells: usize,
    pub(super) sides: LateralCondition,
}

/// The gaps of a test problem on a grid, and the powers of its data.
pub(super) struct Gaps {
    gaps: Vec<Gap>,
    /// Boundary dimension d.
    dimension: f64,
    /// The exponent q in λ = dist^q.
    pressure: f64,
    /// The exponent α: both data are multiplied by ℓ^{−α}, ℓ(r) = 2 + ln(1/r), r the distance to the ends.
    logarithm: f64,
    /// Distance from the left node to the start of a single gap, in cells, less than 1.
    advance: f64,
}

impl Gaps {
    /// Gaps whose ends are transitions: λ = dist^{τ−2}, d = 0.
    pub(super) fn with_transitions(gaps: Vec<Gap>, grid: Grid) -> Self {
        Self { gaps, dimension: 0.0, pressure: grid.tau - 2.0, logarithm: 0.0, advance: 0.0 }
    }

    /// Gaps of boundary dimension d, with λ = 1 on the contact set.
    pub(super) fn fractal(gaps: Vec<Gap>, dimension: f64) -> Self {
        Self { gaps, dimension, pressure: 0.0, logarithm: 0.0, advance: 0.0 }
    }

    /// The gap after one transition at `place`: half a period long with periodic sides, otherwise extending beyond
    /// the side.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless the place lies in (0, 1).
    pub(super) fn after_transition(place: f64, grid: Grid) -> Result<Self> {
        Error::require("position", place, "(0, 1)", place > 0.0 && place < 1.0)?;
        let start = place * grid.cells as f64;
        let left = start as usize;
        let right = match grid.sides {
            LateralCondition::Natural => usize::MAX,
            LateralCondition::Periodic => left + grid.cells / 2,
        };
        Ok(Self { advance: start.fract(), ..Self::with_transitions(vec![Gap { left, right }], grid) })
    }

    /// The same gaps with data multiplied by ℓ^{−α}.
    pub(super) fn damped(self, logarithm: f64) -> Self {
        Self { logarithm, ..self }
    }

    /// The pair (u_N, λ).
    ///
    /// u_N = −δ^p at the nodes of each gap, λ_i half the integral of dist^q over each contact cell at node i, both
    /// multiplied by ℓ^{−α} if damped.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) without a gap; the errors of [`EdgeData::new`].
    pub(super) fn pair(&self, grid: Grid) -> Result<EdgeData> {
        let Grid { tau, cells, sides } = grid;
        if self.gaps.is_empty() {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "non-contact intervals on this grid",
                value: 0,
                range: "[1, inf)",
            }));
        }
        let exponent = tau - 1.0 + 0.5 * self.dimension;
        let h = 1.0 / cells as f64;
        let nodes = sides.nodes(cells);
        let mut values = vec![0.0; nodes];
        for &gap in &self.gaps {
            for i in gap.left + 1..gap.right.min(gap.left + nodes) {
                let node = if sides == LateralCondition::Periodic { i % cells } else { i };
                if node < nodes {
                    let depth = h * self.depth(gap, i, grid);
                    values[node] = -depth.powf(exponent) * (2.0 - depth.ln()).powf(-self.logarithm);
                }
            }
        }
        let forces = contact_forces(&values, cells, sides, (self.pressure, self.logarithm));
        Ok(EdgeData::new(cells, sides, &values, &forces)?.with_regularity(tau))
    }

    /// δ/h at node i of a gap from a = left + advance: (i − a)(b − i)/(b − a), or i − a if the gap extends beyond the
    /// side.
    fn depth(&self, gap: Gap, i: usize, grid: Grid) -> f64 {
        let left = (i - gap.left) as f64 - self.advance;
        if grid.sides == LateralCondition::Natural && gap.right > grid.cells {
            left
        } else {
            left * (gap.right - i) as f64 / ((gap.right - gap.left) as f64 - self.advance)
        }
    }
}
