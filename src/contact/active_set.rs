//! Condensed primal-dual active set method: guess the contact set, solve on the edge, correct the guess.
//!
//! A step solves the problem with the constraints of the set as equations. An active constraint is violated if
//! λ_i < 0 or if it cannot be satisfied, an inactive one if (B w − g)_i > 0. The next set is a semismooth Newton step
//! for w = Proj(w − D⁻¹ ∇J(w)), J(w) = ½ w'S w − b'w, D the diagonal of S:
//!
//! * nodal cone: all violated constraints are exchanged (M. Hintermüller, K. Ito, K. Kunisch, SIAM J.
//!   Optim. 13 (2002));
//! * midpoint cone: the constraints active at the exact projection onto the cone. Exchanging single
//!   constraints leads to checkerboard patterns there, because the constraints of neighbouring segments are
//!   coupled through B B'.
//!
//! A set that is mapped to itself solves the problem. Between a fixed node and a non-contact interval the multipliers
//! of a contact interval may contain a sawtooth in the kernel of B': half of them are negative, and the interval must
//! be divided at points that such a step does not find. When a set recurs (in the midpoint cone already after a step
//! without progress) the dual method (`dual_active_set`) is applied once. Its set is accepted if it has fewer
//! violated constraints than all previous sets, since on an edge graded over many decades it may be affected by
//! rounding. Otherwise, when a set has recurred, constraints are exchanged one by one until fewer are violated than
//! before: for some steps the one with the largest violation, then the one with the smallest index. The latter rule
//! terminates in exact arithmetic for every symmetric positive definite S (K. G. Murty 1974; J. J. Júdice and F. M.
//! Pires 1994). In this phase the next set depends on the current set alone, so that a set that recurs again recurs
//! forever: [`Status::Cycled`]. This happens only by rounding, or if S is not symmetric positive definite. Cost: one
//! dense factorization on the edge per step, independent of the mesh of the body.

use super::dual_active_set::dual_active_set;
use super::edge_problem::{EdgeProblem, EdgeState};
use crate::cone::{Cone, ContactSet, Ends, Status, Weighted, active_on_ring, project_weighted};
use crate::error::Result;
use std::collections::{HashMap, HashSet};

/// Signs of quantities below this multiple of the size of their terms are attributed to rounding (16 ε).
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Largest number of steps, plus [`STEPS_PER_CONSTRAINT`] for every constraint. Ten or twenty steps are typical;
/// exchanging single constraints takes a few steps per constraint.
const FEWEST_STEPS: usize = 100;
const STEPS_PER_CONSTRAINT: usize = 20;

/// Number of consecutive steps in the midpoint cone without a new minimum of violated constraints after which the
/// dual method is tried.
const PATIENCE: usize = 1;

/// Largest number of exchanges by the largest violation, before the smallest index is used; at most the number of
/// constraints.
const FURTHEST_FIRST: usize = 64;

/// The outcome of the iteration on the edge.
#[derive(Debug, Clone)]
pub(crate) struct EdgeOutcome {
    pub(crate) state: EdgeState,
    pub(crate) set: ContactSet,
    pub(crate) status: Status,
    /// The steps in order, the last one included.
    pub(crate) steps: Vec<Step>,
}

/// A step of the active set method: the minimiser of J whose constraints in a set hold with equality.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// The constraints that hold with equality.
    pub set: ContactSet,
    /// J of the minimiser. It may lie below that of the solution, as other constraints may be violated.
    pub energy: f64,
    /// Largest penetration, max (B u − g)₊ over the constraints that are not in the set; 0 if they hold.
    pub penetration: f64,
    /// Largest tensile force, max (−λ)₊ over the constraints in the set; 0 if all push.
    pub tension: f64,
}

