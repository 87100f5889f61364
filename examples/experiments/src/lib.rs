//! Experiments of the examples: sweeps, random families and studies on top of the two libraries. Each module serves
//! the example that its first line names; tests run them at other parameters.

pub mod arrangement;
pub mod contact_levels;
pub mod convergence;
mod estimates;
mod faults;
pub mod gallery;
pub mod growth;
pub mod hard_cases;
pub mod induction;
pub mod interpolation;
mod known_levels;
pub mod location;
mod parallel;
pub mod proof;
mod random;
mod scale;
mod search;
pub mod solver_variants;
pub mod sorting;
pub mod square_trace;
mod sum;
pub mod trial;
pub mod wedge_grid;
pub mod zone_bound;
pub mod zones;

pub use estimates::EstimateExt;
pub use faults::ErrorExt;
pub use known_levels::{KnownLevel, known_levels};
pub use random::SplitMix;
pub use scale::largest;
