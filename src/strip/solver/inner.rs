//! The linear problem on a face: Π A Π x = Π b, Π the projection onto the face, by preconditioned conjugate
//! gradients.
//!
//! The residual is measured in the norm of the preconditioner, ρ = (r'B r)^{1/2}, B the preconditioner, which
//! is equivalent to the energy norm of the error with constants close to 1. The number of iterations for a
//! given reduction is bounded independently of n and of the contact set.

use super::precondition::Preconditioner;
use crate::cone::Face;
use crate::error::{Error, Result};
use crate::numeric::conjugate_gradients::{ConjugateGradients, Step, System};
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::operator::fourier::Workspace;

/// The result of one inner solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Inner {
    pub(crate) iterations: usize,
    /// The final ρ, relative to the norm of the load in the same sense.
    pub(crate) residual: f64,
}

/// Conjugate gradients with buffers kept over all steps on one edge.
pub(crate) struct FaceSolver<'a> {
    operator: &'a EdgeOperator,
    preconditioner: Preconditioner<'a>,
    work: Workspace,
    iteration: ConjugateGradients,
    residual: Vec<f64>,
    image: Vec<f64>,
}

/// Π A Π and its preconditioner on one face; vectors lie on the face.
struct OnFace<'s, 'a> {
    face: &'s Face,
    operator: &'a EdgeOperator,
    preconditioner: &'s mut Preconditioner<'a>,
    work: &'s mut Workspace,
}

impl System for OnFace<'_, '_> {
    type Error = Error;

    fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        self.operator.apply_into(x, out, self.work)?;
        self.face.project(out);
        Ok(())
    }

    fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<()> {
        self.preconditioner.apply(self.face, r, out, self.work)?;
        self.face.project(out);
        Ok(())
    }
}

impl<'a> FaceSolver<'a> {
    pub(crate) fn new(operator: &'a EdgeOperator) -> Self {
        let nodes = operator.nodes();
        Self {
            operator,
            preconditioner: Preconditioner::new(operator),
            work: operator.workspace(),
            iteration: ConjugateGradients::new(nodes),
            residual: vec![0.0; nodes],
            image: vec![0.0; nodes],
        }
    }

    /// Improves x (projected onto the face) until ρ ≤ max(goal · ‖b‖, reduction · initial ρ), in at most `limit`
    /// iterations.
    pub(crate) fn solve(
        &mut self,
        face: &Face,
        b: &[f64],
        x: &mut [f64],
        goal: f64,
        reduction: f64,
        limit: usize,
    ) -> Result<Inner> {
        let mut system = OnFace {
            face,
            operator: self.operator,
            preconditioner: &mut self.preconditioner,
            work: &mut self.work,
        };
        self.residual.copy_from_slice(b);
        face.project(&mut self.residual);
        self.iteration.start(&mut system, &self.residual)?;
        let scale = self.iteration.rho().sqrt();
        face.project(x);
        system.operator.apply_into(x, &mut self.image, system.work)?;
        for i in 0..x.len() {
            self.residual[i] = b[i] - self.image[i];
        }
        face.project(&mut self.residual);
        self.iteration.start(&mut system, &self.residual)?;
        let target = (goal * scale).max(reduction * self.iteration.rho().sqrt());
        let mut iterations = 0;
        while self.iteration.rho().sqrt() > target && iterations < limit {
            if self.iteration.step(&mut system, x)? == Step::Flat {
                break;
            }
            iterations += 1;
        }
        let residual = if scale > 0.0 { self.iteration.rho().sqrt() / scale } else { 0.0 };
        Ok(Inner { iterations, residual })
    }

    /// A x.
    pub(crate) fn product(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        self.operator.apply_into(x, out, &mut self.work)
    }
}
