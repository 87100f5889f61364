//! An interior point method on the condensed edge for the nodal cone, with a separate barrier weight for every node.
//!
//! min ½ w'S w − b'w − μ Σ ω_i ln s_i, s = g − w. On its central path S w + λ = b and λ_i s_i = μ ω_i. With equal
//! weights, as in a general solver, forces and gaps far below the largest ones do not change until μ is as small.
//! With ω_i = S_ii d_i², d_i the expected size of the displacement at node i, the path has the same relative distance
//! from both limits, λ_i = 0 and s_i = 0, at all nodes. Every step (Mehrotra's predictor-corrector) is a Newton
//! step,
//!
//! (S + diag(λ/s)) δw = …,
//!
//! and its Cholesky factorization is not affected by the d_i, since it commutes with scaling. Nodes should be
//! numbered from small to large displacements, so that small quantities are not differences of large ones.
//! The iteration ends when all nodes are classified: λ_i/(S_ii s_i) below 1e-12 or above 1e12. The method
//! shares only S with the active set method. It is not used in the midpoint cone, where λ/s would
//! dominate S on the sawtooth. Cost: one dense factorization per step, 15 to 60 steps.

use super::active_set::EdgeOutcome;
use super::edge_problem::{EdgeProblem, EdgeState};
use super::units::unit_for;
use crate::cone::{Cone, ContactSet, Status};
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::check::{require_entry, require_finite, require_length};
use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};

/// Ratio of force and gap, in the same units, at which a node is classified.
const DECIDED: f64 = 1e-12;
/// Tolerance for the balance of forces at every node, relative to its own terms.
const BALANCED: f64 = 1e-13;
/// Without contact, forces below this multiple of their terms are attributed to the barrier.
const LEFT: f64 = 1e-11;
/// Largest fraction of the distance to the boundary covered by a step.
const INSIDE: f64 = 0.995;
/// Largest number of steps.
const STEPS: usize = 200;

/// The iterate at all nodes; forces and gaps of fixed nodes are kept and ignored.
struct Iterate<'a> {
    problem: &'a EdgeProblem<'a>,
    weight: Vec<f64>,
    displacement: Vec<f64>,
    force: Vec<f64>,
    gap: Vec<f64>,
}

/// Changes of displacement, force and gap.
struct Change {
    displacement: Vec<f64>,
    force: Vec<f64>,
    gap: Vec<f64>,
}

/// The solution of the edge problem; `sizes` are the expected relative sizes of the displacement at the nodes.
///
/// # Errors
/// [`ToolkitError::NotPositiveDefinite`](crate::ToolkitError::NotPositiveDefinite) unless S is positive definite;
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if lengths differ;
/// [`ToolkitError::EntryOutOfRange`](crate::ToolkitError::EntryOutOfRange) for sizes that are not positive;
/// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) for loads and gaps that are not finite;
/// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for the midpoint cone.
pub(super) fn solve_by_barrier(problem: &EdgeProblem<'_>, sizes: &[f64]) -> Result<EdgeOutcome> {
    if problem.cone != Cone::Nodal {
        let given = problem.cone.to_string();
        return Err(Error::Toolkit(ToolkitError::Incompatible {
            what: "cone",
            given,
            with: "displacement sizes",
            expected: "the nodal cone",
        }));
    }
    let nothing = ContactSet::empty(problem.load.len());
    problem.check(&nothing)?;
    require_length("displacement sizes", sizes.len(), problem.load.len())?;
    require_finite("displacement size", sizes)?;
    require_finite("edge load", problem.load)?;
    require_finite("gap", problem.bound)?;
    if let Some(k) = sizes.iter().position(|&size| size <= 0.0) {
        require_entry("displacement size", k, sizes[k], "(0, inf)", false)?;
    }
    let free = || (0..sizes.len()).filter(|&i| !problem.fixed[i]);
    let alone = |i: usize| problem.load[i].abs() / problem.stiffness[(i, i)] / sizes[i];
    let scale =
        free().map(alone).chain(free().map(|i| problem.bound[i].abs() / sizes[i])).fold(0.0, f64::max);
    let is_unloaded = free().all(|i| problem.load[i] == 0.0 && problem.bound[i] >= 0.0);
    if scale == 0.0 || is_unloaded {
        let state = problem.solve_with(&nothing)?;
        let status = Status::Converged;
        return Ok(EdgeOutcome { state, set: nothing, status, history: Vec::new(), steps: 0 });
    }
    // Products of forces and gaps are of this size, squared.
    let root = free().map(|i| problem.stiffness[(i, i)].sqrt() * scale * sizes[i]).fold(0.0, f64::max);
    if let Some(unit) = unit_for(root) {
        return solve_in_unit(problem, sizes, unit);
    }
    let mut iterate = Iterate::new(problem, sizes, scale);
    for step in 0..STEPS {
        let balance = iterate.balance();
        if iterate.undecided() <= DECIDED && iterate.is_balanced(&balance) {
            return Ok(iterate.outcome(Status::Converged, step));
        }
        iterate.step(&balance)?;
    }
    Ok(iterate.outcome(Status::StepLimit { steps: STEPS }, STEPS))
}

