//! Theorems 3.1 and 4.1, Figure 3.1: how fast errors and consistency terms fall.

mod bounds;
mod figure;
mod fit;
mod introduction;
mod level;
mod listing;
mod logarithm;
mod mesh_rates;
mod orders;
mod store;
mod strip_rates;
mod study;
mod theorem;

pub use bounds::Bound;
pub use figure::{FigureRates, figure_chart, figure_headline};
pub use fit::{Fit, Model};
pub use introduction::{introduction_chart, introduction_headline, introduction_rows, introduction_studies};
pub use level::{Flag, RateLevel};
pub use logarithm::{LogarithmFit, logarithm_chart, logarithm_headline, logarithm_studies};
pub use mesh_rates::MeshRates;
pub use orders::observed_orders;
pub use store::LevelStore;
pub use strip_rates::{RateStrip, SceneFamily};
pub use study::{Quantity, RateStudy};
pub use theorem::{StripGroup, TheoremPlan, theorem_headline};
