//! Appendix B: Lemmas 6.1 and 6.2, equation (6.2).

#[path = "../common/rough_slopes.rs"]
mod rough_slopes;

mod equation_6_2;
mod lemma_6_1;
mod lemma_6_2;
mod triangles;
