//! The contact problem reduced to its edge: min ½ w'S w − b'w over { B w ≤ g }, some w_i fixed at 0.
//!
//! For a given contact set the active constraints are eliminated exactly: w = o + Z q, the coordinates of
//! the face (module `cone`): the free nodes, and in the midpoint cone one amplitude of the sawtooth (−1)^i
//! for every contact interval. Z'SZ is as well conditioned as S, while the condition number of B S⁻¹ B' is of
//! order h^{-3} in the midpoint cone, h the mesh size.
//! The multipliers follow from r = b − S w = B'λ, interval by interval. Cost: one dense Cholesky
//! factorization with the number of free amplitudes.

use crate::cone::{Cone, ContactSet, Coordinates, EdgeCone, Ends};
use crate::error::{Error, Result};
use crate::numeric::check::require_length;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// The equations of a set count as consistent if they hold up to this multiple of their terms.
pub(super) const HELD: f64 = 1e-10;

/// A dense contact problem on an open or closed chain of nodes.
#[derive(Debug, Clone)]
pub(crate) struct EdgeProblem<'a> {
    /// S, symmetric positive definite.
    pub(crate) stiffness: &'a Mat<f64>,
    /// b.
    pub(crate) load: &'a [f64],
    /// g, one bound per constraint of the cone.
    pub(crate) bound: &'a [f64],
    /// Nodes fixed at w = 0 (ends of the edge on the Dirichlet boundary).
    pub(crate) fixed: &'a [bool],
    /// B.
    pub(crate) cone: Cone,
    /// Whether the chain is closed; a closed chain has no fixed nodes.
    pub(crate) ends: Ends,
}

/// The solution for a given contact set, feasible or not.
#[derive(Debug, Clone)]
pub(crate) struct EdgeState {
    /// w.
    pub(crate) displacement: Vec<f64>,
    /// λ; zero off the set.
    pub(crate) multiplier: Vec<f64>,
    /// B w − g; exactly zero on the set, except on a contact interval between two fixed nodes, which has
    /// one equation more than nodes and may be inconsistent.
    pub(crate) gap: Vec<f64>,
}

impl EdgeProblem<'_> {
    /// The minimiser if the constraints in `set` hold with equality and the others are ignored.
    ///
    /// # Errors
    /// [`ToolkitError::NotPositiveDefinite`](crate::ToolkitError::NotPositiveDefinite) unless S is positive definite,
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if sizes differ.
    pub(crate) fn solve_with(&self, set: &ContactSet) -> Result<EdgeState> {
        self.check(set)?;
        let cone = self.edge_cone();
        let free = cone.coordinates(set.as_slice(), self.bound, self.fixed);
        let displacement = self.minimise(&free)?;
        let residual = self.residual(&displacement);
        let multiplier = cone.multipliers(set.as_slice(), &residual, |node| self.fixed[node]);
        let mut gap = cone.apply(&displacement);
        for (i, gap) in gap.iter_mut().enumerate() {
            let size = cone
                .support(i)
                .map(|node| displacement[node].abs())
                .fold(self.bound[i].abs(), f64::max);
            let off = *gap - self.bound[i];
            let holds = set.contains(i) && !self.is_settled(i) && off.abs() <= HELD * size;
            *gap = if holds { 0.0 } else { off };
        }
        Ok(EdgeState { displacement, multiplier, gap })
    }

    /// True if all nodes of constraint `i` are fixed, so that it does not depend on the contact set.
    pub(super) fn is_settled(&self, i: usize) -> bool {
        self.edge_cone().support(i).all(|node| self.fixed[node])
    }

    /// b − S w.
    pub(super) fn residual(&self, w: &[f64]) -> Vec<f64> {
        let mut residual = self.load.to_vec();
        for (j, &value) in w.iter().enumerate() {
            let column = self.stiffness.col(j);
            for i in 0..residual.len() {
                residual[i] -= column[i] * value;
            }
        }
        residual
    }

    /// The sizes of the terms of the residual at a displacement.
    ///
    /// t_i = |b_i| + Σ_j |S_ij||w_j|: the componentwise scale of a backward error in b − S w. Cost: O(n²).
    pub(super) fn sizes(&self, w: &[f64]) -> Sizes<'_> {
        let mut terms: Vec<f64> = self.load.iter().map(|b| b.abs()).collect();
        for (j, &value) in w.iter().enumerate() {
            let column = self.stiffness.col(j);
            for i in 0..terms.len() {
                terms[i] += (column[i] * value).abs();
            }
        }
        Sizes { problem: self, terms }
    }

    pub(super) fn check(&self, set: &ContactSet) -> Result<()> {
        let nodes = self.stiffness.nrows();
        let constraints = self.edge_cone().constraints();
        for (name, given, expected) in [
            ("edge load", self.load.len(), nodes),
            ("fixed nodes", self.fixed.len(), nodes),
            ("gap", self.bound.len(), constraints),
            ("contact set", set.constraints(), constraints),
        ] {
            require_length(name, given, expected)?;
        }
        Ok(())
    }

    pub(super) fn edge_cone(&self) -> EdgeCone {
        self.cone.on(self.load.len(), self.ends)
    }

    /// w = o + Z q with Z'S Z q = Z'(b − S o).
    fn minimise(&self, free: &Coordinates) -> Result<Vec<f64>> {
        let mut reduced = Mat::<f64>::zeros(free.count, free.count);
        let moving: Vec<(usize, usize, f64)> = free
            .amplitude
            .iter()
            .enumerate()
            .filter_map(|(i, amplitude)| amplitude.map(|(q, sign)| (i, q, sign)))
            .collect();
        for &(j, column, t) in &moving {
            let source = self.stiffness.col(j);
            for &(i, row, s) in &moving {
                reduced[(row, column)] += s * t * source[i];
            }
        }
        let residual = self.residual(&free.offset);
        let mut right = Mat::<f64>::zeros(free.count, 1);
        for &(i, row, s) in &moving {
            right[(row, 0)] += s * residual[i];
        }
        if free.count > 0 {
            let what = "condensed stiffness matrix on the contact edge";
            let factor = reduced.llt(Side::Lower);
            let factor = factor.map_err(|_| Error::not_positive_definite(what, free.count))?;
            factor.solve_in_place(&mut right);
        }
        let mut w = free.offset.clone();
        for &(i, row, s) in &moving {
            w[i] += s * right[(row, 0)];
        }
        Ok(w)
    }
}

