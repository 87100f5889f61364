//! Contact forces of a test problem: their density is a power of the distance to the nearest non-contact interval.

use crate::strip::LateralCondition;

/// Nodal forces of the density dist^q ℓ(dist)^{−α} on the contact cells (both ends in contact), ℓ(r) = 2 + ln(1/r),
/// dist the distance to the nearest non-contact interval; half of the integral over each cell is assigned to each of
/// its ends. ℓ is evaluated at the midpoint of the cell.
///
/// ∫_{r_0}^{r_1} r^q dr = (r_1^{q+1} − r_0^{q+1})/(q + 1) per cell, finite for q > −1.
pub(crate) fn contact_forces(
    values: &[f64],
    cells: usize,
    sides: LateralCondition,
    (q, alpha): (f64, f64),
) -> Vec<f64> {
    let nodes = values.len();
    let distance = distance_to_gap(values, cells, sides);
    let h = 1.0 / cells as f64;
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
        let force = force * (2.0 - middle.ln()).powf(-alpha);
        forces[cell] += 0.5 * force;
        forces[right] += 0.5 * force;
    }
    forces
}

/// For every node, the distance in cells to the nearest contact node with a free neighbour; infinite without free
/// nodes.
fn distance_to_gap(values: &[f64], cells: usize, sides: LateralCondition) -> Vec<f64> {
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
    debug_assert_eq!(sides.nodes(cells), nodes);
    distance
}
