//! Section 3: the nodal cone. Theorem 3.1, its proof, Remarks 2 and 3, Figures 3.1 and 3.2.

#[path = "../common/program.rs"]
mod program;
#[path = "../common/proof_cases.rs"]
mod proof_cases;
#[path = "../common/rough_slopes.rs"]
mod rough_slopes;

mod embeddings;
mod figure_3_2;
mod rates;
mod remark_2;
mod remark_3_face;
mod theorem_3_1_proof;
mod theta;
