//! The explicit constants of the proofs of Theorems 3.1 and 4.1, the bounds that contain them, and the best constants
//! of a segment. Both sides of every inequality are evaluated in the example `theorem_3_1_proof_profile`.

mod constants;
mod explicit_bound;
mod laws;
mod segment_constants;
mod theorem_constants;
mod theta;
mod worst_pair;

pub use constants::ProofConstants;
pub use explicit_bound::{ExplicitBound, MeshShape, half_plane_korn};
pub use laws::TwoLaws;
pub use segment_constants::{
    SegmentConstant, consistency_constant, midpoint_bound, one_gap_ratio, product_bound, product_constant,
};
pub use theorem_constants::TheoremConstants;
pub use theta::printed_exponent;
pub use worst_pair::worst_ratio;
