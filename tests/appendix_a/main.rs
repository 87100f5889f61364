//! Appendix A: Lemmas 5.1 and 5.2, Remarks 5 to 7.

/// Sizes of random searches: the few that decide here, or as many as the target `attacks` takes.
pub const MANY: bool = false;

mod exact_law;
mod lemma_5_1;
mod lemma_5_2;
mod remark_5;
mod remark_6;
mod remark_7;
