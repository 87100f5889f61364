//! Sections 3 and 4 on computed solutions: which case a contact segment falls into, what it adds to the consistency
//! term, and how fast errors fall.
//!
//! Everything here looks at the trace on the straight contact edge only ([`EdgeTrace`]): the normal displacement at the
//! nodes of a fine mesh and the contact forces there. Lengths are in units of the data.

mod alternative_study;
mod alternatives;
mod classification;
mod consistency;
mod edge_trace;
mod orders;
mod rates;

pub use alternative_study::{AlternativeRow, AlternativeStudy, ThetaRule};
pub use alternatives::{Alternative, NearVertices, SetDiameter, printed_theta};
pub use classification::{Classification, ClassifiedSegment, Section};
pub use consistency::{midpoint_term, nodal_term};
pub use edge_trace::{EdgeTrace, Interval};
pub use orders::observed_orders;
pub use rates::{
    Bound, EdgeNorms, FigureRates, Fit, Flag, LevelStore, LogarithmFit, MeshRates, Model, Quantity,
    RateLevel, RateStrip, RateStudy, SceneFamily, SearchRow, StripGroup, TheoremPlan, TransitionPowers,
    clamped_free_exponent, edge_norm, edge_norms, figure_chart, figure_headline, introduction_chart,
    introduction_headline, introduction_rows, introduction_studies, logarithm_chart, logarithm_headline,
    logarithm_studies, scene_regularity, search_chart, search_headline, search_sets, search_size,
    theorem_headline, worst_gaps, worst_ratio,
};
