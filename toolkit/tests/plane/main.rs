//! Norms in the plane: triangulations, corner singularities and polygonal curves.

#[allow(dead_code)]
#[path = "../common/mod.rs"]
mod common;
#[allow(dead_code)]
#[path = "../hard/mod.rs"]
mod hard;

mod boundaries;
mod corners;
mod norms;

/// The part of the random cases that is run by default; `attacks` runs more.
const SHARE: f64 = 0.1;
