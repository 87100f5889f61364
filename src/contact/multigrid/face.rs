//! The free unknowns of a contact set, on a level and on the coarser ones.
//!
//! At active nodes of the nodal cone u_N is fixed. On a contact interval of the midpoint cone one amplitude of the
//! sawtooth (−1)^i is free: a single unknown with many nodes. Coarse functions leave u_N unchanged if they vanish at
//! all nodes of the contact intervals, so that the coarse spaces are subspaces of the fine one. The functions omitted
//! on a coarse level lie within one coarse mesh size of the ends of the contact intervals and are represented
//! on the next finer level.

use super::super::problem::ContactProblem;
use super::level::Level;
use crate::cone::{ContactSet, Coordinates, EdgeCone};

/// A single unknown: the amplitude of the sawtooth on a contact interval.
#[derive(Debug, Clone)]
pub(super) struct Sawtooth {
    /// Place and sign of every node of the contact interval.
    pub(super) nodes: Vec<(usize, f64)>,
    /// s'K divided by the unit, as (place, value).
    row: Vec<(usize, f32)>,
    /// s'K s divided by the unit.
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
        let nodes: Vec<(usize, f64)> =
            run.into_iter().map(|(u, sign)| (level.place(u), sign)).collect();
        let own: f64 =
            nodes.iter().map(|(place, sign)| sign * row.get(place).copied().unwrap_or(0.0)).sum();
        Self {
            nodes,
            row: row.into_iter().map(|(place, value)| (place, value as f32)).collect(),
            own: own as f32,
        }
    }

    /// The component of the residual that acts on the amplitude, ± its mean on the contact interval, times a factor.
    pub(super) fn force(&self, residual: &[f64], factor: f64, out: &mut [f32]) {
        let sum: f64 = self.nodes.iter().map(|&(place, sign)| sign * residual[place]).sum();
        let mean = factor * sum / self.nodes.len() as f64;
        self.nodes.iter().for_each(|&(place, sign)| out[place] = (sign * mean) as f32);
    }

    /// Sets the amplitude to the value for which its residual vanishes.
    pub(super) fn relax(&self, x: &mut [f32], b: &[f32]) {
        let force: f32 = self.nodes.iter().map(|&(place, sign)| sign as f32 * b[place]).sum();
        let held: f32 = self.row.iter().map(|&(place, value)| value * x[place]).sum();
        let change = (force - held) / self.own;
        self.nodes.iter().for_each(|&(place, sign)| x[place] += sign as f32 * change);
    }
}

/// The free and fixed unknowns of a contact set.
pub(super) struct FreePart {
    /// Nodes of the contact edge whose u_N is not an independent unknown.
    pub(super) held: Vec<bool>,
    /// The amplitudes.
    pub(super) sawtooths: Vec<Sawtooth>,
    /// The change of u_N along the edge that satisfies the active constraints.
    pub(super) change: Vec<f64>,
}

impl FreePart {
    /// The free unknowns for the active constraints `set` and B w ≤ `bound`, for a change w of u_N that
    /// vanishes at fixed nodes.
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
            // The smallest change that satisfies the constraints.
            let mean =
                run.iter().map(|&(k, sign)| sign * change[k]).sum::<f64>() / run.len() as f64;
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
