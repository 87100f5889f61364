//! Section 1: fractional Sobolev spaces on intervals.

mod order;

pub use order::FractionalOrder;
