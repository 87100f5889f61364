//! Section 2: P1 finite elements for the scalar and the elastic form, and elimination of all but the contact
//! unknowns.

mod assembly;
mod condensation;
mod cubature;
mod dissection;
mod error_norms;
mod field;
mod form;
mod frame;
mod front;
mod loads;
mod matrix;
mod pool;
mod stencil;
mod stress;

#[cfg(test)]
pub(crate) use assembly::stiffness;
pub(crate) use assembly::stiffness_in;
pub(crate) use condensation::{Condensation, Reduced};
pub use cubature::Cubature;
pub use error_norms::{ErrorNorms, error_norms};
pub use field::Field;
pub(crate) use form::Element;
pub use form::{Form, Lame};
pub(crate) use frame::{Frame, Frames};
pub(crate) use front::inner;
pub(crate) use loads::{consistent_load, load_by_edges, load_by_triangles, volume_load};
pub(crate) use matrix::BlockMatrix;
pub(crate) use stencil::{Block, NEIGHBOURS, Stencils, kind};
pub use stress::{Stress, gradients, stresses};
