//! The proofs of Theorems 3.1 and 4.1 in numbers: which case a contact segment falls into, both sides of
//! every inequality, the ladder of bounds, the balance of θ, Falk's lemma, and the worst pairs and contact
//! sets of one segment.

mod alternative_study;
mod alternatives;
mod balance;
mod balance_rows;
mod case;
mod classification;
mod constants;
mod contact_cost;
mod exponent;
mod extrapolated;
mod face_gaps;
mod falk;
mod fine_norms;
mod inequality;
mod ladder;
mod limit_lines;
mod line;
mod profile;
mod resolution;
mod section;
mod section_four;
mod section_three;
mod segment_constants;
mod segment_sets;
mod setting;
mod step;
mod theta;
mod with_numbers;
mod without_c;
mod without_c_strip;
mod without_c_study;
mod worst_pair;
mod worst_sets;

pub use alternative_study::{Against, AlternativeCase, AlternativeRow, AlternativeStudy};
pub use alternatives::{Alternative, Case, NearVertices, SetDiameter};
pub use balance::{ElementBalance, WorstPair};
pub use balance_rows::{BalanceExponents, BalanceRow, worst_of_cases};
pub use case::ProofCase;
pub use classification::{Classification, ClassifiedSegment};
pub use constants::ProofConstants;
pub use contact_cost::{CostRow, CostStudy, contact_cost};
pub use exponent::Exponent;
pub use extrapolated::{ExtrapolatedRow, ExtrapolatedStudy, SolvedBody};
pub use face_gaps::FaceGaps;
pub use falk::{FalkRow, falk_terms};
pub use fine_norms::{FineForms, FineNorms};
pub use inequality::{Check, InequalityProfile};
pub use ladder::{LineProfile, Rung};
pub use limit_lines::{LimitLine, LimitLines, limit_lines};
pub use line::Line;
pub use profile::{CaseCounts, LevelProfile, ProofProfile};
pub use resolution::Resolution;
pub use section::Section;
pub use section_four::section_four_checks;
pub use section_three::section_three_checks;
pub use segment_constants::{
    SegmentConstant, consistency_constant, half_sharpened, midpoint_bound, one_gap_ratio, product_constant,
};
pub use segment_sets::{RatedSet, SegmentSearch, SegmentSets};
pub use setting::SegmentSetting;
pub use step::{Step, TwoLaws};
pub use theta::{ThetaRule, printed_exponent, printed_theta};
pub use with_numbers::{NumberedRow, NumberedStudy, TheoremNumbers};
pub use without_c::{BoundRow, BoundWithoutC, MeshShape, half_plane_korn};
pub use without_c_study::{BoundProblem, BoundStudy, segment_versions};
pub use worst_pair::worst_ratio;
pub use worst_sets::{ContactFamily, SetTerms};
