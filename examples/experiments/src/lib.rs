//! Experiments of the examples: sweeps, random families and studies on top of the two libraries. Each module serves
//! the example that its first line names; tests run them at other parameters.

pub mod arrangement;
mod parallel;
mod random;
mod scale;
mod search;

pub use random::SplitMix;
pub use scale::largest;