/// The solution of the edge problem by the active set method from the given initial guess.
///
/// # Errors
/// As for [`EdgeProblem::solve_with`].
pub(crate) fn solve_on_edge(problem: &EdgeProblem<'_>, start: ContactSet) -> Result<EdgeOutcome> {
    let limit = FEWEST_STEPS + STEPS_PER_CONSTRAINT * start.constraints();
    let furthest_first = FURTHEST_FIRST.min(start.constraints());
    let mut set = start;
    let mut history: Vec<Step> = Vec::new();
    let mut seen: HashSet<ContactSet> = HashSet::new();
    let (mut fewest, mut in_vain) = (usize::MAX, 0);
    let mut one_at_a_time = false;
    let mut single_steps = 0;
    let mut is_dual_tried = false;
    // The sets from which a single constraint was exchanged, with their steps.
    let mut changed_one: HashMap<ContactSet, usize> = HashMap::new();
    loop {
        let state = problem.solve_with(&set)?;
        let wrong = wrong_constraints(problem, &set, &state);
        history.push(step(problem, &set, &state));
        let steps = history.len();
        let came_back = !seen.insert(set.clone());
        if wrong.len() < fewest {
            (fewest, in_vain) = (wrong.len(), 0);
            one_at_a_time = false;
            single_steps = 0;
            changed_one.clear();
        } else {
            in_vain += 1;
            one_at_a_time |= came_back;
        }
        single_steps += usize::from(one_at_a_time);
        let by_index = single_steps > furthest_first;
        let before = if by_index { changed_one.insert(set.clone(), steps) } else { None };
        let status = match before {
            _ if wrong.is_empty() => Some(Status::Converged),
            Some(before) => Some(Status::Cycled { period: steps - before }),
            None => (steps == limit).then_some(Status::StepLimit { steps }),
        };
        if let Some(status) = status {
            return Ok(EdgeOutcome { state, set, status, steps: history });
        }
        let is_stuck = one_at_a_time || problem.cone == Cone::Midpoint && in_vain >= PATIENCE;
        if is_stuck && !is_dual_tried {
            is_dual_tried = true;
            if let Some(found) = by_dual(problem, fewest)? {
                set = found;
                continue;
            }
        }
        set = match (one_at_a_time, problem.cone) {
            (true, _) if by_index => changed(&set, &wrong[..1]),
            (true, _) => changed(&set, &[furthest(problem, &set, &state, &wrong)]),
            (false, Cone::Nodal) => changed(&set, &wrong),
            (false, Cone::Midpoint) => projected_set(problem, &state)?,
        };
    }
}

/// The step to a state; its energy is that of the edge, ½ w'S w − b'w.
fn step(problem: &EdgeProblem<'_>, set: &ContactSet, state: &EdgeState) -> Step {
    let w = &state.displacement;
    // S w = b − r.
    let terms =
        w.iter().zip(problem.load).zip(problem.residual(w)).map(|((w, b), r)| -0.5 * w * (b + r));
    let worst = |values: &[f64], inside: bool, sign: f64| {
        let wrong =
            (0..values.len()).filter(|&i| set.contains(i) == inside).map(|i| sign * values[i]);
        wrong.fold(0.0, f64::max)
    };
    let (penetration, tension) =
        (worst(&state.gap, false, 1.0), worst(&state.multiplier, true, -1.0));
    Step { set: set.clone(), energy: terms.sum(), penetration, tension }
}

/// The set found by the dual method, if it has fewer violated constraints than `fewest`.
fn by_dual(problem: &EdgeProblem<'_>, fewest: usize) -> Result<Option<ContactSet>> {
    let (set, _) = dual_active_set(problem)?;
    let state = problem.solve_with(&set)?;
    Ok((wrong_constraints(problem, &set, &state).len() < fewest).then_some(set))
}

/// The set with the given constraints exchanged.
pub(super) fn changed(set: &ContactSet, constraints: &[usize]) -> ContactSet {
    let mut active = set.as_slice().to_vec();
    constraints.iter().for_each(|&i| active[i] = !active[i]);
    ContactSet::new(&active)
}

/// The constraint with the largest violation, measured by its gap or by its multiplier divided by the diagonal of S.
///
/// The maximum of (B w − g)_i over the penetrating constraints and of −λ_i/max S_kk over those with
/// negative multiplier; both are lengths.
fn furthest(
    problem: &EdgeProblem<'_>,
    set: &ContactSet,
    state: &EdgeState,
    wrong: &[usize],
) -> usize {
    let cone = problem.edge_cone();
    let off = |i: usize| {
        if !set.contains(i) {
            return state.gap[i];
        }
        let stiffness =
            cone.support(i).map(|node| problem.stiffness[(node, node)]).fold(0.0, f64::max);
        state.gap[i].abs().max(-state.multiplier[i] / stiffness)
    };
    wrong.iter().copied().max_by(|&i, &j| off(i).total_cmp(&off(j))).unwrap_or(0)
}

