//! The rows of a consistent P1 load.

use crate::strip::sides::LateralCondition;
use std::array::from_fn;

/// The rows j = m − 1, ..., 0 of the load ∫ f_h·v, f_h the nodal interpolant of f, on n cells and m layers of height
/// 1/n, with their numbers; row 0 is the contact edge.
pub(crate) fn load_rows<const C: usize>(
    n: usize,
    layers: usize,
    sides: LateralCondition,
    f: impl Fn(f64, f64) -> [f64; C],
) -> impl Iterator<Item = (usize, [Vec<f64>; C])> {
    let nodal = move |j: usize| -> [Vec<f64>; C] {
        let y = j as f64 / n as f64;
        let values: Vec<[f64; C]> =
            (0..sides.nodes(n)).map(|i| f(i as f64 / n as f64, y)).collect();
        from_fn(|component| values.iter().map(|value| value[component]).collect())
    };
    let mut above = nodal(layers);
    let mut here = nodal(layers - 1);
    (0..layers).rev().map(move |j| {
        let below = if j > 0 { nodal(j - 1) } else { from_fn(|_| Vec::new()) };
        let row = from_fn(|component| {
            mass_row(n, sides, &below[component], &here[component], &above[component])
        });
        above = std::mem::replace(&mut here, below);
        (j, row)
    })
}

/// One row of the consistent P1 load: the mass matrix applied to nodal values in the row below, the row itself and
/// the row above (`below` is empty on the contact edge). Squares are cut from bottom left to top right, h = 1/n.
///
/// Entries h²/12 on the six neighbours of an inner node and h²/2 on the node itself: row sum h².
fn mass_row(
    n: usize,
    sides: LateralCondition,
    below: &[f64],
    here: &[f64],
    above: &[f64],
) -> Vec<f64> {
    let unit = 1.0 / (24.0 * (n * n) as f64);
    let nodes = sides.nodes(n);
    let mut out = vec![0.0; nodes];
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
    out
}
