//! Beyond the paper: best and explicit constants, rearrangement, accuracy and extreme input.

/// Sizes of random searches: the few that decide here, or as many as the target `attacks` takes.
pub const MANY: bool = false;

mod bound_from_data;
mod contact_costs_nothing;
mod explicit_bound;
mod explicit_constants;
mod extremes;
mod finite_contact_set;
mod rate_of_the_bound;
mod rearrangement;
mod segment_constants;
mod worst_contact_set;
mod worst_pair;
