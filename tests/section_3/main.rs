//! Section 3: the nodal cone. Theorem 3.1, its proof, Remarks 2 and 3, Figures 3.1 and 3.2.

#[path = "../common/proof_cases.rs"]
mod proof_cases;
#[path = "../common/rough_slopes.rs"]
mod rough_slopes;
#[path = "../common/theorem_rates.rs"]
mod theorem_rates;

mod embeddings;
mod equation_3_2;
mod figure_3_1;
mod figure_3_2;
mod remark_2;
mod remark_3_face;
mod theorem_3_1;
mod theorem_3_1_proof;
mod theta;
