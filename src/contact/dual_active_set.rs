//! The contact set of an edge problem by the dual method of D. Goldfarb and A. Idnani (Math. Program. 27
//! (1983)).
//!
//! Starting from the minimiser without contact, violated constraints are added one by one, and the iterate minimises
//! the energy ½ w'S w − b'w subject to the working set: with S = L L', c a row of B and C those of the
//! working set, the columns of L⁻¹C' are orthogonalised, L⁻¹C' = Q R, and J = L⁻ᵀ (Q, Q⊥) is stored. With
//! d = J'c = (d₁, d₂)
//!
//! w ← w − t J₂ d₂, λ ← λ − t R⁻¹d₁, λ_c ← λ_c + t,
//!
//! t up to where c holds, (c'w − g)/|d₂|², or to where a multiplier of the working set changes its sign; that
//! constraint is then dropped. The minimal energy subject to the working set increases from one set to the next, so
//! that no set recurs: the method terminates for every symmetric positive definite S and all loads, in exact
//! arithmetic. The constraint added is the one with the largest violation in the energy norm,
//! (c'w − g)/(c'S⁻¹c)^{1/2}. The condition number of L⁻¹C' is only the square root of that of B S⁻¹B', n^{3/2} in the
//! midpoint cone.
//!
//! No initial guess is needed: constraints with oscillating multipliers, which slow down an exchange method, are
//! dropped one by one. Measured for contact beside a clamped end in the midpoint cone, S about the square root of a
//! second difference on 513 nodes: the active set method takes 4 steps and less than a second with this method; with
//! single exchanges alone 516 steps and 6 s for one load, and for another there is no solution after 10 340 steps and
//! 83 s.
//!
//! Cost: one factorization of S, and O(n²) per constraint added or dropped, whose number is about that of the active
//! constraints. Rounding errors are corrected by [`super::solve_on_edge`], which starts with
//! [`EdgeProblem::solve_with`] from the set found.

use super::edge_problem::EdgeProblem;
use crate::cone::{ContactSet, EdgeCone};
use crate::error::{Error, Result};
use faer::linalg::solvers::Solve;
use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::{Mat, Par, Side};

/// A gap below this multiple of the size of its terms counts as closed.
const CLOSED: f64 = 1e-13;
/// A constraint counts as dependent on the working set if its component orthogonal to it, in the energy norm, is
/// smaller than this fraction of it.
const DEPENDENT: f64 = 1e-10;
/// Largest number of additions and removals per constraint.
const CHANGES: usize = 10;

/// The contact set, and the number of constraints added and dropped. If that number reaches the limit, or if rounding
/// makes the constraints inconsistent, the last working set.
///
/// # Errors
/// [`ToolkitError::NotPositiveDefinite`](crate::ToolkitError::NotPositiveDefinite) unless S is positive definite.
pub(super) fn dual_active_set(problem: &EdgeProblem<'_>) -> Result<(ContactSet, usize)> {
    let mut iterate = Iterate::new(problem)?;
    let limit = CHANGES * (1 + problem.bound.len());
    let mut changes = 0;
    'sets: while let Some(constraint) = iterate.furthest_off() {
        let mut force = 0.0;
        loop {
            changes += 1;
            match iterate.approach(constraint, &mut force) {
                _ if changes >= limit => break 'sets,
                Approach::Held => break,
                Approach::LetGo => (),
                Approach::Barred => break 'sets,
            }
        }
    }
    let mut active = vec![false; problem.bound.len()];
    iterate.held.iter().for_each(|&(constraint, _)| active[constraint] = true);
    Ok((ContactSet::new(&active), changes))
}

/// The outcome of a step toward a constraint.
enum Approach {
    Held,
    LetGo,
    /// The constraint is inconsistent with the working set.
    Barred,
}

struct Iterate<'a> {
    problem: &'a EdgeProblem<'a>,
    cone: EdgeCone,
    /// Nodes that may move.
    free: Vec<usize>,
    /// w at all nodes.
    displacement: Vec<f64>,
    /// The working set with its multipliers.
    held: Vec<(usize, f64)>,
    /// J, one vector for every column.
    basis: Vec<Vec<f64>>,
    /// R, column by column.
    triangle: Vec<Vec<f64>>,
    /// (c'S⁻¹c)^{1/2} for every constraint.
    norm: Vec<f64>,
}

