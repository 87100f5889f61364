//! Appendix A: Lemmas 5.1 and 5.2, Remarks 5 to 7.

mod exact_law;
mod lemma_5_1;
mod lemma_5_2;
mod remark_5;
mod remark_6;
mod remark_7;
