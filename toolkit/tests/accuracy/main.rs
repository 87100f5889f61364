//! Hard inputs with known answers: every answer lies within its stated error, or is refused with a best value
//! that does. `SIGNORINI_ATTACK=10` takes ten times the cases, `SIGNORINI_SEED=7` other ones;
//! `cargo test --release --test attacks` takes ten times as many.

#[allow(dead_code)]
#[path = "../common/mod.rs"]
mod common;
#[allow(dead_code)]
#[path = "../hard/mod.rs"]
mod hard;

mod constants;
mod features;
mod half_order_moments;
mod maxima;
mod numbers;
mod rules;
mod scales;

/// The part of the random cases that is run by default; `attacks` runs more.
const SHARE: f64 = 0.1;