/// The constraints active at the projection of w − D⁻¹ ∇J = w + D⁻¹ B'λ, D the diagonal of S.
///
/// d = diag S, z = w + D⁻¹B'λ, A = { i : (B p)_i = g_i } with p = argmin ½ Σ d_i (p_i − z_i)² over B p ≤ g. In the
/// nodal cone this would be the rule λ_i + d_i (w_i − g_i) > 0.
fn projected_set(problem: &EdgeProblem<'_>, state: &EdgeState) -> Result<ContactSet> {
    let force = problem.edge_cone().apply_transposed(&state.multiplier)?;
    let weight = |i: usize| problem.stiffness[(i, i)];
    let target: Vec<f64> =
        (0..force.len()).map(|i| state.displacement[i] + force[i] / weight(i)).collect();
    let nearest = Weighted {
        weight,
        bound: |i: usize| problem.bound[i],
        is_fixed: |i: usize| problem.fixed[i],
    };
    Ok(ContactSet::new(&match problem.ends {
        Ends::Open => project_weighted(&target, &nearest).1,
        Ends::Joined => active_on_ring(&target, &nearest),
    }))
}

/// The violated constraints, ascending.
///
/// i ∈ A with λ_i < −16 ε (|b| + |S||w|) or a gap that is not closed; i ∉ A with (B w − g)_i > 16 ε of its
/// terms.
fn wrong_constraints(problem: &EdgeProblem<'_>, set: &ContactSet, state: &EdgeState) -> Vec<usize> {
    let sizes = problem.sizes(&state.displacement);
    let is_wrong = |&i: &usize| {
        if set.contains(i) {
            state.multiplier[i] < -ROUNDING * sizes.force(i)
                || state.gap[i] != 0.0 && !problem.is_settled(i)
        } else {
            state.gap[i] > ROUNDING * sizes.gap(i) && !problem.is_settled(i)
        }
    };
    (0..set.constraints()).filter(is_wrong).collect()
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
                ends: Ends::Open,
            };
            for first in 0..8u32 {
                let start =
                    ContactSet::new(&(0..3).map(|i| first >> i & 1 == 1).collect::<Vec<_>>());
                let outcome = solve_on_edge(&problem, start).unwrap();
                assert!(outcome.status.is_converged(), "{load:?} from {first}");
            }
        }
    }

    /// Node 0 is pushed into the foundation, and off it as soon as it touches: no solution, and an S that is
    /// not symmetric.
    #[test]
    fn a_cycle_without_a_way_out_is_reported() {
        let entries = [[1.0, -2.0], [0.0, 1.0]];
        let stiffness = Mat::from_fn(2, 2, |i, j| entries[i][j]);
        let problem = EdgeProblem {
            stiffness: &stiffness,
            load: &[1.0, -1.0],
            bound: &[0.0; 2],
            fixed: &[false; 2],
            cone: Cone::Nodal,
            ends: Ends::Open,
        };
        let outcome = solve_on_edge(&problem, ContactSet::empty(2)).unwrap();
        assert_eq!(outcome.status, Status::Cycled { period: 2 });
        assert!(outcome.steps.len() < 10);
        // The last set is that of the outcome; its step still violates a constraint.
        let last = outcome.steps.last().unwrap();
        assert_eq!(last.set, outcome.set);
        assert!(last.penetration.max(last.tension) > 0.0, "{last:?}");
    }

    /// Two segments of different gaps between fixed ends: both cannot close, and it shows.
    #[test]
    fn a_run_that_cannot_hold_has_a_gap() {
        let stiffness = Mat::identity(3, 3);
        let fixed = [true, false, true];
        let (load, cone, ends) = (&[0.0, 1.0, 0.0][..], Cone::Midpoint, Ends::Open);
        for (bound, off) in [([0.1, 0.2], 0.1), ([0.2, 0.1], 0.1), ([0.2, 0.2], 0.0)] {
            let problem = EdgeProblem {
                stiffness: &stiffness,
                load,
                bound: &bound,
                fixed: &fixed,
                cone,
                ends,
            };
            let state = problem.solve_with(&ContactSet::new(&[true; 2])).unwrap();
            let largest = state.gap.iter().fold(0.0, |m: f64, gap| m.max(gap.abs()));
            assert!((largest - off).abs() < 1e-15, "{bound:?}: {:?}", state.gap);
            for start in [[true, true], [true, false], [false, true], [false, false]] {
                let outcome = solve_on_edge(&problem, ContactSet::new(&start)).unwrap();
                assert!(
                    outcome.status.is_converged(),
                    "{bound:?} from {start:?}: {}",
                    outcome.status
                );
                let least = 2.0 * f64::min(bound[0], bound[1]);
                assert!((outcome.state.displacement[1] - least).abs() < 1e-15);
            }
        }
    }
}
