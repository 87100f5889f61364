//! Sections 3 and 4: two cones, two consistency terms, two alternatives.

/// The section of the paper, with its alternative and its consistency term.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Section {
    /// Section 3, Figure 3.2: zeros of u_N near both vertices; ∫ σ_N (I^h u)_N.
    Three,
    /// Section 4, Figure 4.1: diameter of C_T; ∫ (σ_N − π^h σ_N)(π^h u_N − u_N).
    Four,
}