impl<'a> Iterate<'a> {
    fn new(problem: &'a EdgeProblem<'a>) -> Result<Self> {
        let free: Vec<usize> = (0..problem.load.len()).filter(|&i| !problem.fixed[i]).collect();
        let n = free.len();
        let mut displacement = vec![0.0; problem.load.len()];
        let mut inverse = Mat::<f64>::identity(n, n);
        if n > 0 {
            let part = Mat::from_fn(n, n, |i, j| problem.stiffness[(free[i], free[j])]);
            let what = "condensed stiffness matrix on the contact edge";
            let factor =
                part.llt(Side::Lower).map_err(|_| Error::not_positive_definite(what, n))?;
            let mut w = Mat::from_fn(n, 1, |i, _| problem.load[free[i]]);
            factor.solve_in_place(&mut w);
            free.iter().enumerate().for_each(|(i, &node)| displacement[node] = w[(i, 0)]);
            solve_upper_triangular_in_place(factor.L().transpose(), inverse.as_mut(), Par::Seq);
        }
        let basis = (0..n).map(|j| (0..n).map(|i| inverse[(i, j)]).collect()).collect();
        let (held, triangle, norm, cone) =
            (Vec::new(), Vec::new(), Vec::new(), problem.edge_cone());
        let mut iterate = Self { problem, cone, free, displacement, held, basis, triangle, norm };
        let norm = |i| iterate.image(i).iter().map(|d| d * d).sum::<f64>().sqrt();
        iterate.norm = (0..problem.bound.len()).map(norm).collect();
        Ok(iterate)
    }

    /// d = J'c.
    fn image(&self, constraint: usize) -> Vec<f64> {
        let place = |node: usize| self.free.binary_search(&node).ok();
        let places: Vec<usize> = self.cone.support(constraint).filter_map(place).collect();
        let weight = self.cone.weight();
        self.basis
            .iter()
            .map(|column| weight * places.iter().map(|&i| column[i]).sum::<f64>())
            .collect()
    }

    /// c'w − g.
    fn off(&self, constraint: usize) -> f64 {
        let mean: f64 = self.cone.support(constraint).map(|node| self.displacement[node]).sum();
        self.cone.weight() * mean - self.problem.bound[constraint]
    }

    /// The constraint with the largest violation in the energy norm.
    fn furthest_off(&self) -> Option<usize> {
        let mut held = vec![false; self.norm.len()];
        self.held.iter().for_each(|&(i, _)| held[i] = true);
        let sizes = self.problem.sizes(&self.displacement);
        (0..self.norm.len())
            .filter(|&i| {
                !held[i] && !self.problem.is_settled(i) && self.off(i) > CLOSED * sizes.gap(i)
            })
            .max_by(|&i, &j| (self.off(i) / self.norm[i]).total_cmp(&(self.off(j) / self.norm[j])))
    }

    /// Takes one step toward a constraint whose current multiplier is `force`.
    ///
    /// t₁ = min { λ_k/(R⁻¹d₁)_k : (R⁻¹d₁)_k > 0 }, t₂ = (c'w − g)/|d₂|², t = min(t₁, t₂): a full step if t = t₂,
    /// otherwise constraint k is dropped. If no t is finite, c is a nonpositive combination of the constraints in the
    /// working set: inconsistent.
    fn approach(&mut self, constraint: usize, force: &mut f64) -> Approach {
        let image = self.image(constraint);
        let count = self.held.len();
        let (along, rest) = image.split_at(count);
        let left: f64 = rest.iter().map(|d| d * d).sum();
        let shares = self.shares(along);
        let falls =
            (0..count).filter(|&k| shares[k] > 0.0).map(|k| (k, self.held[k].1 / shares[k]));
        let first = falls.min_by(|a, b| a.1.total_cmp(&b.1));
        let is_dependent = left.sqrt() <= DEPENDENT * self.norm[constraint];
        let closes = if is_dependent { f64::INFINITY } else { self.off(constraint) / left };
        let length = first.map_or(closes, |(_, falls)| falls.max(0.0).min(closes));
        if !length.is_finite() {
            return Approach::Barred;
        }
        if !is_dependent {
            for (column, d) in self.basis[count..].iter().zip(rest) {
                self.free
                    .iter()
                    .zip(column)
                    .for_each(|(&i, v)| self.displacement[i] -= length * d * v);
            }
        }
        self.held.iter_mut().zip(&shares).for_each(|(held, share)| held.1 -= length * share);
        *force += length;
        match first {
            Some((k, falls)) if falls.max(0.0) < closes => {
                self.let_go(k);
                Approach::LetGo
            }
            _ => {
                self.take(constraint, *force, image);
                Approach::Held
            }
        }
    }

    /// R⁻¹d₁.
    fn shares(&self, along: &[f64]) -> Vec<f64> {
        let mut shares = along.to_vec();
        for k in (0..shares.len()).rev() {
            shares[k] /= self.triangle[k][k];
            let share = shares[k];
            shares[..k].iter_mut().zip(&self.triangle[k]).for_each(|(s, r)| *s -= share * r);
        }
        shares
    }

    /// Adds the constraint with image d: rotates the columns of J₂ so that only the first of them has a
    /// component along it.
    fn take(&mut self, constraint: usize, force: f64, mut image: Vec<f64>) {
        let count = self.held.len();
        for k in (count + 1..image.len()).rev() {
            let (turn, length) = Turn::of(image[k - 1], image[k]);
            image[k - 1] = length;
            turn.apply(&mut self.basis, k - 1);
        }
        image.truncate(count + 1);
        self.triangle.push(image);
        self.held.push((constraint, force));
    }

