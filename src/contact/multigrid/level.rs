//! The interface of a level for a cycle, independent of the storage of its matrix.

use super::real::Real;

/// The order of a sweep: the second is the adjoint of the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sweep {
    Forward,
    Backward,
}

/// A level: its matrix, and the transfer to the coarser level. Vectors have the layout of the level; the f32
/// operations use K / [`Level::unit`].
pub(super) trait Level: Sync {
    /// Number of unknowns, prescribed ones included.
    fn unknowns(&self) -> usize;

    /// The unit of K: its largest diagonal entry.
    fn unit(&self) -> f64;

    /// The position of an unknown (node-major).
    fn place(&self, unknown: usize) -> usize;

    /// out ← K x.
    fn multiply(&self, x: &[f64], out: &mut [f64]);

    /// One block Gauss-Seidel sweep for K x = b; fixed unknowns are not changed.
    fn sweep(&self, x: &mut [f32], b: &[f32], fixed: &[bool], direction: Sweep);

    /// out ← b − K x.
    fn residual(&self, x: &[f32], b: &[f32], out: &mut [f32]);

    /// coarse ← P' fine.
    fn restrict(&self, fine: &[f32], coarse: &mut [f32]);

    /// fine ← fine + P coarse.
    fn prolong<T: Real>(&self, coarse: &[T], fine: &mut [T]);
}
