//! `figure_3_2_alternative`, `theorem_3_1_proof_profile`, `theta_balance`, `falk_terms`, `contact_costs_nothing`,
//! `theorem_3_1_with_numbers*`, `theorem_3_1_without_c`, `worst_contact_set`, `remark_3_face`: the proofs over meshes,
//! positions, values of θ and families of contact sets.

mod alternative_study;
mod balance;
mod balance_rows;
mod bound_row;
mod case;
mod contact_cost;
mod extrapolated;
mod face_gaps;
mod falk;
mod fine_norms;
mod inequality_profile;
mod ladder;
mod limit_lines;
mod numbered;
mod profile;
mod resolution;
mod segment_sets;
mod without_c_strip;
mod without_c_study;
mod worst_sets;

pub use alternative_study::{Against, AlternativeCase, AlternativeRow, AlternativeStudy};
pub use balance::{ElementBalance, WorstPair};
pub use balance_rows::{BalanceExponents, BalanceRow, worst_of_cases};
pub use bound_row::BoundRow;
pub use case::ProofCase;
pub use contact_cost::{CostRow, CostStudy, contact_cost};
pub use extrapolated::{ExtrapolatedRow, ExtrapolatedStudy, SolvedBody};
pub use face_gaps::FaceGaps;
pub use falk::{FalkRow, falk_terms};
pub use fine_norms::{FineForms, FineNorms};
pub use inequality_profile::InequalityProfile;
pub use ladder::{LineProfile, Rung};
pub use limit_lines::{LimitLine, LimitLines, limit_lines};
pub use numbered::{NumberedRow, NumberedStudy};
pub use profile::{CaseCounts, LevelProfile, ProofProfile};
pub use resolution::Resolution;
pub use segment_sets::{RatedSet, SegmentSearch, SegmentSets};
pub use without_c_study::{BoundProblem, BoundStudy, segment_versions};
pub use worst_sets::{ContactFamily, SetTerms};
