//! The stiffness matrix of a problem: constant stencils on a grid with constant steps; an assembled matrix otherwise,
//! or if a factorization is needed. Products, rows and diagonal do not assemble the matrix if stencils exist.

use super::problem::ContactProblem;
use crate::fem::{BlockMatrix, Form, Frames, Stencils, stiffness_in};
use crate::mesh::Triangulation;
use std::sync::OnceLock;
use std::time::Instant;

/// Stencils, and the assembled matrix once it is used, with the time of its assembly in seconds.
#[derive(Debug, Clone, Default)]
pub(super) struct Operator {
    pub(super) stencils: Option<Stencils>,
    pub(super) assembled: OnceLock<(BlockMatrix, f64)>,
}

impl Operator {
    pub(super) fn of(mesh: &Triangulation, form: &Form, frames: &Frames) -> Self {
        let stencils = frames.common().and_then(|frame| Stencils::of(mesh, form, frame));
        Self { stencils, assembled: OnceLock::new() }
    }
}

impl ContactProblem {
    /// The stencils, on a grid with constant steps.
    pub(super) fn stencils(&self) -> Option<&Stencils> {
        self.operator.stencils.as_ref()
    }

    /// The stiffness matrix K, assembled at its first use.
    pub(super) fn matrix(&self) -> &BlockMatrix {
        let assemble = || {
            let start = Instant::now();
            let matrix = stiffness_in(&self.mesh, &self.form, &self.frames);
            (matrix, start.elapsed().as_secs_f64())
        };
        &self.operator.assembled.get_or_init(assemble).0
    }

    /// Seconds spent so far on load, edge and matrix.
    pub(super) fn assembly_seconds(&self) -> f64 {
        self.preparation_seconds
            + self.operator.assembled.get().map_or(0.0, |assembled| assembled.1)
    }

    /// Number of unknowns, prescribed ones included.
    pub(super) fn unknowns(&self) -> usize {
        self.mesh.nodes().len() * self.form.components()
    }

    /// K x.
    pub(super) fn multiply(&self, x: &[f64]) -> Vec<f64> {
        self.stencils().map_or_else(|| self.matrix().multiply(x), |stencils| stencils.multiply(x))
    }

    /// |K| |x|.
    pub(super) fn multiply_absolute(&self, x: &[f64]) -> Vec<f64> {
        match self.stencils() {
            Some(stencils) => stencils.multiply_absolute(x),
            None => self.matrix().multiply_absolute(x),
        }
    }

    /// The entries of row `unknown` as (column, value).
    pub(super) fn row(&self, unknown: usize) -> Vec<(usize, f64)> {
        match self.stencils() {
            Some(stencils) => stencils.row(unknown).collect(),
            None => self.matrix().row(unknown).collect(),
        }
    }

    /// K_ii.
    pub(super) fn diagonal(&self, unknown: usize) -> f64 {
        let is_own = |&(column, _): &(usize, f64)| column == unknown;
        match self.stencils() {
            Some(stencils) => stencils.row(unknown).find(is_own).map_or(0.0, |(_, value)| value),
            None => self.matrix().diagonal(unknown),
        }
    }
}
