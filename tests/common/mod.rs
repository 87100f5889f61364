//! What several tests share: random numbers.

#![allow(dead_code, reason = "each test uses a part")]

#[path = "../../toolkit/tests/common/mod.rs"]
mod random;

#[allow(unused_imports, reason = "each test uses a part")]
pub use random::SplitMix;
