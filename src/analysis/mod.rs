//! Sections 3 and 4 on computed solutions: which case a contact segment falls into, what it adds to the consistency
//! term, and how fast errors fall.
//!
//! Everything here looks at the trace on the straight contact edge only ([`EdgeTrace`]): the normal displacement at the
//! nodes of a fine mesh and the contact forces there. Lengths are in units of the data.

mod alternative_report;
mod alternative_study;
mod alternatives;
mod balance;
mod balance_report;
mod classification;
mod consistency;
mod contact_source;
mod edge_trace;
mod falk;
mod falk_report;
mod orders;
mod pair;
mod profile;
mod rates;
mod segment;
mod segment_seminorm;

pub use alternative_study::{AlternativeCase, AlternativeRow, AlternativeStudy, ThetaRule};
pub use alternatives::{Alternative, NearVertices, SetDiameter, printed_theta};
pub use balance::{ElementBalance, WorstPair};
pub use balance_report::{BalanceExponents, BalanceRow, worst_of_cases};
pub use classification::{Classification, ClassifiedSegment, Section};
pub use consistency::{midpoint_term, nodal_term};
pub use contact_source::{Against, ContactSource};
pub use edge_trace::{EdgeTrace, Interval};
pub use falk::{FalkRow, falk_terms};
pub use falk_report::{falk_chart, falk_headline};
pub use orders::observed_orders;
pub use pair::{ContactPair, Segment, Traces};
pub use profile::{
    Check, Exponent, InequalityProfile, LevelProfile, ProofCase, ProofConstants, ProofProfile, Resolution,
    Rung, SegmentSetting, section_four_checks, section_three_checks,
};
pub use rates::{
    Bound, EdgeNorms, FigureRates, Fit, Flag, LevelStore, LogarithmFit, MeshRates, Model, Quantity,
    RateLevel, RateStrip, RateStudy, SceneFamily, SearchRow, StripGroup, TheoremPlan, TransitionPowers,
    clamped_free_exponent, edge_norm, edge_norms, figure_chart, figure_headline, introduction_chart,
    introduction_headline, introduction_rows, introduction_studies, logarithm_chart, logarithm_headline,
    logarithm_studies, scene_regularity, search_chart, search_headline, search_sets, search_size,
    theorem_headline, worst_gaps, worst_ratio,
};
pub use segment::{SegmentNorms, TraceNorms};
pub use segment_seminorm::{SegmentTrace, SeminormForm, seminorm_by_quadrature};
