//! Section 4: the midpoint cone. Theorem 4.1, its proof, Falk's lemma, the projection on constants.

#[path = "../common/proof_cases.rs"]
mod proof_cases;
#[path = "../common/reference_squares.rs"]
mod reference_squares;
#[path = "../common/rough_slopes.rs"]
mod rough_slopes;

mod falk;
mod figure_4_1;
mod midpoint_cone;
mod projection;
mod theorem_4_1_proof;
