//! Moments of functions that vanish on a zone at one end, ∫ m w / |w|_ν: by slopes, between the bounds of the
//! strong form, and at ν = 1/2 in closed form.

mod dual;
mod half_order;
mod strong_basis;
mod strong_form;

pub use dual::{Moment, moment_extremal, moment_norm, moment_norm_beside};
pub use half_order::half_order_moment;
pub use strong_form::{MomentBounds, StrongForm};