    /// Drops the k-th constraint of the working set.
    ///
    /// R loses column k and becomes upper Hessenberg from there; Givens rotations restore it and act on J. O(n²).
    fn let_go(&mut self, k: usize) {
        self.held.remove(k);
        self.triangle.remove(k);
        for i in k..self.triangle.len() {
            let (turn, length) = Turn::of(self.triangle[i][i], self.triangle[i][i + 1]);
            self.triangle[i][i] = length;
            self.triangle[i].truncate(i + 1);
            for column in &mut self.triangle[i + 1..] {
                [column[i], column[i + 1]] = turn.of_pair(column[i], column[i + 1]);
            }
            turn.apply(&mut self.basis, i);
        }
    }
}

/// A rotation (a, b) → (c a + s b, c b − s a).
#[derive(Clone, Copy)]
struct Turn {
    cos: f64,
    sin: f64,
}

impl Turn {
    /// The rotation that maps (a, b) to (length, 0).
    fn of(a: f64, b: f64) -> (Self, f64) {
        let length = a.hypot(b);
        if length == 0.0 {
            (Self { cos: 1.0, sin: 0.0 }, 0.0)
        } else {
            (Self { cos: a / length, sin: b / length }, length)
        }
    }

    fn of_pair(self, a: f64, b: f64) -> [f64; 2] {
        [self.cos * a + self.sin * b, self.cos * b - self.sin * a]
    }

    /// Applies the rotation to columns k and k + 1.
    fn apply(self, columns: &mut [Vec<f64>], k: usize) {
        let [left, right] = &mut columns[k..k + 2] else { return };
        for (a, b) in left.iter_mut().zip(right) {
            [*a, *b] = self.of_pair(*a, *b);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::{Cone, Ends};
    use crate::contact::active_set::solve_on_edge;

    /// S = A A' + a random diagonal, bounds of either sign, ends fixed or not; every condition is checked.
    #[test]
    fn sets_are_those_of_the_solution() {
        let mut state = 7_u64;
        let mut between = |low: f64, high: f64| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            low + (high - low) * ((state >> 11) as f64 / (1_u64 << 53) as f64)
        };
        for trial in 0..400 {
            let nodes = 3 + between(0.0, 12.0) as usize;
            let a = Mat::from_fn(nodes, nodes, |_, _| between(-1.0, 1.0));
            let shift = 10f64.powf(between(-3.0, 1.0));
            let stiffness = &a * a.transpose()
                + Mat::from_fn(nodes, nodes, |i, j| if i == j { shift } else { 0.0 });
            let load: Vec<f64> = (0..nodes).map(|_| between(-1.0, 1.0)).collect();
            let fixed: Vec<bool> = (0..nodes)
                .map(|i| i == 0 && trial % 2 == 1 || i + 1 == nodes && trial % 4 > 1)
                .collect();
            for cone in Cone::ALL {
                let bound: Vec<f64> =
                    (0..cone.constraints(nodes)).map(|_| between(0.0, 0.3)).collect();
                let (load, fixed, bound) = (&load[..], &fixed[..], &bound[..]);
                let ends = Ends::Open;
                let problem = EdgeProblem { stiffness: &stiffness, load, bound, fixed, cone, ends };
                let (set, changes) = dual_active_set(&problem).unwrap();
                let state = problem.solve_with(&set).unwrap();
                let case = format!("{trial} {cone}: {set:?}");
                assert!(changes >= set.count(), "{case}");
                assert!(
                    state.multiplier.iter().all(|&l| l >= -1e-10),
                    "{case} {:?}",
                    state.multiplier
                );
                let open = |i: usize| !problem.is_settled(i) && state.gap[i] > 1e-12;
                assert!(!(0..bound.len()).any(open), "{case} {:?}", state.gap);
            }
        }
    }

    /// Contact from a clamped node to a gap, S about h^{-1} times the square root of a second difference.
    #[test]
    fn a_run_beside_a_clamped_node_is_broken_up() {
        let nodes = 97;
        let wave = |k: usize, i: usize| {
            (std::f64::consts::PI * ((2 * k + 1) * i) as f64 / (2 * nodes - 2) as f64).sin()
        };
        let stiffness = Mat::from_fn(nodes, nodes, |i, j| {
            let own = if i == j { 1e-3 } else { 0.0 };
            own + (0..nodes - 1).map(|k| (k as f64 + 0.5) * wave(k, i) * wave(k, j)).sum::<f64>()
                / nodes as f64
        });
        let load: Vec<f64> =
            (0..nodes).map(|i| if i < 3 * nodes / 10 { 1.0 } else { -1.0 }).collect();
        let (bound, fixed) = (vec![0.0; nodes - 1], (0..nodes).map(|i| i == 0).collect::<Vec<_>>());
        let (load, bound, fixed) = (&load[..], &bound[..], &fixed[..]);
        let (cone, ends) = (Cone::Midpoint, Ends::Open);
        let problem = EdgeProblem { stiffness: &stiffness, load, bound, fixed, cone, ends };
        let (set, _) = dual_active_set(&problem).unwrap();
        let found = solve_on_edge(&problem, ContactSet::empty(nodes - 1)).unwrap();
        let (status, steps) = (found.status, found.steps.len());
        assert!(status.is_converged() && steps < 30, "{status} {steps}");
        assert_eq!(found.set, set);
    }
}
