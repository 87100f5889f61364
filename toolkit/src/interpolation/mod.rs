//! Appendix B, (4.6), (4.7) and the embeddings of Sections 3 and 4: constants of
//! interpolation.
//!
//! | paper | here |
//! | --- | --- |
//! | I^h u, Lagrange interpolation of degree one | affine on each element, equal to u at the nodes |
//! | e = u − I^h u, e' = u' − (mean of u' on the element) | everything is written in the slope v = u' |
//! | \|u\|\_{1+ν} = \|u'\|_ν | [`crate`], double integral over both orders of x and y |
//! | Lemma 6.1: ‖e‖₀ ≤ h^{1+ν} \|u\|\_{1+ν}, ‖e‖₁ ≤ h^ν \|u\|\_{1+ν} | [`element_constant`] |
//! | Lemma 6.1 on a triangle | [`TriangleConstants`], [`kobayashi`] |
//! | Lemma 6.2: best constants on a mesh | [`mesh_constant`] |
//! | an optimiser | [`ascend`] |
//! | π^h v, mean on each element; π^h(u') = (I^h u)' | [`ElementMesh`]; (4.6) is Lemma 6.2 for φ = u' |
//! | (4.6), (4.7): best constants | [`projection_constant`], [`dual_projection_constant`] |
//! | (4.6), (4.7): on a mesh | [`projection_norm_on_mesh`] |
//! | ‖·‖\_{1/2,*} | [`crate::dual`]: dual to the full norm (1.1) of order 1/2 on the interval |
//! | C(q) in (3.6), (3.10), (4.12), from both sides | [`embedding_upper_bound`], [`EmbeddingSpace`] |
//! | C(α) in (E3) | [`EndIncrements`] |
//! | limits ν → 0, ν → 1, (6.2) | [`limits`] |
//! | (6.2) for one v | [`mean_deviation`], [`extremal_slopes`] |
//!
//! All constants are those of the seminorm (1.1) as the paper defines it, on an interval of length h = 1
//! unless said.

mod element;
mod elements;
mod embedding;
mod extremal;
mod forms;
mod mesh;
mod projection;
mod triangle;

pub use element::{
    ElementExtremal, ErrorNorm, LocalConstants, element_constant, element_extremal, extremal_slopes,
    largest_share, limits, longest_element, mean_deviation,
};
pub use elements::{ElementMesh, lagrange};
pub use embedding::{
    EMBEDDING_GROWTH, EmbeddingSpace, EmbeddingTrial, EndIncrements, critical_exponent, embedding_upper_bound,
};
pub use mesh::{ascend, mesh_constant, mesh_constant_on_cells};
pub use projection::{
    ProjectionNorm, dual_projection_constant, projection_constant, projection_norm_on_cells,
    projection_norm_on_mesh,
};
pub use triangle::{TriangleConstant, TriangleConstants, TriangleExtremal, TriangleShape, kobayashi};
