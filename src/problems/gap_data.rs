//! u_N and λ on the edge of a strip from the gaps (non-contact intervals) of a test problem: powers of the distance
//! to their ends.

use super::contact_sets::Gap;
use crate::error::{Error, Result};
use crate::strip::{EdgeData, LateralCondition};

/// The gaps of a test problem on a grid, and the powers of its data.
pub(super) struct Gaps {
    pub(super) gaps: Vec<Gap>,
    /// Boundary dimension d.
    pub(super) dimension: f64,
    /// The exponent q in λ = dist^q.
    pub(super) pressure: f64,
    /// The exponent α: both data are multiplied by ℓ^{−α}, ℓ(r) = 2 + ln(1/r), r the distance to the ends.
    pub(super) logarithm: f64,
    /// Distance from the left node to the start of a single gap, in cells, less than 1.
    pub(super) advance: f64,
}

impl Gaps {
    /// The pair (u_N, λ) of regularity τ; a gap whose right end lies beyond the edge reaches a natural side.
    ///
    /// u_N = −δ^p ℓ(δ)^{−α} at the nodes of each gap from a to b, p = τ − 1 + d/2, δ = (x − a)(b − x)/(b − a), or x − a if
    /// it reaches the side.
    ///
    /// λ_i is half the integral of the density dist^q ℓ(dist)^{−α} over each contact cell (both ends in contact) at node
    /// i, dist the distance to the nearest gap: ∫_{r_0}^{r_1} r^q dr = (r_1^{q+1} − r_0^{q+1})/(q + 1) per cell, finite
    /// for q > −1; ℓ is evaluated at the midpoint of the cell.
    pub(super) fn pair(&self, tau: f64, cells: usize, sides: LateralCondition) -> Result<EdgeData> {
        let count = self.gaps.len();
        Error::require_count("non-contact intervals on this grid", count, "[1, inf)", count > 0)?;
        let exponent = tau - 1.0 + 0.5 * self.dimension;
        let h = 1.0 / cells as f64;
        let nodes = sides.nodes(cells);
        let mut values = vec![0.0; nodes];
        for gap in &self.gaps {
            for i in gap.left + 1..gap.right.min(gap.left + nodes) {
                let node = if sides == LateralCondition::Periodic { i % cells } else { i };
                if node < nodes {
                    let left = (i - gap.left) as f64 - self.advance;
                    let depth = if sides == LateralCondition::Natural && gap.right > cells {
                        h * left
                    } else {
                        let length = (gap.right - gap.left) as f64 - self.advance;
                        h * (left * (gap.right - i) as f64 / length)
                    };
                    values[node] = -depth.powf(exponent) * (2.0 - depth.ln()).powf(-self.logarithm);
                }
            }
        }
        let forces = self.forces(&values, cells, sides);
        Ok(EdgeData::new(cells, sides, &values, &forces)?.with_regularity(tau))
    }

    fn forces(&self, values: &[f64], cells: usize, sides: LateralCondition) -> Vec<f64> {
        let nodes = values.len();
        let distance = distance_to_gap(values, sides);
        let (h, q) = (1.0 / cells as f64, self.pressure);
        let mut forces = vec![0.0; nodes];
        // ∫_a^b t^q dt
        let integral = |a: f64, b: f64| (b.powf(q + 1.0) - a.powf(q + 1.0)) / (q + 1.0);
        for cell in 0..cells {
            let right = (cell + 1) % nodes;
            if values[cell] != 0.0 || values[right] != 0.0 {
                continue;
            }
            let (a, b) = (distance[cell], distance[right]);
            let force = if q == 0.0 || !a.is_finite() {
                h
            } else if a == b {
                // The midpoint of a contact interval lies inside this cell.
                2.0 * integral(a * h, (a + 0.5) * h)
            } else {
                integral(a.min(b) * h, a.max(b) * h)
            };
            let middle = if a.is_finite() { 0.5 * (a + b).max(1.0) * h } else { 1.0 };
            let force = force * (2.0 - middle.ln()).powf(-self.logarithm);
            forces[cell] += 0.5 * force;
            forces[right] += 0.5 * force;
        }
        forces
    }
}

/// For every node, the distance in cells to the nearest contact node with a free neighbour; infinite without free
/// nodes.
fn distance_to_gap(values: &[f64], sides: LateralCondition) -> Vec<f64> {
    let nodes = values.len();
    let turns = if sides == LateralCondition::Periodic { 2 } else { 1 };
    let mut distance = vec![f64::INFINITY; nodes];
    let mut sweep = |order: &mut dyn Iterator<Item = usize>| {
        let mut since = f64::INFINITY;
        for i in order {
            since = if values[i] != 0.0 { -1.0 } else { since + 1.0 };
            distance[i] = distance[i].min(since.max(0.0));
        }
    };
    sweep(&mut (0..turns * nodes).map(|i| i % nodes));
    sweep(&mut (0..turns * nodes).rev().map(|i| i % nodes));
    distance
}
