//! The rows of a consistent P1 load.

use crate::strip::sides::LateralCondition;

/// One row of the consistent P1 load: the mass matrix applied to nodal values in the row below, the row itself and
/// the row above (`below` is empty on the contact edge). Squares are cut from bottom left to top right, h = 1/n.
///
/// Entries h²/12 on the six neighbours of an inner node and h²/2 on the node itself: row sum h².
pub(crate) fn mass_row(
    n: usize,
    sides: LateralCondition,
    below: &[f64],
    here: &[f64],
    above: &[f64],
    out: &mut [f64],
) {
    let unit = 1.0 / (24.0 * (n * n) as f64);
    let nodes = sides.nodes(n);
    out.fill(0.0);
    // Each triangle (a, b, c) gives its vertex a the load h²/24 (2 f_a + f_b + f_c).
    for cell in 0..n {
        let (left, right) = (cell, (cell + 1) % nodes);
        let (bl, br, tl, tr) = (here[left], here[right], above[left], above[right]);
        out[left] += unit * ((2.0 * bl + br + tr) + (2.0 * bl + tr + tl));
        out[right] += unit * (2.0 * br + bl + tr);
        if !below.is_empty() {
            let (bl, br, tl, tr) = (below[left], below[right], here[left], here[right]);
            out[left] += unit * (2.0 * tl + bl + tr);
            out[right] += unit * ((2.0 * tr + bl + br) + (2.0 * tr + bl + tl));
        }
    }
}