/// The solution for loads and bounds divided by `unit`, scaled back.
fn solve_in_unit(problem: &EdgeProblem<'_>, sizes: &[f64], unit: f64) -> Result<EdgeOutcome> {
    let over = |values: &[f64]| -> Vec<f64> { values.iter().map(|v| v / unit).collect() };
    let (load, bound) = (over(problem.load), over(problem.bound));
    let scaled = EdgeProblem { load: &load, bound: &bound, ..*problem };
    let mut outcome = solve_by_barrier(&scaled, sizes)?;
    let EdgeState { displacement, multiplier, gap } = &mut outcome.state;
    for values in [displacement, multiplier, gap] {
        values.iter_mut().for_each(|v| *v *= unit);
    }
    Ok(outcome)
}

impl<'a> Iterate<'a> {
    fn new(problem: &'a EdgeProblem<'a>, sizes: &[f64], scale: f64) -> Self {
        let gap: Vec<f64> = sizes.iter().map(|size| scale * size).collect();
        let force: Vec<f64> = gap.iter().enumerate().map(|(i, s)| problem.stiffness[(i, i)] * s).collect();
        let weight = gap.iter().zip(&force).map(|(s, l)| s * l).collect();
        Self { problem, weight, displacement: vec![0.0; sizes.len()], force, gap }
    }

