//! The elimination order of the unknowns.

use super::matrix::BlockMatrix;
use super::pool::Pool;

/// The input of the elimination of a subtree.
pub(super) struct Ordering<'a> {
    pub(super) matrix: &'a BlockMatrix,
    /// Position of every unknown; the largest number for prescribed ones.
    pub(super) positions: &'a [u32],
    /// The unknown at every position.
    pub(super) unknowns: &'a [u32],
    pub(super) pool: Pool,
}
