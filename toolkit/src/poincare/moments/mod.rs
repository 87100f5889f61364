//! Moments of functions that vanish on a zone at one end: by a dual problem, and by the strong form.

mod constant;
mod strong_basis;
mod strong_form;
mod weight;

pub use constant::moment;
pub use weight::Moment;
