//! Contact on the edge: the linear problem on a face, its preconditioner, and the iteration over faces.

mod inner;
mod precondition;
pub(super) mod solution;
pub(super) mod solve;
