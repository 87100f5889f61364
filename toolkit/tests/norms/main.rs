//! Norms on intervals: closed forms, piecewise polynomials, Gram matrices, dual norms, errors of interpolants.

#[allow(dead_code)]
#[path = "../common/mod.rs"]
mod common;
#[allow(dead_code)]
#[path = "../hard/mod.rs"]
mod hard;

mod closed_forms;
mod dual_norms;
mod eigenvalues;
mod errors_of_fields;
mod extremes;
mod fields;
mod fractional_laplacian;
mod functions;
mod gram;
mod intervals;
mod piecewise;
mod products;
mod rough_loads;
mod verbs;

/// The part of the random cases that is run by default; `attacks` runs more.
const SHARE: f64 = 0.1;
