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
mod precise;
mod stencil;
mod stress;

pub use assembly::stiffness;
pub(crate) use assembly::stiffness_in;
pub use condensation::{Condensation, Reduced};
pub use cubature::Cubature;
pub use error_norms::{ErrorNorms, Gradient, error_norms};
pub use field::Field;
pub(crate) use form::Element;
pub use form::{Form, Lame};
pub use frame::Frame;
pub(crate) use frame::Frames;
pub(crate) use front::inner;
pub(crate) use loads::load_by_triangles;
pub use loads::{consistent_load, surface_load, volume_load};
pub use matrix::BlockMatrix;
pub(crate) use precise::{PreciseRow, precise_stiffness};
pub(crate) use stencil::{Block, NEIGHBOURS, Stencils, kind};
pub use stress::{Stress, gradients, stresses};
