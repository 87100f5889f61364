//! Theorems 3.1 and 4.1, Figure 3.1: how fast errors and consistency terms fall; studies of scenes.
//!
//! | | here |
//! | --- | --- |
//! | operator, load, contact solution, error, level after level | [`solve_levels`], [`LevelProblem`] |
//! | the levels of a strip; of a case at all positions | [`StripLevels`], [`strip_levels`]; [`CaseStudy`] |
//! | a scene of the strip with levels, cone and positions: what is solved | [`StripCase`], [`Levels`] |
//! | a scene in one cone, strips and meshes | [`RateStrip`], [`StripGroup`], [`MeshRates`], [`RateStudy`] |
//! | one transition on meshes, against its known solution | [`TransitionRates`] |
//! | the scenes' regularity beside their orders | [`scene_orders`] |
//! | which levels count | [`RateLevel`], [`Flag`] |
//! | the exponent of an alternating series; the slope of a term | [`Trend`]; [`regression`] |
//! | the power of \|ln h\| at τ = 2 | [`LogarithmFit`] |
//! | the exponent at a scene's worst corner, read off graded meshes | [`CornerReading`] |
//! | one body at its clamped end, solved; on all roads | [`EndRun`], [`EndCase`] |

mod case_study;
mod clamped_end;
mod clamped_end_case;
mod corner_reading;
mod family;
mod group;
mod level;
mod level_loop;
mod levels;
mod logarithm;
mod memory;
mod mesh_rates;
mod regression;
mod scene_orders;
mod strip_case;
mod strip_levels;
mod strip_rates;
mod study;
mod subject;
mod transition_rates;
mod trend;

pub use case_study::{CaseStudy, Solved, mean_errors};
pub use clamped_end::{EndMethod, EndRun};
pub use clamped_end_case::EndCase;
pub use corner_reading::CornerReading;
pub use family::SceneFamily;
pub use group::StripGroup;
pub use level::{Flag, RateLevel};
pub use level_loop::{Facts, Level, LevelProblem, solve_levels};
pub use levels::Levels;
pub use logarithm::LogarithmFit;
pub use memory::{LevelKey, LevelMemory, NoMemory};
pub use mesh_rates::MeshRates;
pub use regression::regression;
pub use scene_orders::{SceneOrder, scene_orders};
pub use strip_case::StripCase;
pub use strip_levels::{StripLevels, StripSolution, strip_levels};
pub use strip_rates::RateStrip;
pub use study::{Quantity, RateReference, RateStudy};
pub use subject::{FamilyScene, Subject};
pub use transition_rates::TransitionRates;
pub use trend::Trend;
