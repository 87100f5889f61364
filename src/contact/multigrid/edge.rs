//! The contact edge of a level during the iteration: gaps, forces, violated constraints, and the next contact set.

use super::super::active_set::{ROUNDING, changed};
use super::super::edge_problem::HELD;
use super::super::problem::ContactProblem;
use super::level::Level;
use crate::cone::{Cone, ContactSet, EdgeCone, Face, Weighted, project_weighted};
use crate::error::Result;

pub(super) struct Edge {
    pub(super) cone: EdgeCone,
    /// B g.
    pub(super) bound: Vec<f64>,
    /// Prescribed u_N.
    pub(super) fixed: Vec<bool>,
    places: Vec<usize>,
    diagonals: Vec<f64>,
    /// An estimate of the ratio of the diagonals of the condensed matrix and of K.
    condensed: f64,
    /// Rows of |K| at the places, and |F|.
    rows: Vec<Vec<(usize, f64)>>,
    loads: Vec<f64>,
}

/// The contact quantities of an iterate.
pub(super) struct Contact {
    /// λ, zero off the set.
    pub(super) multiplier: Vec<f64>,
    /// B u − g; zero on the set, except on a contact interval between two fixed nodes whose constraints are
    /// inconsistent.
    pub(super) gap: Vec<f64>,
    pub(super) wrong: Vec<usize>,
}

impl Edge {
    pub(super) fn new<L: Level>(
        problem: &ContactProblem,
        level: &L,
        cone: Cone,
        condensed: f64,
    ) -> Self {
        let cone = problem.edge_cone(cone);
        let normals = problem.normal_unknowns();
        let row = |&unknown: &usize| {
            problem
                .row(unknown)
                .into_iter()
                .map(|(column, value)| (level.place(column), value.abs()))
                .collect()
        };
        Self {
            cone,
            bound: cone.apply(&problem.gap),
            fixed: normals.iter().map(|&unknown| problem.prescribed[unknown]).collect(),
            places: normals.iter().map(|&unknown| level.place(unknown)).collect(),
            diagonals: normals.iter().map(|&unknown| problem.diagonal(unknown)).collect(),
            rows: normals.iter().map(row).collect(),
            condensed,
            loads: normals.iter().map(|&unknown| problem.load[unknown].abs()).collect(),
        }
    }

    /// The bound on B w for changes w of the iterate.
    pub(super) fn slack(&self, x: &[f64]) -> Vec<f64> {
        let normal: Vec<f64> = self.places.iter().map(|&place| x[place]).collect();
        self.cone
            .apply(&normal)
            .into_iter()
            .zip(&self.bound)
            .map(|(mean, bound)| bound - mean)
            .collect()
    }

    /// x ← x + change along the edge.
    pub(super) fn add(&self, x: &mut [f64], change: &[f64]) {
        self.places.iter().zip(change).for_each(|(&place, change)| x[place] += change);
    }

    /// r ← r − B'λ.
    pub(super) fn subtract_force(&self, residual: &mut [f64], multiplier: &[f64]) -> Result<()> {
        let force = self.cone.apply_transposed(multiplier)?;
        self.places.iter().zip(force).for_each(|(&place, force)| residual[place] -= force);
        Ok(())
    }

    /// The contact quantities of an iterate that satisfies the constraints of the set, given its residual F − K x.
    pub(super) fn contact(&self, x: &[f64], residual: &[f64], set: &ContactSet) -> Contact {
        let force = self.balanced_force(residual, set);
        let multiplier = self.cone.multipliers(set.as_slice(), &force, |node| self.fixed[node]);
        let settled = |i: usize| self.cone.support(i).all(|node| self.fixed[node]);
        let slack = self.slack(x);
        let size = |i: usize| {
            self.cone
                .support(i)
                .map(|k| x[self.places[k]].abs())
                .fold(self.bound[i].abs(), f64::max)
        };
        let holds = |i: usize| set.contains(i) && !settled(i) && slack[i].abs() <= HELD * size(i);
        let gap: Vec<f64> =
            (0..slack.len()).map(|i| if holds(i) { 0.0 } else { -slack[i] }).collect();
        let sizes: Vec<f64> = (0..self.places.len())
            .map(|k| {
                self.loads[k]
                    + self.rows[k].iter().map(|&(place, v)| v * x[place].abs()).sum::<f64>()
            })
            .collect();
        let is_wrong = |&i: &usize| {
            let largest =
                |value: &dyn Fn(usize) -> f64| self.cone.support(i).map(value).fold(0.0, f64::max);
            if set.contains(i) {
                let force = largest(&|k| sizes[k]);
                multiplier[i] < -ROUNDING * force || gap[i] != 0.0 && !settled(i)
            } else {
                let size = largest(&|k| sizes[k] / self.diagonals[k]).max(self.bound[i].abs());
                gap[i] > ROUNDING * size && !settled(i)
            }
        };
        let wrong = (0..gap.len()).filter(is_wrong).collect();
        Contact { multiplier, gap, wrong }
    }

