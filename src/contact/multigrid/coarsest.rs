//! The coarsest level: condensed to its contact edge once, solved exactly for every contact set.

use super::super::problem::ContactProblem;
use crate::error::{Error, Result};
use crate::fem::Condensation;
use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};

/// A pivot below this fraction of its diagonal entry counts as zero: some part of the body has no Dirichlet boundary.
const VANISHED: f64 = 1e-14;

/// The condensation and the factor of S on the free nodes.
pub(super) struct Coarsest {
    condensation: Condensation,
    free: Vec<usize>,
    factor: Option<Llt<f64>>,
}

impl Coarsest {
    pub(super) fn new(problem: &ContactProblem) -> Result<Self> {
        let normals = problem.normal_unknowns();
        let condensation = Condensation::new(
            problem.matrix(),
            problem.mesh.nodes(),
            &problem.prescribed,
            &normals,
        )?;
        Ok(Self { condensation, free: Vec::new(), factor: None })
    }

    /// The mean of S_kk/K_kk along the contact edge; both scale in the same way from level to level.
    pub(super) fn condensed_share(&self, problem: &ContactProblem) -> f64 {
        let (schur, normals) = (self.condensation.schur(), problem.normal_unknowns());
        let shares = normals
            .iter()
            .enumerate()
            .map(|(k, &unknown)| schur[(k, k)] / problem.diagonal(unknown));
        shares.sum::<f64>() / normals.len() as f64
    }

    /// Fixes the marked nodes of the contact edge.
    pub(super) fn hold(&mut self, held: &[bool]) -> Result<()> {
        self.free = (0..held.len()).filter(|&k| !held[k]).collect();
        let (schur, free) = (self.condensation.schur(), &self.free);
        if free.is_empty() {
            self.factor = None;
            return Ok(());
        }
        let part = Mat::from_fn(free.len(), free.len(), |i, j| schur[(free[i], free[j])]);
        let what = "condensed stiffness matrix on the coarsest contact edge";
        let failed = |pivot: usize| Error::not_positive_definite(what, pivot);
        let factor = part.llt(Side::Lower).map_err(|_| failed(free.len()))?;
        let vanishes = |&k: &usize| factor.L()[(k, k)].powi(2) <= VANISHED * part[(k, k)];
        if let Some(pivot) = (0..free.len()).find(vanishes) {
            return Err(failed(pivot));
        }
        self.factor = Some(factor);
        Ok(())
    }

    /// K⁻¹ b on the free unknowns, node-major.
    pub(super) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let reduced = self.condensation.reduce(b);
        let mut edge = vec![0.0; reduced.kept().len()];
        if let Some(factor) = &self.factor {
            let mut right = Mat::from_fn(self.free.len(), 1, |i, _| reduced.kept()[self.free[i]]);
            factor.solve_in_place(&mut right);
            self.free.iter().enumerate().for_each(|(i, &k)| edge[k] = right[(i, 0)]);
        }
        self.condensation.recover(&reduced, &edge)
    }
}
