//! The contact problem reduced to its edge: min ½ w'S w − b'w over { B w ≤ g }, some w_i fixed at 0.
//!
//! For a given contact set the active constraints are eliminated exactly: w = o + Z q. For the nodal cone q are the
//! nodes off contact. For the midpoint cone a run of active segments leaves one amplitude of the sawtooth (−1)^i, the
//! kernel of B on that run, none when an end of the run is fixed. Z'SZ is as well conditioned as S, while
//! B S⁻¹ B' would lose a factor h^{-3}. The multipliers follow from r = b − S w = B'λ, run by run.
//! Cost: one dense Cholesky factorization with the number of free amplitudes.

use super::cone::Cone;
use super::contact_set::ContactSet;
use crate::error::{Error, Result};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// A dense contact problem on a chain of nodes.
#[derive(Debug, Clone)]
pub struct EdgeProblem<'a> {
    /// S, symmetric positive definite.
    pub stiffness: &'a Mat<f64>,
    /// b.
    pub load: &'a [f64],
    /// g, one bound per constraint of the cone.
    pub bound: &'a [f64],
    /// Nodes held at w = 0 (clamped ends of the edge).
    pub fixed: &'a [bool],
    /// B.
    pub cone: Cone,
}

/// The solution for one contact set, admissible or not.
#[derive(Debug, Clone)]
pub struct EdgeState {
    /// w.
    pub displacement: Vec<f64>,
    /// λ; zero off the set.
    pub multiplier: Vec<f64>,
    /// B w − g; exactly zero on the set.
    pub gap: Vec<f64>,
}

/// w = offset + sign · q at every node; no q where the node is determined by the set.
struct Parametrization {
    offset: Vec<f64>,
    amplitude: Vec<Option<(usize, f64)>>,
    count: usize,
}

