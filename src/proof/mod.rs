//! The explicit constants of the proofs of Theorems 3.1 and 4.1, the bounds that contain them, and the best constants
//! of a segment. Both sides of every inequality are evaluated in the example `theorem_3_1_proof_profile`.

mod constants;
mod segment_constants;

pub use constants::{ProofConstants, TwoLaws};
pub use segment_constants::{
    SegmentConstant, consistency_constant, midpoint_bound, one_gap_ratio, product_bound,
    product_constant,
};
