//! The stiffness matrix of a problem: constant stencils on a grid with constant steps; an assembled matrix otherwise,
//! or if a factorization is needed.

use crate::fem::{BlockMatrix, Form, Frames, Stencils};
use crate::mesh::Triangulation;
use std::sync::OnceLock;

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
