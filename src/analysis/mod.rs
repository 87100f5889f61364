//! How fast errors fall, and what is printed and drawn of the rooms [`crate::edge`] and [`crate::proof`].

mod alternative_report;
mod balance_report;
mod contact_source;
mod falk_report;
mod orders;
mod profile_report;
mod rates;
mod worst_report;

pub use balance_report::BalanceRow;
pub use contact_source::{Against, ContactSource};
pub use falk_report::{falk_chart, falk_headline};
pub use orders::observed_orders;
pub use rates::{
    Bound, FigureRates, Fit, Flag, LevelStore, LogarithmFit, MeshRates, Model, Quantity, RateLevel,
    RateStrip, RateStudy, SceneFamily, StripGroup, TheoremPlan, TransitionPowers, clamped_free_exponent,
    figure_chart, figure_headline, introduction_chart, introduction_headline, introduction_rows,
    introduction_studies, logarithm_chart, logarithm_headline, logarithm_studies, scene_regularity,
    theorem_headline,
};
pub use worst_report::{SearchRow, search_chart, search_headline, search_sets, search_size, worst_gaps};
