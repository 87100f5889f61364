//! Theorems 3.1 and 4.1, Figure 3.1: how fast errors and consistency terms fall.

mod bounds;
mod element;
mod figure;
mod fit;
mod introduction;
mod level;
mod listing;
mod logarithm;
mod mesh;
mod norms;
mod store;
mod strip;
mod study;
mod theorem;
mod worst;

pub use bounds::Bound;
pub use element::worst_ratio;
pub use figure::{FigureRates, figure_chart, figure_headline};
pub use fit::{Fit, Model};
pub use introduction::{introduction_chart, introduction_headline, introduction_rows, introduction_studies};
pub use level::{Flag, RateLevel};
pub use logarithm::{LogarithmFit, logarithm_chart, logarithm_headline, logarithm_studies};
pub use mesh::MeshRates;
pub use norms::{EdgeNorms, edge_norm, edge_norms};
pub use store::LevelStore;
pub use strip::{RateStrip, SceneFamily};
pub use study::{Quantity, RateStudy};
pub use theorem::{StripGroup, TheoremPlan, theorem_headline};
pub use worst::{SearchRow, search_chart, search_headline, search_sets, search_size, worst_gaps};