    fn free(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.gap.len()).filter(|&i| !self.problem.fixed[i])
    }

    /// b − S w − λ; 0 at fixed nodes.
    fn balance(&self) -> Vec<f64> {
        let mut balance = self.problem.residual(&self.displacement);
        for (i, r) in balance.iter_mut().enumerate() {
            *r = if self.problem.fixed[i] { 0.0 } else { *r - self.force[i] };
        }
        balance
    }

    fn is_balanced(&self, balance: &[f64]) -> bool {
        let term = |i: usize, j: usize| (self.problem.stiffness[(i, j)] * self.displacement[j]).abs();
        let size = |i: usize| {
            let terms: f64 = (0..balance.len()).map(|j| term(i, j)).sum();
            terms + self.problem.load[i].abs()
        };
        self.free().all(|i| balance[i].abs() <= BALANCED * size(i))
    }

    /// The ratio of force and gap, or its reciprocal, at the node that is farthest from being classified.
    fn undecided(&self) -> f64 {
        let quotient = |i: usize| self.force[i] / (self.problem.stiffness[(i, i)] * self.gap[i]);
        self.free().map(quotient).map(|q| q.min(1.0 / q)).fold(0.0, f64::max)
    }

    /// The mean of λ_i s_i/ω_i after a step of relative length `share`.
    fn mean(&self, change: &Change, share: f64) -> f64 {
        let product = |i: usize| {
            let force = self.force[i] + share * change.force[i];
            force * (self.gap[i] + share * change.gap[i]) / self.weight[i]
        };
        self.free().map(product).sum::<f64>() / self.free().count() as f64
    }

    fn step(&mut self, balance: &[f64]) -> Result<()> {
        let (size, fixed) = (self.gap.len(), self.problem.fixed);
        let entry = |i: usize, j: usize| match (fixed[i] || fixed[j], i == j) {
            (true, same) => f64::from(u8::from(same)),
            (false, true) => self.problem.stiffness[(i, i)] + self.force[i] / self.gap[i],
            (false, false) => self.problem.stiffness[(i, j)],
        };
        let factor = Mat::from_fn(size, size, entry).llt(Side::Lower).map_err(|_| {
            Error::Toolkit(ToolkitError::NotPositiveDefinite {
                what: "condensed stiffness matrix with barrier term",
                pivot: size,
            })
        })?;
        let predicted = self.change(&factor, balance, |i| -self.force[i] * self.gap[i]);
        let (now, then) =
            (self.mean(&predicted, 0.0), self.mean(&predicted, self.longest(&predicted).min(1.0)));
        let centre = (then / now).powi(3) * now;
        let change = self.change(&factor, balance, |i| {
            centre * self.weight[i] - self.force[i] * self.gap[i] - predicted.force[i] * predicted.gap[i]
        });
        let share = (INSIDE * self.longest(&change)).min(1.0);
        let add = |now: &mut [f64], change: &[f64]| {
            now.iter_mut().zip(change).for_each(|(now, change)| *now += share * change);
        };
        add(&mut self.displacement, &change.displacement);
        add(&mut self.force, &change.force);
        add(&mut self.gap, &change.gap);
        Ok(())
    }

    /// The change that balances the forces and satisfies s = g − w and λ_i δs_i + s_i δλ_i = `product(i)`.
    fn change(&self, factor: &Llt<f64>, balance: &[f64], product: impl Fn(usize) -> f64) -> Change {
        let (size, fixed) = (self.gap.len(), self.problem.fixed);
        let missing = |i: usize| self.problem.bound[i] - self.displacement[i] - self.gap[i];
        let force = |i: usize, gap: f64| (product(i) - self.force[i] * gap) / self.gap[i];
        let mut right =
            Mat::from_fn(size, 1, |i, _| if fixed[i] { 0.0 } else { balance[i] - force(i, missing(i)) });
        factor.solve_in_place(&mut right);
        let displacement: Vec<f64> = (0..size).map(|i| right[(i, 0)]).collect();
        let at_free = |i: usize, value: f64| if fixed[i] { 0.0 } else { value };
        let gap: Vec<f64> = (0..size).map(|i| at_free(i, missing(i) - displacement[i])).collect();
        let force = (0..size).map(|i| at_free(i, force(i, gap[i]))).collect();
        Change { displacement, force, gap }
    }

    /// The step length at which a force or a gap vanishes; at most 2.
    fn longest(&self, change: &Change) -> f64 {
        let until = |now: &[f64], change: &[f64]| {
            let falling = now.iter().zip(change).filter(|(_, change)| **change < 0.0);
            falling.map(|(now, change)| -now / change).fold(2.0, f64::min)
        };
        until(&self.force, &change.force).min(until(&self.gap, &change.gap))
    }

    fn outcome(mut self, status: Status, steps: usize) -> EdgeOutcome {
        let fixed = self.problem.fixed;
        let active = |i: usize| !fixed[i] && self.force[i] > self.problem.stiffness[(i, i)] * self.gap[i];
        let set = ContactSet::new(&(0..fixed.len()).map(active).collect::<Vec<_>>());
        // Without contact, small forces left by the barrier are set to zero.
        let sizes = self.problem.sizes(&self.displacement);
        let is_left = |i: usize| fixed[i] || self.force[i] <= LEFT * sizes.force(i);
        let is_free = set.count() == 0 && (0..fixed.len()).all(is_left);
        (0..fixed.len()).filter(|&i| fixed[i] || is_free).for_each(|i| self.force[i] = 0.0);
        let gap = self.displacement.iter().zip(self.problem.bound).map(|(w, g)| w - g).collect();
        let state = EdgeState { displacement: self.displacement, multiplier: self.force, gap };
        EdgeOutcome { state, set, status, history: Vec::new(), steps }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::Ends;
    use crate::contact::active_set::solve_on_edge;

    /// Loads of either sign that fall over sixty decades from the last node to the first.
    #[test]
    fn every_decade_agrees_with_the_active_set() {
        let nodes = 61;
        let size: Vec<f64> = (0..nodes).map(|i| 10f64.powi(i as i32 - 60)).collect();
        // Of what is ten times as large a hundredth arrives.
        let stiffness = Mat::from_fn(nodes, nodes, |i: usize, j| match i.abs_diff(j) {
            0 => 2.5,
            1 => -0.01,
            _ => 0.0,
        });
        let load: Vec<f64> = (0..nodes).map(|i| size[i] * if i % 5 < 2 { 1.0 } else { -1.0 }).collect();
        let (bound, fixed) = (vec![0.0; nodes], (0..nodes).map(|i| i == 0).collect::<Vec<_>>());
        let problem = EdgeProblem {
            stiffness: &stiffness,
            load: &load,
            bound: &bound,
            fixed: &fixed,
            cone: Cone::Nodal,
            ends: Ends::Open,
        };
        let exact = solve_on_edge(&problem, ContactSet::empty(nodes)).unwrap();
        let found = solve_by_barrier(&problem, &size).unwrap();
        assert!(found.status.is_converged(), "{:?}", found.status);
        for (i, &size) in size.iter().enumerate().skip(1) {
            assert_eq!(found.set.contains(i), exact.set.contains(i), "{i}");
            let off = (found.state.multiplier[i] - exact.state.multiplier[i]).abs();
            assert!(off < 1e-10 * size, "{i}: {off:e}");
        }
        for wrong in [vec![0.0; nodes], vec![-1.0; nodes], vec![f64::NAN; nodes], vec![1.0; 7]] {
            assert!(solve_by_barrier(&problem, &wrong).is_err());
        }
        let midpoint = EdgeProblem { cone: Cone::Midpoint, bound: &bound[1..], ..problem };
        assert!(solve_by_barrier(&midpoint, &size).is_err());
    }
}