    /// The residual along the edge without its sawtooth components on contact intervals with a free amplitude: B'λ
    /// has no such component, so that it is an iteration error.
    fn balanced_force(&self, residual: &[f64], set: &ContactSet) -> Vec<f64> {
        let mut force: Vec<f64> = self.places.iter().map(|&place| residual[place]).collect();
        if self.cone.kind() == Cone::Midpoint {
            for run in Face::new(self.cone, set.as_slice()).runs() {
                let nodes: Vec<usize> = run.nodes(force.len()).collect();
                if nodes.iter().any(|&k| self.fixed[k]) {
                    continue;
                }
                let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
                let sum: f64 = nodes.iter().enumerate().map(|(i, &k)| sign(i) * force[k]).sum();
                let mean = sum / nodes.len() as f64;
                nodes.iter().enumerate().for_each(|(i, &k)| force[k] -= sign(i) * mean);
            }
        }
        force
    }

    /// The next set: in the nodal cone, and if only ends of contact intervals move, all violated constraints are
    /// exchanged; otherwise it consists of the constraints active at the projection of w + D⁻¹ B'λ. If a contact
    /// interval is too short by one segment, the force at its end causes an oscillation of all its multipliers, which
    /// the projection would follow.
    pub(super) fn next_set(
        &self,
        x: &[f64],
        set: &ContactSet,
        contact: &Contact,
    ) -> Result<ContactSet> {
        if self.cone.kind() == Cone::Nodal || only_ends_move(set, &contact.wrong) {
            return Ok(changed(set, &contact.wrong));
        }
        let force = self.cone.apply_transposed(&contact.multiplier)?;
        let weight = |k: usize| self.condensed * self.diagonals[k];
        let target: Vec<f64> = force
            .iter()
            .enumerate()
            .map(|(k, force)| if self.fixed[k] { 0.0 } else { force / weight(k) })
            .collect();
        let mut slack = self.slack(x);
        (0..slack.len()).filter(|&i| set.contains(i)).for_each(|i| slack[i] = 0.0);
        let nearest =
            Weighted { weight, bound: |i: usize| slack[i], is_fixed: |k: usize| self.fixed[k] };
        Ok(ContactSet::new(&project_weighted(&target, &nearest).1))
    }

    /// The energy norm of a change that removes all penetration, estimated node by node.
    ///
    /// (Σ_i k_i (B u − g)_{i,+}²)^{1/2}, k_i the larger K_kk of the nodes of constraint i.
    pub(super) fn penetration(&self, contact: &Contact) -> f64 {
        let term = |(i, gap): (usize, &f64)| {
            let stiff = self.cone.support(i).map(|k| self.diagonals[k]).fold(0.0, f64::max);
            stiff.sqrt() * gap.max(0.0)
        };
        contact.gap.iter().enumerate().map(term).fold(0.0, f64::hypot)
    }
}

/// True if all violated constraints are adjacent to an end of a contact interval. Intervals that vanish, and new
/// contact inside a non-contact interval, are treated by the projection.
fn only_ends_move(set: &ContactSet, wrong: &[usize]) -> bool {
    wrong.chunk_by(|&a, &b| a + 1 == b && set.contains(a) == set.contains(b)).all(|stretch| {
        let (first, last, is_active) =
            (stretch[0], stretch[stretch.len() - 1], set.contains(stretch[0]));
        let differs = |i: usize| i < set.constraints() && set.contains(i) != is_active;
        match (first.checked_sub(1).is_some_and(differs), differs(last + 1)) {
            (before, after) if is_active => before != after,
            (before, after) => before || after,
        }
    })
}
