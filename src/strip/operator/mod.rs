//! The strip reduced to its edge: symbols, loads, and the excess energy of a coarse strip over a fine one.

pub(super) mod defect;
pub(super) mod edge;
pub(super) mod elastic;
pub(super) mod elastic_defect;
pub(super) mod fourier;
pub(super) mod load;
pub(super) mod scalar;
mod slab;
