//! Long runs of the random cases of `accuracy`, `norms` and `plane`, more than 10 000 by default:
//! `cargo test --release -p fractional-sobolev --test attacks`.

#[allow(dead_code)]
#[path = "../common/mod.rs"]
mod common;
#[allow(dead_code)]
#[path = "../hard/mod.rs"]
mod hard;

#[path = "../accuracy/constants.rs"]
mod constants;
#[path = "../norms/errors_of_fields.rs"]
mod errors_of_fields;
#[path = "../accuracy/features.rs"]
mod features;
#[path = "../accuracy/maxima.rs"]
mod maxima;
#[path = "../accuracy/numbers.rs"]
mod numbers;
#[path = "../norms/rough_loads.rs"]
mod rough_loads;
#[path = "../accuracy/scales.rs"]
mod scales;
#[path = "../plane/norms.rs"]
mod triangulations;

/// All random cases.
const SHARE: f64 = 1.0;
