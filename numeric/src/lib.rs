//! What the crates `fractional-sobolev` and `signorini` both compute with: sums with small rounding errors, searches in
//! one variable, units that are powers of two, preconditioned conjugate gradients, Fourier transforms, parallel maps, the
//! size of the memory.
//!
//! This crate is internal to those two, which depend on exactly this version: its interface may change in any release.

#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod conjugate_gradients;
pub mod memory;
pub mod parallel;
pub mod scale;
pub mod search;
pub mod sum;
pub mod transforms;
