//! The linear problem on a face: Π A Π x = Π b by preconditioned conjugate gradients.
//!
//! The residual is measured in the norm of the preconditioner, ρ = (r'B r)^{1/2}, which is equivalent to the energy norm of
//! the error with constants near 1. Iterations needed for a given reduction do not depend on n or on the gaps.

use super::edge::{EdgeOperator, Workspace};
use super::precondition::Preconditioner;
use crate::cone::Face;

/// What one inner solve did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Inner {
    pub(crate) iterations: usize,
    /// ρ at the end, relative to the load's norm in the same sense.
    pub(crate) residual: f64,
}

/// Conjugate gradients with buffers kept over all steps on one edge.
pub(crate) struct FaceSolver<'a> {
    operator: &'a EdgeOperator,
    preconditioner: Preconditioner<'a>,
    work: Workspace,
    residual: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    corrected: Vec<f64>,
}

impl<'a> FaceSolver<'a> {
    pub(crate) fn new(operator: &'a EdgeOperator) -> Self {
        let zeros = || vec![0.0; operator.nodes()];
        Self {
            operator,
            preconditioner: Preconditioner::new(operator),
            work: operator.workspace(),
            residual: zeros(),
            direction: zeros(),
            image: zeros(),
            corrected: zeros(),
        }
    }

    /// Improves x (made to lie on the face) until ρ ≤ max(goal · ‖b‖, reduction · ρ at the start), at most `limit` times.
    pub(crate) fn solve(
        &mut self,
        face: &Face,
        b: &[f64],
        x: &mut [f64],
        goal: f64,
        reduction: f64,
        limit: usize,
    ) -> Inner {
        self.residual.copy_from_slice(b);
        face.project(&mut self.residual);
        let scale = self.precondition(face).sqrt();
        face.project(x);
        self.refresh(face, b, x);
        let mut rho = self.precondition(face);
        let target = (goal * scale).max(reduction * rho.sqrt());
        self.direction.copy_from_slice(&self.corrected);
        let mut iterations = 0;
        while rho.sqrt() > target && iterations < limit {
            self.operator.apply_into(&self.direction, &mut self.image, &mut self.work);
            face.project(&mut self.image);
            let curvature = dot(&self.direction, &self.image);
            if curvature <= 0.0 {
                break;
            }
            let step = rho / curvature;
            for i in 0..x.len() {
                x[i] += step * self.direction[i];
                self.residual[i] -= step * self.image[i];
            }
            let next = self.precondition(face);
            let turn = next / rho;
            for (d, c) in self.direction.iter_mut().zip(&self.corrected) {
                *d = c + turn * *d;
            }
            rho = next;
            iterations += 1;
        }
        let residual = if scale > 0.0 { rho.sqrt() / scale } else { 0.0 };
        Inner { iterations, residual }
    }

    /// A x.
    pub(crate) fn product(&mut self, x: &[f64], out: &mut [f64]) {
        self.operator.apply_into(x, out, &mut self.work);
    }

    fn refresh(&mut self, face: &Face, b: &[f64], x: &[f64]) {
        self.operator.apply_into(x, &mut self.image, &mut self.work);
        for i in 0..x.len() {
            self.residual[i] = b[i] - self.image[i];
        }
        face.project(&mut self.residual);
    }

    /// corrected ← B residual; returns residual'B residual.
    fn precondition(&mut self, face: &Face) -> f64 {
        self.preconditioner.apply(face, &self.residual, &mut self.corrected, &mut self.work);
        face.project(&mut self.corrected);
        dot(&self.residual, &self.corrected).max(0.0)
    }
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    super::edge::pairwise_sum(0, a.len(), |i| a[i] * b[i])
}
