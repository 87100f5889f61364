//! The constraints of the two cones on a chain or ring of edge nodes: B w, B'λ, λ from forces, and refinement.
//!
//! The cones of the contact room act on chains; a ring is a chain whose last node is the first. Cost O(n).

use super::edge::EdgeOperator;
use super::face::Face;
use super::sides::Sides;
use crate::contact::Cone;
use crate::error::Result;

/// Number of constraints of the cone on this edge.
pub(crate) fn constraints(operator: &EdgeOperator, cone: Cone) -> usize {
    match cone {
        Cone::Nodal => operator.nodes(),
        Cone::Midpoint => operator.segments(),
    }
}

/// B w; a ring is a chain whose last node is the first.
pub(crate) fn means(operator: &EdgeOperator, cone: Cone, w: &[f64]) -> Vec<f64> {
    if cone == Cone::Midpoint && operator.sides() == Sides::Periodic {
        let mut closed = w.to_vec();
        closed.push(w[0]);
        cone.apply(&closed)
    } else {
        cone.apply(w)
    }
}

/// B'λ.
pub(crate) fn forces(operator: &EdgeOperator, cone: Cone, multiplier: &[f64]) -> Result<Vec<f64>> {
    let nodes = operator.nodes();
    if cone == Cone::Midpoint && operator.sides() == Sides::Periodic {
        let mut chain = cone.apply_transposed(multiplier, nodes + 1)?;
        let last = chain.pop().unwrap_or(0.0);
        chain[0] += last;
        Ok(chain)
    } else {
        cone.apply_transposed(multiplier, nodes)
    }
}

/// λ on the runs from B'λ = surplus there, zero elsewhere.
pub(crate) fn multipliers(operator: &EdgeOperator, cone: Cone, active: &[bool], surplus: &[f64]) -> Vec<f64> {
    let nodes = operator.nodes();
    let mut multiplier = vec![0.0; active.len()];
    if cone == Cone::Nodal {
        for i in 0..nodes {
            if active[i] {
                multiplier[i] = surplus[i];
            }
        }
        return multiplier;
    }
    let face = Face::new(cone, operator, active);
    for run in &face.runs {
        let list: Vec<usize> = run.nodes(nodes).collect();
        let ring = active.iter().all(|&a| a) && active.len() == nodes;
        let middle = if ring { list.len() } else { list.len() / 2 };
        // From both ends to the middle: rounding is carried over half the run only.
        let mut previous = 0.0;
        for &node in &list[..middle] {
            previous = 2.0 * surplus[node] - previous;
            multiplier[node] = previous;
        }
        let mut previous = 0.0;
        for pair in list[middle..].windows(2).rev() {
            previous = 2.0 * surplus[pair[1]] - previous;
            multiplier[pair[0]] = previous;
        }
        if ring {
            balance_ring(&mut multiplier);
        }
    }
    multiplier
}

/// On a closed ring λ is determined up to ±c: the choice with equal smallest even and odd multipliers.
fn balance_ring(multiplier: &mut [f64]) {
    let smallest =
        |parity: usize| multiplier.iter().skip(parity).step_by(2).fold(f64::INFINITY, |m, &v| m.min(v));
    let shift = 0.5 * (smallest(1) - smallest(0));
    for (i, value) in multiplier.iter_mut().enumerate() {
        *value += if i % 2 == 0 { shift } else { -shift };
    }
}

/// Linear interpolation from the half as fine edge.
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

pub(crate) fn refine_set(coarse: &[bool], cone: Cone, operator: &EdgeOperator) -> Vec<bool> {
    (0..constraints(operator, cone))
        .map(|i| match cone {
            Cone::Midpoint => coarse[i / 2],
            Cone::Nodal if i % 2 == 0 => coarse[i / 2],
            Cone::Nodal => coarse[i / 2] && coarse[(i / 2 + 1) % coarse.len()],
        })
        .collect()
}