impl EdgeProblem<'_> {
    /// The minimiser when the constraints in `set` hold with equality and the others are ignored.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] when S is not, [`Error::LengthMismatch`] when sizes disagree.
    pub fn solve_with(&self, set: &ContactSet) -> Result<EdgeState> {
        self.check(set)?;
        let free = match self.cone {
            Cone::Nodal => self.nodal_parametrization(set),
            Cone::Midpoint => self.midpoint_parametrization(set),
        };
        let displacement = self.minimise(&free)?;
        let residual = self.residual(&displacement);
        let multiplier = match self.cone {
            Cone::Nodal => (0..residual.len())
                .map(|i| if set.contains(i) && !self.fixed[i] { residual[i] } else { 0.0 })
                .collect(),
            Cone::Midpoint => self.midpoint_multiplier(set, &residual),
        };
        let mut gap = self.cone.apply(&displacement);
        for (i, gap) in gap.iter_mut().enumerate() {
            *gap = if set.contains(i) && !self.is_settled(i) { 0.0 } else { *gap - self.bound[i] };
        }
        Ok(EdgeState { displacement, multiplier, gap })
    }

    /// True when all nodes of constraint `i` are fixed, so that no set can influence it.
    pub fn is_settled(&self, i: usize) -> bool {
        self.cone.support(i).all(|node| self.fixed[node])
    }

    /// b − S w.
    pub fn residual(&self, w: &[f64]) -> Vec<f64> {
        let mut residual = self.load.to_vec();
        for (j, &value) in w.iter().enumerate() {
            let column = self.stiffness.col(j);
            for i in 0..residual.len() {
                residual[i] -= column[i] * value;
            }
        }
        residual
    }

    fn check(&self, set: &ContactSet) -> Result<()> {
        let nodes = self.stiffness.nrows();
        let constraints = self.cone.constraints(nodes);
        for (name, given, expected) in [
            ("edge load", self.load.len(), nodes),
            ("fixed nodes", self.fixed.len(), nodes),
            ("gap", self.bound.len(), constraints),
            ("contact set", set.constraints(), constraints),
        ] {
            if given != expected {
                return Err(Error::LengthMismatch { name, given, expected });
            }
        }
        Ok(())
    }

    fn nodal_parametrization(&self, set: &ContactSet) -> Parametrization {
        let mut free = Parametrization::empty(self.load.len());
        for i in 0..self.load.len() {
            if self.fixed[i] {
                continue;
            }
            if set.contains(i) {
                free.offset[i] = self.bound[i];
            } else {
                free.add(i);
            }
        }
        free
    }

    fn midpoint_parametrization(&self, set: &ContactSet) -> Parametrization {
        let nodes = self.load.len();
        let mut free = Parametrization::empty(nodes);
        let mut next = 0;
        for run in set.runs() {
            (next..run.start).filter(|&i| !self.fixed[i]).for_each(|i| free.add(i));
            next = run.end + 1;
            // Start where the value is known: at a fixed end, else at the left end with a new amplitude.
            if self.fixed[run.end] && !self.fixed[run.start] {
                for k in run.rev() {
                    free.offset[k] = 2.0 * self.bound[k] - free.offset[k + 1];
                }
                continue;
            }
            if !self.fixed[run.start] {
                free.add(run.start);
            }
            for k in run {
                if !self.fixed[k + 1] {
                    free.offset[k + 1] = 2.0 * self.bound[k] - free.offset[k];
                    free.amplitude[k + 1] = free.amplitude[k].map(|(q, sign)| (q, -sign));
                }
            }
        }
        (next..nodes).filter(|&i| !self.fixed[i]).for_each(|i| free.add(i));
        free
    }

    /// w = o + Z q with Z'S Z q = Z'(b − S o).
    fn minimise(&self, free: &Parametrization) -> Result<Vec<f64>> {
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
            let factor = reduced.llt(Side::Lower).map_err(|_| Error::NotPositiveDefinite {
                what: "condensed stiffness on the contact edge",
                pivot: free.count,
            })?;
            factor.solve_in_place(&mut right);
        }
        let mut w = free.offset.clone();
        for &(i, row, s) in &moving {
            w[i] += s * right[(row, 0)];
        }
        Ok(w)
    }

    /// λ from r = B'λ, along every run of active segments.
    fn midpoint_multiplier(&self, set: &ContactSet, residual: &[f64]) -> Vec<f64> {
        let mut multiplier = vec![0.0; set.constraints()];
        for run in set.runs() {
            if !self.fixed[run.start] {
                let mut before = 0.0;
                for k in run {
                    before = 2.0 * residual[k] - before;
                    multiplier[k] = before;
                }
                continue;
            }
            let mut after = 0.0;
            let known = if self.fixed[run.end] { run.end - 1 } else { run.end };
            for k in (run.start..known).rev() {
                after = 2.0 * residual[k + 1] - after;
                multiplier[k] = after;
            }
            if self.fixed[run.end] {
                center_sawtooth(&mut multiplier[run]);
            }
        }
        multiplier
    }
}

impl Parametrization {
    fn empty(nodes: usize) -> Self {
        Self { offset: vec![0.0; nodes], amplitude: vec![None; nodes], count: 0 }
    }

    fn add(&mut self, node: usize) {
        self.amplitude[node] = Some((self.count, 1.0));
        self.count += 1;
    }
}

/// Between two fixed ends λ is determined up to a sawtooth: the one with the greatest minimum is taken.
fn center_sawtooth(multiplier: &mut [f64]) {
    let least = |parity: usize| multiplier.iter().skip(parity).step_by(2).copied().reduce(f64::min);
    let (Some(even), Some(odd)) = (least(0), least(1)) else {
        return;
    };
    let shift = 0.5 * (odd - even);
    for (k, value) in multiplier.iter_mut().enumerate() {
        *value += if k % 2 == 0 { shift } else { -shift };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
                let problem =
                    EdgeProblem { stiffness: &stiffness, load: &load, bound: &bound, fixed: &fixed, cone };
                for pattern in 0..1u32 << (constraints - 1) {
                    let set = ContactSet::new((0..constraints).map(|i| pattern >> i & 1 == 1).collect());
                    check(&problem, &set);
                }
            }
        }
    }

    fn check(problem: &EdgeProblem<'_>, set: &ContactSet) {
        let state = problem.solve_with(set).unwrap();
        let residual = problem.residual(&state.displacement);
        let force = problem.cone.apply_transposed(&state.multiplier, residual.len()).unwrap();
        let means = problem.cone.apply(&state.displacement);
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
}