/// (|b| + |S||w|)_i, the size of the terms of b − S w at every node. On an edge graded over many decades
/// displacements and forces have no common scale; rounding is therefore measured node by node.
pub(super) struct Sizes<'a> {
    problem: &'a EdgeProblem<'a>,
    terms: Vec<f64>,
}

impl Sizes<'_> {
    /// The size at the nodes of a constraint, as a force.
    pub(super) fn force(&self, constraint: usize) -> f64 {
        let support = self.problem.edge_cone().support(constraint);
        support.map(|node| self.terms[node]).fold(0.0, f64::max)
    }

    /// The size as a displacement: the force divided by the diagonal of S, and the bound of the constraint.
    pub(super) fn gap(&self, constraint: usize) -> f64 {
        let alone = |node: usize| self.terms[node] / self.problem.stiffness[(node, node)];
        let support = self.problem.edge_cone().support(constraint);
        support.map(alone).fold(self.problem.bound[constraint].abs(), f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::{Weighted, project_weighted};

    /// S = tridiag(−1, 2.5, −1): solutions for a set satisfy the equations they claim to satisfy.
    #[test]
    fn equality_problems_balance() {
        let nodes = 7;
        let stiffness = Mat::from_fn(nodes, nodes, |i, j| match i.abs_diff(j) {
            0 => 2.5,
            1 => -1.0,
            _ => 0.0,
        });
        let load = [1.0, -2.0, 3.0, 0.5, -1.0, 2.0, 1.5];
        for cone in Cone::ALL {
            for fixed_ends in 0..4usize {
                let mut fixed = vec![false; nodes];
                fixed[0] = fixed_ends & 1 == 1;
                fixed[nodes - 1] = fixed_ends & 2 == 2;
                let constraints = cone.constraints(nodes);
                let bound: Vec<f64> = (0..constraints).map(|i| 0.1 * i as f64).collect();
                let problem = EdgeProblem {
                    stiffness: &stiffness,
                    load: &load,
                    bound: &bound,
                    fixed: &fixed,
                    cone,
                    ends: Ends::Open,
                };
                for pattern in 0..1u32 << (constraints - 1) {
                    let set = ContactSet::new(
                        &(0..constraints).map(|i| pattern >> i & 1 == 1).collect::<Vec<_>>(),
                    );
                    check(&problem, &set);
                }
            }
        }
    }

    fn check(problem: &EdgeProblem<'_>, set: &ContactSet) {
        let state = problem.solve_with(set).unwrap();
        let residual = problem.residual(&state.displacement);
        let force = problem.edge_cone().apply_transposed(&state.multiplier).unwrap();
        let means = problem.edge_cone().apply(&state.displacement);
        for i in 0..residual.len() {
            if problem.fixed[i] {
                assert_eq!(state.displacement[i], 0.0);
            } else {
                assert!((residual[i] - force[i]).abs() < 1e-13, "{set:?} node {i}");
            }
        }
        for i in set.indices().into_iter().filter(|&i| !problem.is_settled(i)) {
            if problem.cone == Cone::Midpoint || !problem.fixed[i] {
                assert!((means[i] - problem.bound[i]).abs() < 1e-14, "{set:?} constraint {i}");
            }
        }
    }

    fn project(
        target: &[f64],
        weights: &[f64],
        bound: &[f64],
        fixed: &[bool],
    ) -> (Vec<f64>, ContactSet) {
        let nearest =
            Weighted { weight: |i| weights[i], bound: |i| bound[i], is_fixed: |i| fixed[i] };
        let (p, active) = project_weighted(target, &nearest);
        (p, ContactSet::new(&active))
    }

    /// The other method: try every contact set for S = D, b = D z, and take the one that satisfies all
    /// conditions.
    fn exhaustive(target: &[f64], weights: &[f64], bound: &[f64], fixed: &[bool]) -> Vec<f64> {
        let nodes = target.len();
        let stiffness = Mat::from_fn(nodes, nodes, |i, j| if i == j { weights[i] } else { 0.0 });
        let load: Vec<f64> = target.iter().zip(weights).map(|(z, d)| z * d).collect();
        let (cone, ends) = (Cone::Midpoint, Ends::Open);
        let problem = EdgeProblem { stiffness: &stiffness, load: &load, bound, fixed, cone, ends };
        (0..1_u32 << bound.len())
            .map(|pattern| {
                ContactSet::new(
                    &(0..bound.len()).map(|i| pattern >> i & 1 == 1).collect::<Vec<_>>(),
                )
            })
            .map(|set| problem.solve_with(&set).unwrap())
            .find(|state| {
                let admissible =
                    (0..bound.len()).all(|i| state.gap[i] <= 1e-13 || problem.is_settled(i));
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
                assert!(
                    (p[i] - expected[i]).abs() < 1e-12,
                    "{trial}: {p:?}, expected {expected:?}"
                );
            }
            for i in active.indices() {
                let slack = 2.0 * bound[i] - p[i] - p[i + 1];
                assert!(slack.abs() < 1e-12, "{trial}: constraint {i}, {p:?}");
            }
        }
    }
}
