//! Section 2: P1 finite elements for the scalar and the elastic form, and elimination of all but the contact unknowns.

mod assembly;
mod condensation;
mod dissection;
mod form;
mod front;
mod matrix;
mod pool;
mod stress;

pub use assembly::{Frame, consistent_load, stiffness};
pub use condensation::{Condensation, Reduced};
pub use form::{Form, Lame};
pub use matrix::{BlockMatrix, compensated, dot};
pub use stress::{Stress, gradients, stresses};
