//! Transfer between an edge and the edge of twice the mesh size: linear interpolation P and its adjoint P'.

use super::sides::LateralCondition;

/// The linear interpolant P g on an edge of `nodes` nodes, from the edge of twice the mesh size.
///
/// (P g)_{2i} = g_i, (P g)_{2i+1} = (g_i + g_{i+1})/2; with periodic sides indices are modulo the coarse
/// length.
pub(crate) fn prolong(coarse: &[f64], nodes: usize) -> Vec<f64> {
    (0..nodes)
        .map(|i| {
            if i % 2 == 0 {
                coarse[i / 2]
            } else {
                0.5 * (coarse[i / 2] + coarse[(i / 2 + 1) % coarse.len()])
            }
        })
        .collect()
}

/// The restriction P'b: the load on the edge of twice the mesh size.
///
/// (P'b)_i = b_{2i} + (b_{2i−1} + b_{2i+1})/2. Σ_i (P'b)_i = Σ_i b_i: the resultant is preserved.
pub(crate) fn restrict(fine: &[f64], sides: LateralCondition) -> Vec<f64> {
    let cells = match sides {
        LateralCondition::Natural => (fine.len() - 1) / 2,
        LateralCondition::Periodic => fine.len() / 2,
    };
    let last = fine.len() - 1;
    (0..sides.nodes(cells))
        .map(|i| {
            let left = match (i, sides) {
                (0, LateralCondition::Natural) => 0.0,
                (0, LateralCondition::Periodic) => fine[last],
                _ => fine[2 * i - 1],
            };
            let right = fine.get(2 * i + 1).copied().unwrap_or(0.0);
            fine[2 * i] + 0.5 * (left + right)
        })
        .collect()
}
