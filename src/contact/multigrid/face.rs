//! The unknowns that a contact set leaves free, on a level and on the coarser ones.
//!
//! Active nodes of the nodal cone have no u_N left. On a run of active segments of the midpoint cone one
//! amplitude of the sawtooth (−1)^i is left: one unknown with many nodes. Coarse functions keep their u_N
//! where they vanish at every node of a run: so the coarse spaces lie in the fine one, and a cycle corrects
//! exactly. What this takes from a coarse level lies within a coarse mesh size of the ends of contact, and
//! the next finer level has it.

use super::super::problem::ContactProblem;
use super::level::Level;
use crate::cone::{ContactSet, Coordinates, EdgeCone};

/// One unknown: the sawtooth on a run.
#[derive(Debug, Clone)]
pub(super) struct Sawtooth {
    /// Place and sign of every node of the run.
    pub(super) nodes: Vec<(usize, f64)>,
    /// s'K over the unit, as (place, value).
    row: Vec<(usize, f32)>,
    /// s'K s over the unit.
    own: f32,
}

impl Sawtooth {
    fn new<L: Level>(problem: &ContactProblem, level: &L, run: Vec<(usize, f64)>) -> Self {
        let mut row = std::collections::BTreeMap::new();
        for &(unknown, sign) in &run {
            for (column, value) in problem.row(unknown) {
                *row.entry(level.place(column)).or_insert(0.0) += sign * value / level.unit();
            }
        }
        let nodes: Vec<(usize, f64)> = run.into_iter().map(|(u, sign)| (level.place(u), sign)).collect();
        let own: f64 = nodes.iter().map(|(place, sign)| sign * row.get(place).copied().unwrap_or(0.0)).sum();
        Self {
            nodes,
            row: row.into_iter().map(|(place, value)| (place, value as f32)).collect(),
            own: own as f32,
        }
    }

    /// The part of the residual that moves the amplitude, ± its mean on the run, times a factor.
    pub(super) fn force(&self, residual: &[f64], factor: f64, out: &mut [f32]) {
        let sum: f64 = self.nodes.iter().map(|&(place, sign)| sign * residual[place]).sum();
        let mean = factor * sum / self.nodes.len() as f64;
        self.nodes.iter().for_each(|&(place, sign)| out[place] = (sign * mean) as f32);
    }

    /// Gives the amplitude the value that balances it.
    pub(super) fn relax(&self, x: &mut [f32], b: &[f32]) {
        let force: f32 = self.nodes.iter().map(|&(place, sign)| sign as f32 * b[place]).sum();
        let held: f32 = self.row.iter().map(|&(place, value)| value * x[place]).sum();
        let change = (force - held) / self.own;
        self.nodes.iter().for_each(|&(place, sign)| x[place] += sign as f32 * change);
    }
}

/// A contact set as the unknowns see it.
pub(super) struct FreePart {
    /// Nodes of the contact edge whose u_N is not free by itself.
    pub(super) held: Vec<bool>,
    /// The amplitudes.
    pub(super) sawtooths: Vec<Sawtooth>,
    /// What to add to u_N along the edge so that the active constraints hold.
    pub(super) change: Vec<f64>,
}

impl FreePart {
    /// For the active constraints `set` and B w ≤ `bound` for a change w of u_N; nothing moves at fixed
    /// nodes.
    pub(super) fn new<L: Level>(
        problem: &ContactProblem,
        level: &L,
        (cone, set): (EdgeCone, &ContactSet),
        bound: &[f64],
        fixed: &[bool],
    ) -> Self {
        let Coordinates { offset: mut change, amplitude, count } =
            cone.coordinates(set.as_slice(), bound, fixed);
        let normals = problem.normal_unknowns();
        let mut runs: Vec<Vec<(usize, f64)>> = vec![Vec::new(); count];
        for (k, amplitude) in amplitude.iter().enumerate() {
            if let &Some((q, sign)) = amplitude {
                runs[q].push((k, sign));
            }
        }
        let mut held: Vec<bool> = amplitude.iter().map(Option::is_none).collect();
        let mut sawtooths = Vec::new();
        for run in runs.into_iter().filter(|run| run.len() > 1) {
            // The smallest change that does it.
            let mean = run.iter().map(|&(k, sign)| sign * change[k]).sum::<f64>() / run.len() as f64;
            for &(k, sign) in &run {
                change[k] -= sign * mean;
                held[k] = true;
            }
            let nodes = run.into_iter().map(|(k, sign)| (normals[k], sign)).collect();
            sawtooths.push(Sawtooth::new(problem, level, nodes));
        }
        Self { held, sawtooths, change }
    }
}
