//! Condensed primal-dual active set: guess the contact set, solve on the edge, correct the guess.
//!
//! A step solves with the constraints of the set as equations; wrong are the active ones that pull (λ_i < 0) and the
//! inactive ones that penetrate ((B w − g)_i > 0). The next set, both times a semismooth Newton step for
//! w = Proj(w − D⁻¹ ∇J(w)), D the diagonal of S:
//!
//! * nodal cone: all wrong constraints change sides (M. Hintermüller, K. Ito, K. Kunisch, SIAM J. Optim. 13 (2002));
//! * midpoint cone: the constraints active at the exact projection onto the cone. Changing sides one by one falls into
//!   checkerboards there, because the constraints of neighbouring segments are coupled through B B'.
//!
//! A set that reproduces itself solves the problem. When a set comes back, only the wrong constraint with the least
//! index changes sides until fewer constraints are wrong than ever before: finite for every symmetric positive definite
//! S (K. G. Murty 1974; J. J. Júdice and F. M. Pires 1994).
//! Cost: one dense factorization on the edge per step, however fine the mesh behind it.

use super::cone::Cone;
use super::contact_set::ContactSet;
use super::edge_problem::{EdgeProblem, EdgeState};
use super::projection::project;
use super::status::Status;
use crate::error::Result;
use std::collections::HashMap;

/// Signs below this multiple of the size of the terms are rounding (16 ε).
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// How the iteration on the edge went.
#[derive(Debug, Clone)]
pub struct EdgeOutcome {
    /// The last solution.
    pub state: EdgeState,
    /// Its set.
    pub set: ContactSet,
    /// How the iteration ended.
    pub status: Status,
    /// The sets visited, in order, the last one included.
    pub history: Vec<ContactSet>,
}

/// Solves the edge problem from the given first guess.
///
/// # Errors
/// As for [`EdgeProblem::solve_with`].
pub fn solve_on_edge(problem: &EdgeProblem<'_>, start: ContactSet) -> Result<EdgeOutcome> {
    let limit = 100 + 20 * start.constraints();
    let mut set = start;
    let mut history: Vec<ContactSet> = Vec::new();
    let mut seen: HashMap<ContactSet, usize> = HashMap::new();
    let mut fewest = usize::MAX;
    let mut one_at_a_time = false;
    loop {
        let state = problem.solve_with(&set)?;
        let wrong = wrong_constraints(problem, &set, &state);
        history.push(set.clone());
        let steps = history.len();
        if wrong.is_empty() || steps == limit {
            let status = if wrong.is_empty() { Status::Converged } else { Status::StepLimit { steps } };
            return Ok(EdgeOutcome { state, set, status, history });
        }
        let came_back = seen.insert(set.clone(), steps).is_some();
        if wrong.len() < fewest {
            fewest = wrong.len();
            one_at_a_time = false;
        } else {
            one_at_a_time |= came_back;
        }
        set = match (one_at_a_time, problem.cone) {
            (true, _) => changed(&set, &wrong[..1]),
            (false, Cone::Nodal) => changed(&set, &wrong),
            (false, Cone::Midpoint) => projected_set(problem, &state)?,
        };
    }
}

/// The set with the given constraints on the other side.
fn changed(set: &ContactSet, constraints: &[usize]) -> ContactSet {
    let mut active = set.as_slice().to_vec();
    constraints.iter().for_each(|&i| active[i] = !active[i]);
    ContactSet::new(active)
}

/// The constraints active at the projection of w − D⁻¹ ∇J = w + D⁻¹ B'λ, D the diagonal of S.
fn projected_set(problem: &EdgeProblem<'_>, state: &EdgeState) -> Result<ContactSet> {
    let nodes = state.displacement.len();
    let weights: Vec<f64> = (0..nodes).map(|i| problem.stiffness[(i, i)]).collect();
    let force = problem.cone.apply_transposed(&state.multiplier, nodes)?;
    let target: Vec<f64> = (0..nodes).map(|i| state.displacement[i] + force[i] / weights[i]).collect();
    Ok(project(&target, &weights, problem.bound, problem.fixed).1)
}

/// The constraints on the wrong side, ascending.
fn wrong_constraints(problem: &EdgeProblem<'_>, set: &ContactSet, state: &EdgeState) -> Vec<usize> {
    let largest = |values: &[f64]| values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let displacement = ROUNDING * largest(&state.displacement).max(largest(problem.bound));
    let force = ROUNDING * terms(problem, &state.displacement);
    (0..set.constraints())
        .filter(|&i| {
            if set.contains(i) {
                state.multiplier[i] < -force
            } else {
                state.gap[i] > displacement && !problem.is_settled(i)
            }
        })
        .collect()
}

/// max_i (|b| + |S||w|)_i, the size of what is summed in b − S w.
fn terms(problem: &EdgeProblem<'_>, w: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = problem.load.iter().map(|b| b.abs()).collect();
    for (j, &value) in w.iter().enumerate() {
        let column = problem.stiffness.col(j);
        for i in 0..sizes.len() {
            sizes[i] += (column[i] * value).abs();
        }
    }
    sizes.into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::Mat;

    /// Murty's 3x3 example: changing all wrong constraints at once cycles on it, the fallback must finish.
    #[test]
    fn cycles_are_left() {
        let entries = [[1.0, 2.0, 2.0], [2.0, 4.1, 4.0], [2.0, 4.0, 4.2]];
        let stiffness = Mat::from_fn(3, 3, |i, j| entries[i][j]);
        for pattern in 0..27 {
            let load: Vec<f64> = (0..3).map(|i| (pattern / 3_i32.pow(i) % 3 - 1) as f64).collect();
            let problem = EdgeProblem {
                stiffness: &stiffness,
                load: &load,
                bound: &[0.0; 3],
                fixed: &[false; 3],
                cone: Cone::Nodal,
            };
            for first in 0..8u32 {
                let start = ContactSet::new((0..3).map(|i| first >> i & 1 == 1).collect());
                let outcome = solve_on_edge(&problem, start).unwrap();
                assert!(outcome.status.is_converged(), "{load:?} from {first}");
            }
        }
    }
}
