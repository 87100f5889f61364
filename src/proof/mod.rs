//! The quantities in the proofs of Theorems 3.1 and 4.1: the case of a contact segment, both sides of every
//! inequality on one segment, Falk's terms of one pair, the explicit constants, and the best constants of a
//! segment.

mod alternatives;
mod chain;
mod check;
mod classification;
mod constants;
mod explicit_bound;
mod falk;
mod inequality;
mod laws;
mod section;
mod section_four;
mod section_three;
mod segment_constants;
mod setting;
mod step;
mod theorem_constants;
mod theta;
mod worst_pair;

pub use alternatives::Alternative;
pub use chain::{segment_chain, segment_checks};
pub use check::Check;
pub use classification::{Classification, ClassifiedSegment};
pub use constants::ProofConstants;
pub use explicit_bound::{ExplicitBound, MeshShape, half_plane_korn};
pub use falk::FalkTerms;
pub use inequality::Inequality;
pub use laws::TwoLaws;
pub use section::Section;
pub use segment_constants::{
    SegmentConstant, consistency_constant, midpoint_bound, one_gap_ratio, product_bound, product_constant,
};
pub use setting::SegmentSetting;
pub use step::Step;
pub use theorem_constants::TheoremConstants;
pub use theta::{ThetaRule, printed_exponent};
pub use worst_pair::worst_ratio;
