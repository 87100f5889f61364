//! Exact projection onto the midpoint cone { p : p_i + p_{i+1} ≤ 2 g_i } in a weighted norm.
//!
//! minimise ½ Σ d_i (p_i − z_i)². With F_i(p) the least cost of the nodes up to i when p_i = p,
//!
//! F_i'(p) = d_i (p − z_i) + φ_i'(p),   φ_{i+1}(p) = min { F_i(q) : q ≤ 2 g_i − p },
//!
//! so φ_{i+1}' vanishes up to 2 g_i − q_i, q_i the minimiser of F_i, and is −F_i'(2 g_i − p) beyond: the part of F_i'
//! left of q_i, reflected. All F_i' are increasing and piecewise linear. Backwards, p_i = min(q_i, 2 g_i − p_{i+1});
//! the constraint is active where the second is smaller. Nodes that are fixed stay at 0.
//! Cost: O(number of pieces) per node, in all at most quadratic in the length of the chain, in practice linear.

use super::contact_set::ContactSet;

/// v(p) = intercept + slope p for p ≥ start, up to the start of the next piece.
#[derive(Debug, Clone, Copy)]
struct Piece {
    start: f64,
    intercept: f64,
    slope: f64,
}

/// The projection of `target` and the constraints active at it; `weights` are d, `bound` is g.
pub(super) fn project(
    target: &[f64],
    weights: &[f64],
    bound: &[f64],
    fixed: &[bool],
) -> (Vec<f64>, ContactSet) {
    let nodes = target.len();
    let mut minimisers = vec![0.0; nodes];
    let mut pieces = vec![FLAT];
    // Beyond a fixed node the next one has a hard upper bound.
    let mut limit = f64::INFINITY;
    for i in 0..nodes {
        if fixed[i] {
            pieces = vec![FLAT];
            limit = bound.get(i).map_or(f64::INFINITY, |g| 2.0 * g);
            continue;
        }
        for piece in &mut pieces {
            piece.slope += weights[i];
            piece.intercept -= weights[i] * target[i];
        }
        minimisers[i] = minimiser(&pieces, limit);
        limit = f64::INFINITY;
        if let Some(g) = bound.get(i) {
            pieces = reflected(&pieces, minimisers[i], 2.0 * g);
        }
    }
    let mut projection = minimisers;
    let mut active = vec![false; bound.len()];
    for i in (0..bound.len()).rev() {
        let allowed = 2.0 * bound[i] - projection[i + 1];
        active[i] = allowed < projection[i];
        if active[i] && !fixed[i] {
            projection[i] = allowed;
        }
        // A node pressed against the hard bound of a fixed left neighbour touches it with equality.
        if fixed[i] && !fixed[i + 1] {
            active[i] = projection[i + 1] >= 2.0 * bound[i];
        }
    }
    (projection, ContactSet::new(active))
}

/// φ' = 0.
const FLAT: Piece = Piece { start: f64::NEG_INFINITY, intercept: 0.0, slope: 0.0 };

/// Where the increasing function turns positive, at most `limit`.
fn minimiser(pieces: &[Piece], limit: f64) -> f64 {
    for (k, piece) in pieces.iter().enumerate() {
        let end = pieces.get(k + 1).map_or(limit, |next| next.start.min(limit));
        let zero = (-piece.intercept / piece.slope).max(piece.start);
        if zero <= end {
            return zero;
        }
    }
    limit
}

/// p ↦ −F'(c − p) for p > c − q, zero before.
fn reflected(pieces: &[Piece], minimiser: f64, c: f64) -> Vec<Piece> {
    let mut turned = vec![FLAT];
    let mut end = minimiser;
    for piece in pieces.iter().rev().filter(|piece| piece.start < minimiser) {
        turned.push(Piece {
            start: c - end,
            intercept: -piece.intercept - piece.slope * c,
            slope: piece.slope,
        });
        end = piece.start;
    }
    turned
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Cone, EdgeProblem};
    use faer::Mat;

    /// The other road: try every contact set for S = D, b = D z, and take the one that satisfies all conditions.
    fn exhaustive(target: &[f64], weights: &[f64], bound: &[f64], fixed: &[bool]) -> Vec<f64> {
        let nodes = target.len();
        let stiffness = Mat::from_fn(nodes, nodes, |i, j| if i == j { weights[i] } else { 0.0 });
        let load: Vec<f64> = target.iter().zip(weights).map(|(z, d)| z * d).collect();
        let problem = EdgeProblem { stiffness: &stiffness, load: &load, bound, fixed, cone: Cone::Midpoint };
        (0..1_u32 << bound.len())
            .map(|pattern| ContactSet::new((0..bound.len()).map(|i| pattern >> i & 1 == 1).collect()))
            .map(|set| problem.solve_with(&set).unwrap())
            .find(|state| {
                let admissible = (0..bound.len()).all(|i| state.gap[i] <= 1e-13 || problem.is_settled(i));
                admissible && state.multiplier.iter().all(|&l| l >= -1e-13)
            })
            .unwrap()
            .displacement
    }

    #[test]
    fn projection_is_the_best_of_all_contact_sets() {
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for trial in 0..600 {
            let nodes = 3 + trial % 6;
            let target: Vec<f64> = (0..nodes).map(|_| random()).collect();
            let weights: Vec<f64> = (0..nodes).map(|_| 1.0 + random()).collect();
            let bound: Vec<f64> =
                (1..nodes).map(|_| if trial % 2 == 0 { 0.0 } else { 0.3 * random() }).collect();
            let mut fixed = vec![false; nodes];
            fixed[0] = trial % 3 == 1;
            fixed[nodes - 1] = trial % 5 == 1;
            let (p, active) = project(&target, &weights, &bound, &fixed);
            let expected = exhaustive(&target, &weights, &bound, &fixed);
            for i in 0..nodes {
                assert!((p[i] - expected[i]).abs() < 1e-12, "{trial}: {p:?}, expected {expected:?}");
            }
            for i in active.indices() {
                let slack = 2.0 * bound[i] - p[i] - p[i + 1];
                assert!(slack.abs() < 1e-12, "{trial}: constraint {i}, {p:?}");
            }
        }
    }

    #[test]
    fn admissible_points_stay() {
        let target = [-1.0, 0.5, -0.75, 0.25];
        let (p, active) = project(&target, &[1.0; 4], &[0.0; 3], &[false; 4]);
        assert_eq!(p, target);
        assert_eq!(active.count(), 0);
    }
}
